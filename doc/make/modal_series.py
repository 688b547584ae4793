"""An impact on a simply supported plate by the series of its modes, apart from the program.

A Reissner-Mindlin plate whose edges can neither sink nor turn about their normals moves in products
of sines (Navier's solution). A mode has two frequencies, of bending and of shear. Its motion under a
force that is linear in a step is known exactly, so only the force on the ball, of Hertz's law with a
half-space, needs the steps.
"""
import math

import numpy

SHEAR_CORRECTION = 5 / 6


def modes(plate, impact_point, radius, most):
    """Angular frequencies of the modes [1/s], and the displacement under the load per force and
    acceleration of each [1/kg].

    plate: side lengths, thickness, Young's modulus, Poisson's ratio and density; SI units
    radius: of the disc with Hertz's pressure, which loads the plate and weighs its displacement [m]
    most: wavenumbers up to this over the radius
    """
    a, b, h, modulus, nu, rho = plate
    k = [numpy.arange(1, int(most / radius * side / math.pi) + 1) * math.pi / side
         for side in (a, b)]
    shape = numpy.outer(*(numpy.sin(k_d * (0.5 * side + x))
                          for k_d, side, x in zip(k, (a, b), impact_point)))
    k2 = numpy.add.outer(k[0]**2, k[1]**2)
    moved = (k2 < (most / radius)**2) & (abs(shape) > 1e-9)
    k2, shape = k2[moved], shape[moved]
    z = radius * numpy.sqrt(k2)
    shape = shape * 3 * (numpy.sin(z) - z * numpy.cos(z)) / z**3
    # deflection and potential of the rotations, scaled to masses of 1
    shear = SHEAR_CORRECTION * modulus / (2 * (1 + nu)) * h
    bending = modulus * h**3 / (12 * (1 - nu**2))
    mass = rho * h
    k_ww, k_wp = shear * k2 / mass, -shear * numpy.sqrt(12 * k2) / (mass * h)
    k_pp = 12 * (shear + bending * k2) / (mass * h**2)
    half_sum, root = 0.5 * (k_ww + k_pp), numpy.hypot(0.5 * (k_ww - k_pp), k_wp)
    upper = half_sum + root
    squares = numpy.concatenate([(k_ww * k_pp - k_wp**2) / upper, upper])
    part = numpy.tile(k_wp**2, 2) / (numpy.tile(k_wp**2, 2) + (squares - numpy.tile(k_ww, 2))**2)
    return numpy.sqrt(squares), part * numpy.tile(shape**2, 2) / (0.25 * a * b * mass)


def indentation(overlap, compliance, stiffness):
    """The root of indentation + compliance * stiffness * indentation^1.5 = overlap."""
    root = overlap
    while True:
        excess = root + compliance * stiffness * root**1.5 - overlap
        root -= excess / (1 + 1.5 * compliance * stiffness * root**0.5)
        if abs(excess) < 1e-14 * overlap:
            return root


def history(plate, impact_point, load_radius, stiffness, mass, velocity, dt, most):
    """Forces [N] after every step, until the ball leaves the plate.

    stiffness: force over indentation^1.5 of Hertz's law [N/m^1.5]
    """
    omega, share = modes(plate, impact_point, load_radius, most)
    cos, sin = numpy.cos(omega * dt), numpy.sin(omega * dt)
    # displacements and velocities after a step, by the force at its beginning and its end
    of_first = share * (sin / (omega * dt) - cos) / omega**2
    of_last = share * (1 - sin / (omega * dt)) / omega**2
    v_first = share * (omega * sin - (1 - cos) / dt) / omega**2
    v_last = share * (1 - cos) / dt / omega**2
    compliance = of_last.sum() + dt**2 / (6 * mass)
    z, z_rate = numpy.zeros_like(omega), numpy.zeros_like(omega)
    position, forces = 0.0, [0.0]
    while velocity > 0 or forces[-1] > 0:
        force = forces[-1]
        free = cos * z + sin / omega * z_rate + of_first * force
        position += dt * velocity - dt**2 / (3 * mass) * force
        overlap = position - free.sum()
        now = stiffness * indentation(overlap, compliance, stiffness)**1.5 if overlap > 0 else 0.0
        z_rate = cos * z_rate - omega * sin * z + v_first * force + v_last * now
        z = free + of_last * now
        position -= dt**2 / (6 * mass) * now
        velocity -= 0.5 * dt / mass * (force + now)
        forces.append(now)
    return numpy.array(forces)


def peak_force(plate, impact_point, load_radius, stiffness, mass, velocity):
    """The largest force [N], and how far half the steps and fewer modes are from it."""
    omega, share = modes(plate, impact_point, load_radius, 12)
    # half a period of the ball on the plate as a spring
    time = math.pi * math.sqrt(mass * (share / omega**2).sum())
    of_ball = 2.87 * (mass**2 / (stiffness**2 * 0.5625 * velocity))**0.2
    coarse, fine = (history(plate, impact_point, load_radius, stiffness, mass, velocity,
                            math.hypot(time, of_ball) / steps, most).max()
                    for steps, most in ((5000, 9), (10000, 12)))
    return fine, abs(coarse / fine - 1)
