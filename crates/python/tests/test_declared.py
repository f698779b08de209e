"""The classes of rows have the properties that the program writes."""

from dataclasses import fields
from typing import Any

import wholestring as ws

# The sentence with its quantities is the program's, for other units.
WITHOUT = {"parts"}


def names(kind: type[Any]) -> set[str]:
    return {field.name for field in fields(kind)}


def test_a_check_has_what_the_program_writes() -> None:
    results = ws.Case.example().soft("slide")
    for operation in results.summary["operations"]:
        for check in operation["checks"]:
            assert set(check) - WITHOUT == names(ws.Check)


def test_a_check_of_a_plan_has_what_the_program_writes() -> None:
    plan = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]}).plan()
    for check in plan.summary["checks"] + plan.summary["governing"]:
        assert set(check) - WITHOUT == names(ws.PlanCheck)


def test_an_estimate_has_what_the_program_writes() -> None:
    case = ws.Case.example().with_(rig__block_weight="200 kN")
    depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    table = case.broomstick(
        frictions=[0.25], bit_depths=depths, operations="trip_out", model="soft"
    )
    data = {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}
    found = case.calibrate(data, one_factor=True)
    for estimate in found.summary["estimates"]:
        assert set(estimate) == names(ws.Estimate)
