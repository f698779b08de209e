"""The work that every program is given, and what it must answer.

A plain pipe hangs in a well that goes down, builds at a constant rate and then goes straight, all
in one vertical plane. Coordinates: x along the departure, y across the plane, z down, all in m; s
is the measured depth in m.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Problem:
    """What `problem.json` declares; units stand in the names."""

    length_m: float
    element_length_m: float
    stations_md_m_inc_deg_azi_deg: list[list[float]]
    build_md_m_inc_deg_azi_deg: list[list[float]]
    drop_md_m_inc_deg_azi_deg: list[list[float]]
    station_spacing_m: float
    hole_diameter_m: float
    outside_diameter_m: float
    inside_diameter_m: float
    density_kg_per_m3: float
    youngs_modulus_Pa: float
    shear_modulus_Pa: float
    gravity_m_per_s2: float
    friction: float
    rotary_speed_rpm: float
    trip_speed_m_per_s: float
    contact_stiffness_N_per_m: float
    contact_damping_ratio: float
    damping_mass_per_s: float
    damping_stiffness_s: float

    @staticmethod
    def read() -> Problem:
        text = Path(__file__).with_name("problem.json").read_text(encoding="utf-8")
        return Problem(**json.loads(text))

    @property
    def elements(self) -> int:
        return round(self.length_m / self.element_length_m)

    @property
    def kick_off_m(self) -> float:
        return self.stations_md_m_inc_deg_azi_deg[1][0]

    @property
    def build_end_m(self) -> float:
        return self.stations_md_m_inc_deg_azi_deg[2][0]

    @property
    def inclination_rad(self) -> float:
        """Of the tangent, from the vertical."""
        return math.radians(self.stations_md_m_inc_deg_azi_deg[2][1])

    @property
    def curvature_per_m(self) -> float:
        return self.inclination_rad / (self.build_end_m - self.kick_off_m)

    @property
    def radius_m(self) -> float:
        return self.outside_diameter_m / 2

    @property
    def clearance_m(self) -> float:
        """Between pipe and wall where the pipe is in the middle."""
        return (self.hole_diameter_m - self.outside_diameter_m) / 2

    @property
    def area_m2(self) -> float:
        return math.pi / 4 * (self.outside_diameter_m**2 - self.inside_diameter_m**2)

    @property
    def second_moment_m4(self) -> float:
        return math.pi / 64 * (self.outside_diameter_m**4 - self.inside_diameter_m**4)

    @property
    def shear_coefficient(self) -> float:
        """Cowper's, of a hollow circle."""
        nu = self.youngs_modulus_Pa / (2 * self.shear_modulus_Pa) - 1
        m2 = (self.inside_diameter_m / self.outside_diameter_m) ** 2
        top = 6 * (1 + nu) * (1 + m2) ** 2
        return top / ((7 + 6 * nu) * (1 + m2) ** 2 + (20 + 12 * nu) * m2)

    @property
    def weight_N_per_m(self) -> float:
        return self.density_kg_per_m3 * self.area_m2 * self.gravity_m_per_s2

    @property
    def rotary_speed_rad_per_s(self) -> float:
        return self.rotary_speed_rpm * 2 * math.pi / 60

    def inclination_at(self, s: Array) -> Array:
        """Inclination in rad at the measured depths `s` in m."""
        return np.clip((s - self.kick_off_m) * self.curvature_per_m, 0, self.inclination_rad)

    def position_at(self, s: Array) -> Array:
        """Points of the hole's axis in m, a row for each measured depth in m."""
        inc = self.inclination_at(s)
        along = np.maximum(s - self.build_end_m, 0)
        x = (1 - np.cos(inc)) / self.curvature_per_m + along * math.sin(self.inclination_rad)
        z = np.minimum(s, self.kick_off_m) + np.sin(inc) / self.curvature_per_m
        z = z + along * math.cos(self.inclination_rad)
        return np.column_stack([x, np.zeros_like(x), z])

    def tangent_at(self, s: Array) -> Array:
        """Unit vectors towards the bit, a row for each measured depth in m."""
        inc = self.inclination_at(s)
        return np.column_stack([np.sin(inc), np.zeros_like(inc), np.cos(inc)])

    def high_side_at(self, s: Array) -> Array:
        """Unit vectors across the hole, up, a row for each measured depth in m."""
        inc = self.inclination_at(s)
        return np.column_stack([np.cos(inc), np.zeros_like(inc), -np.sin(inc)])


