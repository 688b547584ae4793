// ---------------------------------------------------------------- sweep.html

/** What is shown in plots: quantities where points have them, and limits of what a browser draws without delay. */
const plottedQuantities = ['peak_force', 'first_contact_end', 'coefficient_of_restitution', 'max_plate_displacement',
  'number_of_contacts', 'peak_force_over_zener', 'discretization_error'];
const mostCurves = 8, mostPanels = 8, mostMapPoints = 40000, mostRows = 200;

/** The quantities that are shown, in units that read well. */
function shownQuantities(quantities) {
  return plottedQuantities.map((name) => quantities.find((quantity) => quantity.name === name))
    .filter((quantity) => quantity?.values.some((value) => value !== null))
    .filter(({ name, values }) => name !== 'number_of_contacts' || values.some((value) => value > 1))
    .map(({ title, unit, values }) => {
      const scale = prefixed(unit, values);
      return { name: title, title: titled(title, scale.name), unit: titled('', scale.name).trim(), values: scale.of(values) };
    });
}

/** The texts of a point; in a product the values of the last entry change fastest. */
function valuesAt({ entries, isProduct, statuses }, point) {
  let stride = statuses.length;
  return entries.map(({ values }) => {
    stride = isProduct ? stride / values.length : 1;
    return values[Math.floor(point / stride) % values.length];
  });
}

/** An entry as an axis; words have the numbers 1, 2, ... */
function scaleOf({ path, unit, values }) {
  const numbers = values.map(Number), isNumeric = !numbers.some(Number.isNaN);
  return { title: titled(path, unit), isNumeric, values: isNumeric ? numbers : values.map((_, i) => i + 1),
    caption: isNumeric ? '' : values.map((value, i) => `${i + 1}: ${value}`).join(', ') };
}

/** "Velocity = 2 m/s" with " = " between name and value. */
function assignment({ path, unit }, value, between) {
  return path.split('/')[1] + between + value + (unit && unit !== '-' ? ` ${unit}` : '');
}

/** A quantity over an entry, a curve for each name; points with warnings are dots of their own. */
function curvesOf({ warned }, quantity, x, names, points) {
  const numbered = (curve) => curve.map((point, i) => ({ point, x: x.values[i], y: quantity.values[point] }));
  const series = points.map((curve, s) => {
    const sorted = numbered(curve);
    if (x.isNumeric) sorted.sort((a, b) => a.x - b.x);
    const shown = sorted.filter((_, i) => i % (1 + Math.floor(sorted.length / 2000)) === 0); // more do not show
    return { name: names[s], x: shown.map((one) => one.x), y: shown.map((one) => one.y), colour: s,
      style: curve.length <= 40 ? 'line and points' : 'line' };
  });
  const marked = points.flatMap(numbered).filter(({ point }) => warned.has(point));
  if (marked.length > 0)
    series.push({ name: 'with warnings', x: marked.map((one) => one.x), y: marked.map((one) => one.y), colour: 7, style: 'points' });
  return { title: quantity.name, caption: x.caption, x: { title: x.title }, y: { title: quantity.title }, series };
}

/** Figures over the first two entries, as maps, or as curves where one of both has words or few values.
    @param panels  quantity, title that tells it from others of the quantity, first point, stride of the second entry */
function panelsOf(results, panels, size) {
  const [a, b] = results.entries.map(scaleOf), nA = a.values.length, nB = b.values.length;
  const point = ({ first, stride }, i, j) => first + (i * nB + j) * stride;
  const indices = (n) => Array.from({ length: n }, (_, i) => i);
  if (a.isNumeric && b.isNumeric && Math.min(nA, nB) > 3)
    return element('div', { className: `grid ${size}` }, panels.map((panel) => {
      const points = indices(nB).flatMap((j) => indices(nA).map((i) => point(panel, i, j)));
      return makeMap({ title: panel.title || panel.quantity.name, valueTitle: panel.quantity.title, x: a, y: b, range: rangeOf(panel.quantity.values),
        values: points.map((p) => panel.quantity.values[p]), marked: indices(points.length).filter((k) => results.warned.has(points[k])) });
    }));
  const aIsFamily = b.isNumeric && (!a.isNumeric || (nA < nB && nA <= mostCurves));
  const family = results.entries[aIsFamily ? 0 : 1], x = aIsFamily ? b : a;
  const names = family.values.map((value) => assignment(family, value, ' '));
  return plotGrid(panels.map((panel) => {
    const plot = curvesOf(results, panel.quantity, x, names, names.map((_, s) =>
      x.values.map((_, i) => aIsFamily ? point(panel, s, i) : point(panel, i, s))));
    return panel.title ? { ...plot, title: panel.title, y: { title: panel.quantity.unit, range: rangeOf(panel.quantity.values) } } : plot;
  }), size);
}

