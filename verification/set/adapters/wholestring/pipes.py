"""What a pipe bears and how it bends: by a string that hangs, or lies in a short arc."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import wholestring as ws

from .case import GRAVITY_m_per_s2, Inputs, case, part, steel

HANGS_m = 5000.0
"""So long that a pipe of a likely mass pulls at its top as hard as a problem wants."""

ARC_m = 0.2
LEVEL_m = 60.0
HEAVY_N_per_m = 1500.0
PSI_Pa = 6894.757293168361

SMALL_N = 10.0
"""A tension of no account; without any there is no limit of it."""


def hanging(
    inputs: Inputs, tension_N: float, operation: Mapping[str, Any], **tables: Any
) -> ws.Case:
    """A pipe in a vertical hole with a tension at its top."""
    weighing = {**inputs, "weight_in_mud_N_per_m": tension_N / HANGS_m}
    string = [part(weighing, yield_strength=inputs["yield_strength_Pa"])]
    stations = [[0.0, 0.0, 0.0], [HANGS_m, 0.0, 0.0]]
    return case(stations, string, operation, hole_m=0.3, **tables)


def limits(
    inputs: Inputs, tension_N: float, operation: str = "drill", part_of_yield: float = 0.9
) -> dict[str, float]:
    """Capacities by the kind of limit, of a pipe that turns with a tension at its top."""
    plan = hanging(
        inputs,
        tension_N,
        {"kind": operation, "wob": 1e-3, "rop": "1e-9 m/s"},
        bit={"torque": 1.0},
        plan={
            "operations": [operation],
            "bit_depths": [HANGS_m],
            "factors": {"tension": 1 / part_of_yield},
        },
    ).plan()
    return {check.kind: check.limit for check in plan.checks if check.factor is not None}


def pipe_strength(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Yield of the body."""
    least = limits(inputs, SMALL_N)
    answers: dict[str, Any] = {
        "tensile_yield_N": least["tension"],
        "torsional_yield_N_m": least["torsion"],
    }
    if "tensions_N" in inputs:
        tensions_N = [max(of, SMALL_N) for of in inputs["tensions_N"]]
        torques = [limits(inputs, of)["tension_and_torsion"] for of in tensions_N]
        answers["torsional_yield_under_tension_N_m"] = torques
    return answers


def overpull(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """What may still be pulled."""
    of = limits(inputs, inputs["hook_load_N"], "trip_out", inputs["allowed_part_of_yield"])
    return {"margin_of_overpull_N": of["overpull"]}


def pipe_stress(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Stress at the top of a pipe that hangs and turns its bit."""
    elsewhere = ("bending_moment_N_m", "pressure_inside_Pa", "pressure_outside_Pa")
    if any(inputs[name] for name in elsewhere):
        return {}
    made = hanging(
        inputs,
        inputs["effective_tension_N"],
        {"kind": "drill", "wob": 1e-3, "rop": "1e-9 m/s"},
        bit={"torque": inputs["torque_N_m"]},
    )
    top = made.soft().nodes
    return {
        "force_in_metal_N": top["true_tension_N"][0],
        "largest_von_mises_stress_Pa": top["von_mises_stress_Pa"][0],
        "safety_factor": 1 / top["yield_use"][0],
    }


def joint_bending(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """Moments at the upper end of a short arc; the soft string bends pipe at its joints."""
    inc, rate = inputs["inclination_deg"], inputs["build_rate_deg_per_30m"]
    joints = {
        "joint_od": inputs["tool_joint_diameter_m"],
        "joint_spacing": inputs["tool_joint_spacing_m"],
    }
    solved = case(
        [[0.0, inc, 0.0], [ARC_m, inc + rate * ARC_m / 30, 0.0]],
        [part(inputs, **joints)],
        {"kind": "rotate_off_bottom", "bit_pull": inputs["tension_N"]},
        hole_m=inputs["hole_diameter_m"],
        steel=steel(inputs),
    ).soft()
    top = solved.nodes
    answers = {
        "moment_at_joint_N_m": top["bending_moment_N_m"][0],
        "moment_between_joints_N_m": top["bending_moment_between_N_m"][0],
        "joint_side_force_N": top["side_force_per_joint_N"][0],
    }
    return {name: answers[name] for name in expected}


def stretch(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """A pipe that hangs off bottom."""
    if inputs["gravity_m_per_s2"] != GRAVITY_m_per_s2:
        raise NotImplementedError
    modulus = inputs["youngs_modulus_Pa"]
    shear = {"shear_modulus_Pa": modulus / (2 + 2 * inputs["poisson_ratio"])}
    solved = case(
        [[0.0, 0.0, 0.0], [inputs["length_m"], 0.0, 0.0]],
        [part(inputs)],
        {"kind": "rotate_off_bottom"},
        mud_kg_per_m3=inputs["mud_density_kg_per_m3"],
        steel=steel({**inputs, **shear}),
    ).soft()
    return {"stretch_m": solved["rotate_off_bottom"].stretch_m}


def casing_wear(inputs: Inputs, expected: Mapping[str, Any]) -> dict[str, Any]:
    """A pipe that turns in level casing. The plan tells the groove, not its volume."""
    # A pipe weighs no more than its steel: what it lacks in force it turns longer.
    longer = max(1.0, inputs["side_force_N_per_m"] / HEAVY_N_per_m)
    weighing = {
        "outside_diameter_m": 0.127,
        "inside_diameter_m": 0.1086,
        "weight_in_mud_N_per_m": inputs["side_force_N_per_m"] / longer,
    }
    joints = {"joint_od": inputs["tool_joint_diameter_m"], "joint_spacing": 9.6}
    campaign = {
        "off_bottom": inputs["time_s"] * longer,
        "round_trips": 0,
        "wear_factor": inputs["wear_factor_per_Pa"] * PSI_Pa * 1e10,
    }
    operation = "rotate_off_bottom"
    plan = case(
        [[0.0, 90.0, 0.0], [LEVEL_m, 90.0, 0.0]],
        [part(weighing, **joints)],
        {"kind": operation, "rpm": f"{inputs['rotary_speed_rev_per_min']} rpm"},
        hole_m=inputs["casing_inside_diameter_m"],
        hole_kind="casing",
        plan={"operations": [operation], "bit_depths": [LEVEL_m], "campaign": campaign},
    ).plan()
    return {"groove_depth_m": plan.table("plan_wear")["groove_m"][0]}
