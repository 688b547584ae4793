'use strict';

const data = JSON.parse(document.getElementById('data').textContent);

/** A colour of page.css as it is now, in light or dark. */
function cssColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

function formatted(value, digits = 6) {
  if (value === null || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7))
    return value.toExponential(Math.max(0, digits - 1)).replace(/\.?0+e/, 'e');
  return String(Number(value.toPrecision(digits)));
}

// ---------------------------------------------------------------- plots

/** Of every series the point nearest in x to the pointer. */
Chart.Interaction.modes.nearestOfEach = (chart, event) => {
  const items = [];
  for (const meta of chart.getSortedVisibleDatasetMetas()) {
    let best = null, distance = Infinity;
    meta.data.forEach((element, index) => {
      const d = Math.abs(element.x - event.x);
      if (!element.skip && d < distance) { best = { element, datasetIndex: meta.index, index }; distance = d; }
    });
    if (best && distance < 30) items.push(best);
  }
  return items;
};

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
    ctx.beginPath();
    ctx.moveTo(active[0].element.x, chartArea.top);
    ctx.lineTo(active[0].element.x, chartArea.bottom);
    ctx.stroke();
    ctx.restore();
  }
});

function axis(description, overrides, values) {
  const result = {
    type: description.logarithmic ? 'logarithmic' : 'linear',
    title: { display: true, text: description.title, color: cssColour('text') },
    grid: { color: cssColour('line') },
    ticks: { color: cssColour('text'), maxRotation: 0 }, ...overrides
  };
  if (result.type === 'category') return result;
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

/** Series of the page as datasets of Chart.js. */
function datasets(plot) {
  const bars = plot.categories.length > 0;
  return plot.series.map((series) => {
    const y = data.arrays[series.y];
    const colour = cssColour('c' + (series.colour % 8));
    const dataset = { label: series.name, style: series.style, group: series.colour,
      backgroundColor: colour, borderColor: series.style === 'faint' ? colour + '90' : colour };
    if (bars) return { ...dataset, data: y, stack: 'all' };
    const x = data.arrays[series.x];
    const points = series.style.includes('points');
    return {
      ...dataset,
      data: x.map((value, i) => ({ x: value, y: y[i] })),
      showLine: series.style !== 'points',
      borderWidth: series.style === 'faint' ? 1 : 2,
      borderDash: series.style === 'dashed' ? [6, 4] : [],
      pointRadius: points ? 4 : 0, pointHoverRadius: 4,
      clip: points ? 8 : 2, order: series.style === 'faint' ? 1 : 0
    };
  });
}

/** Toggles a series together with its fainter companions of the same colour. */
function toggleSeries(event, item, legend) {
  const { chart } = legend;
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
  canvas.addEventListener('keydown', (event) => {
    const chart = Chart.getChart(canvas);
    const longest = Math.max(...chart.data.datasets.map((d) => d.data.length)) - 1;
    const step = { ArrowRight: 1, ArrowLeft: -1, PageUp: Math.ceil(longest / 20), PageDown: -Math.ceil(longest / 20),
      Home: -longest, End: longest }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    at = Math.min(longest, Math.max(0, at + step));
    const items = chart.getSortedVisibleDatasetMetas()
      .filter((meta) => at < meta.data.length)
      .map((meta) => ({ datasetIndex: meta.index, index: at }));
    chart.setActiveElements(items);
    chart.tooltip.setActiveElements(items, { x: 0, y: 0 });
    chart.update('none');
  });
  canvas.addEventListener('blur', () => {
    const chart = Chart.getChart(canvas);
    chart.setActiveElements([]);
    chart.tooltip.setActiveElements([], { x: 0, y: 0 });
    chart.update('none');
  });
}

function makePlot(canvas, plot) {
  const bars = plot.categories.length > 0;
  // points in the order of x need no parsing
  const sorted = plot.series.every((series) =>
    (data.arrays[series.x] ?? []).every((value, i, x) => i === 0 || x[i - 1] <= value));
  const unit = (title) => (title.match(/\[(.*)\]/) ?? ['', ''])[1];
  Chart.getChart(canvas)?.destroy();
  return new Chart(canvas, {
    type: bars ? 'bar' : 'line',
    data: { labels: bars ? plot.categories : undefined, datasets: datasets(plot) },
    options: {
      animation: false, maintainAspectRatio: false, parsing: bars || !sorted ? undefined : false,
      indexAxis: bars ? 'y' : 'x',
      interaction: bars ? { mode: 'index', axis: 'y', intersect: false } : { mode: 'nearestOfEach', intersect: false },
      scales: bars ?
        { x: axis(plot.x, { stacked: true }), y: axis(plot.y, { type: 'category', stacked: true }) } :
        { x: axis(plot.x, {}, plot.series.flatMap((series) => data.arrays[series.x])), y: axis(plot.y) },
      plugins: {
        legend: {
          display: plot.series.length > 1, position: 'bottom', onClick: toggleSeries,
          labels: { color: cssColour('text'), boxWidth: 24, boxHeight: bars ? 10 : 2,
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

const plots = Array.from(document.querySelectorAll('[data-plot]'), (holder) => {
  const plot = data.plots[holder.dataset.plot];
  const canvas = document.createElement('canvas');
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `${plot.title}: ${plot.y.title} over ${plot.x.title}. Left and right keys read values.`);
  if (plot.categories.length > 0) {
    holder.classList.add('flat');
    holder.style.height = 6 + 2.2 * plot.categories.length + 'rem';
  }
  holder.append(canvas);
  readByKeys(canvas);
  return [canvas, plot];
});

/** Draws all plots in the colours and the size of the medium. */
function drawPlots() {
  plots.forEach(([canvas, plot]) => makePlot(canvas, plot));
}

drawPlots();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawPlots);
matchMedia('print').addEventListener('change', drawPlots);
