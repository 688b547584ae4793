"""A sphere strikes an elastic layer: three-dimensional elastodynamics, no plate theory.

  layer.py CASES.json [--output FILE.json] [--check]

Prints a Markdown table of the impacts in CASES.json; where a case carries values already, with
the differences from them. --output writes the results in the format of the cases; --check
prints how they depend on every choice made here.

A case has plate {thickness, E, nu, rho}, impactor {radius, E, nu, rho}, velocity and, if wanted,
end_time. SI units throughout: m, s, kg, N, Pa.

The layer. Axisymmetric waves in a circular plate of thickness h whose edge r = R is guided
(u_r = 0, no shear stress) are Dini series: u_r = U(z) J_1(k r), u_z = W(z) J_0(k r) with
J_1(k R) = 0. The wave numbers are uncoupled, and the strain energy of one of them is that of
plane strain, per area 1/2 int [ lambda (k U + W')^2 + 2 mu (k^2 U^2 + W'^2) + mu (U' - k W)^2 ] dz:
the modes are those of Rayleigh and Lamb. U and W are sums of Legendre polynomials, normalised, so
that the mass matrix is the identity times rho h / 2 and numpy's symmetric eigensolver suffices.
R is so large that no wave is back at the axis before the end.

The struck face. A force F(t) on the axis is the sum of pressures F c_n J_0(k_n r) with
c_n = 1 / (pi R^2 J_0(k_n R)^2), and of k = 0, where the layer moves like a rigid mass rho h pi R^2.
A mode of frequency omega and face deflection phi (modal mass 1 per area) answers with
c phi^2 / omega int sin(omega (t - s)) F(s) ds. For a force that is linear within the steps this
is exactly w_n = sum_m g_m F_(n-m) with

  g_0 = c phi^2 / omega^2 (1 - sin(omega dt) / (omega dt)),
  g_m = c phi^2 / (omega^3 dt) 4 sin(omega dt / 2)^2 sin(omega m dt),

and g_0 = dt^2 / (6 M), g_m = m dt^2 / M for a free mass M, be it the layer's or the impactor's.
What the polynomials miss and what is shorter than the waves that the impact excites, enters
statically, from the closed form C(k) of `static_compliance`.

The contact. Hertz's law F = 4/3 E* sqrt(r) alpha^1.5, 1/E* = (1 - nu^2) / E + (1 - nu_i^2) / E_i,
holds the static compression of a half-space under the contact, (1 - nu) / (G k) at wave number k.
The layer holds it as well; it is taken away from the layer. Then every step is one equation

  alpha_n + g_0 F(alpha_n) = v t_n - sum_(m > 0) g_m F_(n-m),

g the sum for layer less half-space and impactor, a mass point: a rigid sphere but for the contact.
Made for plates: a contact radius below 0.3 h, h below the way of a shear wave during the contact.

Sources: Lamb, Proc. R. Soc. A 93 (1917) 114 (modes); Watson, Theory of Bessel Functions, ch. 18
(Dini series); Johnson, Contact Mechanics, sec. 4.2, 11.4 (Hertz, impact); Sneddon, Fourier
Transforms, ch. 10 (layer and half-space).
"""

import argparse
import json
import sys

import numpy as np
from scipy import special

DEGREE = 14  # of the polynomials through the thickness
DYNAMIC = 10.0  # largest k h of the waves that are dynamic
STATIC = 24.0  # k h beyond which layer and half-space are the same, to 1e-9
STEPS = 1000  # time steps in the contact time on a half-space


def shear_modulus(material):
    """mu or G [Pa]."""
    return material["E"] / (2 * (1 + material["nu"]))


def static_compliance(plate, k):
    """C(k) [m/Pa]: deflection over pressure, both on the same face of the free layer.

    (1 - nu) / (2 G k) [ 2 sinh^2 x / (sinh 2x + 2x) + 2 cosh^2 x / (sinh 2x - 2x) ], x = k h / 2,
    the stretching and the bending half. Written with exp(-k h), for large k h.
    """
    mu = shear_modulus(plate)
    y = k * plate["thickness"]
    e = np.exp(-y)
    stretching = (1 - e) ** 2 / (1 - e**2 + 2 * y * e)
    bending = (1 + e) ** 2 / (1 - e**2 - 2 * y * e)
    return (1 - plate["nu"]) / (2 * mu * k) * (stretching + bending)


