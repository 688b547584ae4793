"""A sphere strikes a laminate: three-dimensional elastodynamics of its plies, no plate theory.

  laminate.py CASES.json [--only NAME ...] [--coarse] [--check] [--within PERCENT]
              [--output FILE.json]

Prints a Markdown table of the impacts in CASES.json up to past their peaks; where a case carries
values already, with the differences from them, and fails where a peak force differs by more than
its uncertainty, or by more than --within. --coarse takes fewer of everything; --check prints how
the results depend on every choice made here. --output writes the results in the format of the
cases.

A case has plate {thickness, rho, plies_from_struck_face_deg, ply {E1, E2, E3, nu12, nu13, nu23,
G12, G13, G23} or ply {E, nu}}, impactor {radius, E, nu, rho}, velocity and, if known,
time_of_peak. SI units throughout: m, s, kg, N, Pa. Needs nothing but numpy.

The plate is infinite. A wave exp(i k x) along a direction theta has the displacements i U(z),
i V(z), W(z) in its own axes; plies, which mirror in their plane, leave them real:
e_11 = -k U, gamma_12 = -k V, e_33 = W', gamma_13 = i (U' + k W), gamma_23 = i V'. Finite elements
of high degree through the thickness, at least one in every ply, make of them a stiffness
A_0 + k A_1 + k^2 A_2 and a mass for every direction: modes with frequencies omega and deflections
phi of the struck face. Slow modes of long waves are oscillators q'' + omega^2 q = phi f, stepped
exactly for forces that are linear within a step; fast ones and short waves answer at once, short
waves by a static solution on elements that shrink towards the face with the wave. From slow to
fast there is a smooth transition: a sharp one would ring.

The contact presses with Hertz's pressure of radius a, whose transform is F P(k a),
P(x) = 3 (sin x - x cos x) / x^3, and the deflection is averaged with the same weights. The
distance that the bodies have come closer is that deflection, the ball's own, 3 F / (5 E_i a) with
E_i = E / (1 - nu^2), and a^2 / (5 R), the mean gap of a sphere. The radius is the one that makes
the complementary energy F^2 C(a) / 2 + F a^2 / (5 R) stationary, F C'(a) / 2 + 2 a / (5 R) = 0,
with the compliance C(a) of the ball and of the static waves beyond k h = 1 (longer ones hardly
know the radius). On half-spaces this is Hertz's law to the letter.

What the choices below leave of two peak forces (--check): 0.012 % by what counts as fast, less than
0.001 % by directions, wave numbers, elements and steps.

Sources: Johnson, Contact Mechanics, secs. 3.4, 4.2 and 5.5 (variational principle, Hertz); Auld,
Acoustic Fields and Waves in Solids, vol. 2 (waves in layers); Jones, Mechanics of Composite
Materials, ch. 2 (plies).
"""

import argparse
import json
import sys

import numpy as np

FULL = {
    "degree": 3,  # of the elements through the thickness
    "directions": 24,  # in half a turn
    "points": 6,  # in a panel of wave numbers
    "phase": 6.0,  # of the fastest wave between the ends of a panel, at the end
    "dynamic": 32.0,  # frequency from which on modes are fast, over that of the contact
    "steps": 400,  # up to the peak
    "wider": 1.0,  # factor of the radius
}
COARSE = {**FULL, "directions": 12, "phase": 10.0, "dynamic": 16.0, "steps": 200}
LONGEST = 1.5  # times the time of the peak


def stiffness(ply):
    """C, 6 x 6, in the order 11, 22, 33, 23, 13, 12."""
    if "E" in ply:
        E, nu = ply["E"], ply["nu"]
        G = E / (2 * (1 + nu))
        ply = {"E1": E, "E2": E, "E3": E, "nu12": nu, "nu13": nu, "nu23": nu,
               "G12": G, "G13": G, "G23": G}
    S = np.zeros((6, 6))
    for i, name in enumerate(("E1", "E2", "E3", "G23", "G13", "G12")):
        S[i, i] = 1 / ply[name]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        S[i, j] = S[j, i] = -ply[f"nu{i + 1}{j + 1}"] * S[i, i]
    return np.linalg.inv(S)


def turned(C, angle):
    """C in axes from which the ply's are turned by an angle about 3."""
    c, s = np.cos(angle), np.sin(angle)
    bond = np.array([
        [c * c, s * s, 0, 0, 0, -2 * c * s],
        [s * s, c * c, 0, 0, 0, 2 * c * s],
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, c, s, 0],
        [0, 0, 0, -s, c, 0],
        [c * s, -c * s, 0, 0, 0, c * c - s * s]])
    return bond @ C @ bond.T


