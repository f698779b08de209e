"""Many variations in memory."""

from typing import Any

import numpy as np
import pandas as pd
import polars
import pytest
import wholestring as ws


def test_it_is_what_each_case_gives_by_itself(slant: ws.Case) -> None:
    changes: list[dict[str, ws.Value]] = [
        {"friction": friction, "wob": f"{wob} kN"} for friction in (0.1, 0.3) for wob in (20, 50)
    ]
    table = slant.soft_many(changes)
    assert table.columns[:4] == ("friction", "wob", "model", "operation")
    assert len(table) == 4 * 5
    assert table.unit("wob") == "N"
    assert table["wob"][5] == 50e3
    for number, change in enumerate(changes):
        alone = slant.with_(change).soft()
        rows = table["case"] == number
        for name in ("hook_load_N", "surface_torque_N_m", "weight_on_bit_N"):
            assert list(table[name][rows]) == [getattr(result, name) for result in alone]


def test_one_operation_by_the_stiff_string(slant: ws.Case) -> None:
    table = slant.soft_many([{"friction": 0.25}], "trip_out", model="stiff", jobs=1)
    alone = slant.with_(friction=0.25).stiff("trip_out")["trip_out"]
    assert list(table["hook_load_N"]) == [alone.hook_load_N]
    assert list(table["model"]) == ["stiff"]


def test_columns_of_any_kind_are_rows_of_changes(slant: ws.Case) -> None:
    columns: dict[str, Any] = {
        "friction": np.linspace(0.1, 0.3, 3, dtype=np.float32),
        "bit_depth": [900, 1000, 1100],
    }
    expected = slant.soft_many(columns, "trip_out")
    for data in (pd.DataFrame(columns), polars.DataFrame(columns)):
        found = slant.soft_many(data, "trip_out")
        assert np.array_equal(found["hook_load_N"], expected["hook_load_N"])
    assert list(expected["bit_depth_m"]) == [900.0, 1000.0, 1100.0]
    # 0.1 in single precision.
    assert expected["friction"][0] == float(np.float32(0.1))


def test_a_case_without_an_answer_is_a_row_with_its_reason(slant: ws.Case) -> None:
    changes: list[dict[str, ws.Value]] = [{"wob": "900 kN", "friction": 1.2}, {}]
    table = slant.soft_many(changes, "drill", model="stiff")
    assert list(table["status"]) == ["failed", "complete"]
    assert table["message"][0]
    assert np.isnan(table["hook_load_N"][0])


def test_what_cannot_be_is_said(slant: ws.Case) -> None:
    with pytest.raises(ws.CaseError, match="1 of 2 cases are faulty"):
        slant.soft_many([{"friction": 0.2}, {"friction": 30.0}], "trip_out")
    with pytest.raises(ws.InputError, match="`fish` is no operation"):
        slant.soft_many([{"friction": 0.2}], "fish")
    with pytest.raises(ws.InputError, match="none of soft, stiff"):
        slant.soft_many([{"friction": 0.2}], model="dynamic")  # type: ignore[arg-type]
    with pytest.raises(ws.InputError, match="differ in length"):
        slant.soft_many({"friction": [0.2], "wob": [1e4, 2e4]})
    with pytest.raises(ws.InputTypeError, match="a list of changes"):
        slant.soft_many(3)
    with pytest.raises(ws.InputTypeError, match="a mapping of keys"):
        slant.soft_many([3])
    with pytest.raises(ws.InputError, match="set the same key"):
        slant.soft_many([{"friction": 0.2, "well.hole.0.friction": 0.3}])
    assert len(slant.soft_many([])) == 0