/** The quantities of the points over the swept values: curves over one entry, or over the first where lists are
    paired up; maps or families of curves over two; over three such a panel for each value of the third, on one
    scale. */
function showQuantities(results) {
  const { entries, statuses } = results, [first, , third] = entries, shown = shownQuantities(results.quantities);
  const all = statuses.map((_, point) => point);
  if (entries.length === 1 || !results.isProduct)
    return section('Figures', plotGrid(shown.map((quantity) => curvesOf(results, quantity, scaleOf(first), [''], [all]))));
  const nThird = third?.values.length ?? 1, nShown = Math.min(nThird, mostPanels);
  const drawn = shown.slice(0, Math.max(1, Math.floor(mostMapPoints * nThird / (statuses.length * nShown))));
  if (!third)
    return section('Figures', panelsOf(results, drawn.map((quantity) => ({ quantity, title: '', first: 0, stride: 1 })), ''));
  return section('Figures', drawn.flatMap((quantity) => [heading(quantity.name), panelsOf(results,
    third.values.slice(0, nShown).map((value, k) => ({ quantity, title: assignment(third, value, ' = '), first: k, stride: nThird })), 'small')].flat()),
  nShown < nThird && paragraph(`The other ${nThird - nShown} values of ${third.path} are in sweep.csv.`));
}

function extremesOf(results) {
  const { unit, values } = results.quantities[0];
  const known = values.map((value, point) => ({ value, point })).filter(({ value }) => value !== null).sort((a, b) => a.value - b.value);
  if (known.length === 0) return [];
  return [['Smallest peak force', known[0]], ['Largest peak force', known.at(-1)]].map(([name, { value, point }]) =>
    [name, withUnit(value, unit), `at ${valuesAt(results, point).map((text, i) => assignment(results.entries[i], text, ' ')).join(', ')}`]);
}

function showForcesOfPoints(results) {
  const { histories } = results;
  if (histories.length === 0) return;
  const newton = prefixed('N', histories.flatMap(({ force }) => force)), second = prefixed('s', histories.flatMap(({ time }) => time));
  section('Force against time', plotGrid([{ title: 'Force against time', x: { title: titled('time', second.name) },
    y: { title: titled('force', newton.name) }, series: histories.map(({ point, time, force }, colour) =>
      ({ name: valuesAt(results, point).join(', '), colour, style: 'line', x: second.of(time), y: newton.of(force) })) }]));
}

function showTable(results) {
  const { entries, quantities, statuses, warned } = results;
  const rows = statuses.slice(0, mostRows).map((status, point) => [...valuesAt(results, point),
    ...quantities.map((quantity) => formatted(quantity.values[point], 6)), status === 'ok' && warned.has(point) ? 'ok, with warnings' : status]);
  section('Table', table([...entries, ...quantities].map(({ path, title, unit }) => titled(path ?? title, unit)).concat('Status'), rows, 'words'),
    statuses.length > mostRows && paragraph(`The first ${mostRows} of ${statuses.length} points; all of them are in sweep.csv.`));
}

function showSweep(study) {
  const results = { ...study, warned: new Set(study.warned) }, { work, statuses } = study;
  section('Outcome', facts([...extremesOf(results),
    ['Points', String(statuses.length), `failed: ${statuses.filter((status) => status !== 'ok').length}, with warnings: ${study.warned.length}`],
    ['Meshes', String(work.meshes), `plate models: ${work.plates}, responses to a load: ${work.loads}`]]),
  study.warnings.map((warning) => notice(`Warning: ${warning}`)), study.words.map(paragraph),
  paragraph('The numbers of meshes, plate models and responses are those of the last start of this sweep; points with the same plate, mesh and load share them.'));
  showQuantities(results);
  showForcesOfPoints(results);
  showTable(results);
  section('Scene', preformatted(study.text), paragraph(`plate-impact ${study.version}`));
}

({ run: showRun, comparison: showComparison, sweep: showSweep })[data.study](data);
drawPlots();
