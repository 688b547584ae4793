"""What the portable program of the Debian package costs beside the one of this machine."""

import resource
import statistics
import subprocess
import tempfile

import runs

COMMANDS = {
    "the main scene": ("run", "prm/sphere-on-steel-plate.prm"),
    "a whole plate, for the peak force": ("run", "prm/off-centre.prm"),
    "a sweep over masses": ("sweep", "prm/mass-ratio.prm"),
}
ROUNDS = 9


def cpu_seconds(program, words):
    """CPU seconds of one process of the program."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as results:
        subprocess.run([program, *words, "--quiet", "--output", results], cwd=runs.root,
                       check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(program):
    """Ratios of processes that run one after the other, their median."""
    native, portable = program.program, runs.root / "build/package/plate-impact"
    if not portable.exists():
        raise SystemExit("measure.py: first `cmake --workflow --preset package`")
    ratios = {}
    for what, words in COMMANDS.items():
        pairs = [(cpu_seconds(native, words), cpu_seconds(portable, words))
                 for _ in range(ROUNDS)]
        ratios[what] = statistics.median(slow / fast for fast, slow in pairs)
    return {"ratios": ratios}
