"""Sweeps: on threads, on executors, and on workers that are killed."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
import tracemalloc
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import wholestring as ws
from wholestring._gather import PER_WORKER, Gathering
from wholestring._pool import Pool
from wholestring._task import Done, Solved

VARIED: dict[str, Any] = {"friction": [0.1, 0.2, 0.3], "bit_depth": ["900 m", "1200 m"]}


needs_kill = pytest.mark.skipif(
    not hasattr(signal, "SIGKILL"), reason="this system has no signal that kills a process at once"
)


@pytest.fixture(scope="module")
def soft() -> ws.Case:
    """A case that takes milliseconds."""
    return ws.Case.example().with_(model="soft", operation__kind=["trip_out", "trip_in"])


@pytest.fixture(scope="module")
def dynamic() -> ws.Case:
    """A case that takes some tenths of a second."""
    changes: dict[str, ws.Value] = {
        "model": "dynamic",
        "operation.kind": "rotate_off_bottom",
        "dynamics.duration": 0.5,
        "dynamics.settle": 0.5,
        "mesh.element_length": 20.0,
    }
    return ws.Case.example().with_(changes)


@pytest.fixture
def pool() -> Iterator[ProcessPoolExecutor]:
    # Not forked: this process has threads.
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        yield pool


def contents(folder: Path) -> dict[str, bytes]:
    """Return the files of a sweep, except the page and the times that it took."""
    paths = (file for file in folder.rglob("*") if file.is_file() and file.suffix != ".html")
    files = {str(path.relative_to(folder)): path.read_bytes() for path in paths}
    return {name: data for name, data in files.items() if not name.endswith("summary.json")}


def same(one: ws.Sweep, other: ws.Sweep) -> None:
    assert contents(one.folder) == contents(other.folder)
    assert (one.folder / "report.html").is_file() and (other.folder / "report.html").is_file()
    assert one.names == other.names
    for name in one:
        for ours, theirs in zip(one[name], other[name], strict=True):
            assert without_clock(ours.data) == without_clock(theirs.data)


def without_clock(data: Any) -> dict[str, Any]:
    numerics = dict(data.get("numerics") or {})
    for clock in ("wall_time_s", "real_time_factor"):
        numerics.pop(clock, None)
    return {**data, "numerics": numerics}


class Finished:
    """Records the time of the first summary of each case while a sweep runs."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.seen: dict[Path, tuple[int, int]] = {}
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._look)

    def look(self) -> None:
        for file in self.folder.glob("*/summary.json"):
            if file not in self.seen:
                stat = file.stat()
                self.seen[file] = (stat.st_ino, stat.st_mtime_ns)

    def _look(self) -> None:
        while not self._done.wait(0.02):
            self.look()

    def __enter__(self) -> Finished:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._done.set()
        self._thread.join()

    def none_done_twice(self) -> None:
        for file, first in self.seen.items():
            stat = file.stat()
            assert (stat.st_ino, stat.st_mtime_ns) == first, f"{file} was written twice"

    def wait(self, count: int) -> None:
        end = time.monotonic() + 60.0
        while len(self.seen) < count and time.monotonic() < end:
            time.sleep(0.02)

    def kill(self, after: int, processes: Callable[[], Iterable[int]]) -> Killing:
        """Kill processes at given numbers of finished cases."""
        return Killing(self, after, processes)


class Killing(threading.Thread):
    """Kills processes at given numbers of finished cases, and records them."""

    def __init__(
        self, looked: Finished, after: int, processes: Callable[[], Iterable[int]]
    ) -> None:
        super().__init__()
        self._looked = looked
        self._after = after
        self._processes = processes
        self.killed: list[int] = []
        self.finished_then = 0
        self.start()

    def run(self) -> None:
        self._looked.wait(self._after)
        for pid in self._processes():
            os.kill(pid, signal.SIGKILL)
            self.killed.append(pid)
        self.finished_then = len(self._looked.seen)

    def ends(self, killed: int, before: int) -> None:
        """Wait for the thread, and check how many processes were killed and when."""
        # An assertion in the thread itself would fail no test.
        self.join()
        assert len(self.killed) == killed
        assert self._after <= self.finished_then < before


