"""A picture of the report of the main scene, by Chromium (Debian package chromium)."""

import shutil
import subprocess

import runs


def measure(program):
    """Renews doc/report.png, the beginning of report.html."""
    browser = shutil.which("chromium")
    if browser is None:
        raise runs.Failed("there is no Chromium")
    run = program.run("prm/sphere-on-steel-plate.prm")
    subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         "--virtual-time-budget=5000", "--window-size=880,904",
         f"--screenshot={runs.root / 'doc/report.png'}",
         f"file://{run.results / 'report.html'}"],
        check=True, capture_output=True)
    return {"picture": "doc/report.png"}
