"""Pickles: in a fresh interpreter, and from another process."""

import multiprocessing
import pickle
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import wholestring as ws


@pytest.fixture(scope="module")
def pool() -> Iterator[ProcessPoolExecutor]:
    # Not forked: this process has threads.
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        yield pool


def again(value: Any) -> Any:
    return pickle.loads(pickle.dumps(value))


def same_table(ours: ws.Table, theirs: ws.Table) -> None:
    assert ours.to_polars().equals(theirs.to_polars())
    assert (ours.name, ours.columns) == (theirs.name, theirs.columns)
    for column in ours.columns:
        assert ours.unit(column) == theirs.unit(column)
        assert ours.meaning(column) == theirs.meaning(column)
        expected, actual = ours[column], theirs[column]
        assert np.array_equal(expected, actual, equal_nan=expected.dtype.kind == "f")


def same(ours: ws.BaseResults, theirs: ws.BaseResults) -> None:
    assert type(ours) is type(theirs)
    assert ours.summary == theirs.summary
    assert ours.tables == theirs.tables
    for name in ours.tables:
        same_table(ours.table(name), theirs.table(name))
    assert repr(ours) == repr(theirs)


# Functions that the other process runs.


def soft(case: ws.Case) -> ws.Results:
    return case.soft()


def moved(case: ws.Case) -> ws.Results:
    return case.dynamic()


def planned(case: ws.Case) -> ws.Plan:
    return case.plan(jobs=1)


def nodes(case: ws.Case) -> ws.Table:
    return case.soft("drill").nodes


def swept(case: ws.Case, folder: str) -> ws.Sweep:
    return ws.sweep(case, {"friction": [0.2, 0.3]}, folder=folder)


def locked(case: ws.Case) -> ws.Results:
    return case.stiff()


def interrupted(case: ws.Case) -> ws.Results:
    import signal
    import threading

    threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT)).start()
    return case.dynamic()


def calibrated(case: ws.Case) -> ws.Calibration[ws.Case]:
    depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    table = case.broomstick(
        frictions=0.25, bit_depths=depths, operations="trip_out", model="soft", jobs=1
    )
    data = {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}
    return case.calibrate(data, one_factor=True)


def test_results_in_memory_come_from_another_process(
    slant: ws.Case, short: ws.Case, pool: ProcessPoolExecutor, tmp_path: Path
) -> None:
    ours = slant.soft()
    theirs = pool.submit(soft, slant).result()
    assert theirs.folder is None
    same(ours, theirs)
    # They are saved in the same form as results computed here.
    for results, name in ((ours, "ours"), (theirs, "theirs")):
        results.save(tmp_path / name, csv=True)
    for file in sorted((tmp_path / "ours").iterdir()):
        # The page has the time at which it was made.
        if file.suffix != ".html":
            assert file.read_bytes() == (tmp_path / "theirs" / file.name).read_bytes(), file.name
    assert (tmp_path / "theirs" / "report.html").is_file()
    case = short.with_(records__spectra=["hook_load"])
    theirs = pool.submit(moved, case).result()
    ours = case.dynamic()
    assert theirs.tables == ours.tables
    assert "spectra" in theirs.tables
    for table in ours.tables:
        same_table(ours.table(table), theirs.table(table))


def test_results_of_a_temporary_folder_bring_its_files(
    slant: ws.Case, pool: ProcessPoolExecutor, tmp_path: Path
) -> None:
    case = slant.with_({"plan.depths": 2})
    ours, theirs = case.plan(jobs=1), pool.submit(planned, case).result()
    assert theirs.folder is not None and theirs.folder != ours.folder
    for file in ("report.html", "summary.json", "plan_broomstick.parquet"):
        assert (theirs.folder / file).is_file(), file
    same(ours, theirs)
    assert isinstance(ws.load(theirs.save(tmp_path / "saved")), ws.Plan)
    folder = again(ours).folder
    assert folder is not None and not folder.exists(), "the folder is removed with its results"


def test_results_of_a_folder_are_that_folder(slant: ws.Case, tmp_path: Path) -> None:
    saved = slant.soft()
    folder = saved.save(tmp_path / "here")
    assert again(saved).folder == folder
    same(saved, again(saved))
    pickled = pickle.dumps(saved)
    assert len(pickled) < 1000
    folder.rename(tmp_path / "gone")
    with pytest.raises(ws.ResultsError, match="here"):
        pickle.loads(pickled)


