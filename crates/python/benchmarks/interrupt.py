"""Waiting time of Python after an interrupt: ``python benchmarks/interrupt.py``.

Each method is interrupted several times, each at another time of a case that takes longer. The
result is the time from the signal to the exception with the results so far, median and maximum. An
interrupt must end within 0.2 s. No other work should run on the machine meanwhile.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import signal
import statistics
import tempfile
import threading
import time
from collections.abc import Callable, Generator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import wholestring as ws

CASES = Path(__file__).parents[3] / "cases"

Work = Callable[[], object]


@dataclass(frozen=True)
class Verb:
    """Work that is interrupted, within an interval of times after its start, s."""

    work: Work
    first_s: float = 0.3
    last_s: float = 1.0


def interrupt() -> None:
    """Send the interrupt of a terminal or a notebook to this process."""
    os.kill(os.getpid(), signal.SIGINT)


def waited_s(work: Work, after_s: float) -> float:
    """Interrupt some work after a time, and return the time that it took to end, s."""
    sent = 0.0

    def send() -> None:
        nonlocal sent
        sent = time.perf_counter()
        interrupt()

    timer = threading.Timer(after_s, send)
    timer.start()
    try:
        work()
    except ws.Interrupted as error:
        waited = time.perf_counter() - sent
        results = error.results if error.sweep is None else error.sweep
        assert results is not None or after_s < 0.3, "the results so far are lost"
        return waited
    finally:
        timer.join()
    raise RuntimeError(f"the work ended before it was interrupted, within {after_s:.2f} s")


def alone() -> dict[str, Verb]:
    """Return the methods that need no executor."""
    np13 = ws.Case.load(CASES / "np13-x1042.toml").with_(dynamics__duration="1 h")
    rock = ws.Case.load(CASES / "np13-x1042-rock.toml").with_(dynamics__duration="1 h")
    statics = np13.with_({"plan.models": "stiff", "plan.depths": 200})
    live, live_on_rock = np13.simulation("drill"), rock.simulation("drill")
    many = {"friction": [0.01 * i for i in range(5, 60)]}
    return {
        "dynamic": Verb(lambda: np13.dynamic("drill"), 1.0, 3.0),
        "dynamic, before its first step": Verb(lambda: np13.dynamic("drill"), 0.02, 0.2),
        "dynamic on rock, the run-in": Verb(lambda: rock.dynamic("drill"), 0.05, 0.29),
        "run into a folder": Verb(lambda: np13.with_(model="dynamic").run(), 1.0, 3.0),
        "advance": Verb(lambda: live.advance("1 h")),
        "advance on rock": Verb(lambda: live_on_rock.advance("1 h")),
        "plan": Verb(statics.plan),
        "broomstick": Verb(
            lambda: np13.broomstick(model="stiff", bit_depths="500m..4300m/10m"), 0.3, 1.0
        ),
        "sweep": Verb(lambda: swept(np13, many, None), 1.0, 3.0),
    }


def swept(case: ws.Case, vary: dict[str, Any], executor: Any, **keywords: Any) -> object:
    """Sweep dynamics into a folder of its own."""
    with tempfile.TemporaryDirectory() as place:
        moved = case.with_(model="dynamic", operation__kind="drill")
        return ws.sweep(moved, vary, folder=f"{place}/sweep", executor=executor, **keywords)


@contextmanager
def pool() -> Generator[Executor, None, None]:
    """Return two processes that have the package."""
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as made:
        for done in [made.submit(_imports) for _ in range(4)]:
            done.result()
        yield made


def _imports() -> None:
    time.sleep(0.2)


def on_processes(executor: Executor) -> dict[str, Verb]:
    """Return the sweeps on two processes."""
    np13 = ws.Case.load(CASES / "np13-x1042.toml").with_(dynamics__duration="1 h")
    many = {"friction": [0.01 * i for i in range(5, 60)]}
    return {
        "sweep on processes that see the folder": Verb(
            lambda: swept(np13, many, executor), 1.0, 3.0
        ),
    }


def measure(name: str, verb: Verb, count: int) -> dict[str, float | str]:
    """Interrupt the work ``count`` times, at evenly spaced times."""
    times: list[float] = []
    for number in range(count):
        part = (number + 0.5) / count
        times.append(waited_s(verb.work, verb.first_s + part * (verb.last_s - verb.first_s)))
    found: dict[str, float | str] = {
        "verb": name,
        "median_s": round(statistics.median(times), 3),
        "most_s": round(max(times), 3),
    }
    print(json.dumps(found), flush=True)
    return found


def main() -> None:
    """Measure, and print a line of JSON for each method."""
    parser = argparse.ArgumentParser(description="Waiting time of Python after an interrupt.")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--only", default="", help="only the methods whose name contains this text")
    given = parser.parse_args()
    for name, verb in alone().items():
        if given.only in name:
            measure(name, verb, given.count)
    with pool() as executor:
        for name, verb in on_processes(executor).items():
            if given.only in name:
                measure(name, verb, given.count)


if __name__ == "__main__":
    main()
