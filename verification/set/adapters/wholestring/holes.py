"""Well paths, buckling, lock-up, and how far a well can go."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import wholestring as ws

from .case import Inputs, case, part, stations_of, steel

SPAN_m = 0.2
"""So short that its arc has one curvature and the string in it one tension."""

SMALL_N = 1.0

CRITERIA = {
    "sinusoidal_load_N": ("he-kyllingstad", "sinusoidal_load_N"),
    "helical_load_N": ("he-kyllingstad", "helical_load_N"),
    "full_helix_load_N": ("wu-juvkam-wold", "helical_load_N"),
}


def well_path(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Positions of the stations, between two places of the path by direction and place."""
    stations = stations_of(inputs["survey"])
    hole_m = 0.3
    string = [{"component": "pipe", "od": 0.127, "id": 0.1086, "length": "to surface"}]
    made = case(stations, string, {"kind": "trip_out"}, hole_m=hole_m)
    path = made.well_path()
    depth_m = path["md_m"]
    inclination, azimuth = path["inclination_rad"], path["azimuth_rad"]
    directions = {
        "north_m": np.sin(inclination) * np.cos(azimuth),
        "east_m": np.sin(inclination) * np.sin(azimuth),
        "true_vertical_depth_m": np.cos(inclination),
    }
    at = np.array([of[0] for of in stations])
    answers: dict[str, Any] = {}
    for name, slope in directions.items():
        column = path["tvd_m" if name == "true_vertical_depth_m" else name]
        found = hermite(at, depth_m, column, slope)
        found += inputs[f"first_{name}"] - found[0]
        answers[name] = found
        answers[f"end_{name}"] = found[-1]
    return {name: answers[name] for name in expected}


def hermite(at: Any, x: Any, y: Any, slope: Any) -> Any:
    """Cubics through places and directions."""
    i = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(x) - 2)
    h = x[i + 1] - x[i]
    t = (at - x[i]) / h
    return (
        (1 + 2 * t) * (1 - t) ** 2 * y[i]
        + t * (1 - t) ** 2 * h * slope[i]
        + t**2 * (3 - 2 * t) * y[i + 1]
        + t**2 * (t - 1) * h * slope[i + 1]
    )


def buckling_load(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Loads in a short arc of the curvature, under next to no compression."""
    half = SPAN_m / 2 / 30
    build, turn = inputs["build_rate_deg_per_30m"], inputs["turn_rate_deg_per_30m"]
    inc = inputs["inclination_deg"]
    stations = [
        [0.0, inc - half * build, 90 - half * turn],
        [SPAN_m, inc + half * build, 90 + half * turn],
    ]
    answers: dict[str, Any] = {}
    for name, (criterion, column) in CRITERIA.items():
        if name not in expected:
            continue
        solved = case(
            stations,
            [part(inputs)],
            {"kind": "slide", "wob": SMALL_N},
            hole_m=inputs["hole_diameter_m"],
            steel=steel(inputs),
            buckling={"criterion": criterion},
        ).soft()
        # The two ends are half the span off the place, to either side.
        answers[name] = float(np.mean(solved.nodes[column]))
    return answers


def lock_up(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """The push at a length, and the length at which no push is enough."""
    answers: dict[str, Any] = {}
    for length_m in (inputs["length_m"], 100.0):
        made = case(
            [[0.0, 90.0, 0.0], [length_m, 90.0, 0.0]],
            [part(inputs)],
            {"kind": "slide", "wob": max(inputs["compression_at_bit_N"], 1e-3)},
            friction=inputs["friction_factor"],
            hole_m=inputs["hole_diameter_m"],
            steel=steel(inputs),
            buckling={"criterion": inputs["helix_criterion"], "helix_side_force": "counted"},
        )
        if length_m == inputs["length_m"]:
            answers["push_N"] = -made.soft()["slide"].hook_load_N
        else:
            found = made.reach(to="10 km", operation="slide")
            answers["lock_up_length_m"] = limit_m(found, "slide", "push_absorbed")
    return answers


def reach(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Depths at which limits stop a string that grows with its hole."""
    if inputs["contact_radius_m"] != inputs["outside_diameter_m"] / 2:
        raise ValueError("plain pipe touches at half its outside diameter")
    made = case(
        stations_of(inputs["survey"]),
        [part(inputs)],
        {"kind": "drill", "wob": inputs["weight_on_bit_N"], "rop": "1e-9 m/s"},
        friction=inputs["friction_factor"],
        hole_m=inputs["hole_diameter_m"],
        bit={"torque": inputs["bit_torque_N_m"]},
        rig={"top_drive_torque": inputs["torque_limit_N_m"]},
    )
    operations = ("drill", "rotate_off_bottom", "trip_in", "slide")
    found = made.reach(to="30 km", operation=operations, no_helix_friction=True)
    return {
        "drilling_torque_limit_depth_m": limit_m(found, "drill", "top_drive"),
        "rotating_torque_limit_depth_m": limit_m(found, "rotate_off_bottom", "top_drive"),
        "slack_off_zero_hook_load_depth_m": limit_m(found, "trip_in", "hook_load_zero"),
        "sliding_zero_hook_load_depth_m": limit_m(found, "slide", "hook_load_zero"),
    }


def limit_m(found: ws.Reach, operation: str, limit: str) -> float:
    """The depth at which a limit is met."""
    rows = zip(
        found.limits["operation"], found.limits["limit"], found.limits["depth_m"], strict=True
    )
    [depth_m] = [depth_m for of, kind, depth_m in rows if (of, kind) == (operation, limit)]
    return float(depth_m)
