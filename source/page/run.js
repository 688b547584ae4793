// ---------------------------------------------------------------- report.html

/** Quantities of the table of cycles: title, key of a cycle in summary.json, unit; % for fractions. */
const quantitiesOfCycles = [
  ['Cells', 'cells', ''], ['Unknowns', 'degrees_of_freedom', ''], ['Smallest cell', 'min_cell_size', 'm'],
  ['η', 'discretization_error', '%'], ['largest ξ′', 'max_element_error', ''],
  ['Cells with ξ′ ≥ 1', 'cells_above_limit', ''], ['Peak force', 'peak_force', 'N'],
  ['Error bar of the peak force', 'peak_force_error_bar', '%'], ['Time of the peak force', 'time_of_peak_force', 's'],
  ['First contact ends', 'first_contact_end', 's'], ['Contacts', 'number_of_contacts', ''],
  ['Impulse', 'impulse', 'N s'], ['Final velocity of the impactor', 'final_impactor_velocity', 'm/s'],
  ['Largest displacement of the plate', 'max_plate_displacement', 'm'],
  ['Contact radius over the thickness', 'contact_radius_over_thickness', ''], ['Contact pressure', 'contact_pressure', 'Pa'],
  ['Mean contact pressure over the yield strength', 'mean_pressure_over_yield_strength', ''],
  ['Dent', 'permanent_indentation', 'm'], ['Energy dissipated by the contact', 'dissipated_energy', 'J'],
  ['Energy dissipated by the plate', 'plate_dissipated_energy', 'J'],
  ['Largest stress of the plate', 'max_effective_stress', 'Pa'], ['Energy drift', 'relative_energy_drift', '']];

/** What a reader looks for first: peak force, Zener's beside it, contact, rebound, error, outcome. */
function factsOfRun({ summary, expected, words }) {
  const last = summary.cycles.at(-1), { inputs } = summary, bar = last.peak_force_error_bar;
  const ofForce = last.peak_force === undefined ? [] : [
    ['Peak force', words.force, `at ${withUnit(last.time_of_peak_force, 's')}` +
      (bar ? '; the error is that of mesh and time step; that of the model is below' : '')],
    ["Zener's infinite thin plate", withUnit(expected.force, 'N'), `at ${withUnit(expected.time, 's')}` +
      (inputs['Impactor/Shape'] === 'cylinder' ? ', struck at a point: a lower bound for a cylinder' : '') +
      `; this run: ${deviation(last.peak_force, expected.force)}`],
    last.first_contact_end && ['First contact ends', withUnit(last.first_contact_end, 's'), `contacts: ${last.number_of_contacts}`],
    ['Final velocity of the impactor', withUnit(last.final_impactor_velocity, 'm/s'),
      `positive towards the plate; impulse ${withUnit(last.impulse, 'N s')}`],
    ['Largest displacement under the load', withUnit(last.max_plate_displacement, 'm'),
      `at the peak force ${withUnit(last.plate_displacement_at_peak, 'm')}`],
    last.max_fibre_stress !== undefined && ['Largest stresses of the plies', withUnit(last.max_fibre_stress, 'Pa'),
      `along the fibres, ${withUnit(last.max_transverse_stress, 'Pa')} across them and ${withUnit(last.max_ply_shear_stress, 'Pa')} ` +
      'in shear, at the faces of the plies, of plate theory under the spread load'],
    last.dissipated_energy !== undefined && ['Energy dissipated by the contact', withUnit(last.dissipated_energy, 'J'),
      `which leaves a dent of ${withUnit(last.permanent_indentation, 'm')}`],
    last.plate_dissipated_energy !== undefined && ['Energy dissipated by the plate', withUnit(last.plate_dissipated_energy, 'J'),
      `loss factor ${formatted(Number(inputs['Plate/Loss factor']))} at the first natural frequency` +
        (last.loss_factor_of_contact === undefined ? '' : `, ${formatted(last.loss_factor_of_contact, 2)} at that of the contact`)],
    last.max_effective_stress !== undefined &&
      ['Largest stress of the plate', withUnit(last.max_effective_stress, 'Pa'),
        'von Mises, at the faces, of plate theory under the spread load; not that of the contact' +
        (last.contact_pressure === undefined ? '' : `, whose pressure reaches ${withUnit(last.contact_pressure, 'Pa')}`)]];
  return facts([...ofForce,
    ['Outcome', summary.outcome,
      `cycles: ${summary.cycles.length}, cells: ${last.cells}, unknowns: ${formatted(last.degrees_of_freedom, 6)}`]]);
}