def test_its_table_has_what_was_varied_in_si(soft: ws.Case, tmp_path: Path) -> None:
    swept = ws.sweep(soft, VARIED, folder=tmp_path / "sweep")
    assert swept.names[:2] == ("friction=0.1,bit_depth=900 m", "friction=0.1,bit_depth=1200 m")
    assert len(swept) == 6 and not swept.failed
    table = swept.table
    assert swept.keys == ("friction", "bit_depth")
    assert list(table["friction"]) == [value for value in (0.1, 0.2, 0.3) for _ in range(4)]
    assert list(table["bit_depth"][:4]) == [900.0, 900.0, 1200.0, 1200.0]
    assert table.unit("bit_depth") == "m" and table.unit("hook_load_N") == "N"
    assert all(table.meaning(column) for column in table.columns)
    for name in swept:
        for solved in swept[name]:
            row = (table["folder"] == name) & (table["operation"] == solved.operation)
            assert table["hook_load_N"][row] == [solved.hook_load_N]
    alone = soft.with_(friction=0.2, bit_depth="900 m").soft("trip_out")["trip_out"]
    assert swept["friction=0.2,bit_depth=900 m"]["trip_out"].data == alone.data
    assert swept._repr_html_().count("<tr>") == 13
    assert ws.Sweep.load(swept.folder).names == swept.names
    with pytest.raises(KeyError, match=r"the first are friction=0\.1"):
        swept["friction=9"]


def test_numbers_texts_ranges_and_arrays_name_the_same_cases(soft: ws.Case, tmp_path: Path) -> None:
    depths: list[Any] = [
        [900, 1200],
        [900.0, 1200.0],
        "900 m..1200 m/300 m",
        np.array([900.0, 1200.0]),
    ]
    found = {
        ws.sweep(soft, {"bit_depth": depth}, folder=tmp_path / "same").names for depth in depths
    }
    assert found == {("bit_depth=900 m", "bit_depth=1200 m")}


def test_samples_are_varied_together(soft: ws.Case, tmp_path: Path) -> None:
    draws = np.random.default_rng(1).uniform(0.1, 0.3, 5)
    vary: dict[str, Any] = {"friction": draws, "mud.density": [1100.0 + i for i in range(5)]}
    swept = ws.sweep(soft, vary, together=True, folder=tmp_path)
    assert len(swept) == 5
    assert np.array_equal(np.unique(swept.table["friction"]), np.sort(draws))
    assert swept.table.unit("mud.density") == "kg/m3"
    with pytest.raises(ws.InputError, match="equal numbers of values"):
        ws.sweep(soft, {"friction": [0.1, 0.2], "wob": ["1 kN"]}, together=True, folder=tmp_path)


@pytest.mark.parametrize(("shared", "keep"), [(None, "tables"), (True, "summary"), (False, "all")])
def test_any_executor_gives_the_same_bits(
    soft: ws.Case, tmp_path: Path, shared: bool | None, keep: Any
) -> None:
    here = ws.sweep(soft, VARIED, folder=tmp_path / "here", keep=keep)
    with ThreadPoolExecutor(2) as threads:
        there = ws.sweep(
            soft,
            VARIED,
            folder=tmp_path / "there",
            executor=threads,
            keep=keep,
            shared_folder=shared,
        )
    same(here, there)
    assert not list(there.folder.glob(".running*"))


@pytest.mark.parametrize("shared", [True, False])
def test_processes_give_the_same_bits(
    dynamic: ws.Case, tmp_path: Path, pool: ProcessPoolExecutor, shared: bool
) -> None:
    vary: dict[str, Any] = {"friction": [0.1, 0.2, 0.3], "rpm": ["60 rpm"]}
    here = ws.sweep(dynamic, vary, folder=tmp_path / "here", csv=True)
    there = ws.sweep(
        dynamic, vary, folder=tmp_path / "there", executor=pool, csv=True, shared_folder=shared
    )
    same(here, there)
    assert (there.folder / "friction=0.1,rpm=60 rpm" / "time.parquet").is_file()


def test_a_case_without_an_answer_is_a_row_with_its_reason(tmp_path: Path) -> None:
    case = ws.Case.example().with_(model="stiff", operation__kind="drill", friction=1.2)
    vary: dict[str, Any] = {"wob": ["20 kN", "900 kN"]}
    here = ws.sweep(case, vary, folder=tmp_path / "here")
    with ThreadPoolExecutor(1) as threads:
        there = ws.sweep(case, vary, folder=tmp_path / "there", executor=threads)
    same(here, there)
    assert list(there.failed) == ["wob=900 kN"]
    assert there.failed["wob=900 kN"].startswith("drill: ")
    assert list(there.table["status"]) == ["complete", "failed"]


