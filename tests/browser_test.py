#!/usr/bin/env python3
"""Opens pages of several scenes in headless Chromium and checks them there.

    browser_test.py PROGRAM SCENES_DIRECTORY

Reports, a sweep over three entries and a comparison, as wide as a screen, a tablet
and a telephone: the words that belong there, no error on the console, every plot and map drawn, the slider moves
the film and its peak is one of its frames, keys read values, colours and size of
meshes and film change, legends hide and tables sort, nothing wider than the window, no
colour of the light page left in the dark. Exit status 77, "skipped", where there is no
Chromium.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BEFORE = """<script>
const problems = [];
addEventListener('error', (event) => problems.push('error: ' + event.message));
for (const kind of ['error', 'warn'])
  console[kind] = (...words) => problems.push(kind + ': ' + words.join(' '));
</script>"""

AFTER = """<script>
const expect = (holds, what) => { if (!holds) problems.push(what); };
const isDrawn = (canvas) => canvas.width > 0 &&
  new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)
    .some((pixel) => pixel !== 0);
/** Whether the area of a plot, its axes and legend apart, shows a colour of its series. */
const showsSeries = (chart) => {
  const { left, top, width, height } = chart.chartArea, ratio = chart.currentDevicePixelRatio;
  const pixels = chart.canvas.getContext('2d').getImageData(left * ratio, top * ratio, width * ratio, height * ratio).data;
  return chart.data.datasets.some(({ borderColor }) => {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(borderColor.slice(i, i + 2), 16));
    for (let i = 0; i < pixels.length; i += 4)
      if (Math.abs(pixels[i] - r) + Math.abs(pixels[i + 1] - g) + Math.abs(pixels[i + 2] - b) < 6 && pixels[i + 3] > 250)
        return true;
    return false;
  });
};
const key = (element, name) => element.dispatchEvent(new KeyboardEvent('keydown', { key: name }));

for (const { canvas, plot } of plots) {
  expect(canvas.isConnected && isDrawn(canvas), plot.title + ': not drawn');
  const chart = Chart.getChart(canvas);
  expect(showsSeries(chart), plot.title + ': no series in its colour');
  expect(chart.data.datasets.length === plot.series.length, plot.title + ': series missing');
  expect(canvas.tabIndex === 0, plot.title + ': not reached by keys');
  key(canvas, 'ArrowRight');
  expect(chart.tooltip.getActiveElements().length > 0 && chart.tooltip.title.length > 0,
    plot.title + ': keys read nothing');
  canvas.dispatchEvent(new Event('blur'));
}

for (const { canvas, plot } of plots) {
  const chart = Chart.getChart(canvas);
  const buttons = [...canvas.closest('figure').querySelectorAll('.save button')].map((button) => button.textContent);
  expect(buttons.join() === 'SVG,PNG,CSV', plot.title + ': cannot be saved');
  const rows = csvOf(chart, plot).trim().split('\\n').length - 1;
  const shown = chart.data.datasets.reduce((n, d, i) => n + (chart.isDatasetVisible(i) ? d.data.length : 0), 0);
  expect(rows === shown, plot.title + ': ' + rows + ' rows of ' + shown);
  const svg = new DOMParser().parseFromString(svgOf(chart, plot), 'image/svg+xml');
  expect(svg.querySelector('parsererror') === null && svg.querySelectorAll('polyline, circle, rect').length > 1 &&
    !svgOf(chart, plot).includes('NaN'), plot.title + ': no SVG');
}

