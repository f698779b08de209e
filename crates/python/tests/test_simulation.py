"""A simulation that the caller advances."""

import math
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import wholestring as ws

CASES = Path(__file__).parents[3] / "cases"


def test_it_is_the_run_of_the_case(short: ws.Case) -> None:
    whole = short.dynamic()
    sim = short.simulation()
    while sim.time_s < whole.time["time_s"][-1] - 0.5 * sim.sample_interval_s:
        sim.advance(0.3)
    ours = sim.results()
    count = len(whole.time)
    for name in ("hook_load_N", "surface_torque_N_m", "weight_on_bit_N"):
        assert np.array_equal(ours.time[name][:count], whole.time[name])


def test_a_checkpoint_continues_to_the_same_bits(short: ws.Case) -> None:
    sim = short.simulation("drill")
    sim.set(rpm="130 rpm", ramp="0.5 s")
    sim.advance("0.4 s")
    checkpoint = sim.checkpoint()
    again = short.simulation(checkpoint=checkpoint)
    assert again.time_s == sim.time_s
    for run in (sim, again):
        run.advance("0.5 s")
    assert np.array_equal(list(sim.now.values()), list(again.now.values()), equal_nan=True)
    assert np.array_equal(sim.state()["torque_N_m"], again.state()["torque_N_m"])
    with pytest.raises(ws.FolderError, match="another case"):
        short.with_(friction=0.1).simulation(checkpoint=checkpoint)
    with pytest.raises(ws.ResultsError, match="damaged"):
        short.simulation(checkpoint=checkpoint[:-1] + bytes([checkpoint[-1] ^ 1]))


def test_set_points_go_where_they_are_sent(short: ws.Case) -> None:
    sim = short.with_(operation__kind="rotate_off_bottom").simulation()
    sim.set(rpm=0.0)
    sim.advance("0.2 s")
    sim.set(rpm="60 rpm", ramp="1 s")
    sim.advance("0.5 s")
    half = sim.now["rotary_speed_set_rad_per_s"]
    assert half == pytest.approx(math.pi, rel=0.05)
    sim.set(rpm="10 rpm")
    sim.advance("0.1 s")
    assert sim.now["rotary_speed_set_rad_per_s"] == pytest.approx(10 / 60 * math.tau, rel=1e-12)
    assert sim.state()["rotary_speed_rad_per_s"][0] == pytest.approx(10 / 60 * math.tau, rel=1e-6)
    with pytest.raises(ValueError, match="either"):
        sim.set(block_velocity="0.1 m/s", weight_on_bit="1 kN")
    with pytest.raises(ValueError, match="a time was expected"):
        sim.advance("3 m")
    with pytest.raises(ws.InputError, match="advance by -1"):
        sim.advance(-1.0)
    with pytest.raises(ws.InputError, match="`rpm` was given nan"):
        sim.set(rpm=math.nan)


def test_the_state_is_the_whole_string(short: ws.Case) -> None:
    sim = short.simulation()
    sim.advance(0.1)
    state = sim.state()
    assert state["md_m"][0] < 20.0
    assert state["md_m"][-1] == pytest.approx(1200.0, abs=1.0)
    assert state.unit("tension_N") == "N"
    # The tension at the top is the hook load.
    assert state["tension_N"][0] == pytest.approx(sim.now["hook_load_N"], rel=0.05)


def test_an_operation_that_there_is_not(slant: ws.Case) -> None:
    with pytest.raises(ws.InputError, match="name one of trip_out"):
        slant.simulation()
    with pytest.raises(ws.InputError, match="no operation `fish`"):
        slant.simulation("fish")


def test_reading_looks_at_nothing_older(short: ws.Case) -> None:
    sim = short.simulation()
    assert dict(sim.now) == {}
    assert len(sim.history) == 0
    sim.advance(0.3)
    history = sim.history
    assert tuple(sim.now) == history.columns
    last = [history[name][-1] for name in history.columns]
    assert np.array_equal(list(sim.now.values()), last, equal_nan=True)
    before = sim.time_s
    sim.advance(0.2)
    new = sim.since(before)
    assert new["time_s"][0] > before
    assert len(history) + len(new) == len(sim.history)
    assert np.array_equal(new["hook_load_N"], sim.history["hook_load_N"][len(history) :])
    assert not history["hook_load_N"].flags.writeable
    # A view outlives the run.
    view = history["time_s"]
    del sim, history
    assert view[-1] == before


