"""Whole strings by the soft string."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import wholestring as ws

from .case import Inputs, case, part, stations_of

OFF_BOTTOM = {"pick_up": "trip_out", "slack_off": "trip_in", "rotating": "rotate_off_bottom"}
ON_BOTTOM = {"drilling": "drill", "sliding": "slide"}
SLOWLY = "1e-9 m/s"
"""So slow that all friction of a string that drills acts around the hole."""


def soft_string(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Hook load, torque, side force, and where the string changes sides."""
    answers: dict[str, Any] = {}
    names = {**OFF_BOTTOM, **ON_BOTTOM, "reaming": "ream"}
    for name, operation in names.items():
        asked = {of for of in expected if of.startswith(name + "_")}
        if not asked:
            continue
        results = string_case(inputs, operation).soft()
        solved = results[operation]
        answers |= {
            f"{name}_hook_load_N": solved.hook_load_N,
            f"{name}_torque_N_m": solved.surface_torque_N_m,
            f"{name}_side_force_total_N": solved.side_force_total_N,
        }
        change = f"{name}_side_change_inclination_deg"
        if change in asked:
            answers[change] = side_change_deg(inputs, results)
    return {name: answers[name] for name in expected}


def string_case(inputs: Inputs, operation: str) -> ws.Case:
    """The case in which an operation is solved."""
    pieces = inputs["string"]
    for of in pieces:
        if not math.isclose(of["contact_radius_m"], of["outside_diameter_m"] / 2):
            raise ValueError("plain pipe touches at half its outside diameter")
    string = [part(of, of["length_m"]) for of in pieces[:-1]]
    string.append(part(pieces[-1]))
    doing: dict[str, Any] = {"kind": operation}
    tables: dict[str, Any] = {}
    if operation == "ream":
        doing["rpm"] = f"{inputs['rotary_speed_rad_per_s']} rad/s"
        doing["trip_speed"] = inputs["axial_speed_m_per_s"]
    elif operation in ON_BOTTOM.values():
        doing |= {"wob": inputs["weight_on_bit_N"], "rop": SLOWLY}
        if operation == "drill":
            tables["bit"] = {"torque": inputs["bit_torque_N_m"]}
    elif "tension_at_bit_N" in inputs:
        doing["bit_pull"] = inputs["tension_at_bit_N"]
    return case(
        stations_of(inputs["survey"]),
        string,
        doing,
        friction=inputs["friction_factor"],
        hole_m=inputs["hole_diameter_m"],
        **tables,
    )


def side_change_deg(inputs: Inputs, results: ws.Results) -> float:
    """Inclination in an arc at which the side force changes its sign."""
    depths, sides = results.nodes["md_m"], results.nodes["side_force_N_per_m"]
    [at] = [i for i in range(len(sides) - 1) if sides[i] * sides[i + 1] < 0]
    way = sides[at] / (sides[at] - sides[at + 1])
    depth_m = depths[at] + way * (depths[at + 1] - depths[at])
    [upper, lower] = inputs["survey"]["inclination_deg"]
    return float(upper + (lower - upper) * depth_m / inputs["survey"]["measured_depth_m"][-1])
