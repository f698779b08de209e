"""Bit-rock laws as Python functions."""

import math
import re
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import wholestring as ws
from numpy.typing import NDArray

WEIGHT_N = 5.0 * 9806.65
SPEED = 90.0 / 60.0 * math.tau
RATE_M_PER_S = 20.0 / 3600.0
TORQUE_N_M = 2500.0

LOBES: dict[str, ws.Value] = {"lobes": 3, "amplitude": "0.1 mm"}


def rate_law(bit: ws.BitReading) -> tuple[float, float]:
    """The law of the case: rate of penetration and torque in proportion to the weight."""
    part = bit.weight_on_bit_N / WEIGHT_N
    return RATE_M_PER_S * math.tau / SPEED * part, TORQUE_N_M * part


def weights(sim: ws.Simulation) -> NDArray[np.float64]:
    sim.advance(1.0)
    return sim.history["weight_on_bit_N"]


def errors(
    exact: ws.Simulation, steps: Sequence[int], run: Callable[[float], ws.Simulation]
) -> list[float]:
    """Return the root mean square error of the weight for an interval of calls, in steps."""

    right = weights(exact)
    assert np.ptp(right) > 1e3
    step_s: float = exact.results().summary["operations"][0]["numerics"]["time_step_s"]

    def error(count: int) -> float:
        found = weights(run((1.0 - 1e-9) / (count * step_s)))
        return float(np.sqrt(np.mean((found - right) ** 2)))

    return [error(count) for count in steps]


def test_the_rate_law_as_a_function_is_the_rate_law(short: ws.Case) -> None:
    """Both results are in proportion to the weight, as is the scaling between two calls. At any
    rate the only error is rounding, which smooth drilling amplifies to less than 1e-8."""
    built_in = short.simulation()
    built_in.advance(1.0)
    for rate in ("20 1/s", 1000.0, "50 kHz"):
        own = short.simulation(bit_law=rate_law, rate=rate)
        own.advance(1.0)
        for name in ("weight_on_bit_N", "bit_torque_N_m", "rate_of_penetration_m_per_s"):
            assert np.allclose(own.history[name], built_in.history[name], rtol=1e-8), (rate, name)


def test_a_law_with_wear_flats_converges_with_the_rate(short: ws.Case) -> None:
    """Detournay and Defourny's law in full contact, with the case's defaults, and lobes that make
    the weight swing: the cutters take W - W_f at the depth (W - W_f)/k, and W_f rubs.

    Between two calls depth of cut and torque follow the weight through zero and not along the
    law. The age of a result is from one step to the number of steps between two calls, (n + 1)/2 on
    average, and the error is in proportion to it: of the first order. Measured are 2.87 N to 2.98 N
    per step.
    """
    radius = 0.5 * 8.5 * 0.0254
    cutting_N_per_m = 0.6 * radius * 60e6
    flats_N = 60e6 * radius * 5e-3

    def law(bit: ws.BitReading) -> tuple[float, float]:
        depth = (bit.weight_on_bit_N - flats_N) / cutting_N_per_m
        assert depth > 0.3e-3, "not in full contact"
        torque = 0.5 * radius * (cutting_N_per_m * depth / 0.6 + 0.6 * flats_N)
        return depth, torque

    changes: dict[str, ws.Value] = {
        "bit": {"law": "detournay-defourny", "excitation": LOBES},
        "operation.wob": "60 kN",
    }
    case = short.with_(changes)
    steps = (16, 8, 4, 2, 1)
    found = errors(case.simulation(), steps, lambda rate: case.simulation(bit_law=law, rate=rate))
    each = [error / (count + 1) for error, count in zip(found, steps, strict=True)]
    assert max(each) < 1.1 * min(each), each


def test_an_excitation_converges_with_the_rate(short: ws.Case) -> None:
    """The lobes of the engine as a function: the error of linear interpolation of a sine is of
    second order in the interval."""

    def lobes(bit: ws.ShakeReading) -> tuple[float, float]:
        return 0.1e-3 * math.sin(3.0 * bit.angle_rad), 0.0

    found = errors(
        short.with_({"bit.excitation": LOBES}).simulation(),
        (16, 8, 4, 2),
        lambda rate: short.simulation(excitation=lobes, rate=rate),
    )
    orders = [math.log2(coarse / fine) for coarse, fine in pairwise(found)]
    assert all(order > 1.8 for order in orders), orders


def test_what_a_law_raises_stops_the_run_and_keeps_what_was_computed(short: ws.Case) -> None:
    class BrokenError(Exception):
        pass

    is_broken = True

    def law(bit: ws.BitReading) -> tuple[float, float]:
        if is_broken and bit.time_s > 0.3:
            raise BrokenError(f"at {bit.time_s}")
        return rate_law(bit)

    sim = short.simulation(bit_law=law)
    with pytest.raises(BrokenError, match=r"at 0\.3"):
        sim.advance(1.0)
    assert 0.3 < sim.time_s < 0.3 + 2.0 * sim.sample_interval_s
    assert sim.history["time_s"][-1] == sim.time_s
    assert len(sim.results().time) == len(sim.history)
    with pytest.raises(BrokenError):
        sim.advance(1.0)
    is_broken = False
    sim.advance(0.5)
    assert sim.time_s > 0.8


