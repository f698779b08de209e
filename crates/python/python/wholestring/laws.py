"""Bit-rock laws and excitations as Python functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, SupportsFloat, TypeAlias, cast

from . import _core, _values
from ._values import Scalar
from .errors import InputTypeError


class BitReading(NamedTuple):
    """Argument of a bit-rock law: the state of the bit at the end of a step.

    Attributes
    ----------
    time_s
        Time since the start of the run, s.
    weight_on_bit_N
        Weight on bit, N; above zero, because the law is not called for a bit off the rock.
    rotary_speed_rad_per_s
        Speed of the bit, motor included, rad/s.
    angle_rad
        Angle through which the bit has turned since the start, rad.
    drilled_m
        Length of rock drilled along the hole since the start, m.

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
    """Argument of an excitation: a time one period ahead.

    Attributes
    ----------
    time_s
        Time since the start of the run, s.
    angle_rad
        Angle through which the bit will have turned at that time at its current speed, rad.

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
"""Added depth of the rock front, m, and relative increase of the torque."""


def bit_law(law: BitLaw | None, rate: Scalar) -> _core.Function | None:
    """Return a law in the form of the compiled module: with plain numbers, a name and a rate."""
    if law is None:
        return None

    def evaluate(*reading: float) -> tuple[float, float]:
        return _two(law(BitReading(*reading)), "a bit law returns a depth of cut and a torque")

    return evaluate, _name(law), _rate(rate)


def excitation(law: Excitation | None, rate: Scalar) -> _core.Function | None:
    """Return an excitation in the same way."""
    if law is None:
        return None

    def evaluate(*reading: float) -> tuple[float, float]:
        expected = "an excitation returns a length and a part of torque"
        return _two(law(ShakeReading(*reading)), expected)

    return evaluate, _name(law), _rate(rate)


def _two(answer: object, expected: str) -> tuple[float, float]:
    """Return the result of a law as two numbers."""
    try:
        one, other = cast("tuple[object, object]", _values.plain(answer))
        return _values.real(one, "number"), _values.real(other, "number")
    except (TypeError, ValueError):
        raise InputTypeError(f"{expected}, two numbers, not {answer!r}") from None


def _rate(rate: Scalar) -> float:
    return cast("float", _values.option("rate", rate, "frequency"))


def _name(law: object) -> str:
    return str(getattr(law, "__qualname__", type(law).__qualname__))
