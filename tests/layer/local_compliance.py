"""What a layer gives way under a sphere or a cylinder, beyond plate theory and Hertz's law.

  local_compliance.py

Prints a table of Lambda and Lambda_line, each computed in two ways; exit status 1 where these, or
the values kept below, differ.

C(k) is the static compliance of the struck face of a free layer of thickness h (see layer.py),
C_R(k) that of the plate theory of Reissner and Mindlin, load and reading spread over a patch of
radius c (half width, for a strip) whose pressure has the Hankel or Fourier transform P(k c):

  C_R(k) = P(k c)^2 [ (1 - beta k^2)^2 / (D k^4) + 1 / (kappa G h k^2) ],  D = G h^3 / (6 (1 - nu)).

Load and reading are those of w + beta div theta with grad w - theta the shear strain. beta gives
C_R the layer's 1.2 (1 - nu) / (G h k^2); for one radius, `matching_radius`, it is zero. Then

  Lambda = G h / (2 pi) int [ C(k) - (1 - nu) / (G k) - C_R(k) ] k dk

is the compliance, in 1 / (G h), that is left beside plate and half-space, and with it, for a line
contact of half width a and the force F' per length, the surface under the middle goes by
F' (1 - nu) / (pi G) [ ln(h / a) + Lambda_line ] further than the plate:

  Lambda_line = ln 2 + 1/2
                + G / (1 - nu) int [ C(k) - (1 - nu) (1 - exp(-k h)) / (G k) - C_R(k) ] dk.

All integrals from 0 to infinity. In the functions lengths are in h, wave numbers are y = k h and
C is in h / G.

Sources: Johnson, Contact Mechanics, sec. 3.4 and 4.2 (Hertz's pressure on a half-space);
Reissner, J. Appl. Mech. 12 (1945) A69; Mindlin, J. Appl. Mech. 18 (1951) 31.
"""

import sys

import numpy as np
from numpy.polynomial import polynomial
from scipy import integrate, special

from layer import modes, shown, static_compliance, table, zeros_of_j1

TERMS = 30  # of the power series in y^2, used below y = 1

# kind, nu, kappa, c / h or None for the matching radius: the value to be found, if there is one
# from elsewhere.
CASES = {
    ("hertz", 0.1, 5 / 6, None): -0.42166,
    ("hertz", 0.2, 5 / 6, None): -0.30065,
    ("hertz", 0.25, 5 / 6, None): -0.25440,
    ("hertz", 0.3, 5 / 6, None): -0.21332,
    ("hertz", 0.35, 5 / 6, None): -0.17607,
    ("hertz", 0.4, 5 / 6, None): -0.14184,
    ("hertz", 0.45, 5 / 6, None): -0.11011,
    ("hertz", 0.3, np.pi**2 / 12, None): -0.20898,
    ("hertz", 0.3, 5 / 6, 0.1): None,
    ("hertz", 0.3, 5 / 6, 0.3): None,
    ("hertz", 0.3, 5 / 6, 1.0): None,
    ("hertz", 0.0, 5 / 6, 0.2): None,
    ("hertz", 0.3, 1.0, 0.2): None,
    ("uniform", 0.3, 5 / 6, None): -0.2126,
    ("uniform", 0.3, 5 / 6, 0.1): None,
    ("uniform", 0.3, 5 / 6, 0.3): None,
    ("line", 0.2, 5 / 6, None): 0.14097,
    ("line", 0.3, 5 / 6, None): 0.35029,
    ("line", 0.33, 5 / 6, None): 0.42082,
    ("line", 0.3, 5 / 6, 0.2): None,
}


def transform(kind, x):
    """P(x): Hertz's pressure on a disc; uniform pressure on a disc, which has the same transform
    as Hertz's pressure on a strip ("line")."""
    if kind == "hertz":
        return 3 * (np.sin(x) - x * np.cos(x)) / x**3
    return 2 * special.j1(x) / x


def squared_series(kind, c):
    """Coefficients of P(c y)^2 in powers of y^2: 1 - (c y)^2 / 5 or 1 - (c y)^2 / 4, ..."""
    n = np.arange(TERMS)
    if kind == "hertz":
        series = 3 * (2 * n + 2) / special.factorial(2 * n + 3)
    else:
        series = 0.25**n / (special.factorial(n) * special.factorial(n + 1))
    series = series * (-(c**2)) ** n
    return polynomial.polymul(series, series)[:TERMS]


def layer_series(nu):
    """Coefficients of y^4 C in powers of y^2: 6 (1 - nu) + 1.2 (1 - nu) y^2 + ..."""

    def quotient(a, b):
        q = np.zeros(TERMS)
        for n in range(TERMS):
            q[n] = (a[n] - b[1 : n + 1] @ q[:n][::-1]) / b[0]
        return q

    n = np.arange(TERMS)
    one = n == 0
    # (cosh y - 1) / y^2 over (sinh y + y) / y, cosh y + 1 over (sinh y - y) / y^3
    stretching = quotient(1 / special.factorial(2 * n + 2), 1 / special.factorial(2 * n + 1) + one)
    bending = quotient(1 / special.factorial(2 * n) + one, 1 / special.factorial(2 * n + 3))
    return (1 - nu) / 2 * (bending + np.append([0, 0], stretching)[:TERMS])


def moment(kind):
    """int P(x)^2 x dx, for a strip int P(x)^2 dx, from 0 to infinity, by Parseval's theorem."""
    return {"hertz": 9 / 4, "uniform": 2, "line": 16 / (3 * np.pi)}[kind]