def modes(plate, k, degree=DEGREE):
    """Modes of the layer at each wave number: omega [1/s] and phi^2 [m^2/kg].

    phi is the deflection of the struck face for the modal mass 1 per area. With normalised
    polynomials L_i on -1 < zeta < 1, z = h zeta / 2: D_ij = int L_i L_j', S_ij = int L_i' L_j'.
    """
    h, mu = plate["thickness"], shear_modulus(plate)
    lam = 2 * mu * plate["nu"] / (1 - 2 * plate["nu"])
    n = degree + 1
    x, weight = np.polynomial.legendre.leggauss(n)
    face = np.sqrt(np.arange(n) + 0.5)  # L_i(1)
    value = np.polynomial.legendre.legvander(x, degree) * face
    slope = np.polynomial.legendre.legval(x, np.polynomial.legendre.legder(np.diag(face))).T
    D = value.T @ (weight[:, None] * slope)
    S = slope.T @ (weight[:, None] * slope)
    k = np.asarray(k)[:, None, None]
    stiffness = np.empty((len(k), 2 * n, 2 * n))
    stiffness[:, :n, :n] = h / 2 * (lam + 2 * mu) * k**2 * np.eye(n) + 2 / h * mu * S
    stiffness[:, n:, n:] = h / 2 * mu * k**2 * np.eye(n) + 2 / h * (lam + 2 * mu) * S
    stiffness[:, :n, n:] = k * (lam * D - mu * D.T)
    stiffness[:, n:, :n] = np.swapaxes(stiffness[:, :n, n:], 1, 2)
    eigenvalue, vector = np.linalg.eigh(stiffness)
    mass = plate["rho"] * h / 2
    # The slowest bending waves of a thin layer drown in round-off. In the time of an impact
    # they move like rigid masses, for which 1/s is as good as the true frequency.
    omega = np.sqrt(np.maximum(eigenvalue / mass, 1.0))
    return omega, np.einsum("i,kij->kj", face, vector[:, n:, :]) ** 2 / mass


def zeros_of_j1(n):
    """The first n positive zeros of J_1: McMahon's expansion, then Newton."""
    b = (np.arange(1, n + 1) + 0.25) * np.pi
    x = b - 3 / (8 * b)
    for _ in range(4):
        x -= special.j1(x) / (special.j0(x) - special.j1(x) / x)
    return x


def response(plate, end_time, dt, dynamic, degree=DEGREE, radius=1.0):
    """g_m [m/N] of layer less half-space for a force on the axis, m = 0 ... end_time / dt.

    `radius` multiplies the smallest R from which no wave returns.
    """
    h, nu, mu = plate["thickness"], plate["nu"], shear_modulus(plate)
    # Long stretching waves are the fastest that carry anything worth mentioning.
    R = radius * np.sqrt(plate["E"] / plate["rho"] / (1 - nu**2)) * end_time / 2
    n_static = int(np.ceil(STATIC / h * R / np.pi))
    zeros = zeros_of_j1(n_static)
    k = zeros / R
    c = 1 / (np.pi * R**2 * special.j0(zeros) ** 2)

    # All of it static, less the half-space, an integral since no R belongs to it:
    # 1/(2 pi) int (1 - nu) / (G k) k dk up to the middle between the last wave number and the next.
    end_of_k = (n_static + 0.75) * np.pi / R
    instantaneous = c @ static_compliance(plate, k) - (1 - nu) / mu * end_of_k / (2 * np.pi)

    # Long waves become dynamic, with a smooth transition: a sharp one would ring.
    weight = np.exp(-((k * h / dynamic) ** 4))
    n_dynamic = np.searchsorted(-weight, -1e-4)
    k, c = k[:n_dynamic], (c * weight)[:n_dynamic]
    omega, phi2 = modes(plate, k, degree)
    # What takes the place of the static part: the modes and, from k h = 1, what the polynomials
    # miss of it. For longer waves they miss nothing, but round-off is magnified by (k h)^-4.
    closed_form = static_compliance(plate, k)
    modal = np.sum(phi2 / omega**2, axis=1)
    missed = np.where(k * h > 1, closed_form - modal, 0)
    instantaneous += c @ (missed - closed_form)

    coefficient = c[:, None] * phi2
    n_steps = int(round(end_time / dt))
    g = np.empty(n_steps + 1)
    g[0] = instantaneous + np.sum(coefficient / omega**2 * (1 - np.sinc(omega * dt / np.pi)))
    amplitude = (coefficient * 4 * np.sin(omega * dt / 2) ** 2 / (omega**3 * dt)).ravel()
    angle = (omega * dt).ravel()
    for m in range(1, n_steps + 1):
        g[m] = amplitude @ np.sin(m * angle)
    # The stretching at k = 0 is left out: h / (3 (lambda + 2 mu) pi R^2) m/N, 1e-6 of all.
    return g + free_mass(plate["rho"] * h * np.pi * R**2, dt, n_steps)


def free_mass(mass, dt, n_steps):
    """g_m [m/N] of a mass point."""
    g = np.arange(n_steps + 1) * dt**2 / mass
    g[0] = dt**2 / (6 * mass)
    return g


def hertz(case):
    """Mass [kg], K [N/m^1.5] in F = K alpha^1.5, and on a half-space without waves the largest
    contact radius [m] and the contact time [s]."""
    plate, impactor = case["plate"], case["impactor"]
    mass = 4 / 3 * np.pi * impactor["radius"] ** 3 * impactor["rho"]
    K = 4 / 3 * np.sqrt(impactor["radius"])
    K /= sum((1 - body["nu"] ** 2) / body["E"] for body in (plate, impactor))
    alpha = (5 * mass * case["velocity"] ** 2 / (4 * K)) ** 0.4
    return mass, K, np.sqrt(impactor["radius"] * alpha), 2.9433 * alpha / case["velocity"]


