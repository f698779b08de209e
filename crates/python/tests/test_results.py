"""Results in memory, and in the folder of the command line."""

import json
from pathlib import Path

import polars
import pytest
import wholestring as ws
from wholestring import _core


def test_in_memory_as_in_a_folder(slant: ws.Case, tmp_path: Path) -> None:
    case = slant.with_(model=["soft", "stiff"])
    into = case.run(tmp_path / "run")
    memory = case.soft()
    for solved in memory:
        assert into["soft", solved.operation].data == solved.data
    saved = memory.save(tmp_path / "saved", csv=True)
    for name in ("summary.json", "nodes.parquet", "nodes.csv", "report.html", "profile.svg"):
        assert (saved / name).is_file(), name
    loaded = ws.Results.load(saved)
    assert loaded.summary == memory.summary
    assert loaded.folder == saved
    ours = polars.DataFrame(memory.nodes)
    assert ours.equals(polars.read_parquet(saved / "nodes.parquet"))
    assert ours.equals(polars.DataFrame(loaded.nodes))


def test_a_dynamic_run_in_memory_is_the_command_lines(short: ws.Case, tmp_path: Path) -> None:
    memory = short.dynamic()
    folder = short.with_(model="dynamic").run(tmp_path / "run")
    assert folder.tables == memory.tables
    for name in memory.tables:
        assert polars.DataFrame(memory.table(name)).equals(polars.DataFrame(folder.table(name)))
    assert memory["drill"].statistics["hook_load_N"]["std"] >= 0.0
    assert len(memory.time) > 1


def test_every_scalar_is_an_attribute_with_its_meaning(slant: ws.Case) -> None:
    solved = slant.soft("drill")["drill"]
    for name, unit, _ in _core.SCALARS:
        value = getattr(solved, name)
        assert value is None or isinstance(value, float), name
        text = getattr(type(solved), name).__doc__ or ""
        assert f", {unit.replace('·', '.')}" in text, f"{name} lacks its unit, {unit}"
        assert solved.data[name] == value


def test_findings_are_there(slant: ws.Case) -> None:
    solved = slant.with_(friction=1.5).soft("slide")["slide"]
    assert solved.findings
    assert {found.severity for found in solved.findings} <= {"error", "warning", "note"}
    assert solved.findings[0].sentence


def test_an_operation_is_asked_for_by_name(slant: ws.Case, tmp_path: Path) -> None:
    both = slant.with_(model=["soft", "stiff"], operation__kind="drill").run(tmp_path / "both")
    assert both["soft", "drill"].model == "soft"
    with pytest.raises(KeyError, match="several models"):
        both["drill"]
    with pytest.raises(KeyError, match="soft drill, stiff drill"):
        both["trip_in"]
    assert "hook load" in repr(both["soft", "drill"])
    html = both._repr_html_()
    assert html.count("<tr>") == 3


def test_the_summary_is_json(slant: ws.Case, tmp_path: Path) -> None:
    results = slant.soft()
    saved = results.save(tmp_path / "saved")
    assert json.loads((saved / "summary.json").read_text()) == results.summary