class Element:
    """Nodal polynomials of a degree on -1 < x < 1, the first node at the struck face."""

    def __init__(self, degree):
        slope = np.polynomial.legendre.Legendre.basis(degree).deriv()
        nodes = np.concatenate([[-1], np.sort(slope.roots().real), [1]])
        x, weight = np.polynomial.legendre.leggauss(degree + 2)
        values = np.linalg.inv(np.polynomial.legendre.legvander(nodes, degree))
        N = np.polynomial.legendre.legvander(x, degree) @ values
        D = np.polynomial.legendre.legval(x, np.polynomial.legendre.legder(values)).T
        self.n = degree + 1
        self.NN = N.T @ (weight[:, None] * N)
        self.ND = N.T @ (weight[:, None] * D)
        self.DD = D.T @ (weight[:, None] * D)


def assemble(element, lengths, materials, rho):
    """A_0, A_1, A_2 and the mass, of U, V, W node by node from the struck face.

    `materials` are the C of the elements in the axes of the wave.
    """
    n = 3 * (len(lengths) * (element.n - 1) + 1)
    A = np.zeros((4, n, n))
    U, V, W = range(3)
    for e, (length, C) in enumerate(zip(lengths, materials)):
        NN, ND, DD = element.NN * length / 2, element.ND, element.DD * 2 / length
        first = 3 * e * (element.n - 1)
        node = first + 3 * np.arange(element.n)

        def add(order, a, b, matrix):
            A[order][np.ix_(node + a, node + b)] += matrix
            if a != b:
                A[order][np.ix_(node + b, node + a)] += matrix.T

        add(0, U, U, C[4, 4] * DD)
        add(0, V, V, C[3, 3] * DD)
        add(0, U, V, C[3, 4] * DD)
        add(0, W, W, C[2, 2] * DD)
        add(1, U, W, -C[0, 2] * ND + C[4, 4] * ND.T)
        add(1, V, W, -C[2, 5] * ND + C[3, 4] * ND.T)
        add(2, U, U, C[0, 0] * NN)
        add(2, V, V, C[5, 5] * NN)
        add(2, U, V, C[0, 5] * NN)
        add(2, W, W, C[4, 4] * NN)
        for a in range(3):
            add(3, a, a, rho * NN)
    return A