def test_what_is_finished_is_not_done_again(soft: ws.Case, tmp_path: Path) -> None:
    def work(executor: Executor | None, values: list[float]) -> ws.Sweep:
        return ws.sweep(soft, {"friction": values}, folder=tmp_path / "one", executor=executor)

    class NoMore(ThreadPoolExecutor):
        def submit(self, *_: Any, **__: Any) -> Future[Any]:
            raise AssertionError("nothing was left to be solved")

    values = [0.1, 0.2, 0.3, 0.4]
    with ThreadPoolExecutor(2) as threads:
        work(threads, values[:2])
        looked = Finished(tmp_path / "one")
        looked.look()
        # The threads of the runner continue a sweep of the executor, and the reverse.
        work(None, values[:3])
        looked.look()
        swept = work(threads, values)
        looked.none_done_twice()
        work(NoMore(1), values)
    assert len(swept) == 4
    same(swept, ws.sweep(soft, {"friction": values}, folder=tmp_path / "whole"))


def test_without_resume_all_is_solved_again(soft: ws.Case, tmp_path: Path) -> None:
    with ThreadPoolExecutor(2) as threads:
        for folder in ("a", "b"):
            ws.sweep(soft, VARIED, folder=tmp_path / folder, executor=threads)
        looked = Finished(tmp_path / "a")
        looked.look()
        ws.sweep(soft, VARIED, folder=tmp_path / "a", executor=threads, resume=False)
    with pytest.raises(AssertionError, match="written twice"):
        looked.none_done_twice()
    assert contents(tmp_path / "a") == contents(tmp_path / "b")
    with (
        ThreadPoolExecutor(2) as threads,
        pytest.raises(ws.FolderError, match="other settings or data"),
    ):
        ws.sweep(soft, {"wob": ["1 kN"]}, folder=tmp_path / "a", executor=threads)
    replaced = ws.sweep(soft, {"wob": ["1 kN"]}, folder=tmp_path / "a", overwrite=True)
    assert [path.name for path in replaced.folder.iterdir() if path.is_dir()] == ["wob=1 kN"]


def test_an_interrupt_keeps_what_was_done(dynamic: ws.Case, tmp_path: Path) -> None:
    long = dynamic.with_(dynamics__duration=2.0)
    vary: dict[str, Any] = {"friction": [0.01 * i for i in range(10, 22)]}
    whole = ws.sweep(long, vary, folder=tmp_path / "whole")
    for number, executor in enumerate([None, ThreadPoolExecutor(2)]):
        folder = tmp_path / str(number)
        with Finished(folder) as looked:

            def interrupt(looked: Finished = looked) -> None:
                looked.wait(2)
                signal.raise_signal(signal.SIGINT)

            beside = threading.Thread(target=interrupt)
            beside.start()
            with pytest.raises(ws.Interrupted) as caught:
                ws.sweep(long, vary, folder=folder, executor=executor)
            beside.join()
        swept = caught.value.sweep
        assert swept is not None
        complete = set(swept.table["folder"][swept.table["status"] == "complete"])
        assert 2 <= len(complete) < 12
        looked = Finished(folder)
        for name in complete:
            looked.seen[folder / name / "summary.json"] = (
                (folder / name / "summary.json").stat().st_ino,
                (folder / name / "summary.json").stat().st_mtime_ns,
            )
        # An unfinished case continues from its checkpoint, with bit-identical results.
        with ThreadPoolExecutor(2) as threads:
            again = ws.sweep(long, vary, folder=folder, executor=threads if number == 0 else None)
        looked.none_done_twice()
        assert not list(folder.glob("*/checkpoint.bin"))
        same(whole, again)
        if executor is not None:
            executor.shutdown()


@needs_kill
def test_a_pool_that_loses_a_worker_loses_no_case(
    dynamic: ws.Case, tmp_path: Path, pool: ProcessPoolExecutor
) -> None:
    vary: dict[str, Any] = {"friction": [0.01 * i for i in range(10, 26)]}
    folder = tmp_path / "sweep"

    def one() -> list[int]:
        held: Any = pool
        return list(held._processes)[:1]

    with Finished(folder) as looked:
        killing = looked.kill(3, one)
        swept = ws.sweep(dynamic, vary, folder=folder, executor=pool)
        killing.ends(killed=1, before=12)
    looked.none_done_twice()
    assert len(swept) == 16 and not swept.failed
    same(swept, ws.sweep(dynamic, vary, folder=tmp_path / "whole"))


