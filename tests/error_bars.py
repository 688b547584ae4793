"""Whether error bars of peak forces hold on a few of the scenes of doc/make/error_bars.py.

  error_bars.py PROGRAM CLASS SCENE...

Exit status 1, with a line for every bar that does not hold, when more than one in twenty
does not, a bar is more than four times too wide in the median, or nothing was judged.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "doc/make"))

import error_bars  # noqa: E402


def main():
    program, of_class, *numbers = sys.argv[1:]
    scenes = [error_bars.bars_of_scene(program, int(number), of_class=of_class)
              for number in numbers]
    found = error_bars.summary(scenes)
    print({key: value for key, value in found.items() if key != "outside"})
    for one in found["outside"]:
        print("does not hold:", one)
    bars = found["all"]
    is_good = (found["known"] == len(scenes) and found["failed"] == 0 and bars["bars"] >= 15
               and bars["held"] >= 0.95 * bars["bars"] and bars["median"] <= 4)
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()