const matrix = [...document.querySelectorAll('section')].find((part) => part.textContent.startsWith('Fastest strategies'));
if (matrix) {
  const select = matrix.querySelector('select'), seen = new Set();
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    seen.add(matrix.querySelector('div p').textContent);
  }
  expect(seen.size === data.comparison.thresholds.length, 'who is first: does not change with the error');
  const { strategy } = data.comparison.curves[0];
  expect(matrix.querySelector('tbody th').textContent === strategy, 'who is first: no row for ' + strategy);
}
const legend = document.querySelector('.legend');
if (legend) {
  const charts = [...legend.nextElementSibling.querySelectorAll('canvas')].map((canvas) => () => Chart.getChart(canvas));
  const select = legend.querySelector('select'), titles = new Set();
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    titles.add(charts.map((chart) => chart().options.scales.x.title.text).join());
  }
  expect(titles.size === select.options.length && titles.size > 1, 'legend: the abscissa does not change');
  const elements = legend.querySelectorAll('select')[1];
  const labels = () => charts[0]().data.datasets.filter((_, i) => charts[0]().isDatasetVisible(i)).map(({ label }) => label);
  const few = labels().length;
  for (const option of elements?.options ?? []) {
    elements.value = option.value;
    elements.dispatchEvent(new Event('change'));
    if (option.text === 'all') expect(labels().length > few, 'legend: not all curves are shown');
    else if (Number(option.value) > 1)
      expect(labels().every((label) => !label.includes(', ') || label.endsWith(option.text)), 'legend: other elements than ' + option.text);
  }
  for (const button of legend.querySelectorAll('button')) {
    const visible = () => charts.map((chart) => chart().getVisibleDatasetCount()).join();
    const before = visible();
    button.click();
    expect(visible() !== before && button.getAttribute('aria-pressed') === 'false', button.textContent + ': not hidden');
    button.click();
    expect(visible() === before, button.textContent + ': not shown again');
  }
}
for (const table of document.querySelectorAll('table.sortable')) {
  const column = () => [...table.tBodies[0].rows].map((row) => Number(row.cells[2].textContent));
  const button = table.tHead.rows[0].cells[2].querySelector('button');
  button.click();
  expect(column().every((value, i, all) => i === 0 || all[i - 1] <= value), 'table: not sorted');
  button.click();
  expect(column().every((value, i, all) => i === 0 || all[i - 1] >= value), 'table: not sorted downwards');
}

const player = document.querySelector('.player');
if (player) {
  const canvas = player.querySelector('canvas'), slider = player.querySelector('input');
  expect(isDrawn(canvas), 'film: not drawn');
  const seen = new Set(), read = new Set();
  for (const frame of [0, slider.max / 2, slider.max]) {
    slider.value = frame;
    slider.dispatchEvent(new Event('input'));
    seen.add(canvas.toDataURL());
    read.add(player.querySelector('.readout').textContent);
  }
  expect(seen.size === 3 && read.size === 3, 'film: the slider does not move it');
  const select = player.querySelector('select'), colours = new Set(), scales = new Set();
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    colours.add(canvas.toDataURL());
    scales.add(player.querySelector('.scale').textContent);
  }
  expect(colours.size === select.options.length && scales.size === colours.size, 'film: the field does not change');
  const oblique = canvas.toDataURL();
  [...player.querySelectorAll('button')].find((button) => button.textContent === 'from above').click();
  expect(canvas.toDataURL() !== oblique, 'film: not seen from above');
  const turned = canvas.toDataURL();
  key(canvas, 'ArrowLeft');
  expect(canvas.toDataURL() !== turned, 'film: keys do not turn the plate');
  const zoomed = canvas.toDataURL();
  player.querySelectorAll('button.zoom')[2].click();
  expect(canvas.toDataURL() !== zoomed && isDrawn(canvas), 'film: the contact is not shown');
  player.querySelectorAll('button.zoom')[3].click();
  expect(canvas.toDataURL() === zoomed, 'film: the whole plate is not shown again');
  key(canvas, '+');
  expect(canvas.toDataURL() !== zoomed, 'film: keys do not change its size');
  key(canvas, '0');
  const largest = Math.max(...data.film.forces);
  expect(Math.abs(largest / data.summary.cycles.at(-1).peak_force - 1) < 2e-3, 'film: the peak is no frame');
  player.querySelector('button').click();
  expect(slider.value === '0', 'film: does not play from the beginning');
  player.querySelector('button').click();
}

const lines = [...document.querySelectorAll('section')].find((part) => part.textContent.startsWith('Raw and recovered'));
expect(Boolean(lines) === (data.stresses ?? []).length > 0, 'stresses along lines: missing, or without an impact');
if (lines) {
  const select = lines.querySelector('select'), canvas = lines.querySelector('canvas'), seen = new Set();
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    seen.add(JSON.stringify(Chart.getChart(canvas).data.datasets.map(({ data }) => data)));
  }
  expect(seen.size === select.options.length, 'stresses along lines: the field does not change');
}