def layer(nu, y):
    """C(y) [h / G]."""
    return static_compliance({"thickness": 1.0, "E": 2 * (1 + nu), "nu": nu}, y)


def matching_radius(kind, nu, kappa):
    """c / h for which beta is zero."""
    return np.sqrt((1.0 if kind == "hertz" else 0.8) * (1 / (1.2 * kappa * (1 - nu)) - 1))


def matching_beta(kind, nu, kappa, c):
    """beta / h^2 for the radius c."""
    return 1 / (12 * kappa * (1 - nu)) - 0.1 - c**2 / (10 if kind == "hertz" else 8)


def plate(kind, nu, kappa, c, y, beta, last=1):
    """C_R(y) [h / G]; with last = 0 without the term beta^2, which falls with P^2 alone."""
    bending = 6 * (1 - nu) * (1 / y**4 - 2 * beta / y**2 + last * beta**2)
    return transform(kind, c * y) ** 2 * (bending + 1 / (kappa * y**2))


def difference_series(kind, nu, kappa, c, beta, last=1):
    """Coefficients of C - C_R in powers of y^2; last as in `plate`."""
    bracket = [6 * (1 - nu), 1 / kappa - 12 * (1 - nu) * beta, last * 6 * (1 - nu) * beta**2]
    series = layer_series(nu) - polynomial.polymul(squared_series(kind, c), bracket)[:TERMS]
    assert np.all(np.abs(series[:2]) < 1e-12), "the plate is not the layer for long waves"
    return series[2:]


def compliance(kind, nu, kappa, c, beta):
    """Lambda, for "line" Lambda_line: quadrature of the integral."""
    power = 0 if kind == "line" else 1
    series = difference_series(kind, nu, kappa, c, beta, 0)

    def half_space(y):
        return (1 - nu) / y * (-np.expm1(-y) if kind == "line" else 1)

    def quad(f, *ends):
        pieces = zip(ends[:-1], ends[1:])
        return sum(integrate.quad(f, *piece, epsabs=1e-12, epsrel=1e-11)[0] for piece in pieces)

    # C and C_R cancel in long waves, so these have the power series; C and the half-space are
    # the same for short ones; C_R oscillates.
    total = quad(lambda y: (polynomial.polyval(y**2, series) - half_space(y)) * y**power, 1e-9, 1)
    total += quad(lambda y: (layer(nu, y) - half_space(y)) * y**power, 1, 5, 15, 45)
    ends = 1 + np.arange(300) * np.pi / c
    total -= quad(lambda y: plate(kind, nu, kappa, c, y, beta, 0) * y**power, *ends)
    total -= 6 * (1 - nu) * beta**2 * moment(kind) / c ** (1 + power)
    if kind == "line":
        return np.log(2) + 0.5 + total / (1 - nu)
    return total / (2 * np.pi)


def compliance_from_solutions(kind, nu, kappa, c, beta, period=30.0):
    """The same from three solutions for a small contact of the radius a: layer less plate, both
    as series in a large domain, less half-space in closed form. The error is of order a^2."""
    k_0 = difference_series(kind, nu, kappa, c, beta)[0]  # C - C_R at k = 0
    if kind == "line":
        # Strips at the distance `period`, whose deflection in the middle counts.
        a = 0.001
        y = 2 * np.pi * np.arange(1, 2000000) / period
        terms = layer(nu, y) * transform("line", y * a) - plate(kind, nu, kappa, c, y, beta)
        return (2 * np.sum(terms) + k_0) / period * np.pi / (1 - nu) + np.log(a)
    # A guided circular plate. What counts is the deflection averaged with Hertz's pressure; on
    # a half-space that is 0.3 (1 - nu) F / (G a).
    a = 0.004
    zeros = zeros_of_j1(500000)
    y = zeros / period
    terms = layer(nu, y) * transform("hertz", y * a) ** 2 - plate(kind, nu, kappa, c, y, beta)
    total = np.sum(terms / special.j0(zeros) ** 2) + k_0
    return total / (np.pi * period**2) - 0.3 * (1 - nu) / a


def main():
    # C itself, once more: the static deflection of the modes through the thickness.
    rows = []
    y = np.geomspace(0.3, 20, 60)
    for nu in (0.0, 0.3, 0.45):
        omega, phi2 = modes({"thickness": 1.0, "E": 2 * (1 + nu), "nu": nu, "rho": 1e-3}, y, 20)
        error = np.sum(phi2 / omega**2, axis=1) / layer(nu, y) - 1
        rows.append([f"{nu}", f"{np.max(np.abs(error)):.0e}"])
    table(["nu", "C(k) of 42 modes against closed form, 0.3 < k h < 20"], rows)

    rows, wrong = [], 0
    for (kind, nu, kappa, c), expected in CASES.items():
        beta = 0.0 if c is None else matching_beta(kind, nu, kappa, c)
        c = matching_radius(kind, nu, kappa) if c is None else c
        value = compliance(kind, nu, kappa, c, beta)
        second = compliance_from_solutions(kind, nu, kappa, c, beta)
        digits = 4 if kind == "uniform" else 5
        wrong += abs(value - second) > 3e-5
        wrong += expected is not None and abs(value - expected) > 0.6 * 10.0**-digits
        numbers = [shown(x, 6) for x in (kappa, c, beta, value, second)]
        rows.append([kind, f"{nu}", *numbers, shown(expected, digits)])
    table(["", "nu", "kappa", "c/h", "beta/h^2", "Lambda", "second way", "expected"], rows)
    sys.exit(f"{wrong} values differ" if wrong else 0)


if __name__ == "__main__":
    main()
