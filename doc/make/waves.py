"""The pictures of lesson 10: the wave that runs out, the dual wave that runs back, and what
the cells contribute to the error of the peak force."""

import json

import numpy as np

from drawing import plt, svg


def maps_of_waves(found):
    """Corners [mm] of the cells of LessonTenWaves, and its maps, a row per time: the
    motion and the dual motion, each in thousandths of its largest number at that time, and the
    logarithm of what the cells contribute over the largest contribution of all."""
    vertices, motion, dual, cells = (np.array(json.loads(found[name]))
                                     for name in ("vertices", "motion", "dual", "cells"))
    x, y = (np.unique(np.round(1e3 * axis, 6)) for axis in vertices.T)
    order = np.lexsort((vertices[:, 0], vertices[:, 1]))
    centers = np.array(json.loads(found["centers"]))
    cell_order = np.lexsort((np.round(centers[:, 0], 9), np.round(centers[:, 1], 9)))
    on_grid = [field[:, order].reshape(-1, len(y), len(x)) for field in (motion, dual)]
    parts = cells[:, cell_order].reshape(-1, len(y) - 1, len(x) - 1)
    return x, y, [*on_grid, parts]


WAVES = ("motion of the plate", "dual motion", "contributions, logarithm to base ten")


def waves(found, *shares):
    """Both waves and their product at shares of the time up to the peak, a column each."""
    x, y, fields = maps_of_waves(found)
    figure, axes = plt.subplots(3, len(shares), figsize=(2.7 * len(shares), 7.2),
                                sharex=True, sharey=True)
    for row, (title, field) in enumerate(zip(WAVES, fields)):
        for axis, share in zip(axes[row], shares):
            at = round(share * (len(field) - 1))
            picture = axis.pcolormesh(x, y, field[at], cmap="viridis" if row == 2 else "RdBu_r",
                                      shading="flat" if row == 2 else "gouraud", rasterized=True,
                                      vmin=-5 if row == 2 else -500, vmax=0 if row == 2 else 500)
            axis.set(aspect="equal", title=title if share == shares[len(shares) // 2] else "")
            if row == 0:
                axis.annotate(f"{share:.0%} of the time", (0.5, 0.9), xycoords="axes fraction",
                              ha="center", fontsize=8)
    for axis in axes[-1]:
        axis.set(xlabel="x [mm]")
    axes[1][0].set(ylabel="y [mm]")
    return svg(figure)


def wave_film(found, seconds=0.25):
    """The three rows of `waves` along the x axis, one time after the other."""
    x, _, fields = maps_of_waves(found)
    width, height, left = 560, 120, 30
    lines = []
    for row, (title, field) in enumerate(zip(WAVES, fields)):
        base = 30 + row * (height + 30)
        middle = base + (0 if row == 2 else 0.6 * height)
        abscissae = x if row < 2 else 0.5 * (x[1:] + x[:-1])
        across = left + (width - left - 10) * abscissae / x[-1]
        scale = height / 5 if row == 2 else 0.6 * height / 1000
        shapes = ["M" + " L".join(f"{a:.1f},{middle - scale * max(value, -5 if row == 2 else -1000):.1f}"
                                  for a, value in zip(across, frame[0]))
                  for frame in field]
        lines += [f'<text x="{left}" y="{base - 8}">{title}</text>',
                  f'<path d="M{left},{middle} H{width - 10}" stroke="silver"/>',
                  f'<path d="{shapes[0]}" fill="none" stroke="{("#1f77b4", "#ff7f0e", "#2ca02c")[row]}"'
                  f' stroke-width="1.5"><animate attributeName="d" calcMode="linear" '
                  f'dur="{seconds * len(shapes):g}s" repeatCount="indefinite" '
                  f'values="{";".join(shapes)}"/></path>']
    bottom = 30 + 3 * (height + 30)
    lines += [f'<text x="{width - 10}" y="{bottom}" text-anchor="end">x from 0 to '
              f'{x[-1]:.0f} mm</text>']
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {bottom + 10}" '
            'font-family="sans-serif" font-size="13">\n<rect width="100%" height="100%" '
            'fill="white"/>\n' + "\n".join(lines) + "\n</svg>\n")
