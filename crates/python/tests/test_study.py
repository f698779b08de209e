"""Studies, and their sweeps."""

from pathlib import Path

import polars
import pytest
import wholestring as ws

CASE = """
name = "Rod"

[well]
stations = [[0, 30, 0], [2000, 30, 0]]

[[well.hole]]
kind = "open"
to = "2000 m"
diameter = "8.5 in"
friction = 0.3

[mud]
density = "1.1 sg"

[[string]]
component = "pipe"
catalogue = "5 in 19.50 lb/ft G-105"
length = "to surface"

[operation]
kind = ["trip_out", "trip_in"]
"""

STUDY = """
name = "Little study"

[[sweep]]
name = "statics"
case = "rod.toml"
vary = { friction = [0.1, 0.3], bit_depth = "1000m..2000m/500m" }

[[figure]]
name = "hook-load"
title = "Hook load"
x = "bit_depth"
y = "hook_load_N"
"""


@pytest.fixture
def study(tmp_path: Path) -> Path:
    (tmp_path / "rod.toml").write_text(CASE)
    (tmp_path / "study.toml").write_text(STUDY)
    return tmp_path / "study.toml"


def test_a_study_and_its_sweeps(study: Path, tmp_path: Path) -> None:
    done = ws.study(study, tmp_path / "out", keep="tables", jobs=1)
    assert done.sweeps == ("statics",)
    sweep = done["statics"]
    assert len(sweep) == 6
    rows = sweep.table.to_polars()
    assert rows.height == 12
    assert rows["hook_load_N"].dtype == polars.Float64
    assert sweep.table.unit("hook_load_N") == "N"
    case = ws.Case.load(tmp_path / "rod.toml").with_(friction=0.1, bit_depth="1000 m")
    solved = case.soft()
    first = sweep["friction=0.1,bit_depth=1000m"]
    assert first["trip_out"].data == solved["trip_out"].data
    assert first.nodes.to_polars().equals(solved.nodes.to_polars())
    drawn = polars.read_csv(tmp_path / "out" / "figures" / "hook-load.csv")
    assert done.table("figures/hook-load").to_polars()["value"].equals(drawn["value"])
    assert list(done.figures) == ["hook-load"]
    with pytest.raises(KeyError, match="there are statics"):
        done["fish"]
    with pytest.raises(KeyError, match="there is no case 'fish'"):
        sweep["fish"]
    loaded = ws.load(tmp_path / "out")
    assert isinstance(loaded, ws.Study)
    inside = ws.load(tmp_path / "out" / "statics")
    assert isinstance(inside, ws.Sweep)
    assert len(inside) == 6
    assert isinstance(ws.load(tmp_path / "out" / "statics" / sweep.names[0]), ws.Results)
    assert "6 cases" in repr(loaded)
    assert "6 cases" in loaded._repr_html_()


def test_shares_resume_and_save(study: Path, tmp_path: Path) -> None:
    half = ws.study(study, tmp_path / "out", shard="1/2")
    assert len(half["statics"]) == 3
    whole = ws.study(study, tmp_path / "out", resume=True)
    assert len(whole["statics"]) == 6
    temporary = ws.study(study, changes={"mud.density": 1200.0})
    assert temporary.folder is not None and temporary.folder.is_dir()
    sweep = temporary["statics"]
    assert sweep[sweep.names[0]].summary["settings"]["mud"]["density_kg_per_m3"] == 1200.0
    with pytest.raises(ws.FolderError, match="out"):
        temporary.save(tmp_path / "out")
    temporary.save(tmp_path / "other")
    assert len(ws.Study.load(tmp_path / "other")["statics"]) == 6


def test_strict_lets_no_error_pass(study: Path) -> None:
    weak: dict[str, ws.Value] = {"rig.hoist_capacity": "100 kN"}
    assert ws.study(study, changes=weak).findings
    with pytest.raises(ws.FindingsError, match="errors were found in") as caught:
        ws.study(study, changes=weak, strict=True)
    assert isinstance(caught.value.results, ws.Study)


def test_bad_input(study: Path, tmp_path: Path) -> None:
    with pytest.raises(ws.CaseError, match="there is no such file"):
        ws.study(tmp_path / "none.toml")
    with pytest.raises(ws.InputError, match='`keep`: `some`: expected "summary", "tables"'):
        ws.study(study, keep="some")  # type: ignore[arg-type]
    with pytest.raises(ws.InputError, match="`csv` writes tables"):
        ws.study(study, keep="summary", csv=True)
    with pytest.raises(ws.InputError, match="`shard`: expected such as 1/4"):
        ws.study(study, shard="x")
    with pytest.raises(ws.CaseError, match="there is no key `fish`"):
        ws.study(study, changes={"fish": 1.0})
    with pytest.raises(ValueError, match="resume needs the folder"):
        ws.study(study, resume=True)
    study.write_text(STUDY.replace("figure", "figur"))
    with pytest.raises(ws.CaseError, match="figur") as caught:
        ws.study(study)
    assert caught.value.diagnostics[0].line is not None
