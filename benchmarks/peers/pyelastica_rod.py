"""The turning string in PyElastica: a Cosserat rod, an explicit step, a wall of our own.

The package has contact of rods with planes, cylinders and each other, but no hole around a rod. The
wall here is a forcing compiled by numba as the package's own parts are: the nearest point of the
hole's axis in closed form, a linear spring and dashpot, Coulomb friction on a cone that is linear
below a slip of 1 cm/s.
"""

from __future__ import annotations

import argparse
import math
import time
from importlib.metadata import version
from typing import Any

import elastica as ea
import numpy as np
from numba import njit

from measured import Means, Measured
from problem import Array, Problem, laid

SLIP_m_per_s = 0.01
# See `Damping`.
ACROSS_per_s = 40.0
# The largest that held; the next one tried did not.
STEP_s = {"section": 38e-6, "raised": 420e-6}
TUNED = {
    "section": "explicit: 40 µs blows up within half a second",
    "raised": "explicit: 440 µs blows up within a tenth of a second",
}


class Simulator(ea.BaseSystemCollection, ea.Constraints, ea.Forcing, ea.Damping):
    """A system of rods with boundary conditions, forces and damping."""


@njit(cache=True)
def wall(
    position: Array,
    velocity: Array,
    omega: Array,
    forces: Array,
    torques: Array,
    hole: Array,
    pipe: Array,
) -> None:
    """Adds the wall's forces on nodes (N) and moments on elements (N.m, in their own frames).

    `hole`: kick-off (m), inclination (rad), curvature (1/m). `pipe`: radius, clearance (m),
    stiffness (N/m), dashpot (N.s/m), friction.
    """
    kick_off, inclination, curvature = hole
    radius, clearance, stiffness, dashpot, friction = pipe
    sine, cosine = math.sin(inclination), math.cos(inclination)
    end_x = (1 - cosine) / curvature
    end_z = kick_off + sine / curvature
    nodes = position.shape[1]
    for i in range(nodes):
        x, y, z = position[0, i], position[1, i], position[2, i]
        along = (x - end_x) * sine + (z - end_z) * cosine
        if z <= kick_off:
            inc, across = 0.0, x
        elif along < 0:
            from_centre_x, from_centre_z = 1 / curvature - x, z - kick_off
            inc = math.atan2(from_centre_z, from_centre_x)
            across = 1 / curvature - math.hypot(from_centre_x, from_centre_z)
        else:
            inc, across = inclination, (x - end_x) * cosine - (z - end_z) * sine
        offset = math.hypot(across, y)
        depth = offset - clearance
        if depth <= 0:
            continue
        # Outward normal, in the plane and across it.
        n_x, n_y, n_z = (
            across / offset * math.cos(inc),
            y / offset,
            -across / offset * math.sin(inc),
        )
        t_x, t_z = math.sin(inc), math.cos(inc)
        v_x, v_y, v_z = velocity[0, i], velocity[1, i], velocity[2, i]
        into = v_x * n_x + v_y * n_y + v_z * n_z
        normal = max(stiffness * depth + dashpot * into, 0.0)
        # Around: t x n, the way the surface goes that turns to the right.
        a_x, a_y, a_z = -t_z * n_y, t_z * n_x - t_x * n_z, t_x * n_y
        above, below = max(i - 1, 0), min(i, nodes - 2)
        spin = 0.5 * (omega[2, above] + omega[2, below])
        around = v_x * a_x + v_y * a_y + v_z * a_z + spin * radius
        down = v_x * t_x + v_z * t_z
        sliding = math.hypot(around, down)
        drag = friction * normal / max(sliding, SLIP_m_per_s)
        drag_a, drag_t = -drag * around, -drag * down
        forces[0, i] += -normal * n_x + drag_a * a_x + drag_t * t_x
        forces[1, i] += -normal * n_y + drag_a * a_y
        forces[2, i] += -normal * n_z + drag_a * a_z + drag_t * t_z
        # About the axis; the force along the pipe bends it by next to nothing.
        torques[2, above] += 0.5 * drag_a * radius
        torques[2, below] += 0.5 * drag_a * radius


class Wall(ea.NoForces):
    """The hole around the rod."""

    def __init__(self, problem: Problem, node_mass_kg: float) -> None:
        super().__init__()
        p = problem
        dashpot = (
            2 * p.contact_damping_ratio * math.sqrt(p.contact_stiffness_N_per_m * node_mass_kg)
        )
        self.hole = np.array([p.kick_off_m, p.inclination_rad, p.curvature_per_m])
        self.pipe = np.array(
            [p.radius_m, p.clearance_m, p.contact_stiffness_N_per_m, dashpot, p.friction]
        )

    def apply_forces(self, system: ea.CosseratRod, time: float = 0.0) -> None:
        wall(
            system.position_collection,
            system.velocity_collection,
            system.omega_collection,
            system.external_forces,
            system.external_torques,
            self.hole,
            self.pipe,
        )


class TopDrive(ea.ConstraintBase):
    """The top stays where it is and turns at a constant speed."""

    def __init__(
        self, position: Array, directors: Array, speed_rad_per_s: float, **kwargs: Any
    ) -> None:
        super().__init__(**kwargs)
        self.position = position.copy()
        self.speed_rad_per_s = speed_rad_per_s

    def constrain_values(self, system: ea.CosseratRod, time: float) -> None:
        system.position_collection[:, 0] = self.position

    def constrain_rates(self, system: ea.CosseratRod, time: float) -> None:
        system.velocity_collection[:, 0] = 0.0
        system.omega_collection[:2, 0] = 0.0
        system.omega_collection[2, 0] = self.speed_rad_per_s


