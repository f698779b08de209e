"""welleng: its well path, and its torque and drag. `pip install welleng`."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from welleng.architecture import BHA, WellBore
from welleng.survey import Survey, SurveyHeader, interpolate_survey
from welleng.torque_drag import TorqueDrag

PROGRAM = f"welleng {version('welleng')}"

SPACING_m = 10.0
"""Of the stations: welleng's elements reach from one to the next."""

NO_TORQUE_N_m = 1e-9
"""It takes no weight on bit without a torque."""

NOTES = {
    "soft_string": "Elements of 10 m. Straight holes come out as they should. In a build tension "
    "presses the string to the high side and weight to the low side: `torque_drag.force_normal` "
    "adds the two there, and takes one from the other in a drop, where they go together. "
    "`TorqueDrag` goes from the bit up and takes the contact radii from the top down, which is "
    "felt where the string has several. Neither is a matter of assumption: with that sign turned "
    "and those radii in order, every number that it answers holds. It has no sum of side forces, "
    "no lowering against a pull at the bit and no turning while it is lowered; of these, nothing "
    "is answered.",
}


def answers(problem: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers by name."""
    # Of azimuths that are all zero.
    warnings.filterwarnings("ignore")
    solve = {"well_path": well_path, "soft_string": soft_string}.get(problem["kind"])
    if solve is None:
        raise NotImplementedError
    found = solve(problem["inputs"])
    return {name: number for name, number in found.items() if name in problem["expected"]}


def surveyed(survey: Mapping[str, Any], start: list[float]) -> Survey:
    return Survey(
        md=survey["measured_depth_m"],
        inc=survey["inclination_deg"],
        azi=survey["azimuth_deg"],
        header=SurveyHeader(azi_reference="grid"),
        start_nev=start,
        deg=True,
    )


def well_path(inputs: Mapping[str, Any]) -> dict[str, Any]:
    names = ("north_m", "east_m", "true_vertical_depth_m")
    found = surveyed(inputs["survey"], [inputs[f"first_{name}"] for name in names])
    columns = dict(zip(names, (found.n, found.e, found.tvd), strict=True))
    return columns | {f"end_{name}": column[-1] for name, column in columns.items()}


def soft_string(inputs: Mapping[str, Any]) -> dict[str, Any]:
    if "axial_speed_m_per_s" in inputs:
        raise NotImplementedError
    survey = interpolate_survey(surveyed(inputs["survey"], [0.0, 0.0, 0.0]), step=SPACING_m)
    bottom_m = float(survey.md[-1])
    hole = WellBore("hole", 0.0, bottom_m, method="top_down")
    hole.add_section(
        id=inputs["hole_diameter_m"],
        coeff_friction_sliding=inputs["friction_factor"],
        bottom=bottom_m,
    )
    string = BHA("string", 0.0, bottom_m, method="top_down")
    end_m = bottom_m
    ends_m = []
    for part in inputs["string"]:
        ends_m.append(end_m)
        end_m -= part["length_m"]
    for part, at_m in zip(reversed(inputs["string"]), reversed(ends_m), strict=True):
        string.add_section(
            od=2 * part["contact_radius_m"],
            id=part["inside_diameter_m"],
            unit_weight=part["weight_in_mud_N_per_m"],
            bottom=at_m,
        )
    # The weight in mud is given.
    found = TorqueDrag(survey, hole, string, fluid_density=0.0)
    pull_N = inputs.get("tension_at_bit_N", 0.0)
    if pull_N:
        found.get_forces_and_torsion(overpull=pull_N)
        return {"pick_up_hook_load_N": found.tension["overpull"][0]}
    answers = {
        "pick_up_hook_load_N": found.tension["pickup"][0],
        "slack_off_hook_load_N": found.tension["slackoff"][0],
        "rotating_hook_load_N": found.tension["rotating"][0],
        "rotating_torque_N_m": found.torque["rotating"][0],
    }
    if "weight_on_bit_N" in inputs:
        torque_N_m = inputs["bit_torque_N_m"] or NO_TORQUE_N_m
        found.get_forces_and_torsion(wob=inputs["weight_on_bit_N"], tob=torque_N_m)
        answers |= {
            "drilling_hook_load_N": found.tension["drilling"][0],
            "sliding_hook_load_N": found.tension["sliding"][0],
            "drilling_torque_N_m": found.torque["drilling"][0],
        }
    return answers
