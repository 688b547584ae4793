"""Error bars of the peak force on random scenes, for theory.md."""

import concurrent.futures

import error_bars
import measured


def measure(program):
    forces = measured.stored("true_forces")["forces"]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        scenes = list(pool.map(error_bars.bars_of_scene, [program.program] * len(forces),
                               range(len(forces)), forces))
    half = len(scenes) // 2
    return {**error_bars.summary(scenes),
            "halves": [error_bars.summary(part)["all"]
                       for part in (scenes[:half], scenes[half:])]}
