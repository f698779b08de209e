"""Cases: made, changed, written and pickled."""

import pickle
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pint
import polars
import pytest
import wholestring as ws


def registry() -> Any:
    made: Any = getattr(pint, "UnitRegistry")  # noqa: B009 - its types are half known
    return made()


def test_a_number_is_si_and_a_text_has_its_unit(slant: ws.Case) -> None:
    as_text = slant.with_(wob="60 kN", operation__rpm="120 rpm")
    as_number = slant.with_({"operation.wob": 60e3, "operation.rpm": 120})
    assert as_text == as_number
    assert hash(as_text) == hash(as_number)
    assert as_text != slant
    assert as_text.settings["operation"]["wob_N"] == 60e3


def test_the_path_of_a_well_is_that_of_its_stations(np13: ws.Case) -> None:
    path = np13.well_path()
    stations = np13.settings["well"]["stations"]
    assert path.name == "well"
    rows = np.searchsorted(path["md_m"], np.array(stations["md_m"]) - 1e-3)
    inclination, azimuth = path["inclination_rad"][rows], path["azimuth_rad"][rows]
    np.testing.assert_allclose(inclination, stations["inclination_rad"], atol=1e-6)
    # Vertical hole has no azimuth.
    inclined = inclination > 1e-3
    assert inclined.sum() > 100
    np.testing.assert_allclose(
        azimuth[inclined], np.array(stations["azimuth_rad"])[inclined], atol=1e-6
    )
    depth_m, drilled_m = path["tvd_m"], path["md_m"]
    assert depth_m[0] == 0.0
    assert drilled_m[-1] == np13.settings["operation"]["bit_depth_m"]
    along_m = np.hypot(
        np.hypot(np.diff(path["north_m"]), np.diff(path["east_m"])), np.diff(depth_m)
    )
    np.testing.assert_allclose(along_m, np.diff(drilled_m), rtol=1e-4)
    assert path.unit("dogleg_severity_rad_per_m") == "rad/m"


def test_the_path_of_a_quarter_of_a_circle() -> None:
    """Closed form: minimum curvature from vertical to horizontal is a quarter of a circle."""
    length_m = 900.0
    made = ws.Case.example().with_(
        {"well.stations": [[0, 0, 90], [length_m, 90, 90]], "well.path": "minimum-curvature"},
        bit_depth=length_m,
    )
    path = made.well_path()
    radius_m = length_m / (np.pi / 2)
    np.testing.assert_allclose(path["tvd_m"], radius_m * np.sin(path["md_m"] / radius_m), atol=1e-6)
    np.testing.assert_allclose(path["north_m"], 0.0, atol=1e-6)
    east_m = radius_m * (1 - np.cos(path["md_m"] / radius_m))
    np.testing.assert_allclose(path["east_m"], east_m, atol=1e-6)
    np.testing.assert_allclose(path["vertical_section_m"], east_m, atol=1e-6)
    # Beyond the last station the path is straight.
    np.testing.assert_allclose(path["dogleg_severity_rad_per_m"][:-1], 1 / radius_m, rtol=1e-9)


def test_a_quantity_is_anything_that_converts(slant: ws.Case) -> None:
    units = registry()
    made = slant.with_(
        {
            "operation.wob": units.Quantity(60.0, "kN"),
            "operation.flow_rate": units.Quantity(2000.0, "liter/minute"),
            "mud.density": units.Quantity(9.0, "pound/gallon"),
        }
    )
    assert made.settings["operation"]["wob_N"] == pytest.approx(60e3, rel=1e-15)
    assert made.settings["operation"]["flow_rate_m3_per_s"] == pytest.approx(2 / 60, rel=1e-14)
    assert made.settings["mud"]["density_kg_per_m3"] == pytest.approx(1078.4, rel=1e-4)
    with pytest.raises(ws.InputError, match="Cannot convert") as caught:
        slant.with_(wob=units.Quantity(60.0, "m"))
    assert isinstance(caught.value.__cause__, pint.DimensionalityError)
    assert slant.with_(friction=units.Quantity(0.3, "")) == slant.with_(friction=0.3)
    with pytest.raises(ws.InputError, match="Cannot convert"):
        slant.with_(friction=units.Quantity(0.3, "m"))
    turning = slant.with_(rpm=units.Quantity(4.0, "pi * rad / s"))
    assert turning.settings["operation"]["rotary_speed_rad_per_s"] == pytest.approx(4 * np.pi)


