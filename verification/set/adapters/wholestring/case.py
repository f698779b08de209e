"""Cases that are made of a problem."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import wholestring as ws

GRAVITY_m_per_s2 = 9.80665
"""That of the engine: weights become masses by it."""

WEIGHTLESS_kg_per_m = 1e-6

Inputs = Mapping[str, Any]
Stations = Sequence[Sequence[float]]


def case(
    stations: Stations,
    string: Sequence[Inputs],
    operation: Inputs,
    *,
    friction: float = 0.0,
    hole_m: float = 0.22,
    mud_kg_per_m3: float = 0.0,
    hole_kind: str = "open",
    **tables: Any,
) -> ws.Case:
    """A case of a single hole, in air but where a mud is given."""
    bottom_m = float(stations[-1][0])
    hole = {"kind": hole_kind, "to": bottom_m, "diameter": hole_m, "friction": friction}
    return ws.Case.from_dict(
        {
            "name": "problem",
            "model": "soft",
            "well": {
                "stations": [[float(number) for number in of] for of in stations],
                "path": "minimum-curvature",
                "hole": [hole],
            },
            "mud": {"density": mud_kg_per_m3},
            "string": list(string),
            "operation": {"bit_depth": bottom_m, "rpm": "60 rpm", **operation},
            **tables,
        }
    )


def stations_of(survey: Inputs) -> list[list[float]]:
    names = ("measured_depth_m", "inclination_deg", "azimuth_deg")
    return [list(row) for row in zip(*(survey[name] for name in names), strict=True)]


def part(of: Inputs, length: float | str = "to surface", **keys: Any) -> dict[str, Any]:
    """A component of the diameters and, where it is given, the weight in mud."""
    made = {
        "component": of.get("name", "pipe"),
        "od": of["outside_diameter_m"],
        "id": of["inside_diameter_m"],
        "length": length,
        **keys,
    }
    if "weight_in_mud_N_per_m" in of:
        mass = of["weight_in_mud_N_per_m"] / GRAVITY_m_per_s2
        made["mass_per_length"] = max(mass, WEIGHTLESS_kg_per_m)
    return made


def steel(of: Inputs) -> dict[str, float]:
    """Elastic constants, as far as the problem has them."""
    names = {
        "youngs_modulus_Pa": "youngs_modulus",
        "shear_modulus_Pa": "shear_modulus",
        "density_kg_per_m3": "density",
    }
    return {new: of[old] for old, new in names.items() if old in of}


def area_m2(outside_diameter_m: float, inside_diameter_m: float) -> float:
    """Cross-section of a pipe."""
    return math.pi / 4 * (outside_diameter_m**2 - inside_diameter_m**2)
