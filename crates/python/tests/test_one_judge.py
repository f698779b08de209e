"""One state has one verdict, word for word: in memory, in a folder, in a sweep and in a plan."""

import random
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path

import pytest
import wholestring as ws
from conftest import CASES

STATES = 200
EACH = 5
"""Interval of the states that have a folder and a plan of their own, which write pages."""

OPERATIONS = ("trip_out", "trip_in", "rotate_off_bottom", "drill", "slide")

Words = set[tuple[str, str, str, str]]


def words(checks: Iterable[ws.Check]) -> Words:
    return {(check.kind, check.severity, check.verdict or "", check.sentence) for check in checks}


@pytest.fixture(scope="module")
def well() -> ws.Case:
    """A string that is light for its well, so that states of all severities occur."""
    changes: Mapping[str, ws.Value] = {
        "model": "soft",
        "operation.kind": list(OPERATIONS),
        "rig.block_weight": "120 kN",
        "rig.hoist_capacity": "1200 kN",
        "rig.top_drive_torque": "35 kN.m",
        "rig.top_drive_peak_torque": "42 kN.m",
    }
    return ws.Case.load(CASES / "np13-x1042.toml").with_(changes)


def states() -> list[dict[str, ws.Value]]:
    """Frictions, muds, weights on bit and depths of the bit, the same on every machine."""
    dice = random.Random(40)
    return [
        {
            "friction": round(dice.uniform(0.05, 0.7), 3),
            "mud.density": f"{dice.uniform(1.0, 2.0):.3f} sg",
            "wob": f"{dice.uniform(5, 280):.1f} kN",
            "bit_depth": f"{dice.uniform(1500, 4300):.1f} m",
        }
        for _ in range(STATES)
    ]


def plan_of(case: ws.Case, state: Mapping[str, ws.Value]) -> ws.Plan:
    """The plan of this one state: one depth, and one friction at its three levels."""
    level = {"cased": state["friction"], "open": state["friction"]}
    changes = {f"plan.friction.{name}": dict(level) for name in ("low", "expected", "high")}
    return case.with_({"plan.bit_depths": [state["bit_depth"]], **changes}).plan()


def test_all_fronts_judge_two_hundred_states_alike(well: ws.Case, tmp_path: Path) -> None:
    # The check of cases issues warnings for some of these states.
    warnings.simplefilter("ignore", UserWarning)
    drawn = states()
    vary = {key: [state[key] for state in drawn] for key in drawn[0]}
    sweep = ws.sweep(well, vary, together=True, folder=tmp_path / "sweep")
    severities: set[str] = set()
    for number, state in enumerate(drawn):
        case = well.with_(state)
        memory, swept = case.soft(), sweep[number]
        for operation in OPERATIONS:
            ours = words(memory[operation].checks)
            assert ours == words(swept[operation].checks), (state, operation, "sweep")
            severities |= {severity for _, severity, _, _ in ours}
        if number % EACH > 0:
            continue
        folder, plan = case.run(tmp_path / f"run-{number}"), plan_of(case, state)
        for operation in OPERATIONS:
            ours = words(memory[operation].checks)
            assert ours == words(folder[operation].checks), (state, operation, "run")
            planned = words(check for check in plan.checks if check.operation == operation)
            assert planned <= ours, (state, operation, "plan", planned - ours)
    assert severities == {"ok", "note", "warning", "error"}