def test_every_unit_is_one_that_pint_knows(slant: ws.Case) -> None:
    from wholestring import _core
    from wholestring._values import for_pint

    units = registry()
    keys = ["wob", "rpm", "mud.density", "operation.flow_rate", "mud.plastic_viscosity",
            "string.0.mass_per_length", "string.0.od", "bit.torque", "operation.rop"]  # fmt: skip
    for key in keys:
        unit = _core.unit_of(key)
        assert unit is not None, key
        assert units.Unit(for_pint(unit)) is not None


def test_a_case_of_python_objects_is_the_case_of_a_file() -> None:
    table: dict[str, ws.Value] = {
        "name": "vertical",
        "well": {
            "stations": [["0 m", "0 deg", "0 deg"], ["1000 m", "0 deg", "0 deg"]],
            "hole": [
                {"kind": "open", "to": 1000.0, "diameter": "8-1/2 in", "friction": 0.3},
            ],
        },
        "mud": {"density": 1100.0},
        "string": [
            {
                "component": "pipe",
                "od": 0.127,
                "id": 0.1086,
                "mass_per_length": 29.0,
                "length": "to surface",
            }
        ],
        "operation": {"kind": ["trip_out", "trip_in"]},
    }
    made = ws.Case.from_dict(table)
    # The hook load of a vertical string is its weight in mud, independent of friction.
    solved = made.soft()
    assert solved["trip_out"].hook_load_N == pytest.approx(solved["trip_in"].hook_load_N, rel=1e-12)
    steel = made.settings["string"][0]["density_kg_per_m3"]
    expected = 29.0 * 9.80665 * 1000.0 * (1 - 1100.0 / steel)
    assert solved["trip_out"].hook_load_N == pytest.approx(expected, rel=1e-9)


def test_a_real_case_is_made_of_python_objects(np13: ws.Case) -> None:
    tomllib = pytest.importorskip("tomllib", reason="requires Python 3.11")
    table: dict[str, Any] = tomllib.loads(np13.to_toml())
    # A rotary speed in rev/min, as in a case file.
    table["operation"]["rpm"] = "70 rpm"
    made = ws.Case.from_dict(table, files=np13.files)
    assert made == np13
    del table["well"]["survey"]
    (content,) = np13.files.values()
    frame = polars.read_csv(content)
    rows = frame.to_numpy()
    own = dict(np13.settings["well"], survey=None)
    for survey in (frame, frame.to_pandas(), frame.to_dict(), rows, rows.tolist()):
        made = ws.Case.from_dict(table, survey=survey)
        assert dict(made.settings["well"], survey=None) == own, type(survey)
        assert {**made.settings, "well": own} == {**np13.settings, "well": own}
        assert ws.Case(made.to_toml(), files=made.files) == made
    ours = made.soft("drill")["drill"].hook_load_N
    assert ours == np13.soft("drill")["drill"].hook_load_N


def test_a_survey_that_is_none() -> None:
    table: dict[str, ws.Value] = {"well": {}}
    for bad in (3.0, [[0.0, 0.0]], [["a", "b", "c"]], []):
        with pytest.raises(ValueError, match="`survey`: expected rows of measured depth"):
            ws.Case.from_dict(table, survey=bad)
    with pytest.raises(ws.CaseError, match=r"survey\.csv"):
        ws.Case.from_dict(table, survey={"depth of fish": [1.0]})


def test_numbers_of_numpy_are_numbers(slant: ws.Case) -> None:
    assert slant.with_(friction=np.float64(0.25)) == slant.with_(friction=0.25)
    assert slant.with_(wob=np.float64(6e4)) == slant.with_(wob="60 kN")
    several = np.array([800.0, 900.0])
    assert slant.with_({"plan.bit_depths": several}) == slant.with_(
        {"plan.bit_depths": ["800 m", "900 m"]}
    )
    assert slant.with_({"dynamics.seed": np.int64(3)}).settings["dynamics"]["seed"] == 3


def test_what_a_plan_and_modes_compute_is_of_the_case(slant: ws.Case) -> None:
    assert slant.with_({"plan.depths": 3}) != slant.with_({"plan.depths": 4})
    assert slant.with_({"modes.count": 3}) != slant.with_({"modes.count": 4})
    assert slant.with_({"modes.count": 3}) == slant.with_({"modes.count": 3})


