"""Overhead of Python over Rust, measured on this machine: ``python benchmarks/overhead.py``.

Each pair does the same work in turn, through the package and without its Python: the runner alone,
by a call of the compiled module in the same process. The least times are compared.

=============================  =================================================  =======
work                           measured                                           at most
=============================  =================================================  =======
advance of 1 s                 ``sim.advance(1.0)`` of NP13 over the runner's     3 %
soft solve of NP13             ``case.soft("drill")["drill"].hook_load_N`` over   20 %
                               the runner's, of one case
the same of a new case         ``case.with_(friction=...)`` before it, over the   20 %
                               reading of the text and the solving
table of 1e6 rows to polars    ``results.time.to_polars()``, numbers not copied   50 ms
=============================  =================================================  =======
"""

from __future__ import annotations

import argparse
import itertools
import json
import statistics
import tempfile
import time
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import wholestring as ws
from wholestring import _core

NP13 = Path(__file__).parents[3] / "cases" / "np13-x1042.toml"
ROWS = 1_000_000


Pair = tuple[float, float]


def timed(work: Callable[[], object]) -> Pair:
    """Return wall-clock time and processor time of a call, s."""
    start, cpu = time.perf_counter(), time.process_time()
    work()
    return time.perf_counter() - start, time.process_time() - cpu


def advance(repeats: int) -> dict[str, float]:
    """Measure an advance by 1 s: two equal runs, advanced second by second in turn."""
    case = ws.Case.load(NP13)
    ours = case.simulation()
    ours.advance(0.1)
    theirs = case.simulation(checkpoint=ours.checkpoint())
    found = over(repeats, lambda: ours.advance(1.0), lambda: _core.advance_alone(theirs._held, 1.0))
    assert ours.time_s == theirs.time_s
    return found


def soft(repeats: int) -> dict[str, float]:
    """Measure a soft solve."""
    case = ws.Case.load(NP13)
    ours_N = case.soft("drill")["drill"].hook_load_N
    assert ours_N == _core.solve_alone(case._held, "soft", "drill", [])
    return over(
        5 * repeats,
        lambda: case.soft("drill")["drill"].hook_load_N,
        lambda: _core.solve_alone(case._held, "soft", "drill", []),
    )


def soft_of_a_new_case(repeats: int) -> dict[str, float]:
    """Measure a soft solve of a new case, with another friction each time."""
    case = ws.Case.load(NP13)
    frictions = (0.2 + 1e-6 * number for number in itertools.count())

    def ours() -> float:
        return case.with_(friction=next(frictions)).soft("drill")["drill"].hook_load_N

    def theirs() -> float:
        changes = [("friction", repr(next(frictions)))]
        return _core.solve_alone(case._held, "soft", "drill", changes)

    assert abs(ours() / theirs() - 1.0) < 1e-4
    return over(5 * repeats, ours, theirs)


def over(
    repeats: int, ours: Callable[[], object], theirs: Callable[[], object]
) -> dict[str, float]:
    """Return the least wall-clock times, s, and the relative excess of the first over the second.

    The excess by processor time, which other programs disturb less, is the median of all pairs.
    """
    pairs = [(timed(ours), timed(theirs)) for _ in range(repeats)]
    clock = [min(pair[side][0] for pair in pairs) for side in range(2)]
    parts = [ours_s[1] / theirs_s[1] for ours_s, theirs_s in pairs]
    return {
        "python_s": clock[0],
        "rust_s": clock[1],
        "over": clock[0] / clock[1] - 1.0,
        "over_by_processor_time": statistics.median(parts) - 1.0,
    }


def table(repeats: int) -> dict[str, float]:
    """Measure the transfer of a table of 1e6 rows to polars, and check that no number is copied."""
    # Neither package has types.
    pyarrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    with tempfile.TemporaryDirectory() as place:
        case = ws.Case.example().with_(
            {"mesh.element_length": 20.0, "dynamics.settle": 0.1, "dynamics.duration": 1.0}
        )
        case.dynamic("drill").save(Path(place) / "run")
        file = Path(place) / "run" / "time.parquet"
        rows = parquet.read_table(file)
        many = pyarrow.concat_tables([rows] * (ROWS // len(rows) + 1)).slice(0, ROWS)
        parquet.write_table(many, file)
        series = ws.Results.load(Path(place) / "run").time
    assert len(series) == ROWS
    took = min(timed(series.to_polars)[0] for _ in range(repeats))
    frame = series.to_polars()
    numbers = [name for name in series.columns if series[name].dtype == np.float64]
    moved = sum(
        not np.shares_memory(series[name], frame[name].to_numpy(allow_copy=False))
        for name in numbers
        if frame[name].null_count() == 0
    )
    return {"took_s": took, "columns": len(series.columns), "moved": moved}


def main() -> None:
    """Measure, and print a line of JSON for each measurement."""
    parser = argparse.ArgumentParser(description="Overhead of Python over Rust.")
    parser.add_argument("--repeats", type=int, default=20)
    repeats = parser.parse_args().repeats
    measured = {
        "advance of 1 s": advance,
        "soft solve": soft,
        "soft solve of a new case": soft_of_a_new_case,
        "table": table,
    }
    for name, measure in measured.items():
        print(json.dumps({"what": name, **measure(repeats)}), flush=True)


if __name__ == "__main__":
    main()
