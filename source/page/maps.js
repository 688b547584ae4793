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

/** Colours between which filled contours tell: with one for zero in the middle of two signs. */
const bandsOf = (palette) => (palette === palettes.diverging ? 21 : 20);
const bandColour = (palette, band) => colourAt(palette, (band + 0.5) / bandsOf(palette));

/** A bar with the colours of a palette, with labels evenly along it; in bands or not. */
function makeScale(palette, labels, title, isBanded = false) {
  const n = bandsOf(palette);
  const colours = isBanded ?
    Array.from({ length: n }, (_, k) => `${bandColour(palette, k)} ${100 * k / n}% ${100 * (k + 1) / n}%`) :
    palette.map((_, i) => colourAt(palette, i / (palette.length - 1)));
  return element('div', { className: 'scale' }, title,
    element('div', { className: 'bar', style: `background: linear-gradient(to right, ${colours.join()})` }),
    element('div', { className: 'labels' }, labels.map((label) => element('span', {}, label))));
}

// ---------------------------------------------------------------- colour maps

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

/** Coloured fields over two axes with a `title`, a `valueTitle`, axes `x` and `y` with a title and `values`,
    and `values` row by row, x fastest, null where there is none; `range` of the scale; `marked`, numbers of
    values to look at. */
function makeMap(map) {
  const xs = map.x.values, ys = map.y.values, [low, high] = map.range;
  const width = 480, height = Math.min(480, Math.max(160, width * ys.length / xs.length)), left = 70, bottom = 44;
  const svg = svgElement('svg', { viewBox: `0 0 ${left + width + 10} ${height + bottom + 8}`, 'font-size': 13, role: 'img',
    'aria-label': `${map.valueTitle} from ${formatted(low)} to ${formatted(high)} over ${map.x.title} and ${map.y.title}` });
  const dx = width / xs.length, dy = height / ys.length;
  const readout = element('div', { className: 'readout' });
  map.values.forEach((value, k) => {
    if (value === null) return;
    const i = k % xs.length, j = Math.floor(k / xs.length);
    const cell = svgElement('rect', { x: left + i * dx, y: 4 + height - (j + 1) * dy, width: dx + 0.3, height: dy + 0.3,
      fill: colourAt(palettes.sequential, high > low ? (value - low) / (high - low) : 0.5) });
    const text = `${map.x.title}: ${formatted(xs[i])}, ${map.y.title}: ${formatted(ys[j])}, ${map.valueTitle}: ${formatted(value)}`;
    cell.append(svgElement('title', {}, text));
    cell.addEventListener('pointerenter', () => { readout.textContent = text; });
    svg.append(cell);
  });
  const write = (text, x, y, more) => svg.append(svgElement('text', { x, y, 'text-anchor': 'middle', ...more }, text));
  for (const k of map.marked)
    write('!', left + (k % xs.length + 0.5) * dx, 4 + height - (Math.floor(k / xs.length) + 0.5) * dy, { class: 'marked', 'dominant-baseline': 'central' });
  for (const { value, at } of mapTicks(xs, 8)) write(formatted(value), left + (at + 0.5) * dx, height + 20);
  for (const { value, at } of mapTicks(ys, Math.max(2, height / 24)))
    write(formatted(value), left - 6, 8 + height - (at + 0.5) * dy, { 'text-anchor': 'end' });
  write(map.x.title, left + width / 2, height + 40);
  write(map.y.title, 0, 0, { transform: `translate(14 ${height / 2}) rotate(-90)` });
  const labels = [low, (low + high) / 2, high].map((value) => formatted(value));
  return element('figure', {}, element('h3', {}, map.title), element('div', { className: 'map' }, svg,
    makeScale(palettes.sequential, labels, map.valueTitle), readout,
    map.marked.length > 0 && paragraph('!: with warnings.')));
}

// ---------------------------------------------------------------- meshes

/** Errors over their limit, in meshes and film alike. */
const ratioScale = { title: 'local error ratio ξ′', palette: palettes.diverging, labels: ['≤ 0.1', '0.3', '1 (limit)', '3', '≥ 10'],
  place: (value) => 0.5 + 0.5 * Math.log10(Math.max(value, 1e-12)) };

/** A scale of a field by square roots: resultants are largest by far at the impact. */
function rootScale({ name, unit }, high, isSigned) {
  const root = (value) => Math.sign(value) * Math.sqrt(Math.abs(value) / high), shown = prefixed(unit, [high]);
  const label = (value) => formatted(shown.factor * value, 3), title = titled(name, shown.name);
  return isSigned ?
    { isSigned, title, palette: palettes.diverging, labels: [-high, -high / 4, 0, high / 4, high].map(label), place: (value) => 0.5 + 0.5 * root(value) } :
    { isSigned, title, palette: palettes.sequential, labels: [0, high / 4, high].map(label), place: root };
}