@dataclass(frozen=True)
class Profile:
    """The soft string's answer along the hole, from the top to the bit."""

    s_m: Array
    tension_N: Array
    torque_N_m: Array
    """Of a pipe that has climbed the wall, 1/sqrt(1 + mu^2) of that of one that has not."""
    side_force_N_per_m: Array
    """Of the wall on the string, positive from the low side upwards."""


def soft_string(problem: Problem, axial: int, turning: bool) -> Profile:
    """The string without bending stiffness, by the midpoint rule in pieces of 0.1 m.

    `axial` is 1 where the string is pulled out, -1 where it is run in, 0 where friction has no part
    along the hole. In a vertical plane the side force is w sin I - T dI/ds.
    """
    s = np.linspace(0, problem.length_m, round(problem.length_m * 10) + 1)
    ds = s[1] - s[0]
    middle = (s[1:] + s[:-1]) / 2
    inc = problem.inclination_at(middle)
    build = np.where(
        (middle > problem.kick_off_m) & (middle < problem.build_end_m), problem.curvature_per_m, 0.0
    )
    w, mu = problem.weight_N_per_m, problem.friction
    tension, torque = np.zeros_like(s), np.zeros_like(s)
    side = np.zeros_like(s)
    for i in range(len(middle) - 1, -1, -1):
        down, across = w * math.cos(inc[i]), w * math.sin(inc[i])
        half = tension[i + 1]
        for _ in range(2):
            side[i] = across - half * build[i]
            rate = down + axial * mu * abs(side[i])
            half = tension[i + 1] + rate * ds / 2
        tension[i] = tension[i + 1] + rate * ds
        torque[i] = torque[i + 1] + turning * mu * abs(side[i]) * problem.radius_m * ds
    side[-1] = side[-2]
    torque /= math.sqrt(1 + mu**2)
    return Profile(s, tension, torque, side)


@dataclass(frozen=True)
class Laid:
    """The string at the start: on the wall, climbed, with the soft string's stretch and twist."""

    position_m: Array
    """A row for each node, from the top."""
    twist_rad: Array
    """How far each node is behind the top."""


def laid(problem: Problem) -> Laid:
    """Nodes on the wall where the soft string's side force puts them, passing over in some 30 m."""
    p, answer = problem, soft_string(problem, 0, True)
    s = np.linspace(0, p.length_m, p.elements + 1)
    length = s[1]
    side = np.interp(s, answer.s_m, answer.side_force_N_per_m)
    on_high_side = -np.sign(side) * (np.abs(side) > 1)
    window = np.hanning(round(30 / length) + 2)
    near = np.convolve(np.pad(on_high_side, len(window), "edge"), window / window.sum(), "same")
    into_wall = np.abs(side) * length / p.contact_stiffness_N_per_m
    offset = near[len(window) : -len(window)] * (p.clearance_m + into_wall)
    strain = answer.tension_N / (p.youngs_modulus_Pa * p.area_m2)
    # A turning pipe climbs until its friction carries its share of the load.
    climb = math.atan(p.friction)
    across = np.array([0.0, -math.sin(climb), 0.0])
    chord = length * (1 + np.interp((s[1:] + s[:-1]) / 2, answer.s_m, strain))
    # Chords on the inner side of a bend are shorter than the axis: found by trial.
    along = np.concatenate([[0], np.cumsum(chord)])
    for _ in range(10):
        outward = math.cos(climb) * p.high_side_at(along) + across
        position = p.position_at(along) + offset[:, None] * outward
        made = np.linalg.norm(np.diff(position, axis=0), axis=1)
        along = np.concatenate([[0], np.cumsum(np.diff(along) * chord / made)])
    rate = answer.torque_N_m / (2 * p.shear_modulus_Pa * p.second_moment_m4)
    ds = np.diff(answer.s_m)
    behind = np.concatenate([[0], np.cumsum((rate[1:] + rate[:-1]) / 2 * ds)])
    return Laid(position, np.interp(s, answer.s_m, behind))


if __name__ == "__main__":
    work = Problem.read()
    for name, axial, turning in (("turning", 0, True), ("out", 1, False), ("in", -1, False)):
        answer = soft_string(work, axial, turning)
        print(name, answer.tension_N[0], answer.torque_N_m[0])