def approach(free, g0, K):
    """Solves alpha + g0 K alpha^1.5 = free [m] by Newton's method, from free > 0."""
    alpha = free
    for _ in range(50):
        slope = 1 + 1.5 * g0 * K * np.sqrt(max(alpha, 0))
        if slope < 0.05:
            # With waves shorter than the contact more than Hertz's law holds is taken away.
            raise ValueError("the contact is too wide for the thickness")
        change = (alpha + g0 * K * alpha**1.5 - free) / slope
        alpha -= change
        if abs(change) <= 1e-13 * abs(alpha):
            return alpha
    raise ValueError("the contact equation has no solution")


def impact(case, steps=STEPS, waves=1.0, **resolution):
    """The case with its results, up to the end of the first contact or `end_time`.

    `waves` multiplies the wave number up to which waves are dynamic.
    """
    plate, impactor, velocity = case["plate"], case["impactor"], case["velocity"]
    mass, K, widest, duration = hertz(case)
    end_time = case.get("end_time") or 3 * duration
    n_steps = int(np.ceil(end_time / duration * steps))
    dt = end_time / n_steps
    # Waves shorter than the contact have no business with a point load.
    dynamic = waves * min(DYNAMIC, 1.5 * plate["thickness"] / widest)
    g = response(plate, end_time, dt, dynamic, **resolution) + free_mass(mass, dt, n_steps)
    force = np.zeros(n_steps + 1)
    contact_end, last = None, 0.0
    for n in range(1, n_steps + 1):
        free = velocity * n * dt - g[1 : n + 1] @ force[n - 1 :: -1]
        if free <= 0:
            contact_end = (n - 1 + last / (last - free)) * dt
            break
        last = approach(free, g[0], K)
        force[n] = K * last**1.5
    # The largest force, between the steps: a parabola through the three highest values.
    top = int(np.argmax(force))
    if not 0 < top < n_steps:
        raise ValueError("the force still grows at the end")
    before, peak, after = force[top - 1 : top + 2]
    shift = (before - after) / (2 * (before - 2 * peak + after))
    peak -= (before - after) * shift / 4
    contact_radius = np.sqrt(impactor["radius"] * (peak / K) ** (2 / 3))
    return {
        **{key: case[key] for key in ("name", "plate", "impactor", "velocity")},
        "peak_force": peak,
        "time_of_peak": (top + shift) * dt,
        "contact_end": contact_end,
        "restitution": np.sum(force) * dt / (mass * velocity) - 1 if contact_end else None,
        "contact_radius_over_thickness": contact_radius / plate["thickness"],
        "end_time": end_time,
        "time_step": dt,
    }


def shown(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def difference(value, reference):
    """In percent."""
    return shown(100 * (value / reference - 1) if value and reference else None, 4)


def table(header, rows):
    """A Markdown table."""
    for row in (header, ["---"] * len(header), *rows):
        print("| " + " | ".join(row) + " |")
    print()


def check(cases):
    """Prints what the results owe to the choices made here."""
    finer = {
        "R doubled": {"radius": 2.0},
        "waves to 1.5 times k": {"waves": 1.5, "degree": DEGREE + 6},
        "degree 20": {"degree": 20},
        "half the step": {"steps": 2 * STEPS},
    }
    keys = ("peak_force", "contact_end", "restitution")
    rows = []
    for case in cases:
        base = impact(case)
        for name, choice in finer.items():
            other = impact(case, **choice)
            rows.append([case["name"], name] + [difference(other[key], base[key]) for key in keys])
    table(["case", "change", "peak force %", "contact end %", "restitution %"], rows)


def main():
    parser = argparse.ArgumentParser(description="a sphere strikes an elastic layer")
    parser.add_argument("cases", help="file of cases, JSON")
    parser.add_argument("--output", help="file for the results, JSON")
    parser.add_argument("--check", action="store_true", help="print how the results converge")
    arguments = parser.parse_args()
    with open(arguments.cases, encoding="utf-8") as stream:
        cases = json.load(stream)
    if arguments.check:
        check(cases)
    results = [impact(case) for case in cases]
    header = ["case", "a/h"]
    rows = [[r["name"], shown(r["contact_radius_over_thickness"], 4)] for r in results]
    for title, key, unit, digits in (
        ("peak force N", "peak_force", 1, 3),
        ("at us", "time_of_peak", 1e-6, 3),
        ("contact end us", "contact_end", 1e-6, 3),
        ("restitution", "restitution", 1, 5),
    ):
        header += [title, "%"]
        for row, result, case in zip(rows, results, cases):
            value = result[key]
            row += [shown(value and value / unit, digits), difference(value, case.get(key))]
    table(header, rows)
    for result, case in zip(results, cases):
        for key, tolerance in (("peak_force", 5e-4), ("contact_end", 2e-3)):
            known, value = case.get(key), result[key]
            if known and abs(value / known - 1) > tolerance:
                sys.exit(f"{case['name']}: {key} is {value}, not {known}")
    if arguments.output:
        with open(arguments.output, "w", encoding="utf-8") as stream:
            json.dump(results, stream, indent=1)
            stream.write("\n")


if __name__ == "__main__":
    main()