for (const group of document.querySelectorAll('.mesh-group')) {
  const pictures = [...group.querySelectorAll('svg')], buttons = group.querySelectorAll('button.zoom');
  const view = () => pictures.map((picture) => picture.getAttribute('viewBox'));
  const whole = view();
  buttons[2].click();
  expect(view().every((box, i) => box !== whole[i] && !box.includes('NaN')), 'meshes: the contact is not shown');
  const { x, y, width, height } = pictures[0].viewBox.baseVal, at = pictures[0].dataset;
  expect(x <= at.x && at.x <= x + width && y <= at.y && at.y <= y + height, 'meshes: the contact is elsewhere');
  // some of the smallest cells are at the patch; places have three decimals
  const cells = [...pictures.at(-1).querySelectorAll('polygon')].map((cell) => cell.getBBox());
  const least = Math.min(...cells.map((cell) => cell.width));
  if (pictures.at(-1).querySelector('circle.patch') && cells.length > 100)
    expect(cells.some((cell) => cell.width < least + 0.02 && x <= cell.x + 1 && cell.x <= x + width &&
      y <= cell.y + 1 && cell.y <= y + height), 'meshes: no small cell at the contact');
  buttons[3].click();
  expect(view().join() === whole.join(), 'meshes: not whole again');
  key(pictures[0], '+');
  expect(view().join() !== whole.join(), 'meshes: keys do not change their size');
  key(pictures[0], '0');
  expect(pictures.every((picture) => /^[1-9]+0* .?m$/.test(picture.querySelector('.scalebar text').textContent)),
    'meshes: no scale bar');
  const select = group.querySelector('select');
  if (!select) continue;
  const fills = () => [...group.querySelectorAll('polygon')].map((cell) => cell.getAttribute('fill')).join();
  const seen = new Set();
  for (const option of select.options) {
    select.value = option.value;
    select.dispatchEvent(new Event('change'));
    seen.add(fills());
  }
  expect(seen.size === select.options.length, 'meshes: colours do not change with the field');
  expect(!fills().includes('NaN'), 'meshes: a colour is not a number');
}
const maps = [...document.querySelectorAll('.map')];
for (const map of maps) {
  const title = map.previousSibling.textContent, cells = [...map.querySelectorAll('rect')];
  const fills = cells.map((cell) => cell.getAttribute('fill'));
  const values = cells.map((cell) => Number(cell.textContent.split(': ').at(-1)));
  const scale = [...map.querySelectorAll('.labels span')].map((label) => Number(label.textContent));
  expect(!fills.join().includes('NaN'), title + ': a colour is not a number');
  expect(new Set(fills).size > 1 || Math.min(...values) === Math.max(...values), title + ': one colour');
  expect(Math.min(...values) >= scale[0] * (1 - 1e-3) && Math.max(...values) <= scale[2] * (1 + 1e-3), title + ': beyond its scale');
}

for (const grid of new Set(maps.map((map) => map.closest('.grid')))) {
  const quantity = data.quantities.find(({ title }) => title === grid.previousSibling.textContent);
  expect(grid.querySelectorAll('rect').length === quantity.values.filter((value) => value !== null).length,
    quantity.title + ': cells missing');
}

