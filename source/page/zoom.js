// ---------------------------------------------------------------- zoom

/** Lets wheel, two fingers and the keys + - 0 change the size of a picture, and a pressed pointer and the
    arrow keys move it. The wheel moves the page until the picture has been clicked, or with Ctrl.
    @param zoom   called with a factor and the event, whose place stays where it is
    @param reset  called for the whole picture again
    @param drag   called with the pixels to the right and downwards that the pointer has moved
    @param step   called with -1, 0 or 1 to the right and downwards, of an arrow key */
function makeZoomable(element, { zoom, reset, drag, step }) {
  element.setAttribute('tabindex', 0);
  element.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && document.activeElement !== element) return;
    event.preventDefault();
    zoom(2 ** (-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 150) / 300), event);
  }, { passive: false });

  const fingers = new Map();
  const spread = () => {
    const [a, b] = fingers.values();
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  element.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'touch') fingers.set(event.pointerId, event);
  });
  for (const end of ['pointerup', 'pointercancel', 'pointerleave'])
    element.addEventListener(end, (event) => fingers.delete(event.pointerId));
  element.addEventListener('pointermove', (event) => {
    if (fingers.has(event.pointerId)) {
      const before = fingers.size === 2 ? spread() : 0;
      fingers.set(event.pointerId, event);
      if (before > 0) zoom(spread() / before, event);
    }
    if (event.buttons && fingers.size < 2) drag(event.movementX, event.movementY);
  });

  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  element.addEventListener('keydown', (event) => {
    if (event.key === '0') reset();
    else if (event.key === '+' || event.key === '=') zoom(1.4);
    else if (event.key === '-') zoom(1 / 1.4);
    else if (event.key in arrows) step(...arrows[event.key]);
    else return;
    event.preventDefault();
  });
}

/** Buttons for those without wheel and keys. */
function addZoomButtons(controls, zoom, reset, contact) {
  for (const [text, title, act] of [['−', 'Smaller', () => zoom(1 / 1.4)], ['+', 'Larger', () => zoom(1.4)],
    ['contact', 'The contact and what is around it', contact], ['whole', 'All of it', reset]]) {
    const button = element('button', { type: 'button', className: 'zoom', title }, text);
    button.addEventListener('click', act);
    controls.append(button);
  }
}