/** What the peak force depends on, and how much of it is known: mesh, time step, load. */
function evidenceOfRun({ summary, words }) {
  const last = summary.cycles.at(-1), before = summary.cycles.at(-2);
  const rows = [
    last.discretization_error !== undefined && ['Mesh: estimated error', `η = ${percentage(last.discretization_error)} in the energy norm, ` +
      `target ${percentage(Number(summary.inputs['Adaptivity/Target error']))}` +
      (summary.inputs['Adaptivity/Goal'] === 'peak force' ? ' (not the goal of this run)' : '') +
      `; largest ξ′ ${formatted(last.max_element_error)}; what that means for the peak force is the next row.` +
      (last.singular_cells ? ` ${last.singular_cells} cells are at the point load: ${percentage(last.discretization_error_of_all_cells)} ` +
        `with them, ${percentage(last.discretization_error_of_regular_cells)} without.` : '')],
    last.peak_force_error_bar !== undefined ?
      ['Mesh: error of the peak force', `${percentage(last.peak_force_error_space, 3)} ${words.estimate}`] :
      last.peak_force_error_estimate !== undefined && ['Mesh: error of the peak force', 'not known: the mesh or the time step is too coarse to tell'],
    last.verification && ['Mesh: every cell halved', `${deviation(last.verification.peak_force, last.peak_force)} ` +
      `(to ${withUnit(last.verification.peak_force, 'N')} on ${last.verification.cells} cells)`],
    before && ['Mesh: change in the last cycle',
      `${deviation(last.peak_force, before.peak_force)} (from ${withUnit(before.peak_force, 'N')})`],
    ['Time step', `${withUnit(last.time_step, 's')}, ${last.steps} steps` +
      (last.time_error === undefined ? '' : `; estimated error of the peak force ${percentage(last.time_error)}`) +
      `; energy drift ${formatted(last.relative_energy_drift)}` +
      (last.first_contact_end ? `; ${Math.round(last.first_contact_end / last.time_step)} of the steps in the first contact` : '')],
    ['Local response under the contact',
      `${words.localResponse}; contact radius ${formatted(last.contact_radius_over_thickness)} of the thickness`],
    ['Load', `${words.load}; smallest cell ${withUnit(last.min_cell_size, 'm')}`],
    ['Model: errors from comparisons', (summary.verdict.model.errors ?? []).map(({ of, relative }) =>
      `${of} ${relative === undefined ? 'not known' : percentage(relative, 2)}`).join('; ')],
    ['Contact', summary.verdict.contact],
    summary.verdict.damage && ['Damage', summary.verdict.damage]];
  return table(['What the peak force depends on', 'Evidence'], rows.filter(Boolean), 'words');
}

/** What an axis shows: 0 and the quantities of one history, round, with a little room above. */
function extentOf(values) {
  const low = Math.min(0, ...values), high = Math.max(0, ...values);
  const step = high > low ? 10 ** Math.floor(Math.log10(high - low)) / 5 : 1;
  return [Math.floor(low / step) * step, Math.ceil(1.02 * high / step) * step];
}

/** Quantities of all cycles over time, those before the last thin.
    @param keys  of the columns by the names of their curves; one has the names of the cycles */
function historyPlot({ histories, summary }, title, unit, keys) {
  const last = histories.at(-1), time = prefixed('s', last.time);
  const ofLast = Object.values(keys).flatMap((key) => last[key]), scale = prefixed(unit, ofLast);
  const series = histories.flatMap((history, n) => Object.entries(keys).map(([name, key], colour) => {
    const cycle = `cycle ${summary.cycles[n].cycle}`;
    return { name: name === '' ? cycle : history === last ? name : `${name}, ${cycle}`,
      x: time.of(history.time), y: scale.of(history[key]), colour, style: history === last ? 'line' : 'faint' };
  }));
  return { title, x: { title: titled('time', time.name) },
    y: { title: titled(title, scale.name), limits: extentOf(scale.of(ofLast)) }, series };
}

