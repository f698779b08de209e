"""Assemblies at rest, and small motions of rods."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import wholestring as ws

from .case import GRAVITY_m_per_s2, Inputs, area_m2, case, part, steel

PINNED = {"top": "pinned", "bit": "pinned"}
BLADE_m = 0.05
COLLARS_m = 120.0
STIFF_Pa = 1e12
SHORTEST_m = 0.2
"""The shortest element of a mesh."""

RIGID = {"contact_law": "linear", "contact_stiffness": 1e11}
"""A wall that gives way by nanometres."""

LIGHTEST_kg_per_m3 = 1000.0
"""A pipe without weight is one of this density, faster by the root of what it lacks."""


def assembly(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Collars in a straight hole, a blade for each stabiliser."""
    string, below_m = [], 0.0
    blades = {"blade_od": inputs["stabiliser_diameter_m"], "blade_length": BLADE_m}
    stabilisers_m = inputs["stabilisers_from_bit_m"]
    for from_bit_m in stabilisers_m:
        string.append(part(inputs, from_bit_m - BLADE_m - below_m))
        string.append(part(inputs, 2 * BLADE_m, **blades))
        below_m = from_bit_m + BLADE_m
    string.append(part(inputs))
    inc = inputs["inclination_deg"]
    found = case(
        [[0.0, inc, 0.0], [COLLARS_m, inc, 0.0]],
        string,
        {"kind": "slide", "wob": max(inputs["weight_on_bit_N"], 1.0)},
        hole_m=inputs["hole_diameter_m"],
        steel=steel(inputs),
        ends=PINNED,
        dynamics=RIGID,
    ).bha(whole=True)
    table = found.contacts
    contacts = [
        dict(zip(table.columns, row, strict=True))
        for row in zip(*(table[name] for name in table.columns), strict=True)
    ]
    forces_N = []
    for from_bit_m in stabilisers_m:
        near = [of for of in contacts if abs(of["from_bit_m"] - from_bit_m) < 2 * BLADE_m]
        forces_N.append(sum(of["force_high_N"] for of in near if of["touching"] == "blades"))
    answers = {
        "bit_side_force_N": found.side_force_N[0],
        "bit_tilt_deg": math.degrees(found.tilt_rad[0]),
        "largest_bending_moment_N_m": found.largest_bending_moment_N_m,
        "stabiliser_side_forces_N": forces_N,
        "tangency_from_bit_m": tangency_m(found, contacts, max([0.0, *stabilisers_m]) + 1.0),
    }
    return {name: answers[name] for name in expected}


def tangency_m(found: ws.Bha, contacts: list[dict[str, Any]], above_m: float) -> float:
    """Distance from the bit at which the collars lie down, above their highest stabiliser.

    The bending moment vanishes there: the last element that is free is drawn on to where it does.
    """
    lies_m = min(
        of["from_bit_m"]
        for of in contacts
        if of["touching"] == "body" and of["from_bit_m"] > above_m
    )
    order = np.argsort(found.nodes["from_bit_m"])
    at_m = found.nodes["from_bit_m"][order]
    moment = found.nodes["bending_moment_high_N_m"][order]
    upper = int(np.argmin(np.abs(at_m - lies_m)))
    slope = (moment[upper] - moment[upper - 1]) / (at_m[upper] - at_m[upper - 1])
    return float(at_m[upper] - moment[upper] / slope)


def lateral(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """A pipe in a wide vertical hole. Each mode comes twice, across two planes."""
    weightless = not inputs["gravity_m_per_s2"]
    density = LIGHTEST_kg_per_m3 if weightless else inputs["density_kg_per_m3"]
    length_m, tension_N = inputs["length_m"], inputs["tension_at_lower_end_N"]
    if weightless:
        # What weight is left pulls at the upper half as much more as it pulls less at the lower.
        pipe_m2 = area_m2(inputs["outside_diameter_m"], inputs["inside_diameter_m"])
        tension_N -= density * pipe_m2 * GRAVITY_m_per_s2 * length_m / 2
    doing: dict[str, Any] = {"kind": "trip_out", "bit_pull": max(tension_N, 0.0)}
    if tension_N < 0:
        doing = {"kind": "slide", "wob": -tension_N}
    count = len(expected["frequencies_Hz"]["value"])
    found = case(
        [[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]],
        [part(inputs)],
        doing,
        hole_m=1.0,
        # So stiff in shear that it does not count.
        steel={**steel({**inputs, "density_kg_per_m3": density}), "shear_modulus": STIFF_Pa},
        ends={"top": inputs["upper_end"], "bit": inputs["lower_end"]},
        mesh={"element_length": max(length_m / 400, SHORTEST_m)},
        modes={"assembly": length_m, "count": 2 * count},
    ).modes()
    lacks = math.sqrt(density / inputs["density_kg_per_m3"])
    return {"frequencies_Hz": found.frequencies_Hz("lateral")[::2] * lacks}


def axial_torsional(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """A string off bottom that hangs from a rigid hoist."""
    length_m = inputs["length_m"]
    found = case(
        [[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]],
        [part(inputs)],
        {"kind": "rotate_off_bottom"},
        steel=steel(inputs),
        hoist={"stiffness": 1e12},
        mesh={"element_length": length_m / 200},
        modes={"count": len(expected["axial_frequencies_Hz"]["value"])},
    ).modes()
    return {
        "axial_frequencies_Hz": np.asarray(found.frequencies_Hz("axial")),
        "torsional_frequencies_Hz": np.asarray(found.frequencies_Hz("torsional")),
    }