const words = document.getElementById('content').textContent.replace(/\s+/g, ' ');
for (const [word, isThere] of WORDS) expect(words.includes(word) === isThere, word + (isThere ? ' is missing' : ' is too much'));
expect(!/undefined|NaN|\[object/.test(document.getElementById('content').textContent), 'something is undefined');
expect(document.querySelectorAll('nav a').length === document.querySelectorAll('section h2').length, 'sections missing in the contents');

const dark = matchMedia('(prefers-color-scheme: dark)').matches;
const ground = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
expect(dark === DARK, 'not seen in the ' + (DARK ? 'dark' : 'light'));
expect(dark === (ground[0] < 128), 'wrong ground for ' + (dark ? 'dark' : 'light'));
expect(innerWidth === WIDTH, 'seen ' + innerWidth + ' pixels wide');
expect(document.documentElement.scrollWidth <= innerWidth, 'wider than the window: ' +
  document.documentElement.scrollWidth + ' > ' + innerWidth);
parent.postMessage(JSON.stringify({ plots: plots.length, film: Boolean(player), maps: maps.length,
  meshes: document.querySelectorAll('.mesh-group svg').length, problems }), '*');
</script>"""

# a window of Chromium is at least 500 pixels wide, a frame within it is not
FRAME = """<!DOCTYPE html><html><head><meta name="color-scheme" content="light dark"><title></title></head><body>
<iframe src="probed.html" width="WIDTH" height="1000" style="border: 0"></iframe>
<script>addEventListener('message', (event) => { document.title = event.data; });</script></body></html>"""


def seen_in_browser(browser, page, width, dark, words, directory):
    """What the probe finds on a page as wide as that, with words and whether they belong there."""
    html = page.read_text(encoding="utf-8")
    after = AFTER.replace("WIDTH", str(width)).replace("DARK", "true" if dark else "false")
    after = after.replace("WORDS", json.dumps(list(words.items())))
    (directory / "probed.html").write_text(
        html.replace("<head>", "<head>" + BEFORE, 1).replace("</body>", after + "</body>", 1),
        encoding="utf-8")
    frame = directory / "frame.html"
    frame.write_text(FRAME.replace("WIDTH", str(width)), encoding="utf-8")
    dom = subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         f"--user-data-dir={directory / 'profile'}", "--window-size=1500,1200",
         *(["--blink-settings=preferredColorScheme=0"] if dark else []),
         "--virtual-time-budget=5000", "--dump-dom", frame.as_uri()],
        capture_output=True, text=True, timeout=300, check=True).stdout
    title = re.search(r"<title>(.*?)</title>", dom, re.DOTALL).group(1)
    if not title.startswith("{"):
        return {"plots": 0, "film": False, "maps": 0, "meshes": 0, "problems": ["a script of the page stops before its end"]}
    return json.loads(title.replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"))


def main():
    program, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        print("skipped: Chromium is not installed (Debian package chromium)")
        return 77

    coarse = ["Time/Time step=1e-6"]
    one_mesh = ["Adaptivity/Strategy=none", "Contact/Patch radius=5e-4"]
    three_entries = ["Sweep/Entry 1=Impactor/Velocity", "Sweep/Values 1=1:2:4",
                     "Sweep/Entry 2=Impactor/Mass", "Sweep/Values 2=0.01:0.04:4",
                     "Sweep/Entry 3=Plate/Thickness", "Sweep/Values 3=0.004, 0.008"]
    small_comparison = ["Comparison/Maximum cycles=2", "Comparison/Reference peak force=1301",
                        "Comparison/Strategies=uniform, hanging nodes", "Comparison/Elements=MITC9, serendipity"]
    struck = {"Within the limits of the model": True, "Zener": True, "change in the last cycle": True}
    still = {"Nothing strikes": False, "Zener": False, "Histories": False, "Animation": False, "η": False}
    alone = {"Zener": True, "change in the last cycle": False, "every cell halved": True,
             "by the late peak on a softer plate": False}
    late = {"by the late peak on a softer plate": True, "too coarse to tell": False}
    blind = {"too coarse to tell": True, "Far outside the limits of the model": False}
    # command, scene, entries; what the page has at least: plots, maps, meshes; whether a film; words that it has or not
    cases = [
        ("run", "sphere-on-steel-plate.prm", coarse, (11, 0, 3), True, struck),
        ("run", "sphere-on-steel-plate.prm", coarse + ["Impactor/Shape=none"], (1, 0, 1), False, still),
        ("run", "sphere-on-steel-plate.prm", coarse + ["Adaptivity/Strategy=none", "Adaptivity/Verify=true"],
         (5, 0, 1), True, alone),
        ("run", "compare-thin-plate.prm", ["Adaptivity/Strategy=none"], (5, 0, 1), True, blind),
        ("run", "paper-cylinder.prm", ["Adaptivity/Maximum cycles=2"], (8, 0, 2), True, {"a lower bound for a cylinder": True}),
        ("run", "off-centre.prm", [], (8, 0, 2), True, {"The whole plate.": True}),
        ("run", "drop-weight.prm", [], (8, 0, 2), True, late),
        ("run", "extremes/long-plate.prm", ["Adaptivity/Maximum cycles=2"], (8, 0, 2), True, {}),
        ("sweep", "sphere-on-steel-plate.prm", coarse + one_mesh + three_entries, (0, 8, 0), False,
         {"failed: 0": True, "Thickness = 0.004 m": True}),
        ("compare", "sphere-on-steel-plate.prm", coarse + small_comparison, (2, 0, 2), False,
         {"given by the scene": True, "hanging nodes, MITC9": True}),
    ]
    page_of = {"run": "report.html", "sweep": "sweep.html", "compare": "comparison.html"}
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for command, scene, entries, least, has_film, words in cases:
            overrides = [word for entry in entries for word in ("--set", entry)]
            subprocess.run([program, command, scenes / scene, "--quiet", "--output",
                            directory / "results", *overrides],
                           check=True, stderr=subprocess.DEVNULL)
            page = directory / "results" / page_of[command]
            for width, dark in ((1400, False), (800, False), (390, False), (1400, True)):
                found = seen_in_browser(browser, page, width, dark, words, directory)
                problems = found["problems"]
                for kind, number in zip(("plots", "maps", "meshes"), least):
                    if found[kind] < number:
                        problems.append(f"{found[kind]} {kind}, expected {number}")
                if found["film"] != has_film:
                    problems.append("film: " + ("missing" if has_film else "not expected"))
                if page.stat().st_size > 3e6:
                    problems.append(f"{page.stat().st_size} bytes")
                print(f"{command} {scene} {' '.join(entries)}, {width} pixels{', dark' if dark else ''}: "
                      f"{'; '.join(problems) or 'as expected'}", flush=True)
                failures += bool(problems)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
