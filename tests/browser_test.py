#!/usr/bin/env python3
"""Opens the reports of several scenes in headless Chromium and checks them there.

    browser_test.py PROGRAM SCENES_DIRECTORY

No error on the console, every plot drawn, the slider moves the film, keys read
values, colours of meshes change, nothing wider than a narrow screen. Exit status
77, "skipped", where there is no Chromium.
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
const key = (element, name) => element.dispatchEvent(new KeyboardEvent('keydown', { key: name }));

const plotHolders = [...document.querySelectorAll('[data-plot]')];
for (const holder of plotHolders) {
  const canvas = holder.querySelector('canvas');
  const plot = data.plots[holder.dataset.plot];
  expect(canvas && isDrawn(canvas), plot.title + ': not drawn');
  const chart = Chart.getChart(canvas);
  expect(chart.data.datasets.length === plot.series.length, plot.title + ': series missing');
  expect(canvas.tabIndex === 0, plot.title + ': not reached by keys');
  key(canvas, 'ArrowRight');
  expect(chart.tooltip.getActiveElements().length > 0 && chart.tooltip.title.length > 0,
    plot.title + ': keys read nothing');
  canvas.dispatchEvent(new Event('blur'));
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
  const before = canvas.toDataURL();
  player.querySelector('select').value = 'error';
  player.querySelector('select').dispatchEvent(new Event('change'));
  expect(canvas.toDataURL() !== before, 'film: the field does not change');
  const turned = canvas.toDataURL();
  key(canvas, 'ArrowLeft');
  expect(canvas.toDataURL() !== turned, 'film: keys do not turn the plate');
  player.querySelector('button').click();
  expect(slider.value === '0', 'film: does not play from the beginning');
  player.querySelector('button').click();
}

for (const group of document.querySelectorAll('.mesh-group')) {
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
expect(document.documentElement.scrollWidth <= innerWidth, 'wider than the window: ' +
  document.documentElement.scrollWidth + ' > ' + innerWidth);
document.title = JSON.stringify({ plots: plotHolders.length, film: Boolean(player),
  meshes: document.querySelectorAll('.mesh-group svg').length, problems });
</script>"""


def seen_in_browser(browser, page, width, directory):
    """What the probe finds on a page in a window of some width."""
    html = page.read_text(encoding="utf-8")
    probed = directory / "probed.html"
    probed.write_text(
        html.replace("<head>", "<head>" + BEFORE, 1).replace("</body>", AFTER + "</body>", 1),
        encoding="utf-8")
    dom = subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         f"--user-data-dir={directory / 'profile'}", f"--window-size={width},1200",
         "--virtual-time-budget=5000", "--dump-dom", probed.as_uri()],
        capture_output=True, text=True, timeout=300, check=True).stdout
    title = re.search(r"<title>(.*?)</title>", dom, re.DOTALL).group(1)
    if not title.startswith("{"):
        return {"plots": 0, "film": False, "meshes": 0, "problems": ["a script of the page stops before its end"]}
    return json.loads(title.replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"))


def main():
    program, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
    browser = shutil.which("chromium") or shutil.which("chromium-browser")
    if browser is None:
        print("skipped: Chromium is not installed (Debian package chromium)")
        return 77

    coarse = ["Time/Time step=1e-6"]
    # arguments of the run, least number of plots, whether there is a film
    cases = [
        ("sphere-on-steel-plate.prm", coarse, 8, True),
        ("sphere-on-steel-plate.prm", coarse + ["Impactor/Shape=none"], 1, False),
        ("sphere-on-steel-plate.prm", coarse + ["Adaptivity/Strategy=none"], 5, True),
        ("paper-cylinder.prm", ["Adaptivity/Maximum cycles=2"], 8, True),
        ("extremes/long-plate.prm", ["Adaptivity/Maximum cycles=2"], 8, True),
    ]
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for scene, entries, n_plots, has_film in cases:
            overrides = [word for entry in entries for word in ("--set", entry)]
            subprocess.run([program, "run", scenes / scene, "--quiet", "--output",
                            directory / "results", *overrides],
                           check=True, stderr=subprocess.DEVNULL)
            for width in (1300, 500):
                found = seen_in_browser(browser, directory / "results" / "report.html", width, directory)
                problems = found["problems"]
                if found["plots"] < n_plots:
                    problems.append(f"{found['plots']} plots, expected {n_plots}")
                if found["film"] != has_film:
                    problems.append("film: " + ("missing" if has_film else "not expected"))
                if found["meshes"] == 0:
                    problems.append("no mesh")
                print(f"{scene} {' '.join(entries)}, {width} pixels: {'; '.join(problems) or 'as expected'}")
                failures += bool(problems)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
