// ---------------------------------------------------------------- plots

/** A colour of page.css as it is now, in light or dark. */
function cssColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

/** Of every series the point nearest in x to the pointer. */
Chart.Interaction.modes.nearestOfEach = (chart, event) => chart.getSortedVisibleDatasetMetas().flatMap((meta) => {
  const distance = ({ element }) => Math.abs(element.x - event.x);
  const near = meta.data.map((element, index) => ({ element, datasetIndex: meta.index, index }))
    .filter((item) => !item.element.skip && distance(item) < 30);
  return near.length > 0 ? near.reduce((best, item) => (distance(item) < distance(best) ? item : best)) : [];
});

/** A vertical line at the point that is read. */
Chart.register({
  id: 'cursor',
  afterDatasetsDraw(chart) {
    const active = chart.tooltip?.getActiveElements() ?? [];
    if (!active.length || chart.config.type !== 'line') return;
    const { ctx, chartArea } = chart;
    ctx.save();
    ctx.strokeStyle = cssColour('faint');
    ctx.setLineDash([3, 3]);
    ctx.stroke(new Path2D(`M${active[0].element.x} ${chartArea.top}V${chartArea.bottom}`));
    ctx.restore();
  }
});

function axis(description, overrides, values) {
  const result = { type: description.logarithmic ? 'logarithmic' : 'linear', title: { display: true, text: description.title },
    ticks: { maxRotation: 0 }, ...overrides };
  if (result.type === 'category') return result;
  if (description.limits) [result.min, result.max] = description.limits;
  if (description.range) [result.suggestedMin, result.suggestedMax] = description.range;
  if (description.logarithmic) {
    result.afterBuildTicks = (scale) => {
      const decades = Math.log10(scale.max / scale.min);
      const shown = decades > 2.5 ? [1] : decades > 1.2 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 8];
      scale.ticks = scale.ticks.filter(({ value }) => {
        const lead = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
        return shown.some((s) => Math.abs(s - lead) < 1e-6);
      });
    };
    result.ticks.callback = (value) => formatted(value, 3);
  } else {
    result.ticks.callback = (value) => formatted(value, 5);
    if (values?.every(Number.isInteger) && Math.max(...values) - Math.min(...values) < 25) result.ticks.stepSize = 1;
  }
  return result;
}

/** Shapes of points, in the order of the names that series give them. */
const shapes = ['circle', 'rect', 'triangle', 'rectRot', 'star', 'crossRot'];

function shapeOf(marker, plot) {
  const names = [...new Set(plot.series.map((series) => series.marker).filter(Boolean))];
  return shapes[Math.max(0, names.indexOf(marker)) % shapes.length];
}

/** A plot over the abscissa that is chosen. */
function shown({ plot, view }) {
  return view.x === 0 ? plot : { ...plot, x: plot.moreX[view.x - 1],
    series: plot.series.map((series) => ({ ...series, x: series.moreX[view.x - 1] })) };
}

/** Series of the page as datasets of Chart.js. */
function datasets(plot, { hidden, chosen }) {
  const bars = Boolean(plot.categories);
  return plot.series.map((series) => {
    const colour = cssColour('c' + (series.colour % 8));
    const dataset = { label: series.marker ? series.name + ', ' + series.marker : series.name,
      hidden: hidden.has(series.name) || !(plot.views?.[chosen].shows(series) ?? true),
      pointStyle: shapeOf(series.marker, plot), style: series.style, group: series.colour,
      backgroundColor: colour, borderColor: series.style === 'faint' ? colour + '90' : colour };
    if (bars) return { ...dataset, data: series.y, stack: 'all' };
    const points = series.style.includes('points');
    return {
      ...dataset,
      data: series.x.map((value, i) => ({ x: value, y: series.y[i] })),
      showLine: series.style !== 'points',
      borderWidth: series.style === 'faint' ? 1 : 2,
      borderDash: series.style === 'dashed' ? [6, 4] : [],
      pointRadius: points ? 4 : 0, pointHoverRadius: 4,
      clip: points ? 8 : 2, order: series.style === 'faint' ? 1 : 0
    };
  });
}

