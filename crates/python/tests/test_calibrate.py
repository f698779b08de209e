"""Friction from readings in every form of input, and the resulting case."""

from pathlib import Path
from typing import Any, cast

import numpy as np
import pandas
import polars
import pytest
import wholestring as ws

DEPTHS = [300.0, 450.0, 600.0, 700.0, 800.0, 900.0, 1000.0, 1100.0, 1200.0]
BLOCK_N = 200e3
ERRORS: dict[str, Any] = {
    "weight_error": "5 kN",
    "rotating_error": 3e3,
    "torque_error": "200 N.m",
}


@pytest.fixture(scope="module")
def rig(slant: ws.Case) -> ws.Case:
    return slant.with_(rig__block_weight=BLOCK_N)


@pytest.fixture(scope="module")
def data(rig: ws.Case) -> dict[str, Any]:
    """Readings computed with the friction of the case, 0.2 in casing and 0.3 in open hole."""
    table = rig.with_({"plan.bit_depths": DEPTHS}).broomstick().to_polars()
    expected = table.filter(polars.col("friction") == "expected")

    def column_of(operation: str, column: str) -> Any:
        return expected.filter(polars.col("operation") == operation)[column].to_numpy()

    return {
        "bit_depth_m": DEPTHS,
        "pick_up_kN": column_of("trip_out", "hook_load_with_block_N") / 1e3,
        "slack_off_kN": column_of("trip_in", "hook_load_with_block_N") / 1e3,
        "rotating_N": column_of("rotate_off_bottom", "hook_load_with_block_N"),
        "torque_kN_m": column_of("rotate_off_bottom", "surface_torque_N_m") / 1e3,
    }


@pytest.fixture(scope="module")
def found(rig: ws.Case, data: dict[str, Any]) -> ws.Calibration[ws.Case]:
    return rig.calibrate(data, **ERRORS)


def parameters(found: ws.Calibration[ws.Case]) -> list[str]:
    return [estimate.parameter for estimate in found.estimates]


def test_friction_is_found_again(found: ws.Calibration[ws.Case]) -> None:
    assert parameters(found) == ["friction_cased", "friction_open"]
    # The plan and the fit use the same soft string, except between nodes of the friction.
    assert found.friction_cased == pytest.approx(0.2, abs=2e-3)
    assert found.friction_open == pytest.approx(0.3, abs=2e-3)
    assert found["friction_open"].value == found.friction_open
    error = found["friction_open"].standard_error
    assert error is not None and 0.0 < error < 0.05
    with pytest.raises(KeyError, match="there are friction_cased, friction_open"):
        found["fish"]
    assert found.block_weight_N is None or found.block_weight_N == BLOCK_N


def test_its_tables(found: ws.Calibration[ws.Case]) -> None:
    assert len(found.residuals) == 4 * len(DEPTHS)
    assert np.nanmax(np.abs(found.residuals["standardised"])) < 1.0
    assert set(found.posterior["parameter"]) == {"friction_cased", "friction_open"}
    assert found.posterior["excess"].min() >= 0.0
    assert len(found.bands) > 0
    covariance = found.covariance
    assert covariance.shape == (2, 2)
    assert (np.linalg.eigvalsh(covariance) > 0.0).all()
    error = found["friction_cased"].standard_error
    assert error is not None
    assert covariance[0, 0] == pytest.approx(error**2)


def test_the_case_has_what_was_found(
    found: ws.Calibration[ws.Case], rig: ws.Case, tmp_path: Path
) -> None:
    hole = found.case.settings["well"]["hole"]
    cased, open_hole = (section["friction"]["kinetic"] for section in hole)
    assert cased == round(found.friction_cased or 0.0, 4)
    assert open_hole == round(found.friction_open or 0.0, 4)
    assert "# 9-5/8 in 40 lb/ft" in found.toml
    assert ws.Case(found.toml) == found.case
    loaded = ws.load(found.save(tmp_path / "saved"))
    assert isinstance(loaded, ws.Calibration)
    with pytest.raises(ValueError, match="applied_to"):
        _ = cast("ws.Calibration[ws.Case]", loaded).case
    assert loaded.applied_to(rig) == found.case
    assert loaded.changes == found.changes


