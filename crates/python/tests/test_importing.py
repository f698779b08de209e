"""Cases from the files of other programs."""

from pathlib import Path

import pytest
import wholestring as ws

SAMPLES = Path(__file__).parents[2] / "import" / "tests" / "samples" / "own"

SURVEY = "MD,Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n4000,30,45\n"

REST = """
[mud]
density = "1.2 sg"
[[well.hole]]
kind = "open"
to = "4000 ft"
diameter = "8-1/2 in"
friction = 0.3
[[string]]
component = "bit"
od = "8-1/2 in"
length = "0.3 m"
[[string]]
component = "drill pipe"
catalogue = "5 in 19.50 lb/ft S-135"
length = "to surface"
"""


@pytest.fixture
def survey(tmp_path: Path) -> Path:
    file = tmp_path / "survey.csv"
    file.write_text(SURVEY)
    return file


DOUBTFUL = """MD (ft),Inc,Azi,TVD (ft)
0,0,0,0
1000,0,0,1000
1100,40,45,1092
1200,4,45,1190
1300,41,45,1280
4000,41,45,9000
"""


def test_doubtful_surveys_are_noted_and_warned_of(tmp_path: Path) -> None:
    """Doglegs beyond the limit of any pipe, and positions in the file that differ from the path."""
    (tmp_path / "survey.csv").write_text(DOUBTFUL)
    doubts = ["deg/100ft above the station at 1100 ft", "true vertical depth of the file is"]
    imported = ws.import_files(tmp_path / "survey.csv")
    checked = [note.text for note in imported.notes if note.kind == "warning"]
    for doubt in doubts:
        assert any(doubt in text and "line " in text for text in checked), checked
    case = tmp_path / "case.toml"
    head = 'units = "field"\n[well]\nsurvey = "survey.csv"\n'
    case.write_text(head + REST + '[operation]\nkind = "trip_out"\n')
    with pytest.warns(ws.CaseWarning) as caught:
        ws.Case.load(case)
    for doubt in doubts:
        assert any(doubt in str(warning.message) for warning in caught), list(caught)


def test_a_survey_is_part_of_a_case(survey: Path, tmp_path: Path) -> None:
    imported = ws.import_files(survey, units={"md": "ft"})
    assert imported.files == {str(survey): "a survey of 4 stations"}
    assert len(imported.missing) == 3
    assert any(note.kind == "read" for note in imported.notes)
    with pytest.raises(ws.CaseError, match="hole"):
        imported.case()
    whole = ws.Case(imported.text + REST)
    assert whole.soft()["trip_out"].bit_depth_m == pytest.approx(1219.2)
    saved = imported.save(tmp_path / "well.toml")
    assert saved.read_text() == imported.text
    with pytest.raises(ws.FolderError, match=r"well\.toml"):
        imported.save(saved)


def test_what_is_not_told_is_asked_for(survey: Path, tmp_path: Path) -> None:
    with pytest.raises(ws.InputError, match="has no unit"):
        ws.import_files(survey)
    with pytest.raises(ws.InputError, match="--pick tubular"):
        ws.import_files(survey, units={"md": "ft"}, picks={"tubular": "BHA 7"})
    with pytest.raises(ws.InputError, match="no such file"):
        ws.Case.from_files(tmp_path / "none.csv")


def test_a_well_from_witsml() -> None:
    files = sorted(SAMPLES.glob("witsml-*.xml"))
    assert len(files) == 4
    case = ws.Case.from_files(*files, changes={"friction": 0.25})
    assert case.name == "Made-up 1"
    assert case.soft()["trip_out"].hook_load_N > 0.0


def test_another_programs_curves(tmp_path: Path) -> None:
    export = SAMPLES / "edm-well.xml"
    with pytest.raises(ws.InputError, match="--pick well=NAME"):
        ws.import_files(export)
    picks = {"well": "WS-1", "wellbore": "WS-1", "case": "8 1/2 in drilling"}
    imported = ws.import_files(export, units={"edm": "api"}, picks=picks)
    assert imported.missing == ()
    saved = imported.save(tmp_path / "well.toml")
    overlay = tmp_path / "well-overlay.csv"
    plan = ws.Case.load(saved).plan(tmp_path / "plan", overlay=overlay)
    assert (tmp_path / "plan" / "plan_overlay.parquet").is_file()
    assert plan.summary["overlay"]["file"].endswith("well-overlay.csv")


def test_a_file_tells_what_it_is(survey: Path) -> None:
    survey.write_text(SURVEY.replace("MD", "MD (ft)"))
    found = ws.contents(survey)
    assert found.what == "a survey of 4 stations"
    assert "measured depth" in " ".join(found.lines)
