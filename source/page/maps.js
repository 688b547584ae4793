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

/** Labels of an axis of a map: not more than there is room for. */
function labels(values, room) {
  const every = Math.ceil(values.length / room);
  return values.map((value, i) => (i % every === 0 ? formatted(value, 4) : ''));
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
  labels(xs, 8).forEach((label, i) => svg.append(svgElement('text', { x: left + (i + 0.5) * dx, y: height + 20, 'text-anchor': 'middle' }, label)));
  labels(ys, Math.max(2, height / 24)).forEach((label, j) => svg.append(svgElement('text', { x: left - 6, y: 8 + height - (j + 0.5) * dy, 'text-anchor': 'end' }, label)));
  svg.append(svgElement('text', { x: left + width / 2, y: height + 40, 'text-anchor': 'middle' }, map.x.title));
  svg.append(svgElement('text', { transform: `translate(14 ${height / 2}) rotate(-90)`, 'text-anchor': 'middle' }, map.y.title));
  holder.append(svg, makeScale(palettes.sequential, [formatted(low), formatted((low + high) / 2), formatted(high)], map.value), readout);
}

document.querySelectorAll('[data-map]').forEach(makeMap);

// ---------------------------------------------------------------- meshes

/** Places of values on a palette, for all meshes of a group alike. */
function fieldScale(fields) {
  if (fields[0].isRatio)
    return { palette: palettes.diverging, labels: ['≤ 0.1', '0.3', '1 (limit)', '3', '≥ 10'],
      place: (value) => 0.5 + 0.5 * Math.log10(Math.max(value, 1e-12)) };
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

function makeMeshes(holder) {
  const meshes = data.meshes[holder.dataset.meshes];
  if (!meshes.every((mesh) => mesh.fields.length > 0)) return;
  const figures = [...holder.querySelectorAll('figure')];
  const controls = document.createElement('div');
  controls.className = 'controls';
  const label = Object.assign(document.createElement('label'), { textContent: 'Colour: ' });
  const select = document.createElement('select');
  meshes[0].fields.forEach((field, i) => select.append(new Option(field.name, i)));
  label.append(select);
  controls.append(label);
  const scaleHolder = document.createElement('div');
  const readout = Object.assign(document.createElement('div'), { className: 'readout' });
  holder.prepend(controls, scaleHolder);
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
