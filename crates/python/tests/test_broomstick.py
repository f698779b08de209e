"""Broomsticks without a folder: curves of a plan, with frictions and depths as arguments."""

import time

import numpy as np
import pytest
import wholestring as ws


def test_it_is_the_broomstick_of_the_plan(slant: ws.Case) -> None:
    case = slant.with_({"plan.depths": 4, "plan.models": ["soft", "stiff"]})
    whole = case.broomstick().to_polars()
    assert whole.equals(case.plan().broomstick.to_polars())
    assert whole.equals(case.broomstick(jobs=1).to_polars())


def test_each_point_is_the_soft_string(slant: ws.Case) -> None:
    depths = [700.0, 1200.0]
    frictions = [0.1, 0.25, 0.4, 0.15]
    table = slant.broomstick(
        frictions=frictions, bit_depths="700m..1200m/500m", operations="trip_out"
    )
    assert table["friction"].dtype == np.float64
    assert list(table["friction"]) == [friction for friction in frictions for _ in depths]
    assert list(table["bit_depth_m"]) == depths * len(frictions)
    for row in range(len(table)):
        case = slant.with_(
            friction=table["friction"][row], bit_depth=f"{table['bit_depth_m'][row]} m"
        )
        solved = case.soft("trip_out")["trip_out"]
        assert table["hook_load_N"][row] == solved.hook_load_N
        assert table["axial_friction_N"][row] == solved.axial_friction_N


def test_the_stiff_string_too(slant: ws.Case) -> None:
    table = slant.broomstick(
        model="stiff", frictions=0.3, bit_depths=1200.0, operations=["trip_in", "trip_out"]
    )
    uniform = slant.with_(friction=0.3)
    for row, operation in enumerate(("trip_in", "trip_out")):
        solved = uniform.stiff(operation)[operation]
        assert table["operation"][row] == operation
        assert table["hook_load_N"][row] == pytest.approx(solved.hook_load_N, rel=1e-9)


def test_what_has_no_answer_says_why(slant: ws.Case) -> None:
    table = slant.with_(wob="900 kN").broomstick(
        model="stiff", frictions=[1.2], bit_depths=[1200.0], operations="slide"
    )
    assert np.isnan(table["hook_load_N"][0])
    assert table["message"][0]


def test_a_point_takes_milliseconds(np13: ws.Case) -> None:
    np13.broomstick(frictions=0.3, bit_depths=4305.0, operations="trip_out")
    begun = time.perf_counter()
    table = np13.broomstick(
        frictions=[0.1, 0.2, 0.3], bit_depths="1000m..4305m/661m", operations="trip_out", jobs=1
    )
    each_ms = 1e3 * (time.perf_counter() - begun) / len(table)
    # A millisecond or two if optimised; the limit allows for a loaded machine and a debug build.
    assert each_ms < 100.0, each_ms


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"frictions": [0.2, 2.5]}, ws.InputError, "friction factor of 2.5 is outside 0 to 2"),
        ({"frictions": [float("nan")]}, ws.InputError, "friction factor of NaN"),
        ({"frictions": "a"}, ValueError, "`frictions`: 'a' is no friction factor"),
        ({"bit_depths": 0.2}, ws.InputError, "bit depth of 0.2 m is out of range"),
        ({"bit_depths": [1300.0]}, ws.InputError, "no more than 1200 m"),
        ({"bit_depths": "1 kN"}, ws.CaseError, "bit_depths"),
        ({"model": "dynamic"}, ws.InputError, "`dynamic` is none of soft, stiff"),
        ({"operations": ["fish"]}, ws.InputError, "`fish` is no operation"),
        ({"jobs": 0}, ValueError, "`jobs` was given 0"),
    ],
)
def test_bad_input(
    options: dict[str, object], error: type[Exception], message: str, slant: ws.Case
) -> None:
    with pytest.raises(error, match=message):
        slant.broomstick(**options)  # type: ignore[arg-type]
