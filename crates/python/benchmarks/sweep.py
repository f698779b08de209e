"""Overhead of a case of a sweep over its solution: on threads, processes and workers of Dask.

    python benchmarks/sweep.py overhead            # short cases: the cost of submitting one
    python benchmarks/sweep.py speed               # 15 depths x 4 friction factors, dynamics
    python benchmarks/sweep.py many                # 100 000 points: in flight, memory, time

``speed`` sweeps by the command line and on Dask in turn, in the same run, and prints the ratio of
their speeds: ``--wholestring PATH`` is the program of the command line, which must be of the same
build as the package. No other work should run on the machine meanwhile: the load at the beginning
and at the end is printed.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import platform
import resource
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable, Generator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import wholestring as ws
from wholestring._gather import PER_WORKER

CASES = Path(__file__).parents[3] / "cases"


@contextmanager
def dask(workers: int) -> Generator[Any, None, None]:
    """Return a client with workers of one thread each, on this machine."""
    distributed: Any = import_module("distributed")  # the package has no types
    cluster = distributed.LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        security=distributed.Security.temporary(),
        silence_logs=40,
    )
    with cluster, distributed.Client(cluster) as client:
        yield client


@contextmanager
def nothing() -> Generator[None, None, None]:
    """Return no executor, which means threads of this process, without Python."""
    yield None


def processes(workers: int) -> ProcessPoolExecutor:
    """Return a pool of processes."""
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def swept_s(case: ws.Case, vary: dict[str, Any], executor: Any, **keywords: Any) -> float:
    """Sweep into a new folder, and return the wall-clock time, s."""
    return swept(case, vary, executor, **keywords)[0]


def swept(
    case: ws.Case, vary: dict[str, Any], executor: Any, **keywords: Any
) -> tuple[float, float]:
    """Sweep into a new folder, and return wall-clock and processor time of this process, s.

    For an executor of processes, the processor time is the cost of submitting and recording, the
    check of the cases, the table and the page; for Dask it includes the scheduler, which is in this
    process.
    """
    with tempfile.TemporaryDirectory() as place:
        begin, begin_cpu = time.perf_counter(), time.process_time()
        done = ws.sweep(case, vary, folder=Path(place) / "sweep", executor=executor, **keywords)
        took = time.perf_counter() - begin, time.process_time() - begin_cpu
        assert not done.failed, done.failed
    return took


def overhead(arguments: argparse.Namespace) -> dict[str, Any]:
    """Measure short cases, and the share of the solution in their time."""
    case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
    count: int = arguments.cases or 1000
    vary = {"friction": [0.1 + 0.3 * i / count for i in range(count)]}
    ways: dict[str, Callable[[], Any]] = {
        "threads of Rust, 1": nothing,
        "threads of Rust, 2": nothing,
        "ThreadPoolExecutor, 2": lambda: ThreadPoolExecutor(2),
        "ProcessPoolExecutor, 1": lambda: processes(1),
        "ProcessPoolExecutor, 2": lambda: processes(2),
        "Dask, 1 worker": lambda: dask(1),
        "Dask, 2 workers": lambda: dask(2),
    }
    found: dict[str, Any] = {}
    for name, make in ways.items():
        jobs = int(name[-1]) if name.startswith("threads") else None
        with make() as executor:
            warm = {"friction": vary["friction"][:20]}
            swept_s(case, warm, executor, jobs=jobs)
            row: dict[str, float] = {}
            for how, bundle in [("bundled", "0.5 s"), ("one by one", "0.001 ms")]:
                times = [
                    swept(case, vary, executor, jobs=jobs, bundle=bundle)
                    for _ in range(arguments.repeat)
                ]
                clock, processor = map(statistics.median, zip(*times, strict=True))
                row[f"{how}, ms a case"] = 1e3 * clock / count
                row[f"{how}, ms of processor here"] = 1e3 * processor / count
        found[name] = row
        print(f"{name:24s}", *(f"{how}: {value:.2f};" for how, value in row.items()), flush=True)
    return found


def speed(arguments: argparse.Namespace) -> dict[str, Any]:
    """Measure dynamics: the command line and Dask with two workers, in turn."""
    changes: dict[str, ws.Value] = {
        "model": "dynamic",
        "dynamics.duration": arguments.duration,
        "dynamics.settle": arguments.settle,
    }
    case = ws.Case.load(CASES / "np13-x1042.toml").with_(changes)
    vary = {"bit_depth": "300m..4305m/300m", "friction": [0.1, 0.2, 0.3, 0.4]}
    rows: list[dict[str, float]] = []
    with dask(2) as client:
        client.run(lambda: __import__("wholestring"))
        for _ in range(arguments.repeat):
            row = {
                "dask_s": swept_s(case, vary, client),
                "threads_s": swept_s(case, vary, None, jobs=2),
            }
            if arguments.wholestring:
                row["command_line_s"] = command_line_s(arguments)
            rows.append(row)
            print({name: round(value, 2) for name, value in row.items()}, flush=True)
    best = {name: min(row[name] for row in rows) for name in rows[0]}
    ratios = {f"{name} / dask_s": value / best["dask_s"] for name, value in best.items()}
    print("speed of Dask relative to:", {name: round(value, 3) for name, value in ratios.items()})
    return {"rows": rows, "ratios": ratios}


def command_line_s(arguments: argparse.Namespace) -> float:
    """Return the time of the same sweep by the command line, s."""
    program = [arguments.wholestring, "sweep", str(CASES / "np13-x1042.toml"), "-q", "-j", "2"]
    for setting in (
        "model=dynamic",
        f"dynamics.duration={arguments.duration} s",
        f"dynamics.settle={arguments.settle} s",
    ):
        program += ["--set", setting]
    for values in ("bit_depth=300m..4305m/300m", "friction=0.1,0.2,0.3,0.4"):
        program += ["--vary", values]
    with tempfile.TemporaryDirectory() as place:
        begin = time.perf_counter()
        subprocess.run([*program, "-o", str(Path(place) / "sweep")], check=True)
        return time.perf_counter() - begin


class Counting(Executor):
    """A pool that counts its tasks in flight."""

    def __init__(self, pool: Executor) -> None:
        self._pool = pool
        self._now = 0
        self.most = 0
        self.tasks = 0

    def submit(self, work: Any, /, *arguments: Any, **keywords: Any) -> Future[Any]:
        """Submit a task, and count it."""
        self._now += 1
        self.tasks += 1
        self.most = max(self.most, self._now)
        future = self._pool.submit(work, *arguments, **keywords)
        future.add_done_callback(self._ended)
        return future

    def _ended(self, _: Future[Any]) -> None:
        self._now -= 1


def many(arguments: argparse.Namespace) -> dict[str, Any]:
    """Sweep the largest number of points."""
    case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
    count: int = arguments.cases or 100_000
    vary = {"friction": [0.1 + 0.3 * i / count for i in range(count)]}
    with processes(2) as pool:
        counting = Counting(pool)
        took_s = swept_s(case, vary, counting)
    # For an executor that is no pool, the number of workers is that of the cores.
    most = PER_WORKER * (os.cpu_count() or 1)
    assert counting.most <= most, f"{counting.most} in flight, {most} at most"
    found = {
        "cases": count,
        "took_s": took_s,
        "tasks": counting.tasks,
        "most_in_flight": counting.most,
        "memory_MB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }
    print(found)
    return found


def main() -> None:
    """Measure, and print the results; with ``--json``, also write them as JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("what", choices=["overhead", "speed", "many"])
    parser.add_argument("--cases", type=int, help="1000 for overhead, 100000 for many by default")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--duration", type=float, default=60.0, help="length of a dynamic case, s")
    parser.add_argument("--settle", type=float, default=20.0, help="settling time before it, s")
    parser.add_argument("--wholestring", default=shutil.which("wholestring"))
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    machine = f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}"
    print(f"{machine}, wholestring {ws.__version__}; load {os.getloadavg()[0]:.2f}")
    measure = {"overhead": overhead, "speed": speed, "many": many}[arguments.what]
    found = measure(arguments)
    print(f"load at the end {os.getloadavg()[0]:.2f}")
    if arguments.json:
        arguments.json.write_text(json.dumps({"machine": machine, "found": found}, indent=1))


if __name__ == "__main__":
    main()