def test_whatever_the_readings_come_in(
    rig: ws.Case, data: dict[str, Any], found: ws.Calibration[ws.Case], tmp_path: Path
) -> None:
    frame = polars.DataFrame(data)
    frame.write_csv(tmp_path / "read.csv")
    ways: list[Any] = [frame, pandas.DataFrame(data), tmp_path / "read.csv"]
    ways.append(str(tmp_path / "read.csv"))
    for way in ways:
        again = rig.calibrate(way, **ERRORS)
        assert again.summary["estimates"] == found.summary["estimates"], type(way)
    for at, ours in enumerate((rig.calibrate(frame, tmp_path / "out", **ERRORS), found)):
        for name in ours.tables:
            written = polars.read_parquet(tmp_path / "out" / f"{name}.parquet")
            assert at == 0 or written.equals(ours.table(name).to_polars()), name
    # The same fit of the same readings may be repeated in the folder, no other fit may.
    rig.calibrate(frame, tmp_path / "out", **ERRORS)
    with pytest.raises(ws.FolderError, match="other settings or data"):
        rig.calibrate(frame, tmp_path / "out", one_factor=True)
    with pytest.raises(ws.FolderError, match="other settings or data"):
        rig.calibrate(frame.head(7), tmp_path / "out", **ERRORS)


def test_what_is_held_and_looked_for(rig: ws.Case, data: dict[str, Any]) -> None:
    held = rig.calibrate(data, hold={"friction_cased": 0.2}, block_weight=True, **ERRORS)
    assert parameters(held) == ["friction_open", "block_weight_N"]
    assert held.held["friction_cased"] == 0.2
    assert held.block_weight_N == pytest.approx(BLOCK_N, rel=1e-3)
    hold: dict[str, Any] = {"block_weight": BLOCK_N}
    both = rig.calibrate(data, hold=hold, block_weight=True, one_factor=True, **ERRORS)
    assert both.held["block_weight_N"] == BLOCK_N
    assert parameters(both) == ["friction"]
    around = rig.calibrate(data, friction_around=True, **ERRORS)
    assert any("around" in name for name in parameters(around))


def test_several_strings_are_told_apart_by_name(rig: ws.Case, data: dict[str, Any]) -> None:
    other = rig.with_(name="Other")
    both = {name: [*values, *values] for name, values in data.items()}
    both["case"] = ["Slant well"] * len(DEPTHS) + ["Other"] * len(DEPTHS)
    found = rig.calibrate(both, others=[other], **ERRORS)
    assert found.summary["cases"] == ["Slant well", "Other"]
    assert len(found.residuals) == 8 * len(DEPTHS)


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"hold": {"fish": 1.0}}, ws.InputError, "`hold`: there is no parameter 'fish'"),
        ({"hold": {"friction_cased": 3.0}}, ws.InputError, "expected 0 to 2"),
        ({"hold": {"block_weight": "3 m"}}, ws.InputError, "`hold`: `block_weight=3 m`: .*force"),
        ({"hold": {"bit_torque": 1.0}}, ws.InputError, "is not a parameter of this fit and cannot"),
        ({"weight_error": 0.0}, ws.InputError, "`weight_error`: .*expected more than zero"),
        ({"rotating_error": "3 m"}, ws.InputError, "`rotating_error`: .*force"),
        ({"torque_error": "x"}, ws.InputError, "`torque_error`"),
        ({"outlier": 0.5}, ws.InputError, "`outlier`: .*expected 1 to 100"),
        ({"band": 100.0}, ws.InputError, "`band`: .*expected 50 to 99.9"),
        ({"model": "dynamic"}, ws.InputError, "`model`: `dynamic` makes no predictions"),
        ({"check_dynamics": "310 m"}, ws.InputError, "310|no reading"),
        ({"units": "x"}, ws.InputError, "`units`"),
    ],
)
def test_bad_options(
    options: dict[str, Any],
    error: type[Exception],
    message: str,
    rig: ws.Case,
    data: dict[str, Any],
) -> None:
    with pytest.raises(error, match=message):
        rig.calibrate(data, **options)