/** Toggles a series together with its fainter companions of the same colour. */
function toggleSeries(event, item, { chart }) {
  const { group } = chart.data.datasets[item.datasetIndex];
  const show = !chart.isDatasetVisible(item.datasetIndex);
  chart.data.datasets.forEach((dataset, i) => {
    if (i === item.datasetIndex || (dataset.group === group && dataset.style === 'faint'))
      chart.setDatasetVisibility(i, show);
  });
  chart.update();
}

/** Left and right keys move the point that is read. */
function readByKeys(canvas) {
  let at = 0;
  const read = (chart, items) => {
    chart.setActiveElements(items);
    chart.tooltip.setActiveElements(items, { x: 0, y: 0 });
    chart.update('none');
  };
  canvas.onblur = () => read(Chart.getChart(canvas), []);
  canvas.onkeydown = (event) => {
    const chart = Chart.getChart(canvas);
    const longest = Math.max(...chart.data.datasets.map((d) => d.data.length)) - 1, page = Math.ceil(longest / 20);
    const step = { ArrowRight: 1, ArrowLeft: -1, PageUp: page, PageDown: -page, Home: -longest, End: longest }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    at = Math.min(longest, Math.max(0, at + step));
    read(chart, chart.getSortedVisibleDatasetMetas().filter((meta) => at < meta.data.length)
      .map((meta) => ({ datasetIndex: meta.index, index: at })));
  };
}

function makePlot(entry) {
  const { canvas, view } = entry, plot = shown(entry);
  const bars = Boolean(plot.categories);
  const unit = (title) => (title.match(/\[(.*)\]/) ?? ['', ''])[1];
  Chart.getChart(canvas)?.destroy();
  Object.assign(Chart.defaults, { color: cssColour('text'), borderColor: cssColour('line'), animation: false, maintainAspectRatio: false });
  return new Chart(canvas, {
    type: bars ? 'bar' : 'line',
    data: { labels: bars ? plot.categories : undefined, datasets: datasets(plot, view) },
    options: {
      indexAxis: bars ? 'y' : 'x',
      interaction: bars ? { mode: 'index', axis: 'y', intersect: false } : { mode: 'nearestOfEach', intersect: false },
      scales: bars ?
        { x: axis(plot.x, { stacked: true }), y: axis(plot.y, { type: 'category', stacked: true }) } :
        { x: axis(plot.x, {}, plot.series.flatMap((series) => series.x)), y: axis(plot.y) },
      plugins: {
        legend: {
          display: plot.series.length > 1 && !plot.series.some((series) => series.marker), position: 'bottom', onClick: toggleSeries,
          labels: { boxWidth: 24, boxHeight: bars ? 10 : 2,
            filter: (item, { datasets }) => datasets[item.datasetIndex].style !== 'faint' }
        },
        tooltip: {
          callbacks: {
            title: (items) => items.length === 0 ? '' : bars ? plot.y.title + ' ' + items[0].label :
              formatted(items[0].parsed.x) + ' ' + unit(plot.x.title),
            label: (item) => ' ' + item.dataset.label + ': ' + formatted(bars ? item.parsed.x : item.parsed.y) +
              ' ' + unit(bars ? plot.x.title : plot.y.title)
          }
        }
      }
    }
  });
}

/** Series of a plot that are shown, a row a point. */
function csvOf(chart, plot) {
  const rows = chart.data.datasets.filter((_, i) => chart.isDatasetVisible(i)).flatMap(({ label, data }) =>
    data.map((point, k) => plot.categories ? [label, point, plot.categories[k]] : [label, point.x, point.y]));
  const field = (value) => typeof value === 'number' ? value : `"${String(value ?? '').replaceAll('"', '""')}"`;
  return [['series', plot.x.title || 'x', plot.y.title || 'y'], ...rows].map((row) => `${row.map(field).join()}\n`).join('');
}

/** A point of a plot as SVG. */
function shapePath(shape, x, y, r, colour) {
  const corners = { rect: [[-1, -1], [1, -1], [1, 1], [-1, 1]], rectRot: [[0, -1.3], [1.3, 0], [0, 1.3], [-1.3, 0]],
    triangle: [[0, -1.2], [1.1, 0.8], [-1.1, 0.8]] }[shape];
  if (corners)
    return `<path d="M${corners.map(([u, v]) => `${(x + r * u).toFixed(2)} ${(y + r * v).toFixed(2)}`).join('L')}Z" fill="${colour}"/>`;
  if (shape === 'circle') return `<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${r}" fill="${colour}"/>`;
  const strokes = shape === 'star' ? [[1, 0], [0, 1], [0.7, 0.7], [0.7, -0.7]] : [[0.8, 0.8], [0.8, -0.8]];
  return `<path d="${strokes.map(([u, v]) => `M${(x - r * u).toFixed(2)} ${(y - r * v).toFixed(2)}l${2 * r * u} ${2 * r * v}`).join('')}" ` +
    `stroke="${colour}" stroke-width="1.5"/>`;
}

