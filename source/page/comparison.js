// ---------------------------------------------------------------- comparison.html

const nameOf = ({ strategy, element }) => `${strategy}, ${element}`;
const isOfEta = (row) => row.quantity === 'eta';

/** The entry of a curve among those that reach a threshold. */
const reachedBy = (row, curve) => row.reached.find((reached) => nameOf(reached) === nameOf(curve));

/** The fastest curve of every strategy to the smallest error that the strategy reaches; its first where it reaches none. */
function bestOfStrategies({ thresholds, curves }) {
  const rows = thresholds.filter((row) => !isOfEta(row)).sort((a, b) => a.threshold - b.threshold);
  return [...new Set(curves.map((curve) => curve.strategy))].map((strategy) => {
    const of = (one) => one.strategy === strategy;
    const reached = rows.map((row) => row.reached.find(of)).find(Boolean);
    return curves.find((curve) => (reached ? nameOf(curve) === nameOf(reached) : of(curve)));
  });
}

function showOutcome({ warnings, reference, thresholds }) {
  const told = thresholds.filter((row) => !isOfEta(row) && [0.01, 0.001].includes(row.threshold));
  section('Outcome', told.map((row) => element('p', {}, element('strong', {}, row.in_words))),
    warnings.map((warning) => notice(`Warning: ${warning}`)), facts([
      ['Reference peak force', prefixed('N', [reference.peak_force]).text(reference.peak_force, 6), reference.origin === 'given' ? 'given by the scene' :
        `uncertain by ${percentage(reference.uncertainty, 3)} for its mesh: ${reference.cells} cells, η = ${percentage(reference.discretization_error, 3)}`],
      reference.time_step_error !== undefined && ['Time step', percentage(reference.time_step_error, 3),
        'of the peak force: the error of the time step, which is the same on all meshes']]));
}

/** Strategies by elements, for the error that is chosen. */
function showThresholds({ thresholds, curves }) {
  const names = (key) => [...new Set(curves.map((curve) => curve[key]))], elements = names('element'), holder = element('div');
  const achieved = (row, curve) => {
    const reached = reachedBy(row, curve);
    return reached ? `${reached.cells} cells, ${reached.cumulative_seconds.toFixed(2)} s${reached.as_fast_as_the_first ? ' ✓' : ''}` : '–';
  };
  const show = (chosen) => {
    const row = thresholds[chosen];
    holder.replaceChildren(paragraph(row.in_words), table(['Strategy', ...elements],
      names('strategy').map((strategy) => [strategy, ...elements.map((name) => achieved(row, { strategy, element: name }))])));
  };
  const first = Math.max(0, thresholds.findIndex((row) => !isOfEta(row) && row.threshold === 0.001 && row.reached.length > 0));
  const choice = selection('Error: ', thresholds.map((row) => isOfEta(row) ? `η of ${percentage(row.threshold, 3)}` :
    `${percentage(row.threshold, 3)} of the peak force`), show, first);
  show(first);
  section('Fastest strategies', paragraph('Cells of the first mesh from which on the error stays below the chosen one, and the seconds until then. ' +
    'The last mesh of a curve counts only if its own error bar confirms it. ✓: the fastest, or slower by at most a tenth.'),
  element('div', { className: 'controls' }, choice), holder);
}

/** Which curves a reader may look at: those of the best elements, of all, of one. */
function viewsOf(curves, best) {
  const elements = [...new Set(curves.map((curve) => curve.element))];
  return [['the best of each strategy', (curve) => best.includes(curve)], ['all', () => true],
    ...elements.map((name) => [name, (curve) => curve.element === name])]
    .slice(0, elements.length > 1 ? undefined : 1)
    .map(([title, shows]) => ({ title, shows: ({ curve }) => !curve || shows(curve) }));
}

