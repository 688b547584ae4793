"""Error bars of the peak force on random scenes, for theory.md."""

import concurrent.futures

import error_bars

N_SCENES = 100


def measure(program):
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        scenes = list(pool.map(lambda number: error_bars.bars_of_scene(program.program, number),
                               range(N_SCENES)))
    return error_bars.summary(scenes)