def test_friction_changes_as_the_run_goes(slant: ws.Case) -> None:
    """The hook load while pulling out agrees with a run whose hole has that friction, within 5e-4,
    the difference of two windows of the same run; the measured difference is 1e-4."""
    base = slant.with_({"mesh.element_length": 10.0, "operation.kind": "trip_out"})
    sim = base.simulation()
    sim.advance(2.0)
    sim.set(friction=[0.3, 0.4], ramp="1 s")
    assert sim.friction == (0.2, 0.3)
    sim.advance(0.5)
    # Friction is updated every 16 steps of 2.5 ms, in which it changes by 4e-3.
    assert sim.friction == pytest.approx((0.25, 0.35), abs=4.1e-3)
    checkpoint = sim.checkpoint()
    changes = {"well.hole.0.friction": 0.3, "well.hole.1.friction": 0.4}
    always = base.with_(changes).simulation()
    again = base.simulation(checkpoint=checkpoint)
    for run in (sim, again, always):
        run.advance(25.0 - run.time_s)
    assert np.array_equal(again.history["hook_load_N"], sim.history["hook_load_N"])
    assert again.friction == sim.friction == (0.3, 0.4)
    means = [run.since(5.0)["hook_load_N"].mean() for run in (sim, always)]
    assert means[0] == pytest.approx(means[1], rel=5e-4)
    assert sim.results()["trip_out"].friction == [0.3, 0.4]
    sim.set(friction=0.25)
    assert sim.friction == (0.25, 0.25)
    for wrong in (-0.1, 3.0, math.nan, [0.1, 0.2, 0.3]):
        with pytest.raises(ws.InputError, match="coefficient"):
            sim.set(friction=wrong)
    with pytest.raises(ws.InputError, match="in which friction changes"):
        sim.set(friction=0.2, ramp=-1.0)
    assert sim.friction == (0.25, 0.25)


THREADS = """
import psutil
import wholestring as ws

case = ws.Case.load("{path}").with_(rock__element_size="24 mm", rock__density_factor=500)
alone = case.simulation(jobs=1)
threads = [psutil.Process().num_threads()]
three = case.simulation(jobs=3)
threads.append(psutil.Process().num_threads())
two = case.simulation(checkpoint=alone.checkpoint(), jobs=2)
threads.append(psutil.Process().num_threads())
print(*threads)
"""
"""Runs in a process of its own, because pools of other tests end their threads at any time."""


def test_threads_are_the_callers(np13_rock: ws.Case) -> None:
    pytest.importorskip("psutil")
    path = CASES / "np13-x1042-rock.toml"
    script = [sys.executable, "-c", THREADS.format(path=path.as_posix())]
    printed = subprocess.run(script, capture_output=True, text=True, check=True).stdout
    before, with_three, with_two_more = map(int, printed.split())
    assert with_three == before + 3
    assert with_two_more == before + 5


def test_threads_change_no_number(np13_rock: ws.Case) -> None:
    alone = np13_rock.simulation(jobs=1)
    three = np13_rock.simulation(jobs=3)
    again = np13_rock.simulation(checkpoint=alone.checkpoint(), jobs=2)
    for run in (alone, three, again):
        run.advance(0.02)
    for run in (three, again):
        assert run.now.keys() == alone.now.keys()
        # Equal to the last digit, with NaN in the same places.
        np.testing.assert_array_equal(list(run.now.values()), list(alone.now.values()))
    for wrong, error in ((0, ValueError), (10**9, ValueError), (1.5, TypeError)):
        with pytest.raises(error):
            np13_rock.simulation(jobs=wrong)  # type: ignore[arg-type]


def test_an_interrupt_leaves_a_run_that_goes_on(short: ws.Case) -> None:
    sim = short.simulation()
    sim.advance(0.1)
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(ws.Interrupted, match="keeps its state") as caught:
        sim.advance(3600.0)
    timer.join()
    assert caught.value.results is not None
    assert 0.1 < sim.time_s < 3600.0
    stands_s = sim.time_s
    sim.advance(0.1)
    assert sim.time_s > stands_s


@pytest.mark.parametrize("step", [0.001, 0.004, 0.005, 0.01, 0.013])
def test_short_steps_come_to_the_same_time_as_long_ones(short: ws.Case, step: float) -> None:
    """Each call advances to the sample nearest to the sum of all calls, without drift."""
    sim = short.simulation()
    assert sim.sample_interval_s == pytest.approx(0.01, rel=1e-12)
    for count in range(1, round(1.0 / step) + 1):
        sim.advance(step)
        if count == 20:
            sim = short.simulation(checkpoint=sim.checkpoint())
        assert abs(sim.time_s - count * step) <= 0.5 * sim.sample_interval_s + 1e-9
    long = short.simulation()
    long.advance(round(1.0 / step) * step)
    assert sim.time_s == long.time_s
    assert np.array_equal(sim.history["hook_load_N"], long.history["hook_load_N"])


@pytest.mark.parametrize("interval", ["0.01 s", "0.013 s", "0.5 ms"])
def test_samples_are_as_far_apart_as_the_case_says(short: ws.Case, interval: str) -> None:
    sim = short.with_(dynamics__sample_interval=interval).simulation()
    sim.advance(0.05)
    interval_s = {"0.01 s": 0.01, "0.013 s": 0.013, "0.5 ms": 5e-4}[interval]
    assert sim.sample_interval_s == pytest.approx(interval_s, rel=1e-12)
    assert np.diff(sim.history["time_s"]) == pytest.approx(interval_s, rel=1e-9)


