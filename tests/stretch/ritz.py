"""Large static deflections of square plates by Ritz's method.

  ritz.py CASES.json            solves the cases again and compares
  ritz.py CASES.json --write    makes the file

First-order shear with von Karman's strains, polynomials of high degree over the
quadrant and their exact energy: no element, no mesh, no tying. Unit square,
Young's modulus 1, Poisson's ratio 0.3, shear correction 5/6, uniform pressure.
"""

import itertools
import json
import sys

import numpy
from numpy.polynomial import legendre

NU, KAPPA = 0.3, 5 / 6


def shapes(x, parity, is_held, n):
    """n polynomials of one parity on -1..1, zero at the ends where held, and
    their derivatives: columns."""
    values, slopes = [], []
    for k in range(n):
        c = legendre.Legendre.basis(2 * k + parity)
        if is_held:
            # differences of Legendre's polynomials vanish at both ends
            c = legendre.Legendre.basis(2 * k + parity + 2) - c
        values.append(c(x))
        slopes.append(c.deriv()(x))
    return numpy.array(values).T, numpy.array(slopes).T


class Field:
    """Values and derivatives of a field at the points, by its coefficients."""

    def __init__(self, x, parities, held, n):
        (f, df), (g, dg) = (shapes(x, p, h, n) for p, h in zip(parities, held))
        def product(a, b):
            return numpy.einsum("ik,jl->ijkl", a, b).reshape(len(x) ** 2, n * n)
        self.value = product(f, g)
        # the side is 1, and -1..1 two half sides
        self.x, self.y = 2 * product(df, g), 2 * product(f, dg)


def deflections(support, in_plane, thickness, pressures, n=8):
    x, weight = legendre.leggauss(4 * n)
    x, weight = 0.5 * (x + 1), 0.5 * weight
    weights = numpy.outer(weight, weight).ravel()  # of the plate: four quadrants of 1/4
    is_clamped, is_held = support == "clamped", in_plane == "held"
    w = Field(x, (0, 0), (True, True), n)
    # a hard support holds the rotation along the edge
    rotations = (Field(x, (1, 0), (is_clamped, True), n), Field(x, (0, 1), (True, is_clamped), n))
    stretches = (Field(x, (1, 0), (is_held, is_held), n), Field(x, (0, 1), (is_held, is_held), n))
    m, q = n * n, len(weights)
    zero = numpy.zeros((q, m))
    def rows(**fields):
        return numpy.hstack([fields.get(k, zero) for k in ("w", "a", "b", "u", "v")])
    (a, b), (u, v) = rotations, stretches
    linear = [rows(a=a.x), rows(b=b.y), rows(a=a.y, b=b.x),
              rows(w=w.x, a=-a.value), rows(w=w.y, b=-b.value),
              rows(u=u.x), rows(v=v.y), rows(u=u.y, v=v.x)]
    wx, wy = rows(w=w.x), rows(w=w.y)
    plane = numpy.array([[1, NU, 0], [NU, 1, 0], [0, 0, (1 - NU) / 2]]) / (1 - NU ** 2)
    C = numpy.zeros((8, 8))
    C[:3, :3] = plane * thickness ** 3 / 12
    C[3:5, 3:5] = numpy.eye(2) * KAPPA * thickness / (2 * (1 + NU))
    C[5:, 5:] = plane * thickness
    load = rows(w=w.value).T @ weights
    # at the middle even polynomials only
    centre = numpy.zeros(5 * m)
    f = shapes(numpy.zeros(1), 0, True, n)[0][0]
    centre[:m] = numpy.outer(f, f).ravel()

    z, result = numpy.zeros(5 * m), []
    for pressure in pressures:
        for iteration in range(60):
            sx, sy = wx @ z, wy @ z
            B = linear[:5] + [linear[5] + sx[:, None] * wx, linear[6] + sy[:, None] * wy,
                              linear[7] + sx[:, None] * wy + sy[:, None] * wx]
            strains = numpy.array([L @ z for L in linear])
            strains[5] += sx ** 2 / 2
            strains[6] += sy ** 2 / 2
            strains[7] += sx * sy
            stresses = weights * (C @ strains)
            residual = pressure * load - sum(b_k.T @ s for b_k, s in zip(B, stresses))
            K = sum(C[i, j] * (B[i].T * weights) @ B[j]
                    for i, j in itertools.product(range(8), repeat=2) if C[i, j] != 0)
            K += (wx.T * stresses[5]) @ wx + (wy.T * stresses[6]) @ wy
            mixed = (wx.T * stresses[7]) @ wy
            K += mixed + mixed.T
            # polynomials that are held by no edge may depend on each other
            step = numpy.linalg.lstsq(K, residual, rcond=1e-13)[0]
            z += step
            if numpy.abs(centre @ step) < 1e-11 * abs(centre @ z):
                break
        else:
            raise RuntimeError("no equilibrium")
        result.append(centre @ z / thickness)
    return result


def cases(with_fewer_terms):
    thickness = 0.01
    for support, in_plane in itertools.product(("clamped", "simply supported"), ("held", "sliding")):
        # in units of E t^4 / a^4
        loads = [20, 60, 150, 300, 600] if support == "clamped" else [8, 25, 60, 150, 300]
        pressures = [p * thickness ** 4 for p in loads]
        found = deflections(support, in_plane, thickness, pressures)
        case = {"support": support, "in_plane": in_plane, "thickness": thickness, "load": loads,
                "deflection": [float(f"{d:.6g}") for d in found]}
        if with_fewer_terms:
            fewer = deflections(support, in_plane, thickness, pressures, n=6)
            change = max(abs(a / b - 1) for a, b in zip(fewer, found))
            case["change_with_fewer_terms"] = float(f"{change:.1e}")
        yield case


def main():
    path, writes = sys.argv[1], "--write" in sys.argv
    found = list(cases(writes))
    if writes:
        with open(path, "w") as out:
            json.dump(found, out, indent=1)
            out.write("\n")
        return 0
    with open(path) as file:
        given = json.load(file)
    worst = max(abs(a / b - 1) for one, other in zip(found, given)
                for a, b in zip(one["deflection"], other["deflection"]))
    print(f"largest difference {worst:.1e}")
    return 0 if len(found) == len(given) and worst < 1e-5 else 1


if __name__ == "__main__":
    sys.exit(main())
