// ---------------------------------------------------------------- colours

const palettes = {
  // perceptually uniform, dark to light (viridis, CC0)
  sequential: [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]],
  // blue, white, red: about a limit or zero
  diverging: [[33, 102, 172], [140, 174, 210], [247, 247, 247], [212, 135, 145], [178, 24, 43]]
};

/** Colour at s from 0 to 1 along a palette. */
function colourAt(palette, s) {
  const at = Math.min(Math.max(s, 0), 1) * (palette.length - 1);
  const i = Math.min(Math.floor(at), palette.length - 2);
  return 'rgb(' + palette[i].map((c, k) => Math.round(c + (at - i) * (palette[i + 1][k] - c))).join(',') + ')';
}

/** A bar with the colours of a palette, with labels evenly along it. */
function makeScale(palette, labels, title) {
  const scale = document.createElement('div');
  scale.className = 'scale';
  const bar = document.createElement('div');
  bar.className = 'bar';
  bar.style.background = 'linear-gradient(to right,' +
    palette.map((_, i) => colourAt(palette, i / (palette.length - 1))).join(',') + ')';
  const line = document.createElement('div');
  line.className = 'labels';
  line.append(...labels.map((label) => Object.assign(document.createElement('span'), { textContent: label })));
  scale.append(title, bar, line);
  return scale;
}

// ---------------------------------------------------------------- colour maps

function svgElement(name, attributes, text) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Ticks of an axis of a map, with their places in cells: round values where the values are evenly
    spaced, or else values themselves, not more than there is room for. */
function mapTicks(values, room) {
  const every = Math.ceil(values.length / room), step = (values.at(-1) - values[0]) / (values.length - 1);
  const isEven = values.length > 2 && step > 0 && values.every((value, i) => Math.abs(value - values[0] - i * step) < 0.02 * step);
  if (!isEven) return values.map((value, i) => ({ value, at: i })).filter((_, i) => i % every === 0);
  const span = values.at(-1) - values[0];
  const tick = [1, 2, 5, 10].map((lead) => lead * roundBelow(span / room)).find((size) => span / size <= room) ?? span;
  const ticks = [];
  for (let n = Math.ceil(values[0] / tick - 1e-6); n * tick <= values.at(-1) + 1e-6 * span; ++n)
    ticks.push({ value: n * tick, at: (n * tick - values[0]) / step });
  return ticks;
}

function makeMap(holder) {
  const map = data.maps[holder.dataset.map];
  const xs = data.arrays[map.xValues], ys = data.arrays[map.yValues], values = data.arrays[map.values];
  const known = values.filter((v) => v !== null);
  const [low, high] = map.range ?? [Math.min(...known), Math.max(...known)];
  const width = 480, height = Math.min(480, Math.max(160, width * ys.length / xs.length)), left = 70, bottom = 44;
  const svg = svgElement('svg', { viewBox: `0 0 ${left + width + 10} ${height + bottom + 8}`, 'font-size': 13, role: 'img',
    'aria-label': `${map.value} from ${formatted(low)} to ${formatted(high)} over ${map.x.title} and ${map.y.title}` });
  const dx = width / xs.length, dy = height / ys.length;
  const readout = document.createElement('div');
  readout.className = 'readout';
  values.forEach((value, k) => {
    if (value === null) return;
    const i = k % xs.length, j = Math.floor(k / xs.length);
    const cell = svgElement('rect', { x: left + i * dx, y: 4 + height - (j + 1) * dy, width: dx + 0.3, height: dy + 0.3,
      fill: colourAt(palettes.sequential, high > low ? (value - low) / (high - low) : 0.5) });
    const text = `${map.x.title}: ${formatted(xs[i])}, ${map.y.title}: ${formatted(ys[j])}, ${map.value}: ${formatted(value)}`;
    cell.append(svgElement('title', {}, text));
    cell.addEventListener('pointerenter', () => { readout.textContent = text; });
    svg.append(cell);
  });
  for (const k of data.arrays[map.marked])
    svg.append(svgElement('text', { x: left + (k % xs.length + 0.5) * dx, y: 4 + height - (Math.floor(k / xs.length) + 0.5) * dy,
      class: 'marked', 'text-anchor': 'middle', 'dominant-baseline': 'central' }, '!'));
  for (const { value, at } of mapTicks(xs, 8))
    svg.append(svgElement('text', { x: left + (at + 0.5) * dx, y: height + 20, 'text-anchor': 'middle' }, formatted(value)));
  for (const { value, at } of mapTicks(ys, Math.max(2, height / 24)))
    svg.append(svgElement('text', { x: left - 6, y: 8 + height - (at + 0.5) * dy, 'text-anchor': 'end' }, formatted(value)));
  svg.append(svgElement('text', { x: left + width / 2, y: height + 40, 'text-anchor': 'middle' }, map.x.title));
  svg.append(svgElement('text', { transform: `translate(14 ${height / 2}) rotate(-90)`, 'text-anchor': 'middle' }, map.y.title));
  holder.append(svg, makeScale(palettes.sequential, [formatted(low), formatted((low + high) / 2), formatted(high)], map.value), readout);
  if (data.arrays[map.marked].length > 0)
    holder.append(Object.assign(document.createElement('p'), { textContent: '!: with warnings.' }));
}

document.querySelectorAll('[data-map]').forEach(makeMap);

// ---------------------------------------------------------------- meshes

/** Errors over their limit, in meshes and film alike. */
const ratioScale = { palette: palettes.diverging, labels: ['≤ 0.1', '0.3', '1 (limit)', '3', '≥ 10'],
  place: (value) => 0.5 + 0.5 * Math.log10(Math.max(value, 1e-12)) };