def test_its_text_is_the_case(np13: ws.Case, slant: ws.Case) -> None:
    for case in (np13, slant.with_(friction=0.4), slant.with_(rig__block_weight="200 kN")):
        again = ws.Case(case.to_toml(), files=case.files)
        assert again == case
    assert "# 9-5/8 in 40 lb/ft" in slant.with_(friction=0.4).to_toml()


def test_a_pickle_opens_in_a_fresh_interpreter(np13: ws.Case, tmp_path: Path) -> None:
    case = np13.with_(friction=0.22)
    pickled = tmp_path / "case.pickle"
    pickled.write_bytes(pickle.dumps(case))
    script = (
        "import pickle, sys; case = pickle.load(open(sys.argv[1], 'rb'));"
        "print(case.soft('trip_out')['trip_out'].hook_load_N.hex())"
    )
    ran = subprocess.run(
        [sys.executable, "-c", script, str(pickled)], capture_output=True, text=True, check=True
    )
    assert ran.stdout.strip() == case.soft("trip_out")["trip_out"].hook_load_N.hex()


def test_a_check_tells_what_is_to_be_said(slant: ws.Case) -> None:
    assert slant.check() == slant.warnings == ()
    idle = slant.with_(operation__kind="drill", operation__bit_pull="10 kN")
    (found,) = idle.check()
    assert (found,) == idle.warnings
    assert found.severity == "warning"
    assert "bit_pull" in found.message
    (found,) = slant.check(operation="fish")
    assert "fish" in found.message


def test_it_cannot_be_changed(slant: ws.Case) -> None:
    with pytest.raises(AttributeError):
        slant.name = "other"  # type: ignore[misc]


def test_none_removes_a_key(slant: ws.Case) -> None:
    weighted = slant.with_(rig__block_weight="20 kN")
    assert weighted != slant
    # The table remains, without its key.
    assert weighted.with_({"rig.block_weight": None}) == slant.with_({"rig": {}})
    assert "block_weight" not in weighted.with_(rig__block_weight=None).to_toml()
    with pytest.raises(ws.CaseError, match=r"the case has no `rig\.block_weight`"):
        slant.with_(rig__block_weight=None)
    with pytest.raises(ws.CaseError, match=r"the case has no `string\.0`"):
        slant.with_({"string.0": None})
    # A missing required key is reported.
    with pytest.raises(ws.CaseError, match="density"):
        slant.with_(mud__density=None)
    # A case sent to another process keeps its removed keys removed.
    without = weighted.with_(rig__block_weight=None)
    assert pickle.loads(pickle.dumps(without)) == without


@pytest.mark.parametrize(
    ("changes", "keywords"),
    [
        ({"mud.density": 1100.0}, {"mud__density": 1200.0}),
        ({"operation.wob": 5e4}, {"wob": 6e4}),
        ({"well.hole.1.friction": 0.3}, {"friction": 0.2}),
        ({"mud": {"density": 1100.0}, "mud.density": 1200.0}, {}),
    ],
)
def test_keys_that_set_the_same_thing_are_refused(
    slant: ws.Case, changes: dict[str, ws.Value], keywords: dict[str, ws.Value]
) -> None:
    with pytest.raises(ws.InputError, match="set the same key"):
        slant.with_(changes, **keywords)
    with pytest.raises(ws.InputError, match="set the same key"):
        ws.sweep(slant, {"wob": [5e4], "operation.wob": [6e4]}, folder="never")
    # Successive changes are unambiguous.
    assert slant.with_({"well.hole.1.friction": 0.3}).with_(friction=0.2) == slant.with_(
        friction=0.2
    )


def test_a_rotary_speed_is_in_rev_per_min(slant: ws.Case) -> None:
    """120 rev/min are 4 pi rad/s; the limit of 1000 rev/min of the case applies."""
    for value in (120, 120.0, np.float32(120.0), np.int64(120), np.array(120)):
        speed = slant.with_(rpm=value).settings["operation"]["rotary_speed_rad_per_s"]
        assert speed == pytest.approx(4 * np.pi, rel=1e-15)
    with pytest.raises(ws.CaseError, match="expected 0 to 1000"):
        slant.with_(rpm=1001)


def test_every_example_is_sound() -> None:
    from wholestring import _core

    for name in _core.EXAMPLES:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            assert ws.Case.example(name).name
    with pytest.raises(ws.NotFoundError, match="there is no example 'fish'"):
        ws.Case.example("fish")
