"""wholestring, by its Python package."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from typing import Any

import wholestring as ws

from . import assemblies, holes, pipes, strings

PROGRAM = f"wholestring {ws.__version__}"

NOTES = {
    "cantilever": "The Python package solves strings in holes; the tests of the engine hold these.",
    "casing_wear": "The plan tells the depth of a groove, not its volume.",
    "lateral_frequency": "A pipe without weight is a light one under the same mean tension.",
    "pipe_stress": "Stresses are those of strings in their holes: a pipe that is bent or under "
    "pressure by itself is not answered.",
}

KINDS: dict[str, Callable[[Mapping[str, Any], Mapping[str, Any]], dict[str, Any]]] = {
    "assembly": assemblies.assembly,
    "axial_torsional_frequency": assemblies.axial_torsional,
    "buckling_load": holes.buckling_load,
    "casing_wear": pipes.casing_wear,
    "joint_bending": pipes.joint_bending,
    "lateral_frequency": assemblies.lateral,
    "lock_up": holes.lock_up,
    "overpull": pipes.overpull,
    "pipe_strength": pipes.pipe_strength,
    "pipe_stress": pipes.pipe_stress,
    "reach": holes.reach,
    "soft_string": strings.soft_string,
    "stretch": pipes.stretch,
    "well_path": holes.well_path,
}


def answers(problem: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers by name."""
    solve = KINDS.get(problem["kind"])
    if solve is None:
        raise NotImplementedError
    with warnings.catch_warnings():
        # Problems have what no rig has: pipes without weight, a weight on bit of 1 N.
        warnings.simplefilter("ignore", ws.CaseWarning)
        return solve(problem["inputs"], problem["expected"])
