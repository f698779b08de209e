"""Commands of the command line: in a temporary folder, in a given one, saved and loaded."""

import signal
import threading
import time
from pathlib import Path
from typing import Any

import pint
import polars
import pytest
import wholestring as ws


@pytest.fixture(scope="module")
def small(slant: ws.Case) -> ws.Case:
    """A well whose plan requires little computation."""
    changes: dict[str, ws.Value] = {
        "plan.depths": 3,
        "mesh.element_length": 20.0,
        "modes.count": 2,
        "rig.top_drive_torque": "12 kN.m",
    }
    return slant.with_(changes)


# Result type of each method, and the settings that make it fast: a case without drilling has no map
# of torsional stability.
VERBS: dict[str, tuple[type[ws.BaseResults], dict[str, Any], dict[str, ws.Value]]] = {
    "plan": (ws.Plan, {}, {}),
    "reach": (ws.Reach, {"to": "3 km"}, {}),
    "bha": (ws.Bha, {"inclination": "10deg"}, {}),
    "modes": (ws.Modes, {}, {"operation.kind": "rotate_off_bottom"}),
}


def done(verb: str, case: ws.Case, folder: Path | None = None) -> ws.BaseResults:
    """Call a method by its name."""
    kind, options, changes = VERBS[verb]
    results: ws.BaseResults = getattr(case.with_(changes), verb)(folder, **options)
    assert type(results) is kind
    return results


def same_tables(ours: ws.BaseResults, folder: Path) -> None:
    """Compare all tables with the Parquet files of a folder."""
    files = {file.stem for file in folder.glob("*.parquet")}
    assert set(ours.tables) == files
    for name in files:
        written = polars.read_parquet(folder / f"{name}.parquet")
        assert ours.table(name).to_polars().equals(written), name


@pytest.mark.parametrize("verb", VERBS)
def test_in_a_temporary_folder_as_in_a_given_one(verb: str, small: ws.Case, tmp_path: Path) -> None:
    own = done(verb, small)
    temporary = own.folder
    assert temporary is not None and temporary.is_dir()
    given = done(verb, small, tmp_path / "given")
    assert given.folder == tmp_path / "given"
    same_tables(own, tmp_path / "given")
    assert own.summary == given.summary
    assert (tmp_path / "given" / "report.html").is_file()
    # The saved folder equals that of the command itself, and no temporary folder remains.
    saved = own.save(tmp_path / "saved")
    assert own.folder == saved
    assert not temporary.exists()
    names = {path.relative_to(saved) for path in saved.rglob("*")}
    target = tmp_path / "given"
    assert names == {path.relative_to(target) for path in target.rglob("*")}
    loaded = ws.load(saved)
    assert type(loaded) is type(own)
    assert isinstance(loaded, ws.BaseResults)
    assert loaded.summary == own.summary
    same_tables(loaded, tmp_path / "given")
    assert type(own).__name__ in repr(loaded)
    assert "<table" in loaded._repr_html_()


@pytest.mark.parametrize("verb", VERBS)
def test_other_results_are_protected(verb: str, small: ws.Case, tmp_path: Path) -> None:
    small.soft("drill").save(tmp_path / "here")
    with pytest.raises(ws.FolderError, match="here"):
        done(verb, small, tmp_path / "here")
    own = done(verb, small)
    with pytest.raises(ws.FolderError, match="here"):
        own.save(tmp_path / "here")
    own.save(tmp_path / "here", overwrite=True)
    # Repeating the same command is allowed.
    done(verb, small, tmp_path / "here")
    with pytest.raises(ws.ResultsError, match=r"and not a run: wholestring\.load"):
        ws.Results.load(tmp_path / "here")


def test_a_temporary_folder_goes_with_its_results(small: ws.Case) -> None:
    plan = small.plan()
    folder = plan.folder
    table = plan.broomstick
    assert folder is not None and folder.is_dir()
    del plan
    assert not folder.exists()
    assert len(table) > 0


def test_what_a_plan_says(small: ws.Case) -> None:
    plan = small.plan(jobs=1)
    assert plan.deepest_m == 1200.0
    assert plan.missing == 0
    assert len(plan.broomstick) == len(plan.summary["points"])
    # The top drive is weaker than the torque of this well.
    assert {check.severity for check in plan.checks} <= {"ok", "note", "warning", "error"}
    order = [("error", "warning", "note").index(found.severity) for found in plan.findings]
    assert order == sorted(order)
    weak = small.with_(rig__top_drive_torque="1 kN.m").plan()
    assert weak.findings[0].severity == "error"
    assert any(check.kind == "top_drive" and check.verdict == "exceeded" for check in weak.checks)