/** One part of the plate in all pictures of a group, with a scale bar in each. */
function makeMeshView(pictures, controls) {
  const [left, top, width, height] = pictures[0].getAttribute('viewBox').split(' ').map(Number);
  const { unit, x, y, r } = Object.fromEntries(Object.entries(pictures[0].dataset).map(([key, value]) => [key, Number(value)]));
  const view = { factor: 1, x: left + width / 2, y: top + height / 2 };
  const bars = pictures.map((picture) => picture.appendChild(svgElement('g', { class: 'scalebar' })));

  const show = (change) => {
    Object.assign(view, change);
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
    const at = event ? new DOMPoint(event.clientX, event.clientY).matrixTransform(event.currentTarget.getScreenCTM().inverse()) : view;
    const kept = Math.max(factor, 1 / view.factor);
    show({ factor: factor * view.factor, x: at.x + (view.x - at.x) / kept, y: at.y + (view.y - at.y) / kept });
  };
  const reset = () => show({ factor: 1 });
  // five radii to either side, or a part of the plate under a point load
  const contact = () => show({ factor: r > 0 ? Math.max(width, height) / (10 * r) : 16, x, y });
  controls.append(...zoomButtons(zoom, reset, contact));
  const move = (right, down, length) => show({ x: view.x + length * right, y: view.y + length * down });
  for (const picture of pictures)
    makeZoomable(picture, { zoom, reset,
      drag: (right, down) => move(right, down, -1 / picture.getScreenCTM().a),
      step: (right, down) => move(right, down, 0.1 * Math.max(width, height) / view.factor) });
  reset();
}

/** A mesh whose cells are coloured later, y upwards, with the load patch and what a view needs of it: the
    length of a metre and where the contact, the origin, is. */
function meshPicture({ title, vertices, cells }, patch) {
  const extent = [0, 1].map((d) => rangeOf(vertices.filter((_, i) => i % 2 === d)));
  const [width, height] = extent.map(([low, high]) => high - low), unit = 400 / Math.max(width, height);
  const [x, y] = [-unit * extent[0][0], unit * extent[1][1]];
  const picture = svgElement('svg', { viewBox: `-1 -1 ${unit * width + 2} ${unit * height + 2}`, role: 'img', 'aria-label': `Mesh, ${title}`,
    'data-unit': unit, 'data-x': x, 'data-y': y, 'data-r': unit * patch.radius });
  const place = (vertex) => `${(x + unit * vertices[2 * vertex]).toFixed(3)},${(y - unit * vertices[2 * vertex + 1]).toFixed(3)}`;
  const group = svgElement('g', { class: 'mesh' });
  for (let c = 0; c < cells.length; c += 4)
    group.append(svgElement('polygon', { points: [0, 1, 3, 2].map((v) => place(cells[c + v])).join(' '), fill: 'none' }));
  picture.append(group);
  if (patch.isDisc) picture.append(svgElement('circle', { class: 'patch', cx: x, cy: y, r: unit * patch.radius }));
  return picture;
}

/** Meshes beside each other where there is room, to be coloured by any of their fields, on one scale for
    all. A mesh has a `title`, `vertices` (x and y of each [m], the impact at the origin), `cells` (four vertices
    of each, lexicographic) and `fields` of values by cell with a `name` and a `unit`, or, where they are ratios to
    a limit, `isRatio`. */
function meshGroup(meshes, patch) {
  const figures = meshes.map((mesh) => element('figure', {}, meshPicture(mesh, patch), element('figcaption', {}, mesh.title)));
  const controls = element('div', { className: 'controls' }), scaleHolder = element('div');
  const readout = element('div', { className: 'readout' });
  makeMeshView(figures.map((figure) => figure.querySelector('svg')), controls);
  const group = element('div', { className: 'mesh-group' }, controls, scaleHolder, element('div', { className: 'grid meshes' }, figures), readout);
  if (!meshes.every((mesh) => mesh.fields.length > 0)) return group;
  const show = (chosen) => {
    const fields = meshes.map((mesh) => mesh.fields[chosen]), [low, high] = rangeOf(fields.flatMap(({ values }) => values));
    const scale = fields[0].isRatio ? ratioScale : rootScale(fields[0], Math.max(high, -low) || 1, low < 0);
    scaleHolder.replaceChildren(makeScale(scale.palette, scale.labels, scale.title));
    figures.forEach((figure, i) => figure.querySelectorAll('polygon').forEach((cell, c) =>
      cell.setAttribute('fill', colourAt(scale.palette, scale.place(fields[i].values[c])))));
  };
  controls.prepend(selection('Colour: ', meshes[0].fields.map((field) => field.name), show));
  figures.forEach((figure, i) => figure.addEventListener('pointerover', (event) => {
    if (event.target.tagName !== 'polygon') return;
    const c = [...event.target.parentNode.children].indexOf(event.target);
    readout.textContent = `${meshes[i].title.split(':')[0]}, cell ${c}: ` + meshes[i].fields
      .map((field) => `${field.name} ${withUnit(field.values[c], field.unit ?? '').trim()}`).join(', ');
  }));
  show(0);
  return group;
}