@pytest.mark.parametrize(
    ("answer", "error"),
    [
        ((math.nan, 0.0), "finite and zero or more"),
        ((-1e-3, 0.0), "finite and zero or more"),
        ((1e-3, math.inf), "finite and zero or more"),
        ((1e-3,), "two numbers"),
        (None, "two numbers, not None"),
        (("x", 1.0), "two numbers, not"),
    ],
)
def test_an_answer_that_is_none(short: ws.Case, answer: object, error: str) -> None:
    def law(bit: ws.BitReading) -> tuple[float, float]:
        return rate_law(bit) if bit.time_s < 0.1 else answer  # type: ignore[return-value]

    with pytest.raises((ValueError, TypeError), match=error):
        short.simulation(bit_law=law).advance(1.0)
    with pytest.raises((ValueError, TypeError), match=error):
        short.simulation(bit_law=lambda bit: answer)  # type: ignore[arg-type, return-value]


def test_a_law_does_not_ask_the_run_that_waits_for_it(short: ws.Case) -> None:
    asks: list[Callable[[], object]] = []

    def law(bit: ws.BitReading) -> tuple[float, float]:
        for ask in asks:
            ask()
        return rate_law(bit)

    sim = short.simulation(bit_law=law)
    for ask in (
        lambda: sim.now,
        lambda: sim.time_s,
        lambda: sim.advance(1.0),
        lambda: sim.set(rpm=1.0),
        sim.checkpoint,
    ):
        asks[:] = [ask]
        with pytest.raises(ws.InputError, match="waiting for its value"):
            sim.advance(0.1)


def test_a_run_with_laws_is_taken_up_to_the_same_bits(short: ws.Case) -> None:
    def lobes(bit: ws.ShakeReading) -> tuple[float, float]:
        return 0.1e-3 * math.sin(3.0 * bit.angle_rad), 0.1 * math.cos(bit.time_s)

    def begin(checkpoint: bytes | None = None) -> ws.Simulation:
        return short.simulation(
            bit_law=rate_law, excitation=lobes, rate="333 Hz", checkpoint=checkpoint
        )

    sim, same = begin(), begin()
    sim.advance(0.4)
    state = sim.checkpoint()
    again = begin(state)
    sim.advance(0.4)
    again.advance(0.4)
    same.advance(0.8)
    for run in (again, same):
        assert run.time_s == sim.time_s
        for name in sim.history.columns:
            assert np.array_equal(run.history[name], sim.history[name], equal_nan=True), name

    def other(bit: ws.BitReading) -> tuple[float, float]:
        return rate_law(bit)

    for own, shaking, rate in (
        (None, None, 333.0),
        (rate_law, None, 333.0),
        (rate_law, lobes, 1000.0),
        (other, lobes, 333.0),
    ):
        with pytest.raises(ws.FolderError, match="rate_law at 333 Hz"):
            short.simulation(checkpoint=state, bit_law=own, excitation=shaking, rate=rate)
    plain = short.simulation().checkpoint()
    with pytest.raises(ws.FolderError, match="no user law, not with the bit law"):
        short.simulation(bit_law=rate_law, checkpoint=plain)


def test_where_a_law_has_no_place(short: ws.Case, slant: ws.Case) -> None:
    def never(bit: ws.BitReading) -> tuple[float, float]:
        raise AssertionError("called off bottom")

    with pytest.raises(ws.InputError, match="off bottom"):
        slant.simulation("trip_out", bit_law=never)
    with pytest.raises(ws.InputError, match="rock stiffness"):
        short.with_({"bit": {"law": "regenerative"}}).simulation(bit_law=rate_law)
    for rate in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ws.InputError, match=r"expected more than zero|`rate` was given"):
            short.simulation(bit_law=rate_law, rate=rate)


def test_the_page_runs_as_it_stands() -> None:
    page = Path(__file__).parents[3] / "docs" / "src" / "extend.md"
    (code,) = re.findall(r"```python\n(.*?)```", page.read_text(), re.DOTALL)
    names: dict[str, object] = {}
    exec(code, names)
    sim = names["sim"]
    assert isinstance(sim, ws.Simulation)
    # The law at 90 rev/min under 5 t.
    expected = 0.05 * WEIGHT_N * (1.0 + 0.6 / (1.0 + SPEED / 4.0))
    torque = sim.since(sim.time_s - 1.0)["bit_torque_N_m"].mean()
    assert torque == pytest.approx(expected, rel=0.02)