/** Places of values on a palette, for all meshes of a group alike. */
function fieldScale(fields) {
  if (fields[0].isRatio) return ratioScale;
  let high = 0, isSigned = false;
  for (const { values } of fields)
    for (const value of data.arrays[values]) {
      high = Math.max(high, Math.abs(value));
      isSigned = isSigned || value < 0;
    }
  high = high || 1;
  // square roots: resultants are largest by far at the impact
  const root = (value) => Math.sign(value) * Math.sqrt(Math.abs(value) / high);
  const label = (value) => formatted(value, 3);
  return isSigned ?
    { palette: palettes.diverging, labels: [-high, -high / 4, 0, high / 4, high].map(label), place: (value) => 0.5 + 0.5 * root(value) } :
    { palette: palettes.sequential, labels: [0, high / 4, high].map(label), place: root };
}

/** One part of the plate in all pictures of a group, with a scale bar in each. */
function makeMeshView(pictures, controls) {
  const { width, height } = pictures[0].viewBox.baseVal;
  const { x: left, y: top } = pictures[0].viewBox.baseVal;
  const { unit, x, y, r } = Object.fromEntries(Object.entries(pictures[0].dataset).map(([key, value]) => [key, Number(value)]));
  const view = { factor: 1, x: left + width / 2, y: top + height / 2 };
  const bars = pictures.map((picture) => {
    const bar = svgElement('g', { class: 'scalebar' });
    picture.append(bar);
    return bar;
  });

  const show = () => {
    view.factor = Math.min(Math.max(view.factor, 1), 1e4);
    // parts of long plates are square
    const side = Math.max(width, height) / view.factor, w = Math.min(width, side), h = Math.min(height, side);
    view.x = Math.min(Math.max(view.x, left + w / 2), left + width - w / 2);
    view.y = Math.min(Math.max(view.y, top + h / 2), top + height - h / 2);
    const u = Math.max(w, h) / 100, length = roundBelow(0.3 * w / unit);
    const x0 = view.x - w / 2 + 2 * u, y0 = view.y + h / 2 - 2.5 * u;
    pictures.forEach((picture) => picture.setAttribute('viewBox', [view.x - w / 2, view.y - h / 2, w, h].join(' ')));
    for (const bar of bars)
      bar.replaceChildren(
        svgElement('path', { d: `M${x0} ${y0 - u}v${u}h${length * unit}v${-u}`, fill: 'none', 'vector-effect': 'non-scaling-stroke' }),
        svgElement('text', { x: x0 + length * unit + u, y: y0, 'font-size': 4.5 * u, 'stroke-width': u }, withUnit(length, 'm')));
  };
  const zoom = (factor, event) => {
    if (event) {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(event.currentTarget.getScreenCTM().inverse());
      const kept = Math.max(factor, 1 / view.factor);
      view.x = at.x + (view.x - at.x) / kept;
      view.y = at.y + (view.y - at.y) / kept;
    }
    view.factor *= factor;
    show();
  };
  const reset = () => { view.factor = 1; show(); };
  const contact = () => {
    // five radii to either side, or a part of the plate under a point load
    Object.assign(view, { factor: Math.max(width, height) / (r > 0 ? 10 * r : Math.max(width, height) / 16), x, y });
    show();
  };
  addZoomButtons(controls, zoom, reset, contact);
  for (const picture of pictures) {
    const fingers = makeZoomable(picture, zoom, reset);
    picture.addEventListener('pointermove', (event) => {
      if (!event.buttons || fingers() > 1 || view.factor === 1) return;
      const scale = picture.getScreenCTM().a;
      view.x -= event.movementX / scale;
      view.y -= event.movementY / scale;
      show();
    });
    picture.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!step) return;
      event.preventDefault();
      view.x += 0.1 * step[0] * Math.max(width, height) / view.factor;
      view.y += 0.1 * step[1] * Math.max(width, height) / view.factor;
      show();
    });
  }
  show();
}

function makeMeshes(holder) {
  const meshes = data.meshes[holder.dataset.meshes];
  const figures = [...holder.querySelectorAll('figure')];
  const controls = document.createElement('div');
  controls.className = 'controls';
  holder.prepend(controls);
  makeMeshView(figures.map((figure) => figure.querySelector('svg')), controls);
  if (!meshes.every((mesh) => mesh.fields.length > 0)) return;
  const label = Object.assign(document.createElement('label'), { textContent: 'Colour: ' });
  const select = document.createElement('select');
  meshes[0].fields.forEach((field, i) => select.append(new Option(field.name, i)));
  label.append(select);
  controls.prepend(label);
  const scaleHolder = document.createElement('div');
  const readout = Object.assign(document.createElement('div'), { className: 'readout' });
  controls.after(scaleHolder);
  holder.append(readout);

  const show = () => {
    const scale = fieldScale(meshes.map((mesh) => mesh.fields[select.value]));
    scaleHolder.replaceChildren(makeScale(scale.palette, scale.labels, meshes[0].fields[select.value].name));
    meshes.forEach((mesh, i) => {
      const values = data.arrays[mesh.fields[select.value].values];
      figures[i].querySelectorAll('polygon').forEach((cell, c) => cell.setAttribute('fill', colourAt(scale.palette, scale.place(values[c]))));
    });
  };
  select.addEventListener('change', show);
  figures.forEach((figure, i) => figure.addEventListener('pointerover', (event) => {
    if (event.target.tagName !== 'polygon') return;
    const c = [...event.target.parentNode.children].indexOf(event.target);
    readout.textContent = `${meshes[i].title.split(':')[0]}, cell ${c}: ` + meshes[i].fields
      .map((field) => `${field.name} ${formatted(data.arrays[field.values][c], 4)}`).join(', ');
  }));
  show();
}

document.querySelectorAll('[data-meshes]').forEach(makeMeshes);
