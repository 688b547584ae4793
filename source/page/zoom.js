// ---------------------------------------------------------------- zoom

/** Lets wheel, two fingers and the keys + - 0 change the size of a picture, and a pressed pointer and the
    arrow keys move it. The wheel moves the page until the picture has been clicked, or with Ctrl.
    @param zoom   called with a factor and the event, whose place stays where it is
    @param reset  called for the whole picture again
    @param drag   called with the pixels to the right and downwards that the pointer has moved
    @param step   called with -1, 0 or 1 to the right and downwards, of an arrow key */
function makeZoomable(picture, { zoom, reset, drag, step }) {
  picture.setAttribute('tabindex', 0);
  picture.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && document.activeElement !== picture) return;
    event.preventDefault();
    zoom(2 ** (-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 150) / 300), event);
  }, { passive: false });

  const fingers = new Map();
  const spread = () => {
    const [a, b] = fingers.values();
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  picture.onpointerdown = (event) => {
    if (event.pointerType === 'touch') fingers.set(event.pointerId, event);
  };
  picture.onpointerup = picture.onpointercancel = picture.onpointerleave = (event) => fingers.delete(event.pointerId);
  picture.onpointermove = (event) => {
    if (fingers.has(event.pointerId)) {
      const before = fingers.size === 2 ? spread() : 0;
      fingers.set(event.pointerId, event);
      if (before > 0) zoom(spread() / before, event);
    }
    if (event.buttons && fingers.size < 2) drag(event.movementX, event.movementY);
  };

  const acts = { 0: reset, '+': () => zoom(1.4), '=': () => zoom(1.4), '-': () => zoom(1 / 1.4), ArrowLeft: () => step(-1, 0),
    ArrowRight: () => step(1, 0), ArrowUp: () => step(0, -1), ArrowDown: () => step(0, 1) };
  picture.onkeydown = (event) => {
    if (!(event.key in acts)) return;
    acts[event.key]();
    event.preventDefault();
  };
}

/** Buttons for those without wheel and keys. */
function zoomButtons(zoom, reset, contact) {
  return [['−', 'Smaller', () => zoom(1 / 1.4)], ['+', 'Larger', () => zoom(1.4)], ['contact', 'The contact and what is around it', contact],
    ['whole', 'All of it', reset]].map(([text, title, act]) => button(text, act, { className: 'zoom', title }));
}