/** What a plot shows, as lines: axes, ticks and series where Chart.js has put them. */
function svgOf(chart, plot) {
  const { chartArea: area, scales, width, height } = chart;
  const text = (x, y, words, anchor = 'middle', more = '') => `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" ` +
    `text-anchor="${anchor}" ${more}>${String(words).replaceAll('&', '&amp;').replaceAll('<', '&lt;')}</text>`;
  const parts = [`<rect width="${width}" height="${height + 24}" fill="${cssColour('ground')}"/>`,
    text(width / 2, 16, plot.title, 'middle', 'font-weight="bold"'), '<g transform="translate(0 24)">'];
  const grid = (scale, lineAt, labelAt) => scale.ticks.forEach(({ label }, i) => {
    const at = scale.getPixelForTick(i);
    parts.push(`<path d="${lineAt(at.toFixed(1))}" stroke="${cssColour('line')}"/>`, labelAt(at, label));
  });
  grid(scales.x, (x) => `M${x} ${area.top}V${area.bottom}`, (x, label) => text(x, area.bottom + 15, label));
  grid(scales.y, (y) => `M${area.left} ${y}H${area.right}`, (y, label) => text(area.left - 5, y + 4, label, 'end'));
  parts.push(text((area.left + area.right) / 2, area.bottom + 31, plot.x.title),
    text(12, (area.top + area.bottom) / 2, plot.y.title, 'middle', `transform="rotate(-90 12 ${(area.top + area.bottom) / 2})"`),
    // a picture within the picture shows nothing beyond its edges
    `<svg x="${area.left}" y="${area.top}" width="${area.right - area.left}" height="${area.bottom - area.top}" ` +
      `viewBox="${area.left} ${area.top} ${area.right - area.left} ${area.bottom - area.top}">`);
  chart.getSortedVisibleDatasetMetas().reverse().forEach((meta) => {
    const dataset = chart.data.datasets[meta.index], colour = dataset.borderColor;
    const lines = [[]];
    for (const point of meta.data)
      if (point.skip || !Number.isFinite(point.x) || !Number.isFinite(point.y)) lines.push([]);
      else lines.at(-1).push(point);
    const points = lines.flat();
    if (plot.categories)
      points.forEach((bar) => parts.push(`<rect x="${Math.min(bar.base, bar.x)}" y="${bar.y - bar.height / 2}" ` +
        `width="${Math.abs(bar.x - bar.base)}" height="${bar.height}" fill="${dataset.backgroundColor}"/>`));
    else if (dataset.showLine !== false)
      lines.filter((line) => line.length > 0).forEach((line) =>
        parts.push(`<polyline fill="none" stroke="${colour}" stroke-width="${dataset.borderWidth}" ` +
          `stroke-dasharray="${dataset.borderDash.join(' ')}" points="${line.map((p) => p.x.toFixed(2) + ',' + p.y.toFixed(2)).join(' ')}"/>`));
    if (dataset.pointRadius > 0)
      points.forEach((p) => parts.push(shapePath(dataset.pointStyle, p.x, p.y, dataset.pointRadius, colour)));
  });
  parts.push('</svg></g>');
  const named = chart.data.datasets.filter((dataset, i) => chart.isDatasetVisible(i) && dataset.style !== 'faint');
  if (named.length > 1)
    named.forEach((dataset, i) => parts.push(text((i + 0.5) * width / named.length, height + 20, dataset.label, 'middle',
      `style="fill: ${dataset.borderColor}"`)));
  return `<svg xmlns="${svgElement('svg', {}).namespaceURI}" width="${width}" height="${height + 24}" ` +
    `font-family="sans-serif" font-size="12" fill="${cssColour('text')}">${parts.join('\n')}</svg>\n`;
}

