"""A problem of the set, and the numbers that are expected of it."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

SOURCES = Path(__file__).parents[2]
OWN_LICENCE = "MIT OR Apache-2.0"

INCH_M = 0.0254
POUND_FORCE_N = 4.4482216152605
FOOT_POUND_N_m = POUND_FORCE_N * 12 * INCH_M
PSI_Pa = POUND_FORCE_N / INCH_M**2

Json = dict[str, Any]


def read(name: str) -> Json:
    """A file of `verification/`."""
    data: Json = json.loads((SOURCES / name).read_text(encoding="utf-8"))
    return data


def relative(value: float | Sequence[float], most: float, reason: str) -> Json:
    """A number or a list of them that an answer may miss by a part of itself."""
    return {"value": value, "tolerance": {"relative": most}, "reason": reason}


def absolute(value: float | Sequence[float], most: float, reason: str) -> Json:
    """A number or a list of them that an answer may miss by so much, in its own unit."""
    return {"value": value, "tolerance": {"absolute": most}, "reason": reason}


def problem(
    *,
    name: str,
    title: str,
    kind: str,
    file: str,
    source: str,
    assumptions: Sequence[str],
    inputs: Json,
    expected: Json,
    licence: str = OWN_LICENCE,
) -> Json:
    """What stands in the file of a problem."""
    return {
        "id": name,
        "title": title,
        "kind": kind,
        "source": {"what": source, "file": f"verification/{file}", "licence": licence},
        "assumptions": list(assumptions),
        "inputs": inputs,
        "expected": expected,
    }


def survey(stations: Sequence[Sequence[float]]) -> Json:
    """Stations of measured depth in m, inclination and azimuth in degrees."""
    names = ("measured_depth_m", "inclination_deg", "azimuth_deg")
    columns = zip(*stations, strict=True)
    return {name: list(column) for name, column in zip(names, columns, strict=True)}


def named(number: float) -> str:
    """A number as it stands in the name of a problem: 0.35 as `0-35`, -3 as `minus-3`."""
    return f"{number:g}".replace("-", "minus-").replace(".", "-")


def area_m2(outside_diameter_m: float, inside_diameter_m: float) -> float:
    """Cross-section of a pipe."""
    return math.pi / 4 * (outside_diameter_m**2 - inside_diameter_m**2)