def test_a_table_comes_from_another_process(slant: ws.Case, pool: ProcessPoolExecutor) -> None:
    theirs = pool.submit(nodes, slant).result()
    ours = nodes(slant)
    same_table(ours, theirs)
    nulls = [name for name in ours.columns if ours.to_polars()[name].null_count()]
    assert nulls, "the table has values that do not apply"
    assert not theirs["tension_N"].flags.writeable


def test_a_sweep_is_its_folder(slant: ws.Case, pool: ProcessPoolExecutor, tmp_path: Path) -> None:
    case = slant.with_(model="soft", operation__kind="trip_out")
    theirs = pool.submit(swept, case, str(tmp_path / "sweep")).result()
    assert theirs.folder == tmp_path / "sweep"
    assert theirs.names == ("friction=0.2", "friction=0.3")
    alone = case.with_(friction=0.2).soft("trip_out")["trip_out"].hook_load_N
    assert theirs["friction=0.2"]["trip_out"].hook_load_N == alone


def test_a_calibration_keeps_its_case(slant: ws.Case, pool: ProcessPoolExecutor) -> None:
    case = slant.with_(rig__block_weight="200 kN")
    found = pool.submit(calibrated, case).result()
    assert found["friction"].value == pytest.approx(0.25, abs=1e-3)
    assert found.case == found.applied_to(case)


def test_errors_bring_what_was_computed(
    slant: ws.Case, short: ws.Case, pool: ProcessPoolExecutor
) -> None:
    with pytest.raises(ws.NoAnswerError) as caught:
        pool.submit(locked, slant.with_(friction=1.2, wob="900 kN")).result()
    assert {"failed", "complete"} == {result.status for result in caught.value.results}
    with pytest.raises(ws.Interrupted) as stopped:
        pool.submit(interrupted, short.with_(dynamics__duration="1 h")).result()
    assert stopped.value.results["drill"].status == "interrupted"
    assert len(stopped.value.results.time) > 0
    with pytest.raises(ws.CaseError) as mistaken:
        slant.with_(wobb=3.0)
    assert again(mistaken.value).diagnostics == mistaken.value.diagnostics


SCRIPT = """
import pickle, sys
results, table, sweep, error = pickle.load(open(sys.argv[1], "rb"))
print(results["drill"].hook_load_N.hex(), len(results.nodes))
print(float(table["md_m"].max()), table.unit("md_m"))
print(sweep.names)
print([of.status for of in error.results])
"""


def test_pickles_open_in_a_fresh_interpreter(slant: ws.Case, tmp_path: Path) -> None:
    results = slant.soft("drill")
    sweep = swept(slant.with_(model="soft", operation__kind="trip_out"), str(tmp_path / "sweep"))
    with pytest.raises(ws.NoAnswerError) as caught:
        slant.with_(friction=1.2, wob="900 kN").stiff("drill")
    pickled = tmp_path / "all.pickle"
    pickled.write_bytes(pickle.dumps((results, results.nodes, sweep, caught.value)))
    ran = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(pickled)],
        capture_output=True,
        text=True,
        check=True,
        cwd=tmp_path,
    )
    lines = [
        f"{results['drill'].hook_load_N.hex()} {len(results.nodes)}",
        "1200.0 m",
        "('friction=0.2', 'friction=0.3')",
        "['failed']",
    ]
    assert ran.stdout.splitlines() == lines


def test_a_damaged_pickle_is_refused() -> None:
    from wholestring import _core

    with pytest.raises(ws.ResultsError, match="schema_version"):
        _core.Answers.restore("{}", [], False)
    columns: list[Any] = [
        [("a", "", "", [b"1234567", b"\0"], None)],
        [("a", "", "", [b"12345678", b"\0\0"], None)],
        [("a", "", "", None, None)],
        [("a", "", "", None, ["x"]), ("b", "", "", None, [])],
    ]
    for parts in columns:
        with pytest.raises(ValueError, match="no columns of a table"):
            _core.Table.restore(parts)
    fish = _core.Table.restore([("a", "m", "a length", None, ["x"])])
    text = ws.Case.example().soft("drill")
    summary, tables, spectra = text._core.parts() or ("", [], False)
    with pytest.raises(ws.ResultsError, match="its table `fish` is not one of a run"):
        _core.Answers.restore(summary, [*tables, ("fish", fish)], spectra)
    with pytest.raises(ws.ResultsError, match="its table `nodes`"):
        _core.Answers.restore(summary, [("nodes", fish)], spectra)