@needs_kill
def test_dask_loses_two_workers_and_no_case(dynamic: ws.Case, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    vary: dict[str, Any] = {"friction": [0.01 * i for i in range(10, 34)]}
    folder = tmp_path / "sweep"
    cluster = distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        security=distributed.Security.temporary(),
        local_directory=str(tmp_path / "dask"),
    )
    with cluster, distributed.Client(cluster) as client, Finished(folder) as looked:
        assert cluster.scheduler_address.startswith("tls://127.0.0.1")
        workers: dict[str, int] = client.run(os.getpid)
        killing = looked.kill(4, workers.values)
        swept = ws.sweep(dynamic, vary, folder=folder, executor=client)
        killing.ends(killed=2, before=20)
        assert not set(client.run(os.getpid).values()) & set(workers.values())
    looked.none_done_twice()
    assert len(swept) == 24 and not swept.failed
    same(swept, ws.sweep(dynamic, vary, folder=tmp_path / "whole"))


class Breaking(ThreadPoolExecutor):
    """A pool that loses the worker of some cases."""

    def __init__(self, breaks: Callable[[str, int], bool]) -> None:
        super().__init__(2)
        self._breaks = breaks
        self.handed_out: dict[str, int] = {}

    def submit(self, work: Any, /, *arguments: Any, **keywords: Any) -> Future[Any]:
        names = [task.name for task in arguments[1]]
        for name in names:
            self.handed_out[name] = self.handed_out.get(name, 0) + 1
        if any(self._breaks(name, self.handed_out[name]) for name in names):
            lost: Future[Any] = Future()
            lost.set_exception(BrokenExecutor("a worker died"))
            return lost
        return super().submit(work, *arguments, **keywords)


def test_a_case_that_kills_its_workers_is_given_up(soft: ws.Case, tmp_path: Path) -> None:
    with Breaking(lambda name, _: name == "friction=0.2") as pool:
        swept = ws.sweep(soft, {"friction": [0.1, 0.2, 0.3]}, folder=tmp_path, executor=pool)
    assert pool.handed_out["friction=0.2"] == 3
    reason = "its worker was lost 3 times, the last time by: a worker died"
    assert swept.failed == {"friction=0.2": reason}
    assert len(swept) == 3
    # The next sweep tries only this case again.
    with Breaking(lambda _, time: time < 3) as pool:
        swept = ws.sweep(soft, {"friction": [0.1, 0.2, 0.3]}, folder=tmp_path, executor=pool)
    assert pool.handed_out == {"friction=0.2": 3}
    assert not swept.failed


def test_another_mistake_ends_the_sweep_and_keeps_what_was_done(
    soft: ws.Case, tmp_path: Path
) -> None:
    class Odd(ThreadPoolExecutor):
        count = 0

        def submit(self, work: Any, /, *arguments: Any, **keywords: Any) -> Future[Any]:
            self.count += 1
            if self.count > 2:
                raise OSError("no more processes")
            return super().submit(work, *arguments, **keywords)

    with Odd(1) as pool, pytest.raises(OSError, match="no more processes"):
        ws.sweep(soft, VARIED, folder=tmp_path, executor=pool, in_flight=1)
    assert len(ws.Sweep.load(tmp_path)) >= 2
    assert len(ws.sweep(soft, VARIED, folder=tmp_path)) == 6