function showCosts(comparison, colourOf) {
  const { curves, reference } = comparison, best = bestOfStrategies(comparison);
  const costs = [['seconds, start-up not included [s]', 'cumulative_seconds'], ['unknowns', 'degrees_of_freedom'], ['cells', 'cells']];
  const column = (curve, key, factor = 1) => curve.meshes.map((mesh) => factor * mesh[key]);
  const pointsOf = (curve, key) => ({ curve, marker: curve.element, x: column(curve, costs[0][1]),
    moreX: costs.slice(1).map(([, cost]) => column(curve, cost)), y: column(curve, key, 100) });
  const [x, ...moreX] = costs.map(([title]) => ({ title, logarithmic: true }));
  const list = [['error of the peak force [%]', 'peak_force_error'], ['η [%]', 'discretization_error']].map(([title, key]) => ({
    title, x, moreX, y: { title, logarithmic: true }, views: viewsOf(curves, best),
    series: curves.filter(({ strategy }) => key === 'peak_force_error' || !strategy.endsWith('by force'))
      .map((curve) => ({ ...pointsOf(curve, key), name: curve.strategy, colour: colourOf(curve), style: 'line and points' })) }));
  for (const curve of curves) {
    const limited = { ...curve, meshes: curve.meshes.filter((mesh) => mesh.cells_at_minimum_size > 0) };
    if (limited.meshes.length > 0)
      ['peak_force_error', 'discretization_error'].forEach((key, i) => list[i].series.unshift({ ...pointsOf(limited, key), curve,
        name: 'cells at the minimum size', colour: colourOf({}), style: 'points' }));
  }
  if (reference.uncertainty > 0) {
    const [first, ...others] = costs.map(([, cost]) => rangeOf(curves.flatMap((curve) => column(curve, cost))));
    list[0].series.push({ name: 'uncertainty of the reference', colour: colourOf({}), style: 'dashed', x: first, moreX: others,
      y: [0, 0].fill(100 * reference.uncertainty) });
  }
  section('Error against cost', paragraph('Every point is a mesh. Each strategy is shown with its best element; others can be chosen. The seconds of a mesh are those of the cycles up to it, without the start of the program. Errors of the peak force below the dashed line, ' +
    'the uncertainty of the reference, say nothing about the mesh. Strategies by force compute the impact up to the peak only, so their η cannot be compared with that of the others.'), plotGrid(list, 'large'));
}

/** A plot for every element with a series for every strategy. */
function plotsByElement(curves, colourOf, frame, seriesOf) {
  const elements = [...new Set(curves.map((curve) => curve.element))];
  return elements.map((title) => ({ ...frame, title, series: curves.filter((curve) => curve.element === title)
    .map((curve) => ({ name: curve.strategy, colour: colourOf(curve), style: 'line and points', ...seriesOf(curve) })) }));
}

function showEffectivity({ curves }, colourOf) {
  const known = (curve) => curve.meshes.filter((mesh) => mesh.effectivity !== undefined);
  if (curves.every((curve) => known(curve).length === 0)) return;
  const frame = { x: { title: 'cells', logarithmic: true }, y: { title: 'effectivity' } };
  section('Effectivity of the estimator', paragraph("η over the error in energy against the reference, on meshes whose η is at " +
    "least three times the reference's."), plotGrid(plotsByElement(curves, colourOf, frame, (curve) =>
    ({ x: known(curve).map((mesh) => mesh.cells), y: known(curve).map((mesh) => mesh.effectivity) })), 'small'));
}

function showForces({ comparison: { curves, reference }, histories }, colourOf) {
  const second = prefixed('s', histories.flatMap((history) => history?.time.at(-1) ?? 0)), newton = prefixed('N', [reference.peak_force]);
  const lines = (history) => history ? { x: second.of(history.time), y: newton.of(history.force) } : { x: [], y: [] };
  const frame = { x: { title: titled('time', second.name) }, y: { title: titled('force', newton.name) } };
  const list = plotsByElement(curves, colourOf, frame, (curve) => ({ style: 'line', ...lines(histories[curves.indexOf(curve)]) }));
  const ofReference = histories[curves.length];
  if (ofReference)
    for (const plot of list) plot.series.push({ name: 'reference', colour: colourOf({}), style: 'dashed', ...lines(ofReference) });
  section('Force histories', paragraph('On the last mesh of every curve.'), plotGrid(list, 'small'));
}

