"""Axisymmetric meshes of a ball that touches a plate, fine at the contact.

Coordinates (r, z) in mm; the plate's face is z = 0, the ball's lowest point is at the origin.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Body:
    """Quadrilaterals and the line of nodes, from the axis outwards, that may touch."""

    nodes: np.ndarray  # n x 2
    quads: np.ndarray  # m x 4, counterclockwise
    surface: np.ndarray  # nodes in the order of r


def graded(length, cell, fine, growth, largest, slope=0):
    """Points from 0 to length: cells of one size up to `fine`, growing from there to `largest`, or
    to `slope` times their distance."""
    sizes = [cell] * max(1, round(fine / cell))
    while sum(sizes) < length:
        sizes.append(min(sizes[-1] * growth, max(largest, slope * sum(sizes))))
    return np.concatenate([[0], np.cumsum(sizes)]) * (length / sum(sizes))


def plate(thickness, radius, cell, fine, growth, largest):
    """A rectangle; cells of size `cell` in a square of side `fine` under the contact, not larger
    than `largest` across the thickness and twice that, or a fortieth of the radius, along it."""
    r = graded(radius, cell, fine, growth, 2 * largest, 1 / 40)
    z = -graded(thickness, cell, fine, growth, largest)[::-1]
    nodes = np.stack(np.meshgrid(r, z), axis=-1).reshape(-1, 2)
    number = np.arange(len(nodes)).reshape(len(z), len(r))
    return Body(nodes, quads_of(number), number[-1])


def quads_of(number):
    return np.stack(
        [number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1
    ).reshape(-1, 4)


def ball(radius, cell, largest=0.35):
    """A half disc: a square block in a ring, mapped onto itself by a conformal map that makes
    cells small at the lowest point and at most `largest` radii at the highest."""
    shrink = np.sqrt(largest * radius / cell)
    m = int(np.ceil(np.pi / 4 * radius / cell / shrink))
    shrink = np.pi / 4 * radius / cell / m
    layers = max(1, round(0.75 * m))
    # the upper half of the unit disc, axis along the real line; its block bulges
    i, j = np.meshgrid(np.arange(-m, m + 1), np.arange(m + 1), indexing="ij")
    square = (i + 1j * j) / m
    side = np.maximum(abs(i), j) / m
    round_ = side * np.exp(1j * angles(i, j, m))
    block = 0.5 * (0.7 * square + 0.3 * round_)
    path = [(m, j) for j in range(m)] + [(i, m) for i in range(m, -m, -1)]
    path += [(-m, j) for j in range(m, -1, -1)]
    path = np.array(path)
    inner = block[path[:, 0] + m, path[:, 1]]
    outer = np.exp(1j * np.linspace(0, np.pi, 4 * m + 1))
    part = np.linspace(0, 1, layers + 1)[1:, None]
    ring = (1 - part) * inner + part * outer
    number = np.arange(block.size).reshape(block.shape)
    rings = np.vstack(
        [number[path[:, 0] + m, path[:, 1]], block.size + np.arange(ring.size).reshape(ring.shape)]
    )
    points = np.concatenate([block.ravel(), ring.ravel()])
    quads = np.vstack([quads_of(number), quads_of(rings)])
    # the lowest point is 1: shrunk there, stretched at -1
    c = (shrink - 1) / (shrink + 1)
    points = (points + c) / (1 + c * points)
    nodes = radius * np.stack([points.imag, 1 - points.real], axis=-1)
    nodes[abs(nodes[:, 0]) < 1e-12 * radius, 0] = 0
    return Body(nodes, counterclockwise(nodes, quads), rings[-1])


def angles(i, j, m):
    """The angle of a point of the block when its squares are rings of equal parts."""
    ring = np.maximum(np.maximum(abs(i), j), 1)
    along = np.where(
        (i == ring), j, np.where(j == ring, 2 * ring - i, 4 * ring - j)
    )  # 0 ... 4 ring
    return np.pi * along / (4 * ring)


def counterclockwise(nodes, quads):
    a, b, c, d = (nodes[quads[:, k]] for k in range(4))
    turned = np.cross(c - a, d - b) < 0
    quads[turned] = quads[turned][:, ::-1]
    return quads