/** Buttons that save a plot. */
function saveButtons(canvas, entry) {
  const { title } = entry.plot;
  const save = (name, url) => element('a', { href: url,
    download: `${title.replace(/[^\w]+/g, '-').toLowerCase() || 'plot'}.${name}` }).click();
  const file = (text, type) => URL.createObjectURL(new Blob([text], { type }));
  const ways = {
    SVG: () => save('svg', file(svgOf(Chart.getChart(canvas), shown(entry)), 'image/svg+xml')),
    PNG: () => save('png', canvas.toDataURL('image/png')),
    CSV: () => save('csv', file(csvOf(Chart.getChart(canvas), shown(entry)), 'text/csv'))
  };
  return element('div', { className: 'controls save' }, Object.entries(ways).map(([name, way]) =>
    button(name, way, { title: `Save the plot "${title}" as ${name}` })));
}

/** One legend for plots beside each other, by colours and by shapes, with the choices of the abscissa and of the series. */
function makeLegend(entries) {
  const { plot, view } = entries[0];
  const redraw = () => entries.forEach(makePlot);
  const bar = element('div', { className: 'controls legend' },
    selection('Against: ', [plot.x, ...plot.moreX].map((x) => x.title), (x) => { view.x = x; redraw(); }),
    plot.views.length > 1 && selection('Elements: ', plot.views.map(({ title }) => title), (chosen) => { view.chosen = chosen; redraw(); }));
  const named = (sign, name) => [element('span', { innerHTML: `<svg width="16" height="12" style="display: inline; width: 16px">${sign}</svg>` }),
    ` ${name}`];
  const toggle = ({ currentTarget }, name) => {
    if (!view.hidden.delete(name)) view.hidden.add(name);
    currentTarget.setAttribute('aria-pressed', String(!view.hidden.has(name)));
    redraw();
  };
  const once = (key) => [...new Map(plot.series.filter((series) => series[key]).map((series) => [series[key], series])).values()];
  for (const { name, colour } of once('name'))
    bar.append(button(named('<path d="M0 6h16" stroke="currentColor" stroke-width="3"/>', name), (event) => toggle(event, name),
      { 'aria-pressed': 'true', style: `color: var(--c${colour % 8})` }));
  for (const { marker } of once('marker'))
    bar.append(element('span', {}, named(shapePath(shapeOf(marker, plot), 8, 6, 5, 'currentColor'), marker)));
  return bar;
}

/** All plots of the page. */
const plots = [];

/** Plots beside each other where there is room. Those whose series have markers share one legend, by
    colours and by shapes, the choice of x, and that of the `views`: each has a `title` and tells by `shows` which
    series it has.

    A plot has a `title`, a `caption`, axes `x` and `y` (`title` with its unit, `logarithmic`; `range`, what
    it shows at least; `limits`, beyond which it shows nothing) and `series`: `name`, numbers `x` and `y`
    (null: a gap), `colour`, `style` (line; faint, which hides and shows with the series of the same colour;
    dashed, points, line and points), `marker` (those of one name have points of one shape) and `moreX`,
    numbers for the axes `moreX` that a reader may choose in place of x. With `categories` it is stacked
    horizontal bars, one for each category.
    @param size  small, for many, or large */
function plotGrid(list, size = '') {
  const view = { x: 0, hidden: new Set(), chosen: 0 }; // what they share: the abscissa, what is hidden, the view
  const entries = list.map((plot) => ({ plot, view, canvas: element('canvas', { tabIndex: 0, role: 'img',
    'aria-label': `${plot.title}: ${plot.y.title} over ${plot.x.title}. Left and right keys read values.` }) }));
  const figures = entries.map((entry) => {
    const { plot, canvas } = entry;
    const holder = element('div', { className: plot.categories ? 'plot flat' : 'plot' }, canvas);
    if (plot.categories) holder.style.height = 6 + 2.2 * plot.categories.length + 'rem';
    readByKeys(canvas);
    return element('figure', {}, element('h3', {}, plot.title), holder, saveButtons(canvas, entry),
      plot.caption && element('figcaption', {}, plot.caption));
  });
  plots.push(...entries);
  return [list[0]?.series.some((series) => series.marker) && makeLegend(entries),
    element('div', { className: `grid ${size} ${list.length === 1 ? 'single' : ''}` }, figures)];
}

/** Draws all plots in the colours and the size of the medium. */
const drawPlots = () => plots.forEach(makePlot);

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawPlots);
matchMedia('print').addEventListener('change', drawPlots);