def test_an_interrupted_advance_counts_from_where_it_stands(short: ws.Case) -> None:
    def law(bit: ws.BitReading) -> tuple[float, float]:
        if 0.05 < bit.time_s < 0.06:
            raise ZeroDivisionError
        return 2e-8 * bit.weight_on_bit_N, 0.05 * bit.weight_on_bit_N

    sim = short.simulation(bit_law=law)
    with pytest.raises(ZeroDivisionError):
        sim.advance(1.0)
    stands_s = sim.time_s
    assert stands_s < 0.1
    sim.advance(0.1)
    assert sim.time_s == pytest.approx(stands_s + 0.1, abs=1e-9)


def test_a_set_point_has_the_limits_of_the_case(short: ws.Case) -> None:
    sim = short.with_(operation__kind="rotate_off_bottom").simulation()
    sim.set(rpm=120)
    sim.advance(0.1)
    assert sim.now["rotary_speed_set_rad_per_s"] == pytest.approx(4 * math.pi, rel=1e-12)
    sim.set(rotary_speed=2.0)
    sim.advance(0.1)
    assert sim.now["rotary_speed_set_rad_per_s"] == pytest.approx(2.0, rel=1e-12)
    cases: list[tuple[dict[str, Any], str]] = [
        ({"rpm": 1001.0}, "rotary speed of 1001 rev/min: expected 0 to 1000 rev/min"),
        ({"rotary_speed": 120.0}, "rotary speed of 1145.916 rev/min"),
        ({"rpm": -9.0}, "rotary speed of -9 rev/min"),
        ({"rpm": 9.0, "rotary_speed": 1.0}, "set the same speed"),
        ({"block_velocity": 1e6}, "block velocity of"),
        ({"weight_on_bit": 1e12}, "weight on bit of"),
        ({"flow_rate": 1.0}, "flow rate of"),
        ({"rpm": 9.0, "ramp": -1.0}, "ramp of -1 s"),
        ({"friction": []}, "`friction` was given no values"),
        ({"friction": "low"}, "'low' is no friction factor"),
    ]
    for refused, message in cases:
        with pytest.raises(ws.InputError, match=message):
            sim.set(**refused)
    assert sim.now["rotary_speed_set_rad_per_s"] == pytest.approx(2.0, rel=1e-12)


def test_forgetting_moves_nothing_and_bounds_memory(short: ws.Case) -> None:
    """Samples of the last second remain; the motion is bit-identical."""
    full, forgets = short.simulation(), short.simulation()
    for turn in range(60):
        for sim in (full, forgets):
            sim.set(rpm=100.0 + turn % 2)
            sim.advance(0.1)
        forgets.forget(forgets.time_s - 1.0)
    rows = len(forgets.history)
    assert rows == pytest.approx(101, abs=1)
    # A row has about twenty numbers, and there is a line of the schedule for every ten rows.
    dropped = len(full.history) - rows
    assert len(full.checkpoint()) - len(forgets.checkpoint()) > 150 * dropped
    for name in ("time_s", "hook_load_N", "surface_torque_N_m", "rotary_speed_set_rad_per_s"):
        assert np.array_equal(forgets.history[name], full.history[name][-rows:])
    assert np.array_equal(forgets.state()["torque_N_m"], full.state()["torque_N_m"])
    again = short.simulation(checkpoint=forgets.checkpoint())
    for sim in (forgets, again):
        sim.advance(0.1)
    assert np.array_equal(again.history["hook_load_N"], forgets.history["hook_load_N"])
    # Scalars are those of the remaining samples; wear is that of the whole window.
    answer, whole = forgets.results(), full.results()
    mean = forgets.history["hook_load_N"].mean()
    assert answer["drill"].hook_load_N == pytest.approx(mean, rel=1e-12)
    wear = [results.table("wear")["wear_power_W_per_m"].sum() for results in (answer, whole)]
    assert wear[0] == pytest.approx(wear[1], rel=0.05)
    forgets.forget()
    assert len(forgets.history) == 1


def test_numbers_of_numpy_and_pandas_are_numbers(short: ws.Case) -> None:
    sim = short.simulation()
    for one in (np.float32(0.1), np.float64(0.1), np.array(0.1), np.int64(0), pd.Series([0.1])[0]):
        sim.advance(one)
        sim.since(one)
        sim.set(ramp=one)
    for speed in (np.float32(90.0), np.int64(90), np.array(90.0), np.array(90, dtype=np.float32)):
        sim.set(rpm=speed, weight_on_bit=np.float32(5e4), ramp=np.float32(0.1))
    for friction in (np.array([0.2, 0.3]), pd.Series([0.2, 0.3]), np.float32(0.3), "0.2, 0.3"):
        sim.set(friction=friction)
    with pytest.raises(ws.InputTypeError, match="`time`"):
        sim.advance(np.array([0.1, 0.2]))