def test_a_plan_is_resumed(small: ws.Case, tmp_path: Path) -> None:
    whole = small.plan(tmp_path / "whole")
    again = small.plan(tmp_path / "whole", resume=True)
    assert again.broomstick.to_polars().equals(whole.broomstick.to_polars())
    with pytest.raises(ws.FolderError, match="whole"):
        small.with_(friction=0.1).plan(tmp_path / "whole", resume=True)


def test_an_interrupted_plan_keeps_what_it_has(slant: ws.Case, tmp_path: Path) -> None:
    case = slant.with_({"plan.models": "stiff", "plan.depths": 200})
    sent = 0.0

    def interrupt() -> None:
        nonlocal sent
        sent = time.monotonic()
        signal.raise_signal(signal.SIGINT)

    threading.Timer(1.5, interrupt).start()
    with pytest.raises(ws.Interrupted) as caught:
        case.plan(tmp_path / "long", jobs=1)
    took = time.monotonic() - sent
    plan = caught.value.results
    assert isinstance(plan, ws.Plan)
    assert plan.missing > 0
    assert len(plan.broomstick) > 0
    assert took < 3.0, took
    with pytest.raises(ws.FolderError, match="long"):
        case.plan(tmp_path / "long")


@pytest.mark.parametrize("verb", ["modes", "bha", "reach", "broomstick"])
def test_an_interrupt_does_not_wait(verb: str, np13: ws.Case) -> None:
    # A large task, so that it is running when interrupted.
    much: dict[str, dict[str, Any]] = {
        "bha": {"weight": [1e3 * i for i in range(1, 2000)]},
        "broomstick": {"model": "stiff", "bit_depths": "500m..4300m/10m"},
        "modes": {},
        "reach": {"to": 15e3, "friction": [0.01 * i for i in range(1, 40)]},
    }
    sent = 0.0

    def interrupt() -> None:
        nonlocal sent
        sent = time.monotonic()
        signal.raise_signal(signal.SIGINT)

    threading.Timer(0.3, interrupt).start()
    with pytest.raises(ws.Interrupted) as caught:
        getattr(np13, verb)(**much[verb])
    # Work that ends by itself raises nothing. How soon it stops is measured by the benchmark.
    assert time.monotonic() - sent < 5.0
    results = caught.value.results
    match verb:
        case "bha":
            assert isinstance(results, ws.Bha)
            found, missing = len(results.summary["sweep"]), results.summary["missing"]
            assert found > 0
            assert found + missing > 1999
        case "reach":
            assert isinstance(results, ws.Reach)
            frictions = results.summary["frictions"]
            assert any(row["limits"] for row in frictions)
            assert any(row.get("missing") for row in frictions)
        case "broomstick":
            assert isinstance(results, ws.Table)
            assert 0 < len(results) < 3 * 4 * 381
        case _:
            # There are no results before the natural modes.
            assert results is None or results.summary["missing"]


def test_a_reach_says_what_stops_the_well(small: ws.Case) -> None:
    reach = small.reach(to=6000.0, friction="0.2, 0.4", operation=["drill", "slide"])
    easy, hard = reach.stops
    assert (easy.friction, hard.friction) == (0.2, 0.4)
    assert easy.depth_m > hard.depth_m
    assert reach.depth_m == easy.depth_m
    # A check for each operation at each friction.
    assert len(reach.checks) == 4
    assert {easy.depth_m, hard.depth_m} <= {check.value for check in reach.checks}
    assert reach.from_m == 1200.0
    far = small.reach(to=6000.0, friction=[0.4], operation="slide", no_helix_friction=True)
    assert far.summary["helix_side_force"] is False
    helix = small.reach(to=6000.0, friction=[0.4], operation="slide", stop_at_helix=True)
    assert helix.summary["stop_at_helix"] is True


def test_an_assembly_says_what_the_bit_does(small: ws.Case) -> None:
    bha = small.bha(operation="drill", weight=[0.0, "50 kN"], inclination=[0.5])
    varied = bha.varied.to_polars()
    assert set(varied["varied"]) == {"weight", "inclination"}
    high_N, right_N = bha.side_force_N
    assert high_N < 0.0
    assert abs(right_N) < abs(high_N)
    assert bha.largest_bending_moment_N_m > 0.0
    assert bha.operation == "drill"
    assert bha.length_m == pytest.approx(148.3, abs=0.1)


def test_modes_are_those_of_a_rod(small: ws.Case) -> None:
    modes = small.modes(operation="rotate_off_bottom")
    lowest = modes.frequencies_Hz("torsional")
    # A uniform rod fixed at its top; collars lower its frequency somewhat.
    shear_m_per_s = (76.923e9 / 7860.0) ** 0.5
    assert 0.6 * shear_m_per_s / 4800.0 < lowest[0] < shear_m_per_s / 4800.0
    assert (modes.critical_speeds_rad_per_s > 0.0).all()
    with pytest.raises(ValueError, match="expected one of"):
        modes.frequencies_Hz("sideways")


