"""Laws of the bit that are Python functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, SupportsFloat, TypeAlias, cast

from . import _core, _values
from ._values import Scalar
from .errors import InputTypeError


class BitReading(NamedTuple):
    """What a law of the bit is asked with: how the bit drills at the end of a step.

    Attributes
    ----------
    time_s
        Time since the start of the run, s.
    weight_on_bit_N
        Weight on bit, N, more than zero: a bit that is off the rock is not asked.
    rotary_speed_rad_per_s
        Speed of the bit, motor included, rad/s.
    angle_rad
        Angle through which the bit has turned since the start, rad.
    drilled_m
        Rock that the bit has taken away along the hole since the start, m.

    Examples
    --------
    >>> import wholestring as ws
    >>> reading = ws.BitReading(0.0, 50e3, 9.4, 0.0, 0.0)
    >>> reading.weight_on_bit_N
    50000.0
    """

    time_s: float
    weight_on_bit_N: float
    rotary_speed_rad_per_s: float
    angle_rad: float
    drilled_m: float


class ShakeReading(NamedTuple):
    """What an excitation is asked with: a moment that lies one period ahead.

    Attributes
    ----------
    time_s
        Time since the start of the run, s.
    angle_rad
        Angle through which the bit will have turned then at the speed that it has, rad.

    Examples
    --------
    >>> import wholestring as ws
    >>> ws.ShakeReading(0.5, 3.0).angle_rad
    3.0
    """

    time_s: float
    angle_rad: float


BitLaw: TypeAlias = Callable[[BitReading], tuple[SupportsFloat, SupportsFloat]]
"""Depth of cut per revolution, m, and torque, N·m, both zero or more."""

Excitation: TypeAlias = Callable[[ShakeReading], tuple[SupportsFloat, SupportsFloat]]
"""How much deeper the rock front stands, m, and by which part the torque is larger."""


def bit_law(law: BitLaw | None, rate: Scalar) -> _core.Function | None:
    """Give a law as the compiled half takes it: with plain numbers, a name and a rate."""
    if law is None:
        return None

    def ask(*reading: float) -> tuple[float, float]:
        return _two(law(BitReading(*reading)), "a bit law gives a depth of cut and a torque")

    return ask, _name(law), _rate(rate)


def excitation(law: Excitation | None, rate: Scalar) -> _core.Function | None:
    """Give an excitation in the same way."""
    if law is None:
        return None

    def ask(*reading: float) -> tuple[float, float]:
        return _two(law(ShakeReading(*reading)), "an excitation gives a length and a torque's part")

    return ask, _name(law), _rate(rate)


def _two(answer: object, expected: str) -> tuple[float, float]:
    """Return what a law answers as two numbers."""
    try:
        one, other = cast("tuple[object, object]", _values.plain(answer))
        return _values.real(one, "number"), _values.real(other, "number")
    except (TypeError, ValueError):
        raise InputTypeError(f"{expected}, two numbers, and not {answer!r}") from None


def _rate(rate: Scalar) -> float:
    return cast("float", _values.option("rate", rate, "frequency"))


def _name(law: object) -> str:
    return str(getattr(law, "__qualname__", type(law).__qualname__))
