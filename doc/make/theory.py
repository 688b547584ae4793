"""Formulas of textbooks that pages set beside their runs."""

import math


def slow_impact(entries, deflection):
    """A ball that stops on a square plate, when it is so slow that both deform as at
    rest: `deflection` is that of the centre, w D / (P a^2). The plate is a spring in
    series with the contact of Hertz, and they hold the energy of the ball."""
    def entry(name):
        return float(entries[name])

    def compliance(body):
        return (1 - entry(f"{body}/Poisson's ratio")**2) / entry(f"{body}/Young's modulus")

    side = float(entries["Plate/Side lengths"].split(",")[0])
    bending = entry("Plate/Thickness")**3 / 12 / compliance("Plate")
    plate = bending / deflection / side**2
    contact = 4 / 3 * entry("Impactor/Radius")**0.5 / (compliance("Plate") + compliance("Impactor"))
    ball = entry("Impactor/Mass") * entry("Impactor/Velocity")**2 / 2

    low, high = 0.0, (2 * plate * ball)**0.5
    for _ in range(60):
        force = (low + high) / 2
        indentation = (force / contact)**(2 / 3)
        energy = force**2 / 2 / plate + 0.4 * force * indentation
        low, high = (force, high) if energy < ball else (low, force)
    return {"force": force, "deflection": force / plate, "plate_stiffness": plate,
            "contact_stiffness": 1.5 * force / indentation}


def velocity_of_first_yield(points, strength, poissons_ratio):
    """Velocity whose contact pressure is 1.295 exp(0.736 nu) of the strength, between the
    points of an elastic sweep over velocities by a power law. [m/s]"""
    pressure = 1.295 * math.exp(0.736 * poissons_ratio) * strength
    for slow, fast in zip(points, points[1:]):
        if slow["contact_pressure"] <= pressure <= fast["contact_pressure"]:
            share = (math.log(pressure / slow["contact_pressure"]) /
                     math.log(fast["contact_pressure"] / slow["contact_pressure"]))
            return slow["Impactor/Velocity"] * (
                fast["Impactor/Velocity"] / slow["Impactor/Velocity"])**share
    raise ValueError(f"no pressure of the sweep is near {pressure:g} Pa")


def bending_wavelength(entries, half_period):
    """Of a bending wave on the plate, omega^2 rho t = D k^4. [m]"""
    thickness, ratio = (float(entries[f"Plate/{name}"]) for name in ("Thickness", "Poisson's ratio"))
    stiffness = float(entries["Plate/Young's modulus"]) * thickness**3 / 12 / (1 - ratio**2)
    mass = float(entries["Plate/Density"]) * thickness
    return 2 * math.pi * (stiffness / mass)**0.25 / (math.pi / half_period)**0.5


def shear_stiffness(entries):
    """kappa G t. [N/m]"""
    modulus, ratio, thickness, factor = (float(entries[f"Plate/{name}"]) for name in (
        "Young's modulus", "Poisson's ratio", "Thickness", "Shear correction factor"))
    return factor * modulus / 2 / (1 + ratio) * thickness


def give_per_halving(entries, force):
    """By how much more the plate deflects, by shear, where a force comes from half the
    distance. [m]"""
    return force * math.log(2) / (2 * math.pi * shear_stiffness(entries))
