"""Fixtures of several tests."""

import signal
from pathlib import Path

import pytest
import wholestring as ws

CASES = Path(__file__).parents[3] / "cases"


@pytest.fixture(autouse=True)
def _interrupts() -> None:
    """Route interrupts to Python, whichever handler is installed.

    Background jobs of a shell ignore them, and dask_jobqueue installs a handler when it is
    imported.
    """
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def slant() -> ws.Case:
    return ws.Case.example()


@pytest.fixture(scope="session")
def np13() -> ws.Case:
    return ws.Case.load(CASES / "np13-x1042.toml")


@pytest.fixture(scope="session")
def np13_rock() -> ws.Case:
    """A run on solid rock, slower than real time; the run-in of the bit takes seconds."""
    case = ws.Case.load(CASES / "np13-x1042-rock.toml")
    return case.with_(rock__element_size="24 mm", rock__density_factor=500)


@pytest.fixture(scope="session")
def short(slant: ws.Case) -> ws.Case:
    """A dynamic run of a second or two."""
    changes: dict[str, ws.Value] = {
        "operation.kind": "drill",
        "dynamics.duration": 1.0,
        "dynamics.settle": 1.0,
        "mesh.element_length": 10.0,
    }
    return slant.with_(changes)