function showHistories(study) {
  const last = study.histories.at(-1), peak = Math.max(...last.force), at = last.time[last.force.indexOf(peak)];
  const force = historyPlot(study, 'Force', 'N', { '': 'force' });
  const newton = prefixed('N', last.force), second = prefixed('s', last.time);
  force.series.push({ name: `peak, ${newton.text(peak)} at ${second.text(at)}`, x: second.of([at]), y: newton.of([peak]),
    colour: 1, style: 'points' });
  section('Histories', plotGrid([force]),
    plotGrid([
      historyPlot(study, 'Displacement', 'm',
        { plate: 'plate_displacement', impactor: 'impactor_displacement', indentation: 'indentation' }),
      historyPlot(study, 'Energy', 'J',
        { impactor: 'impactor_energy', plate: 'plate_energy', contact: 'contact_energy', total: 'total_energy',
          ...(last.dissipated_energy.at(-1) > 0 && { 'dissipated by the contact': 'dissipated_energy' }),
          ...(last.plate_dissipated_energy.at(-1) > 0 && { 'dissipated by the plate': 'plate_dissipated_energy' }) })]),
    paragraph('Point at a curve, or use the arrow keys, to read its values; click a name to hide its curve. Cycles before the last are thin. ' +
      'contact_history.csv has every step.'));
}

/** All quantities that the last cycle has, a row each with its unit, a column per cycle: few cycles beside
    each other fit any screen. */
function tableOfCycles(cycles) {
  const rows = quantitiesOfCycles.filter(([, key]) => cycles.at(-1)[key] !== undefined).map(([title, key, unit]) => {
    const values = cycles.map((cycle) => cycle[key] ?? null);
    const scale = unit === '%' ? { name: '%', of: () => values.map((value) => value === null ? null : 100 * value) } : prefixed(unit, values);
    // whole numbers, and what is compared from cycle to cycle
    return [titled(title, scale.name), ...scale.of(values).map((value) =>
      formatted(value, key === 'peak_force' || Number.isInteger(value) ? 6 : 4))];
  });
  return table(['Cycle', ...cycles.map(({ cycle }) => String(cycle))], rows);
}

function showCycles({ summary: { cycles }, errors }) {
  const over = (key, factor = 1) => cycles.map((cycle) => cycle[key] === undefined ? null : factor * cycle[key]);
  const plot = (title, unit, key, logarithmic, factor) => ({ title, x: { title: 'cycle' }, y: { title: titled(title, unit), logarithmic },
    series: [{ name: title, x: over('cycle'), y: over(key, factor), colour: 0, style: 'line and points' }] });
  const seconds = over('cumulative_seconds'), eta = over('discretization_error', 100);
  const stages = Object.keys(cycles.at(-1).seconds).filter((stage) => stage !== 'total');
  const second = prefixed('s', errors.at(-1)?.time ?? []);
  section('Cycles', tableOfCycles(cycles),
    cycles.length > 1 && plotGrid([
      plot('η', '%', 'discretization_error', true, 100), plot('peak force', 'N', 'peak_force'),
      plot('unknowns', '', 'degrees_of_freedom', true),
      { title: 'Error against time', caption: 'Slope −1: the error halves when the time doubles.',
        x: { title: 'seconds since the beginning', logarithmic: true }, y: { title: 'error [%]', logarithmic: true },
        series: [
          { name: 'η', x: seconds, y: eta, colour: 0, style: 'line and points' },
          { name: 'error bar of the peak force', x: seconds, y: over('peak_force_error_bar', 100), colour: 1, style: 'line and points' },
          { name: 'slope −1', x: [seconds[0], seconds.at(-1)], y: [eta[0], eta[0] * seconds[0] / seconds.at(-1)], colour: 2, style: 'dashed' }]
      }], 'small'),
    errors.length > 0 && plotGrid([{ title: 'Relative error in the energy norm over time, η(t)',
      caption: '‖e‖ over the norm of the solution at the samples of the estimator; η is its mean with that norm as weight.',
      x: { title: titled('time', second.name) }, y: { title: 'η(t) [%]', logarithmic: true },
      series: errors.map(({ time, error }, n) => ({ name: `cycle ${cycles[n].cycle}`, x: second.of(time),
        y: error.map((value) => 100 * value), colour: 0, style: n + 1 < errors.length ? 'faint' : 'line' })) }]),
    plotGrid([{ title: 'Time by stage', x: { title: 'wall time [s]' }, y: { title: 'cycle' },
      categories: cycles.map(({ cycle }) => String(cycle)),
      series: stages.map((stage, colour) => ({ name: stage, colour, y: cycles.map((cycle) => cycle.seconds[stage]) })) }]));
}