class Damping(ea.DamperBase):
    """In proportion to mass, against the string's rigid turning, and more of turns across the axis.

    The package takes the moments that depend on velocities, a turning rod's gyroscopic one among
    them, half a step late. That feeds the mode in which sections turn against the axis until the
    run blows up. The mode is the fastest there is and says nothing of the string; damping holds it.
    """

    def __init__(self, problem: Problem, step_s: float, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.keeps = math.exp(-problem.damping_mass_per_s * step_s)
        self.keeps_across = math.exp(-ACROSS_per_s * step_s)
        self.turning = (1 - self.keeps) * problem.rotary_speed_rad_per_s

    def dampen_rates(self, system: ea.CosseratRod, time: float) -> None:
        system.velocity_collection *= self.keeps
        system.omega_collection[:2] *= self.keeps_across
        system.omega_collection[2] *= self.keeps
        system.omega_collection[2] += self.turning


def rod(problem: Problem, inertia: str) -> ea.CosseratRod:
    """The string, lying on the wall with the soft string's stretch and twist, turning."""
    p, n = problem, problem.elements
    made = ea.CosseratRod.straight_rod(
        n,
        np.zeros(3),
        np.array([0.0, 0.0, 1.0]),
        np.array([1.0, 0.0, 0.0]),
        p.length_m,
        math.sqrt(p.area_m2 / math.pi),
        p.density_kg_per_m3,
        youngs_modulus=p.youngs_modulus_Pa,
        shear_modulus=p.shear_modulus_Pa,
    )
    # The package's rods are solid and round: a pipe has other moments of inertia.
    second_moment, length = p.second_moment_m4, p.length_m / n
    ea_N, gj_N_m2 = p.youngs_modulus_Pa * p.area_m2, 2 * p.shear_modulus_Pa * second_moment
    shear_N = p.shear_coefficient * p.shear_modulus_Pa * p.area_m2
    bend_N_m2 = p.youngs_modulus_Pa * second_moment
    across = p.density_kg_per_m3 * second_moment * length
    about = 2 * across
    if inertia == "raised":
        # Hinton, Rock and Zienkiewicz's: that of a lumped mass matrix, both ends of an element.
        across += p.density_kg_per_m3 * p.area_m2 * length**3 / 39
    for i, value in enumerate((shear_N, shear_N, ea_N)):
        made.shear_matrix[i, i, :] = value
    for i, value in enumerate((bend_N_m2, bend_N_m2, gj_N_m2)):
        made.bend_matrix[i, i, :] = value
    for i, value in enumerate((across, across, about)):
        made.mass_second_moment_of_inertia[i, i, :] = value
        made.inv_mass_second_moment_of_inertia[i, i, :] = 1 / value

    start = laid(p)
    made.position_collection[:] = start.position_m.T
    tangents = np.diff(start.position_m, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    twist = -(start.twist_rad[1:] + start.twist_rad[:-1]) / 2
    out = np.column_stack([np.zeros(n), np.ones(n), np.zeros(n)])
    in_plane = np.cross(out, tangents)
    cos, sin = np.cos(twist)[:, None], np.sin(twist)[:, None]
    first = cos * in_plane + sin * out
    made.director_collection[0] = first.T
    made.director_collection[1] = np.cross(tangents, first).T
    made.director_collection[2] = tangents.T
    made.omega_collection[2] = p.rotary_speed_rad_per_s
    return made


def run(problem: Problem, inertia: str, step_s: float, simulated_s: float) -> Measured:
    """Settles for half of the time, takes means over the other half."""
    string = rod(problem, inertia)
    speed = problem.rotary_speed_rad_per_s
    simulator = Simulator()
    simulator.append(string)
    simulator.constrain(string).using(
        TopDrive,
        constrained_position_idx=(0,),
        constrained_director_idx=(0,),
        speed_rad_per_s=speed,
    )
    gravity = np.array([0.0, 0.0, problem.gravity_m_per_s2])
    simulator.add_forcing_to(string).using(ea.GravityForces, acc_gravity=gravity)
    node_kg = (
        problem.weight_N_per_m / problem.gravity_m_per_s2 * problem.length_m / problem.elements
    )
    simulator.add_forcing_to(string).using(Wall, problem, node_kg)
    simulator.dampen(string).using(Damping, problem, step_s)
    simulator.finalize()
    stepper = ea.PositionVerlet()
    # Compiles what numba compiles, which does not count.
    now = stepper.step(simulator, 0.0, step_s)
    steps, means = round(simulated_s / step_s), Means()
    every = max(round(0.01 / step_s), 1)
    begin = time.process_time()
    for step in range(1, steps):
        now = stepper.step(simulator, now, step_s)
        if step % every == 0 and 2 * step >= steps:
            means.add(string.internal_stress[2, 0], -string.internal_couple[2, 0])
    cpu_s = time.process_time() - begin
    hook_load_N, torque_N_m = means.of()
    return Measured(
        program="PyElastica",
        version=version("pyelastica"),
        variant="inertia raised" if inertia == "raised" else "",
        elements=problem.elements,
        step_s=step_s,
        simulated_s=steps * step_s,
        cpu_s=cpu_s,
        hook_load_N=hook_load_N,
        torque_N_m=torque_N_m,
        tuned=TUNED[inertia],
        leaves_out="a hole (written here), statistics, results on disk",
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--inertia", choices=["section", "raised"], default="section")
    parser.add_argument("--step", type=float, help="s; default: the largest that holds")
    parser.add_argument("--seconds", type=float, default=2.0, help="simulated")
    given = parser.parse_args()
    step_s = given.step or STEP_s[given.inertia]
    run(Problem.read(), given.inertia, step_s, given.seconds).write()