@pytest.mark.parametrize(
    ("readings", "error", "message"),
    [
        ("nowhere.csv", ws.InputError, "there is no such file"),
        ({"depth_of_fish": [1.0]}, ws.InputError, "readings"),
        ({"bit_depth_m": [600.0], "pick_up_m": [3.0]}, ws.CaseError, "no column is a weight"),
        ({"bit_depth_m": [600.0, 700.0], "pick_up_kN": [3.0]}, ValueError, "differ in length"),
        ({"bit_depth_m": [5000.0], "pick_up_kN": [500.0]}, ws.InputError, "end at 1200.0 m"),
        (3.0, TypeError, "expected a path, a data frame or a mapping"),
    ],
)
def test_bad_readings(readings: Any, error: type[Exception], message: str, rig: ws.Case) -> None:
    with pytest.raises(error, match=message):
        rig.calibrate(readings)


def test_readings_that_no_string_gives(rig: ws.Case, data: dict[str, Any]) -> None:
    up, down = data["pick_up_kN"], data["slack_off_kN"]
    with pytest.raises(ws.InputError, match="are the columns swapped"):
        rig.calibrate({**data, "pick_up_kN": down, "slack_off_kN": up})
    klbf = {name: data[name] / 4448.22 for name in ("rotating_N",)}
    weights = {"pick_up_kN": up / 4.44822, "slack_off_kN": down / 4.44822}
    with pytest.raises(ws.InputError, match="Is the unit klbf"):
        rig.calibrate({"bit_depth_m": DEPTHS, **weights, "rotating_kN": klbf["rotating_N"]})
    deep = np.asarray(DEPTHS) > 800.0
    zeros = {**data, "slack_off_kN": np.where(deep, 0.0, down)}
    found = rig.calibrate(zeros, **ERRORS)
    kinds = [check["kind"] for check in found.summary["checks"]]
    assert "zero" in kinds
    warned = [finding for finding in found.findings if finding.severity == "warning"]
    assert any("not a reading" in finding.sentence for finding in warned)
    assert found.friction_open == pytest.approx(0.3, abs=2e-3)


def test_outliers_with_and_without(rig: ws.Case, data: dict[str, Any]) -> None:
    noise = np.random.default_rng(3).normal(0.0, 1.0, len(DEPTHS))
    wrong = {**data, "pick_up_kN": data["pick_up_kN"] + noise + 80.0 * (np.arange(9) == 6)}
    errors = {name: ERRORS[name] for name in ("rotating_error", "torque_error")}
    both = rig.calibrate(wrong, **errors)
    comparison = both.summary["comparison"]
    assert comparison["loss"] == "Huber"
    assert not comparison["left_out"]
    without = rig.calibrate(wrong, without_outliers=True, **errors)
    assert without.summary["comparison"]["left_out"]
    other = {estimate["parameter"]: estimate["value"] for estimate in comparison["estimates"]}
    assert without["friction_open"].value == pytest.approx(other["friction_open"])


def test_dynamics_check_what_was_found(rig: ws.Case, data: dict[str, Any]) -> None:
    coarse = rig.with_(
        {"mesh.element_length": 20.0, "dynamics.duration": 0.5, "dynamics.settle": 0.5}
    )
    found = coarse.calibrate(data, check_dynamics="1200 m", **ERRORS)
    assert "calibration_dynamic" in found.tables
    assert set(found.table("calibration_dynamic")["bit_depth_m"]) == {1200.0}
