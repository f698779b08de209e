"""Values of Python as TOML has them."""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, cast, runtime_checkable

import numpy as np

from . import _core

if TYPE_CHECKING:
    from numpy.typing import NDArray


@runtime_checkable
class Quantity(Protocol):
    """A number with a unit, such as one of pint: ``.to(unit)`` gives it in another unit.

    Examples
    --------
    >>> import pint
    >>> import wholestring as ws
    >>> isinstance(pint.UnitRegistry()("45 klbf"), ws.Quantity)
    True
    """

    def to(self, unit: str, /) -> Any:
        """Give the same quantity in this unit.

        Parameters
        ----------
        unit
            Symbol of the unit, as pint writes it.

        Examples
        --------
        >>> import pint
        >>> float(pint.UnitRegistry()("2 km").to("m").magnitude)
        2000.0
        """
        ...


Scalar: TypeAlias = "str | float | int | bool | np.integer[Any] | Quantity"
"""A value of a key: a text, a number in SI, or a quantity."""

Value: TypeAlias = "Scalar | NDArray[Any] | Sequence[Value] | Mapping[str, Value]"
"""A value of a key, a list or a table of such."""


def for_pint(symbol: str) -> str:
    """Give a unit as pint writes it: ``m3/s`` is ``m**3/s``, ``N.m`` is ``N*m``.

    >>> for_pint("kg.m2"), for_pint("1/s"), for_pint("m3/s")
    ('kg*m**2', '1/s', 'm**3/s')
    """
    return re.sub(r"(?<=[A-Za-z])(\d)", r"**\1", symbol).replace(".", "*")


def toml(value: object, key: str) -> str:
    """Give a value as TOML; ``key`` is the dotted key that it is for.

    A number of a key that has a unit is SI, and is written with it: a case file's own bare numbers
    need not be.

    >>> toml({"kinetic": 0.3}, "well.hole.0.friction"), toml("300 m", "bit_depth")
    ('{ "kinetic" = 0.3 }', '"300 m"')
    >>> toml(12.5, "rpm")
    '"12.5 rad/s"'
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return number(value, key)
    if isinstance(value, str | os.PathLike):
        return text(os.fspath(value))
    if isinstance(value, Mapping):
        table = cast("Mapping[object, object]", value)
        pairs = (f"{text(str(of))} = {toml(one, f'{key}.{of}')}" for of, one in table.items())
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, Sequence):
        items = cast("Sequence[object]", value)
        return "[" + ", ".join(toml(one, f"{key}.{at}") for at, one in enumerate(items)) + "]"
    if isinstance(value, Quantity):
        unit = _core.unit_of(key)
        if unit is None:
            message = f"`{key}` takes a number without a unit or a text, and was given {value!r}"
            raise TypeError(message)
        return number(float(value.to(for_pint(unit)).magnitude), key)
    # NumPy's numbers and arrays.
    if isinstance(value, np.generic | np.ndarray):
        return toml(cast("object", value.tolist()), key)
    expected = "a text with a unit, a number in SI, a quantity, a list or a mapping"
    raise TypeError(f"`{key}` was given {value!r}: expected {expected}")


def number(value: float, key: str) -> str:
    """Give a number as TOML, with its SI unit where it has one."""
    if not math.isfinite(value):
        raise ValueError(f"`{key}` was given {value}: expected a finite number")
    # NumPy's numbers are Python's, but for how they are written.
    plain = int(value) if isinstance(value, int) else float(value)
    unit = _core.unit_of(key)
    return repr(plain) if unit is None else f'"{plain!r} {unit}"'


def text(value: str) -> str:
    r"""Give a text as TOML.

    >>> print(text('8-1/2" \\ \n'))
    "8-1/2\" \\ \n"
    """
    # JSON's escapes are TOML's, but for surrogates.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def document(table: Mapping[str, Value]) -> str:
    """Give a table of tables as a TOML document."""
    lines: list[str] = []
    for key, value in table.items():
        if not isinstance(value, Mapping):
            lines.append(f"{text(key)} = {toml(value, key)}")
    for key, value in table.items():
        if isinstance(value, Mapping):
            lines.append(f"\n[{text(key)}]")
            lines.extend(f"{text(of)} = {toml(one, f'{key}.{of}')}" for of, one in value.items())
    return "\n".join(lines) + "\n"


def changes(table: Mapping[str, Value], keywords: Mapping[str, Value]) -> Iterator[tuple[str, str]]:
    """Give the keys and TOML values of changes; in a keyword, ``__`` stands for a dot."""
    for key, value in table.items():
        yield key, toml(value, key)
    for keyword, value in keywords.items():
        key = keyword.replace("__", ".")
        yield key, toml(value, key)


def si(value: Scalar, dimension: str) -> float:
    """Give a quantity of a dimension in SI.

    >>> si("2 min", "time"), si(3, "time")
    (120.0, 3.0)
    """
    if isinstance(value, str):
        return _core.quantity(value, dimension)
    if isinstance(value, int | float | np.integer):
        return float(value)
    if isinstance(value, Quantity):  # pyright: ignore[reportUnnecessaryIsInstance]
        return float(value.to(for_pint(_core.si_unit(dimension))).magnitude)
    expected = "a text with a unit, a number in SI or a quantity"
    raise TypeError(f"a {dimension} was given {value!r}: expected {expected}")


def option(name: str, value: Scalar | None, dimension: str) -> float | None:
    """Give the value of an option in SI.

    >>> option("to", "6 km", "length"), option("to", None, "length")
    (6000.0, None)
    """
    if value is None:
        return None
    try:
        found = si(value, dimension)
    except (ValueError, TypeError) as error:
        kind = ValueError if isinstance(error, ValueError) else TypeError
        raise kind(f"`{name}`: {error}") from error
    if not math.isfinite(found):
        raise ValueError(f"`{name}` was given {found}: expected a finite number")
    return found


def options(name: str, value: object, dimension: str) -> list[float] | None:
    """Give the values of an option in SI: one, several, or a text with several.

    >>> options("bit_depths", "1000m..2000m/500m", "length")
    [1000.0, 1500.0, 2000.0]
    >>> options("bit_depths", ["1 km", 1500.0], "length")
    [1000.0, 1500.0]
    """
    if value is None:
        return None
    if isinstance(value, str):
        return _core.values(name, value, dimension)
    if isinstance(value, Quantity):
        value = value.to(for_pint(_core.si_unit(dimension))).magnitude
    if isinstance(value, np.ndarray):
        value = cast("object", value.tolist())
    several = cast("Sequence[Scalar]", value if isinstance(value, Sequence) else [value])
    found = (option(name, one, dimension) for one in several)
    return [one for one in found if one is not None]


def written(name: str, value: Scalar | None, dimension: str) -> str | None:
    """Give the value of an option as a text with its unit.

    >>> written("weight_error", 12e3, "force"), written("weight_error", "12 kN", "force")
    ('12000.0 N', '12 kN')
    """
    if value is None or isinstance(value, str):
        return value
    return f"{option(name, value, dimension)!r} {_core.si_unit(dimension)}"
