"""Interrupts: the work ends long before its regular end, with the results so far.

``benchmarks/interrupt.py`` measures medians and maxima, which must be below 0.2 s on a quiet
machine. The limit here only distinguishes an interrupt from work that runs to its end, under
any load of the machine.
"""

import importlib.util
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import wholestring as ws
from conftest import CASES

LIMIT_S = 5.0


def benchmark() -> ModuleType:
    path = Path(__file__).parents[1] / "benchmarks/interrupt.py"
    spec = importlib.util.spec_from_file_location("interrupt", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["interrupt"] = module
    spec.loader.exec_module(module)
    return module


def waited_s(work: Callable[[], object], after_s: float) -> float:
    """Return the time that the work took to end after an interrupt, s."""
    return float(benchmark().waited_s(work, after_s))


@pytest.fixture(scope="module")
def long() -> ws.Case:
    case = ws.Case.load(CASES / "np13-x1042.toml")
    return case.with_(dynamics__duration="1 h", operation__kind="drill")


@pytest.fixture(scope="module")
def rock() -> ws.Case:
    """A run that is slower than real time."""
    case = ws.Case.load(CASES / "np13-x1042-rock.toml")
    return case.with_(dynamics__duration="1 h", operation__kind="drill")


def test_a_dynamic_run(long: ws.Case) -> None:
    assert waited_s(lambda: long.dynamic(), 1.0) <= LIMIT_S


def test_a_string_that_is_being_initialised(long: ws.Case) -> None:
    # With a fine mesh, settling takes longer than the test waits.
    fine = long.with_(mesh__element_length="0.5 m")
    assert waited_s(lambda: fine.dynamic(), 0.29) <= LIMIT_S


def test_a_run_into_a_folder(long: ws.Case) -> None:
    assert waited_s(lambda: long.with_(model="dynamic").run(), 1.0) <= LIMIT_S


def test_a_simulation_in_hand(long: ws.Case) -> None:
    sim = long.simulation()
    assert waited_s(lambda: sim.advance("1 h"), 0.3) <= LIMIT_S


def test_a_bit_that_is_run_in_on_rock(rock: ws.Case) -> None:
    assert waited_s(lambda: rock.dynamic(), 0.25) <= LIMIT_S


def test_a_simulation_on_rock(np13_rock: ws.Case) -> None:
    sim = np13_rock.simulation()
    assert waited_s(lambda: sim.advance("1 h"), 0.3) <= LIMIT_S


@pytest.mark.parametrize("verb", ["plan", "broomstick", "bha", "reach"])
def test_statics_at_many_depths(verb: str, long: ws.Case) -> None:
    much: dict[str, dict[str, Any]] = {
        "bha": {"weight": [1e3 * i for i in range(1, 2000)]},
        "broomstick": {"model": "stiff", "bit_depths": "500m..4300m/10m"},
        "plan": {},
        "reach": {"to": 15e3, "friction": [0.01 * i for i in range(1, 80)]},
    }
    case = long.with_({"plan.models": "stiff", "plan.depths": 200})
    assert waited_s(lambda: getattr(case, verb)(**much[verb]), 1.0) <= LIMIT_S


def test_a_sweep(long: ws.Case, tmp_path: Path) -> None:
    case = long.with_(model="dynamic")
    vary: dict[str, Any] = {"friction": [0.1, 0.2, 0.3]}

    def work() -> object:
        return ws.sweep(case, vary, folder=tmp_path / "sweep", overwrite=True)

    assert waited_s(work, 1.0) <= LIMIT_S