class Plate:
    """Plies, and the directions of waves that differ."""

    def __init__(self, plate, directions):
        self.rho, self.h = plate["rho"], plate["thickness"]
        self.C = stiffness(plate["ply"])
        angles = np.radians(plate["plies_from_struck_face_deg"])
        if "E" in plate["ply"]:
            angles, directions = angles[:1], 1
        self.angles = angles
        theta = (np.arange(directions) + 0.5) * np.pi / directions
        if np.allclose(np.sin(2 * angles), 0):  # mirrors in its axes
            theta = theta[: (directions + 1) // 2]
        self.theta = theta
        self.shear = max(self.C[3, 3], self.C[4, 4], self.C[5, 5])

    def materials(self, theta):
        """C of the plies in the axes of a wave."""
        return [turned(self.C, angle - theta) for angle in self.angles]

    def static_compliance(self, k, degree=5):
        """C(k) [m/Pa], mean of all directions, for k h > 1."""
        n = len(self.angles)
        t = self.h / n
        # elements grow with the depth; within exp(-0.2 k z) all is over, along fibres too
        edges, size = [0.0], 0.7 / k
        while edges[-1] < min(self.h, 80 / k) * (1 - 1e-12):
            ply = int(edges[-1] / t + 1e-9)
            far = min((ply + 1) * t, edges[-1] + size)
            if (ply + 1) * t - far < 0.3 * size:
                far = (ply + 1) * t
            edges.append(far)
            size *= 1.5
        lengths = np.diff(edges)
        plies = ((np.array(edges[:-1]) + 0.5 * lengths) / t).astype(int)
        element = Element(degree)
        total = 0.0
        for theta in self.theta:
            C = self.materials(theta)
            A = assemble(element, lengths, [C[p] for p in plies], self.rho)
            load = np.zeros(len(A[0]))
            load[2] = 1
            total += np.linalg.solve(A[0] + k * A[1] + k * k * A[2], load)[2]
        return total / len(self.theta)

    def modes(self, theta, k, degree):
        """omega [1/s] and phi^2 [m^2/kg] of waves of one direction, a row a wave number."""
        n = len(self.angles)
        parts = int(np.ceil(k[-1] * self.h / n))
        lengths = np.full(n * parts, self.h / (n * parts))
        materials = [C for C in self.materials(theta) for _ in range(parts)]
        A = assemble(Element(degree), lengths, materials, self.rho)
        root = np.linalg.inv(np.linalg.cholesky(A[3]))
        A = [root @ part @ root.T for part in A[:3]]
        face = root[:, 2]
        omega, phi2 = [], []
        for one in k:
            eigenvalue, vector = np.linalg.eigh(A[0] + one * A[1] + one**2 * A[2])
            # what drowns in round-off moves like a rigid mass
            omega.append(np.sqrt(np.maximum(eigenvalue, 1.0)))
            phi2.append((face @ vector) ** 2)
        return np.array(omega), np.array(phi2)


def hertz_transform(x):
    """3 (sin x - x cos x) / x^3."""
    small = x < 0.05
    safe = np.where(small, 1.0, x)
    return np.where(small, 1 - x**2 / 10 + x**4 / 280,
                    3 * (np.sin(safe) - safe * np.cos(safe)) / safe**3)


def panels(edges, points):
    """Gauss points and weights of panels."""
    x, weight = np.polynomial.legendre.leggauss(points)
    half = np.diff(edges)[:, None] / 2
    return ((edges[:-1, None] + half * (1 + x)).ravel(), (half * weight).ravel())


def short_waves(plate, begin):
    """k C(k) of static waves beyond `begin`, as a function of k: a polynomial in log k, constant
    beyond the shortest that see a second ply."""
    n = len(plate.angles)
    last = max(60 * n / plate.h if n > 1 else 0, 40 / plate.h, 2 * begin)
    low, high = np.log(begin), np.log(last)
    x = np.cos(np.pi * (np.arange(41) + 0.5) / 41)
    k = np.exp(low + (high - low) * (1 + x) / 2)
    values = [one * plate.static_compliance(one) for one in k]
    fit = np.polynomial.chebyshev.Chebyshev.fit(x, values, 40, domain=[-1, 1])

    def function(k):
        scaled = 2 * (np.log(np.minimum(k, last)) - low) / (high - low) - 1
        return fit(scaled)

    return function


class Response:
    """The deflection of the struck face, averaged over the contact, step by step."""

    def __init__(self, case, choice, time_of_peak):
        plate = Plate(case["plate"], choice["directions"])
        self.dt = time_of_peak / choice["steps"]
        cut = choice["dynamic"] * np.pi / (2 * time_of_peak)
        end_of_k = 1.8 * cut / np.sqrt(0.7 * min(plate.C[3, 3], plate.C[4, 4]) / plate.rho)
        # long waves: fast ones stretch the plate, from k h = 3 on all are slow
        fast = np.sqrt(max(plate.C[0, 0], plate.C[1, 1]) / plate.rho)
        slow = 2 * np.sqrt(plate.shear / plate.rho)
        end_time = LONGEST * time_of_peak
        middle = min(3 / plate.h, end_of_k)
        edges = [np.linspace(0, middle, 2 + int(middle * fast * end_time / choice["phase"]))]
        if middle < end_of_k:
            n = 2 + int((end_of_k - middle) * slow * end_time / choice["phase"])
            edges.append(np.linspace(middle, end_of_k, n)[1:])
        self.k, weight = panels(np.concatenate(edges), choice["points"])
        self.weight = self.k * weight / (2 * np.pi)
        share = 1 / len(plate.theta)
        omega, phi2, index = [], [], []
        static = np.zeros(len(self.k))
        for theta in plate.theta:
            all_omega, all_phi2 = plate.modes(theta, self.k, choice["degree"])
            slowness = np.exp(-((all_omega / cut) ** 4))
            static += share * np.sum((1 - slowness) * all_phi2 / all_omega**2, axis=1)
            all_phi2 = slowness * all_phi2
            felt = all_phi2 > 1e-5 * np.max(all_phi2, axis=1)[:, None]
            row, _ = np.nonzero(felt)
            omega.append(all_omega[felt])
            phi2.append(share * all_phi2[felt])
            index.append(row)
        omega, phi2, index = map(np.concatenate, (omega, phi2, index))
        order = np.argsort(index, kind="stable")
        omega, self.phi2, self.index = omega[order], phi2[order], index[order]
        self.static = static

        x = omega * self.dt
        small = x < 1e-3
        safe = np.where(small, 1.0, x)
        dt = self.dt
        self.cos, self.sin = np.cos(x), np.sin(x)
        self.omega = omega
        self.from_first = dt**2 * np.where(
            small, 1 / 3 - x**2 / 30, (np.sin(safe) / safe - np.cos(safe)) / safe**2)
        self.from_last = dt**2 * np.where(
            small, 1 / 6 - x**2 / 120, (1 - np.sin(safe) / safe) / safe**2)
        self.speed_from_first = dt * np.where(
            small, 1 / 2 - x**2 / 8, (np.cos(safe) - 1 + safe * np.sin(safe)) / safe**2)
        self.speed_from_last = dt * np.where(
            small, 1 / 2 - x**2 / 24, (1 - np.cos(safe)) / safe**2)
        self.q, self.v = np.zeros(len(omega)), np.zeros(len(omega))
        self.at_once = self.sum_of(self.phi2 * self.from_last) + static
        self.end_of_k, self.static_k = end_of_k, 1 / plate.h
        self.short = short_waves(plate, min(self.end_of_k, self.static_k))

    def sum_of(self, values):
        """Of all oscillators of a wave number."""
        return np.bincount(self.index, values, minlength=len(self.k))

    def static_compliance(self, a, begin):
        """[m/N] of waves beyond k = begin, 1/(2 pi) int P(k a)^2 C(k) k dk."""
        k, weight = panels(np.linspace(begin, max(80 / a, 2 * begin), 200), 8)
        kC = self.short(k)
        # beyond, P^2 falls as 9 / 2 x^-4 in the mean
        tail = kC[-1] * 4.5 / (3 * a**4 * k[-1] ** 3)
        return (weight @ (hertz_transform(k * a) ** 2 * kC) + tail) / (2 * np.pi)

    def tabulate(self, smallest, largest):
        """a C(a) as a polynomial in log a: of the waves that are static throughout, and of those
        that make the radius."""
        log = np.linspace(np.log(smallest), np.log(largest), 80)
        self.tables = [np.polynomial.chebyshev.Chebyshev.fit(
            log, [np.exp(x) * self.static_compliance(np.exp(x), begin) for x in log], 24)
            for begin in (self.end_of_k, self.static_k)]

    def change_with_radius(self, a):
        """C'(a) [1/N]."""
        table = self.tables[1]
        return (table.deriv()(np.log(a)) - table(np.log(a))) / a**2

    def begin(self, force, transform):
        """A step from a force with the transform of its contact."""
        self.load = (force * transform)[self.index]
        self.free_q = self.cos * self.q + self.sin / self.omega * self.v + \
            self.from_first * self.load
        self.free = self.sum_of(self.phi2 * self.free_q)

    def deflection(self, force, a):
        """At the end of the step. [m]"""
        P = hertz_transform(self.k * a)
        return self.weight @ (P * (self.free + self.at_once * P * force)) + \
            force * self.tables[0](np.log(a)) / a

    def finish(self, force, transform):
        load = (force * transform)[self.index]
        self.v = self.cos * self.v - self.omega * self.sin * self.q + \
            self.speed_from_first * self.load + self.speed_from_last * load
        self.q = self.free_q + self.from_last * load


def impact(case, **choices):
    """The case with its results, up to LONGEST times the time of the peak."""
    choice = {**FULL, **choices}
    ball, v = case["impactor"], case["velocity"]
    R = ball["radius"]
    mass = 4 / 3 * np.pi * R**3 * ball["rho"]
    E_ball = ball["E"] / (1 - ball["nu"] ** 2)
    C = stiffness(case["plate"]["ply"])
    K = 4 / 3 * np.sqrt(R) / (1 / E_ball + 1 / C[2, 2])
    hertz = (5 * mass * v**2 / (4 * K)) ** 0.4
    expected = case.get("time_of_peak") or 1.6 * hertz / v
    response = Response(case, choice, expected)
    widest = np.sqrt(R * hertz) * 1.3
    response.tabulate(1e-3 * widest, widest)

    # the force by the radius, and back from a table
    radii = np.geomspace(1e-3 * widest, widest, 400)
    change = response.change_with_radius(radii) - 3 / (5 * E_ball * radii**2)
    forces = -4 * radii / (5 * R * change)
    radii = choice["wider"] * radii

    def radius(force):
        return np.exp(np.interp(np.log(force), np.log(forces), np.log(radii)))

    dt = response.dt
    n_steps = int(np.ceil(LONGEST * choice["steps"]))
    history = np.zeros(n_steps + 1)
    x, u, force, transform = 0.0, v, 0.0, np.ones(len(response.k))
    for n in range(1, n_steps + 1):
        response.begin(force, transform)
        free = x + dt * u - dt**2 / mass * force / 3

        def gap(trial):
            a = radius(trial)
            return (free - dt**2 / mass * trial / 6 - response.deflection(trial, a)
                    - 3 * trial / (5 * E_ball * a) - a**2 / (5 * R))

        high = max(1.05 * history[n - 1] + forces[0], 2 * forces[0])
        while gap(high) > 0:
            high *= 1.5
        low = forces[0]
        if gap(low) <= 0:
            history[n:] = 0
            break
        # the false position with halving (Illinois)
        at_low, at_high = gap(low), gap(high)
        for _ in range(100):
            new = (low * at_high - high * at_low) / (at_high - at_low)
            value = gap(new)
            if value * at_high < 0:
                low, at_low = high, at_high
            else:
                at_low /= 2
            high, at_high = new, value
            if abs(high - low) < 1e-10 * high or abs(value) < 1e-14 * hertz:
                break
        transform = hertz_transform(response.k * radius(new))
        response.finish(new, transform)
        x = free - dt**2 / mass * new / 6
        u -= dt / mass * (force + new) / 2
        history[n] = force = new
    top = int(np.argmax(history))
    if not 0 < top < n_steps:
        sys.exit(f"{case['name']}: no peak until {LONGEST} times {expected} s")
    before, peak, after = history[top - 1 : top + 2]
    shift = (before - after) / (2 * (before - 2 * peak + after))
    peak -= (before - after) * shift / 4
    return {
        **{key: case[key] for key in ("name", "plate", "impactor", "velocity")},
        "peak_force": peak,
        "time_of_peak": (top + shift) * dt,
        "contact_radius_over_thickness": radius(peak) / case["plate"]["thickness"],
    }


def table(header, rows):
    """A Markdown table."""
    for row in (header, ["---"] * len(header), *rows):
        print("| " + " | ".join(row) + " |", flush=True)
    print()


def check(cases, base_choice):
    """Prints what the results owe to the choices made here."""
    finer = {
        "directions doubled": {"directions": 2 * base_choice["directions"]},
        "panels halved": {"phase": base_choice["phase"] / 2},
        "oscillators up to 1.5 times the frequency": {"dynamic": 1.5 * base_choice["dynamic"]},
        "degree higher by 1": {"degree": base_choice["degree"] + 1},
        "half the step": {"steps": 2 * base_choice["steps"]},
        "a radius larger by 1 %": {"wider": 1.01},
    }
    rows = []
    for case in cases:
        base = impact(case, **base_choice)
        for name, choice in finer.items():
            other = impact(case, **{**base_choice, **choice})
            rows.append([case["name"], name] + [f"{100 * (other[key] / base[key] - 1):+.4f}"
                                                for key in ("peak_force", "time_of_peak")])
    table(["case", "change", "peak force %", "time of the peak %"], rows)


def main():
    parser = argparse.ArgumentParser(description="a sphere strikes a laminate")
    parser.add_argument("cases", help="file of cases, JSON")
    parser.add_argument("--only", nargs="+", help="names of cases")
    parser.add_argument("--coarse", action="store_true", help="a tenth of the work")
    parser.add_argument("--check", action="store_true", help="print how the results converge")
    parser.add_argument("--within", type=float, help="largest difference of a peak force, in %%")
    parser.add_argument("--output", help="file for the results, JSON")
    arguments = parser.parse_args()
    with open(arguments.cases, encoding="utf-8") as stream:
        cases = json.load(stream)
    if arguments.only:
        cases = [case for case in cases if case["name"] in arguments.only]
    choice = COARSE if arguments.coarse else FULL
    if arguments.check:
        return check(cases, choice)
    rows, results, far = [], [], []
    for case in cases:
        result = impact(case, **choice)
        results.append(result)
        known = case.get("peak_force")
        change = 100 * (result["peak_force"] / known - 1) if known else 0.0
        later = 100 * (result["time_of_peak"] / case["time_of_peak"] - 1) if known else 0.0
        rows.append([case["name"], f"{result['contact_radius_over_thickness']:.3f}",
                     f"{result['peak_force']:.3f}", f"{change:+.3f}",
                     f"{1e6 * result['time_of_peak']:.3f}", f"{later:+.2f}"])
        print(" ".join(rows[-1]), file=sys.stderr, flush=True)
        allowed = arguments.within or case.get("uncertainty_percent", 100)
        if abs(change) > allowed:
            far.append(f"{case['name']}: {result['peak_force']} N, not {known} within {allowed} %")
    table(["case", "a/h", "peak force N", "%", "at us", "%"], rows)
    if arguments.output:
        with open(arguments.output, "w", encoding="utf-8") as stream:
            json.dump(results, stream, indent=1)
            stream.write("\n")
    if far:
        sys.exit("\n".join(far))


if __name__ == "__main__":
    main()
