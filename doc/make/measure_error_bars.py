"""Error bars of the peak force on random scenes, by class, for theory.md: of the classes
whose true forces are kept."""

import concurrent.futures

import error_bars
import measured


def measure(program):
    true_forces = measured.stored("true_forces")
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        def scenes(name):
            return list(pool.map(
                lambda numbered: error_bars.bars_of_scene(program.program, *numbered, name),
                enumerate(true_forces[name])))

        by_class = {name: scenes(name) for name in error_bars.CLASSES if name in true_forces}
    elastic = by_class["elastic"]
    half = len(elastic) // 2
    supported = by_class["simply supported"]
    # on which constants were chosen, and not
    n_chosen = 90
    chosen = supported[:n_chosen] + [scene for name in ("elastic", "heavy impactors", "damped")
                                     for scene in by_class[name]]
    others = [scene for name in ("yielding", "laminates") for scene in by_class[name]]
    return {**error_bars.summary(elastic),
            "halves": [error_bars.summary(part)["all"]
                       for part in (elastic[:half], elastic[half:])],
            "peaks": {"early": error_bars.of_peaks(chosen, False),
                      "late": error_bars.of_peaks(chosen, True),
                      "late, others": error_bars.of_peaks(others, True),
                      "late, other simply supported": error_bars.of_peaks(supported[n_chosen:], True)},
            "classes": {name: error_bars.summary(found) for name, found in by_class.items()}}
