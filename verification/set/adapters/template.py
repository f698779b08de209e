"""A template: copy it, and fill in what your program answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

PROGRAM = "your program and its version"

# By kind or by the name of a problem: where your program assumes something else than the problem
# asks for. The notes stand under the table of results.
NOTES = {"soft_string": "what differs, and why"}


def answers(problem: Mapping[str, Any]) -> dict[str, float | list[float]]:
    """Numbers by name, SI and degrees; leave out what your program does not know."""
    inputs = problem["inputs"]
    if problem["kind"] == "stretch" and inputs["mud_density_kg_per_m3"] == 0.0:
        weight = inputs["density_kg_per_m3"] * inputs["gravity_m_per_s2"]
        return {"stretch_m": weight * inputs["length_m"] ** 2 / (2 * inputs["youngs_modulus_Pa"])}
    # Outside of what the program does.
    raise NotImplementedError