BAD: list[tuple[str, dict[str, Any], type[Exception], str]] = [
    ("plan", {"jobs": 0}, ValueError, "`jobs` was given 0: expected a whole number from 1"),
    ("plan", {"jobs": 1.5}, ws.InputTypeError, "`jobs` was given 1.5"),
    ("plan", {"units": "imperial"}, ws.InputError, "`units`: .*imperial"),
    ("plan", {"checkpoint": 0.0}, ws.InputError, "`checkpoint`: `0.0 s`: expected 0.01 s to"),
    ("plan", {"checkpoint": "3 m"}, ValueError, "`checkpoint`: .*a time was expected"),
    ("plan", {"resume": True}, ValueError, "resume needs the folder"),
    ("plan", {"resume": True, "overwrite": True}, ValueError, "exclude each other"),
    ("reach", {"from_": "0.1 m"}, ws.InputError, "expected more than 0.3 m"),
    ("reach", {"from_": 1e9}, ws.InputError, "below its beginning|most"),
    ("reach", {"from_": float("nan")}, ValueError, "`from_` was given nan: expected a finite"),
    ("reach", {"friction": 3.0}, ws.InputError, "friction factor of 3 is outside 0 to 2"),
    ("reach", {"friction": "a"}, ValueError, "`friction`: 'a' is no friction factor"),
    ("reach", {"operation": "fish"}, ws.InputError, "`operation`: `fish` is no operation"),
    ("bha", {"operation": "fish"}, ws.InputError, "`operation`: `fish` is no operation"),
    ("bha", {"operation": "back_ream"}, ws.InputError, "the case has no back_ream"),
    ("bha", {"toolface": "0 deg"}, ws.InputError, "no component of the string has a bend"),
    ("bha", {"weight": -1.0}, ws.InputError, "is outside 0 to 5000 kN"),
    ("bha", {"weight": "3 m"}, ws.CaseError, "weight"),
    ("bha", {"weight": ["3 m"]}, ValueError, "`weight`: .*a force was expected"),
    ("bha", {"build": "3 m"}, ValueError, "`build`: .*was expected"),
    ("modes", {"operation": "fish"}, ws.InputError, "`operation`: `fish` is no operation"),
    ("bit_test", {}, ws.InputError, "no rock"),
    ("bit_test", {"shard": "5/4"}, ws.InputError, "`shard`: expected such as 1/4|no rock"),
]


@pytest.mark.parametrize(("verb", "options", "error", "message"), BAD)
def test_bad_input_of_a_verb(
    verb: str, options: dict[str, Any], error: type[Exception], message: str, small: ws.Case
) -> None:
    with pytest.raises(error, match=message):
        getattr(small, verb)(**options)


def test_quantities_of_pint_are_options(small: ws.Case) -> None:
    units: Any = getattr(pint, "UnitRegistry")()  # noqa: B009 - its types are half known
    reach = small.reach(to=units.Quantity(3.0, "km"), operation="slide")
    assert reach.to_m == pytest.approx(3000.0)
    bha = small.bha(operation="drill", weight=units.Quantity([10.0, 20.0], "kN"), inclination=0.5)
    assert list(bha.varied["varied"]) == ["weight", "weight", "inclination"]
    with pytest.raises(ws.InputError, match=r"`to`: .*convert"):
        small.reach(to=units.Quantity(3.0, "kN"))


ROCK: dict[str, ws.Value] = {
    "bit.face.cutter_diameter": "19 mm",
    "rock.strength": "10 MPa",
    "rock.element_size": "15 mm",
    "rock.density_factor": 60,
    "bit_test.wob": ["10 kN", "20 kN"],
    "bit_test.rpm": ["240 rpm"],
    "bit_test.settle_revolutions": 0.25,
    "bit_test.revolutions": 1,
}


def test_a_bit_is_tried_in_shards(slant: ws.Case, tmp_path: Path) -> None:
    case = slant.with_(ROCK).with_({"string.0.od": "120 mm"})
    whole = case.bit_test(jobs=2)
    assert whole.law_file is not None
    here = tmp_path / "here"
    first = case.bit_test(here, shard="1/2")
    assert first.law_file is None
    both = case.bit_test(here, resume=True)
    assert whole.points.to_polars().equals(both.points.to_polars())
    assert isinstance(ws.load(here), ws.BitTest)
    assert both.rock_strength_Pa == pytest.approx(10e6)
    assert "2 of 2" in repr(both)


def test_a_bar_is_drawn(small: ws.Case, capsys: pytest.CaptureFixture[str]) -> None:
    small.plan(progress=True)
    drawn = capsys.readouterr().err
    assert "100%" in drawn
    assert " of " in drawn