/** Cells and eta of both strategies where they keep eta at 5 %, element by element. */
function fairnessTable({ thresholds, curves }) {
  const atFivePercent = thresholds.find((row) => isOfEta(row) && row.threshold === 0.05);
  const meshOf = (strategy, element) => {
    const reached = reachedBy(atFivePercent, { strategy, element });
    return reached && curves.find((curve) => nameOf(curve) === nameOf(reached)).meshes.find((mesh) => mesh.cycle === reached.cycle);
  };
  const rows = [...new Set(curves.map((curve) => curve.element))]
    .map((name) => [name, meshOf('hanging nodes', name), meshOf('remeshing', name)])
    .filter(([, halved, remeshed]) => halved && remeshed)
    .map(([name, ...both]) => [name, ...both.map((mesh) => mesh.cells), ...both.map((mesh) => formatted(100 * mesh.discretization_error))]);
  return rows.length > 0 &&
    table(['Element', 'hanging nodes [cells]', 'remeshing [cells]', 'hanging nodes η [%]', 'remeshing η [%]'], rows);
}

function showFairness(comparison) {
  section('What is compared', paragraph('All curves share the initial cells, which those by force refine towards the load, time step, ' +
    'integrator, linear solver, load and error estimator. Whenever η meets the target error, the target is halved, so that every curve ' +
    'goes on to smaller errors. The cost of a mesh is what a user waits for it: assembly, transient, estimation and adaptation of its ' +
    'own cycle and of all before it; the start of the program is left out. Errors are those of the mesh: the reference has the same ' +
    'time step.'),
  paragraph('Hanging nodes halve sizes: a cell that needs a little less than its size gets half of it, up to four times the cells. ' +
    'Remeshing gives any size, but its cells are no parallelograms, on which elements of eight nodes (serendipity, and the deflection ' +
    'of heterosis) lose an order (Arnold, Boffi & Falk 2002); compare the strategies with MITC9 or Lagrange as well. The first meshes ' +
    'at η of at most 5 % show both effects:'), fairnessTable(comparison));
}

function showNumbers({ curves }) {
  const percent = (value) => value === undefined ? '–' : formatted(100 * value);
  const rows = curves.flatMap((curve) => curve.meshes.map((mesh) => [nameOf(curve), mesh.cycle,
    `${mesh.cells}${mesh.cells_at_minimum_size > 0 ? '*' : ''}`, mesh.degrees_of_freedom,
    percent(mesh.discretization_error), formatted(mesh.peak_force, 6),
    mesh.comparable ? percent(mesh.peak_force_error) : `(${percent(mesh.peak_force_error)})`, percent(mesh.peak_force_error_bar),
    percent(mesh.contact_end_error), formatted(mesh.effectivity), formatted(mesh.seconds), formatted(mesh.cumulative_seconds)]));
  section('All meshes', paragraph('Errors in parentheses are not above the uncertainty of the reference. A star marks meshes with cells that would be ' +
    'refined if they were not at the minimum size. The effectivity is η over the ' +
    'error in energy against the reference, where the reference is three times better. comparison.csv has all digits.'),
  table(['Strategy and element', 'Cycle', 'Cells', 'Unknowns', 'η [%]', 'Peak force [N]', 'Error [%]', 'Error bar [%]',
    'Error of contact end [%]', 'Effectivity', 'Seconds', 'Total [s]'], rows, 'sortable'),
  table(['Strategy and element', 'Ended by'], curves.map((curve) => [nameOf(curve), curve.end]), 'words'));
}

function showComparison(study) {
  const { comparison } = study, { curves } = comparison;
  const strategies = [...new Set(curves.map((curve) => curve.strategy))];
  const colourOf = ({ strategy }) => strategy ? strategies.indexOf(strategy) : strategies.length;
  showOutcome(comparison);
  showCosts(comparison, colourOf);
  showThresholds(comparison);
  showEffectivity(comparison, colourOf);
  showForces(study, colourOf);
  if (study.meshes.length > 0)
    section('Meshes', paragraph(`The first mesh of each curve whose η is at most ${percentage(study.target, 3)}, or its last that can be ` +
      `drawn. ${meshedPart(study.symmetric)}`), meshGroup(study.meshes, study.patch));
  showFairness(comparison);
  showNumbers(comparison);
  section('Scene', paragraph(`plate-impact ${comparison.version}; save as a .prm file and give it to plate-impact compare to repeat ` +
    'the comparison.'), preformatted(study.text));
}