class Slow(Executor):
    """An executor that counts its tasks in flight."""

    def __init__(self) -> None:
        self.waiting: deque[tuple[Future[Any], Any]] = deque()
        self.most = 0
        self.tasks = 0
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._work)
        self._thread.start()

    def submit(self, work: Any, /, *arguments: Any, **keywords: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self.waiting.append((future, (work, arguments)))
        self.most = max(self.most, len(self.waiting))
        self.tasks += 1
        return future

    def _work(self) -> None:
        while not self._end.is_set():
            if not self.waiting:
                time.sleep(1e-4)
                continue
            future, (work, arguments) = self.waiting[0]
            result = work(*arguments)
            # Before the waiting thread can submit the next task.
            self.waiting.popleft()
            future.set_result(result)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        self._end.set()
        self._thread.join()


class Counted:
    """Cases without work, each of which takes some time on the clock of the worker."""

    def __init__(self, case_s: float) -> None:
        self.case_s = case_s
        self.ended: list[int] = []

    def submit(self, pool: Pool, numbers: list[int], first: bool) -> Future[Any]:
        return pool.submit(self._solve, numbers)

    def _solve(self, numbers: list[int]) -> Done:
        solved = [Solved(number=number, ended=b"{}", files=None) for number in numbers]
        return Done(solved=solved, took_s=self.case_s * len(numbers))

    def take(self, done: Done) -> list[int]:
        numbers = [solved.number for solved in done.solved]
        self.ended.extend(numbers)
        return numbers

    def fail(self, number: int, reason: str) -> None:
        raise AssertionError(reason)


@pytest.mark.parametrize(
    ("count", "case_s", "bundles"), [(100_000, 0.002, 2000), (10_000, 60.0, 10_000)]
)
def test_a_hundred_thousand_cases_do_not_flood_a_scheduler(
    count: int, case_s: float, bundles: int
) -> None:
    slow, cases = Slow(), Counted(case_s)
    pool = Pool(slow)
    order = range(count)
    tracemalloc.start()
    Gathering(pool, cases, order, in_flight=None, bundle_s=0.5, tries=3).run()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    slow.shutdown()
    assert sorted(cases.ended) == list(order)
    assert slow.most <= PER_WORKER * pool.workers()
    assert slow.tasks <= bundles
    # The numbers themselves, in the order and in the ended set: 32 bytes and two entries each.
    assert peak < 12e6, peak


def test_of_real_cases_a_few_are_in_flight(soft: ws.Case, tmp_path: Path) -> None:
    vary: dict[str, Any] = {"friction": list(np.linspace(0.1, 0.5, 120))}
    slow = Slow()
    swept = ws.sweep(soft, vary, folder=tmp_path, executor=slow, in_flight=5)
    slow.shutdown()
    assert len(swept) == 120
    assert slow.most <= 5
    assert slow.tasks < 100


def test_bad_input_gets_an_answer(soft: ws.Case, tmp_path: Path) -> None:
    mistaken: list[tuple[Any, type[Exception], str]] = [
        ({}, ValueError, "vary names no key"),
        ({"friction": []}, ws.InputError, "`friction` is given no values"),
        ({"friction": 0.3}, TypeError, "`friction` was given 0.3: expected a list of values"),
        ({"friction": "0.1..0.3"}, ws.CaseError, "a range needs a step"),
        ({"bit_depth": [300.0, float("nan")]}, ValueError, "expected a finite number"),
        ({"frictoin": [0.1]}, ws.CaseError, "there is no key `frictoin`"),
        ({"friction": [0.1, -0.2]}, ws.CaseError, "1 of 2 cases is invalid, friction=-0.2"),
        (
            {"friction": [0.1] * 400, "wob": [1e3] * 400},
            ws.InputError,
            "a sweep of 400 . 400 cases",
        ),
    ]
    for vary, error, message in mistaken:
        with pytest.raises(error, match=message):
            ws.sweep(soft, vary, folder=tmp_path / "none")
    assert not (tmp_path / "none").exists()
    good: Any = {"friction": [0.1]}
    for keywords, error, message in [
        ({"executor": 3}, TypeError, "expected a concurrent.futures.Executor"),
        ({"keep": "nothing"}, ValueError, 'expected "summary", "tables" or "all"'),
        ({"tries": 0}, ValueError, "at least 1"),
        ({"checkpoint_every": "3 m"}, ValueError, "a time was expected"),
        ({"bundle": "1 m"}, ValueError, "a time was expected"),
        (
            {"checkpoint_every": -1.0},
            ws.InputError,
            "`checkpoint_every`: `-1.0 s`: expected 0.01 s",
        ),
        ({"jobs": -1}, ValueError, "`jobs` was given -1: expected a whole number from 1 to 1024"),
        ({"jobs": 10**9}, ValueError, "expected a whole number from 1 to 1024"),
    ]:
        given: Any = keywords
        with pytest.raises(error, match=message):
            ws.sweep(soft, good, folder=tmp_path / "none", **given)
    with ThreadPoolExecutor(1) as threads:
        threads.submit(lambda: None)
        with pytest.raises(ws.Error, match="may differ"):
            solve_with_another_version(soft, tmp_path)


def solve_with_another_version(case: ws.Case, folder: Path) -> None:
    import pickle

    from wholestring._task import Job, solve

    job = Job(
        name="case",
        text=case.to_toml(),
        files={},
        options="{}",
        running=str(folder / "running"),
        shared=None,
        version="0.0.0",
    )
    solve(pickle.dumps(job), [])


def test_a_bar_counts_the_cases(
    soft: ws.Case, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for executor in (None, ThreadPoolExecutor(1)):
        ws.sweep(soft, VARIED, folder=tmp_path, executor=executor, progress=True, resume=False)
        assert "6 of 6" in capsys.readouterr().err