/** A field along a line, as the elements have it and as it is recovered, on the first mesh and the last. */
function linePlot(stresses, line, field) {
  const { fields, lines } = stresses[0], { title, distance } = lines[line], metre = prefixed('m', distance);
  const scale = prefixed(fields[field].unit, stresses.flatMap((mesh) => mesh.lines.flatMap(({ raw }) => raw[field])));
  const series = stresses.flatMap((mesh, k) => ['recovered', 'raw'].map((kind, i) => ({
    name: `${kind}, cycle ${mesh.cycle}`, x: metre.of(mesh.lines[line].distance), y: scale.of(mesh.lines[line][kind][field]),
    colour: 2 * k + i, style: kind === 'raw' ? 'line' : 'dashed' })));
  return { title, x: { title: titled('distance from the impact', metre.name) }, y: { title: `[${scale.name}]` }, series: series.reverse() };
}

function showStressesAlongLines({ stresses }) {
  const at = plots.length, show = (field) => stresses[0].lines.map((_, line) => linePlot(stresses, line, field));
  const { fields } = stresses[0], first = fields.length - (fields.length > 6 ? 3 : 1);
  const grid = plotGrid(show(first), 'small'), entries = plots.slice(at);
  const choose = selection('Stress: ', fields.map(({ name }) => name), (field) => show(field).forEach((plot, i) => {
    entries[i].plot = plot;
    makePlot(entries[i]);
  }), first);
  section('Raw and recovered stresses', paragraph('Stresses at the peak force. The raw stresses of the elements jump from cell to cell; patch recovery ' +
    'fits polynomials to them. The estimator takes the difference of the two for the error.'),
  element('div', { className: 'controls' }, choose), grid);
}

/** Which part of the plate the meshes are, and where the impact is. */
function meshedPart([left, lower]) {
  if (left && lower) return 'A quarter of the plate; the impact is at the lower left corner.';
  if (left || lower) return `Half of the plate; the impact is on the ${left ? 'left' : 'lower'} side.`;
  return 'The whole plate.';
}

function showRun(study) {
  const { summary, histories, meshes, film } = study, { convergence, model, text } = summary.verdict;
  const struck = histories.length > 0;
  section('Outcome', verdict(convergence, text),
    struck && verdict(model, study.words.model),
    factsOfRun(study), struck && [heading('How far to trust the peak force'), evidenceOfRun(study)]);
  if (struck) showHistories(study);
  const shown = meshes.filter(Boolean);
  if (film) {
    const player = element('figure', { className: 'player' });
    section('Animation', paragraph(film.fields.length > 0 ? 'Deflection, local error ratio, stress resultants and stresses on the last mesh.' :
      'Deflection and local error ratio on the last mesh.'), player);
    new Film(player, study, shown.at(-1));
  }
  section('Meshes', paragraph(`${meshedPart(study.symmetric)} Resultants and stresses are those at the peak force, recovered, at the centres of the cells.`),
    shown.length < meshes.length && paragraph('Meshes of too many cells for a page are left out; see mesh_cycle_K.svg and Output/Field samples.'),
    shown.length > 0 && meshGroup(shown, study.patch));
  if (study.stresses.length > 0) showStressesAlongLines(study);
  showCycles(study);
  section('Repeat this run', paragraph(`plate-impact ${summary.version}. Save these values, which are in scene.prm too, and run`),
    preformatted('plate-impact run scene.prm'), preformatted(study.text));
}
