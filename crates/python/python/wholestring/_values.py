"""Conversion of Python values to TOML."""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import (
    TYPE_CHECKING,
    Any,
    Protocol,
    SupportsFloat,
    TypeAlias,
    TypeVar,
    cast,
    runtime_checkable,
)

from . import _core
from .errors import InputError, InputTypeError

if TYPE_CHECKING:
    from numpy.typing import NDArray


@runtime_checkable
class Quantity(Protocol):
    """A number with a unit, such as one of pint: ``.to(unit)`` converts it to another unit.

    Examples
    --------
    >>> import pint
    >>> import wholestring as ws
    >>> isinstance(pint.UnitRegistry()("45 klbf"), ws.Quantity)
    True
    """

    def to(self, unit: str, /) -> Any:
        """Return the same quantity in this unit.

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


Scalar: TypeAlias = "str | SupportsFloat | Quantity"
"""A value of a key: a text, a number in SI, or a quantity.

A number is one of Python, NumPy or pandas in any precision, or an array without dimensions.
"""

Value: TypeAlias = "Scalar | NDArray[Any] | Iterable[Value] | Mapping[str, Value] | None"
"""A value of a key, a list or a table of values; ``None`` removes a key."""


def plain(value: object) -> Any:
    """Return numbers, arrays and series of other libraries as Python numbers and lists.

    >>> import numpy as np
    >>> plain(np.float32(0.5)), plain(np.array(3)), plain(np.linspace(0.0, 1.0, 3))
    (0.5, 3, [0.0, 0.5, 1.0])
    """
    if isinstance(value, str | bytes | Mapping) or _is_quantity(value):
        return cast("Any", value)
    for name in ("tolist", "to_list"):
        give = getattr(value, name, None)
        if callable(give):
            return give()
    return value


def _is_quantity(value: object) -> bool:
    """Return whether a value is a number with a unit, not an array that also has a ``to``."""
    has_unit = hasattr(value, "magnitude") or hasattr(value, "unit")
    return isinstance(value, Quantity) and (has_unit or not hasattr(value, "tolist"))


def _magnitude(value: Quantity, unit: str, name: str) -> Any:
    """Return the magnitude of a quantity in a unit, as a Python number or list."""
    try:
        found = value.to(unit)
    except Exception as error:
        raise InputError(f"{name} was given {value!r}: {error}") from error
    number = getattr(found, "magnitude", None)
    return plain(found.value if number is None else number)


def for_pint(symbol: str) -> str:
    """Return a unit in the notation of pint: ``m3/s`` is ``m**3/s``, ``N.m`` is ``N*m``.

    >>> for_pint("kg.m2"), for_pint("1/s"), for_pint("m3/s")
    ('kg*m**2', '1/s', 'm**3/s')
    """
    return re.sub(r"(?<=[A-Za-z])(\d)", r"**\1", symbol).replace(".", "*")


def toml(value: object, key: str) -> str:
    """Return a value as TOML; ``key`` is its dotted key.

    A number of a key that has a unit is SI and is written with the unit. A rotary speed is in
    rev/min as in a case file, where its keys are called ``rpm``.

    >>> import numpy as np
    >>> toml({"kinetic": 0.3}, "well.hole.0.friction"), toml("300 m", "bit_depth")
    ('{ "kinetic" = 0.3 }', '"300 m"')
    >>> toml(12.5, "rpm"), toml(np.float32(0.5), "mud.density")
    ('"12.5 rpm"', '"0.5 kg/m3"')
    """
    value = plain(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return number(value, key)
    if isinstance(value, str | os.PathLike):
        return text(os.fspath(cast("str | os.PathLike[str]", value)))
    if isinstance(value, Mapping):
        table = cast("Mapping[object, object]", value)
        pairs = (
            f"{text(str(name))} = {toml(one, f'{key}.{name}')}"
            for name, one in table.items()
            if one is not None
        )
        return "{ " + ", ".join(pairs) + " }"
    if _is_quantity(value):
        return _quantity(cast("Quantity", value), key)
    if isinstance(value, Iterable):
        items = cast("Iterable[object]", value)
        return "[" + ", ".join(toml(one, f"{key}.{at}") for at, one in enumerate(items)) + "]"
    if isinstance(value, SupportsFloat):
        return number(float(value), key)
    expected = "a text with a unit, a number in SI, a quantity, a list or a mapping"
    raise InputTypeError(f"`{key}` was given {value!r}: expected {expected}")


def _quantity(value: Quantity, key: str) -> str:
    unit = _core.unit_of(key)
    # A key whose bare numbers are in rev/min still takes quantities in SI.
    unit = "rad/s" if unit == REV_PER_MIN else unit
    found = _magnitude(value, "dimensionless" if unit is None else for_pint(unit), f"`{key}`")
    if isinstance(found, Iterable):
        items = cast("Iterable[float]", found)
        return "[" + ", ".join(number(one, key, unit) for one in items) + "]"
    return number(float(found), key, unit)


def number(value: float, key: str, unit: str | None = None) -> str:
    """Return a number as TOML, with the unit of numbers of the key."""
    if not math.isfinite(_double(value, f"`{key}`")):
        raise InputError(f"`{key}` was given {value}: expected a finite number")
    # Numbers of NumPy are those of Python except for their `repr`.
    bare = int(value) if isinstance(value, int) else float(value)
    unit = unit or _core.unit_of(key)
    return repr(bare) if unit is None else f'"{bare!r} {unit}"'


def _double(value: SupportsFloat, noun: str) -> float:
    """Return a number in double precision.

    >>> _double(10**400, "a length")
    Traceback (most recent call last):
    wholestring.errors.InputError: a length was given a number that is too large: expected ...
    """
    try:
        return float(value)
    except OverflowError as error:
        raise InputError(
            f"{noun} was given a number that is too large: expected at most 1e308"
        ) from error


def text(value: str) -> str:
    r"""Return a text as TOML.

    >>> print(text('8-1/2" \\ \n'))
    "8-1/2\" \\ \n"
    """
    # The escapes of JSON are those of TOML, except for surrogates.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def document(table: Mapping[str, Value]) -> str:
    """Return a table of tables as a TOML document."""
    lines: list[str] = []
    table = {key: value for key, value in table.items() if value is not None}
    for key, value in table.items():
        if not isinstance(value, Mapping):
            lines.append(f"{text(key)} = {toml(value, key)}")
    for key, value in table.items():
        if isinstance(value, Mapping):
            lines.append(f"\n[{text(key)}]")
            inside = cast("Mapping[str, Value]", value).items()
            lines.extend(
                f"{text(name)} = {toml(one, f'{key}.{name}')}"
                for name, one in inside
                if one is not None
            )
    return "\n".join(lines) + "\n"


Change: TypeAlias = "tuple[str, str | None]"
"""A key and its TOML value; ``None`` where the key is removed."""


def changes(table: Mapping[str, Value], keywords: Mapping[str, Value]) -> list[Change]:
    """Return the keys and TOML values of changes; in a keyword, ``__`` is a dot.

    >>> changes({"mud.density": 1200.0}, {"operation__wob": None})
    [('mud.density', '"1200.0 kg/m3"'), ('operation.wob', None)]
    """
    if not isinstance(cast("object", table), Mapping):
        raise InputTypeError(f"changes were given {table!r}: expected a mapping of keys to values")
    for key in cast("Iterable[object]", table):
        if not isinstance(key, str):
            raise InputTypeError(f"a key was given {key!r}: expected a text, such as 'mud.density'")
    named = ((word.replace("__", "."), value) for word, value in keywords.items())
    items = [*table.items(), *named]
    refuse_conflicts([key for key, _ in items])
    return [(key, None if value is None else toml(value, key)) for key, value in items]


def refuse_conflicts(keys: Sequence[str]) -> None:
    """Refuse keys of which two set the same value, because the result would be ambiguous.

    >>> refuse_conflicts(["friction", "well.hole.1.diameter"])
    >>> refuse_conflicts(["friction", "well.hole.1.friction"])
    Traceback (most recent call last):
    wholestring.errors.InputError: `friction` and `well.hole.1.friction` set the same key: ...
    """
    seen: list[tuple[str, list[str]]] = []
    for key in keys:
        parts = _core.long_key(key).split(".")
        for other, others in seen:
            pairs = zip(parts, others, strict=False)
            if all(one == two or "*" in (one, two) for one, two in pairs):
                pair = f"`{key}` twice" if key == other else f"`{other}` and `{key}`"
                raise InputError(
                    f"{pair} set the same key: give one of them, or one after the other to a "
                    "`with_` of its own"
                )
        seen.append((key, parts))


def si(value: Scalar, dimension: str) -> float:
    """Return a quantity of a dimension in SI.

    >>> import numpy as np
    >>> si("2 min", "time"), si(3, "time"), si(np.float32(0.5), "time"), si(np.array(2.0), "time")
    (120.0, 3.0, 0.5, 2.0)
    """
    if isinstance(value, str):
        return _core.quantity(value, dimension)
    if _is_quantity(value):
        unit = for_pint(_core.si_unit(dimension))
        return real(_magnitude(cast("Quantity", value), unit, f"a {dimension}"), dimension)
    return real(plain(value), dimension)


def real(value: object, noun: str) -> float:
    """Return a number.

    >>> import numpy as np
    >>> real(np.int64(2), "a count")
    2.0
    """
    value = plain(value)
    if isinstance(value, SupportsFloat) and not isinstance(value, str):
        return _double(value, f"a {noun}")
    expected = "a text with a unit, a number in SI or a quantity"
    raise InputTypeError(f"a {noun} was given {value!r}: expected {expected}")


REV_PER_MIN = "rpm"


def path(name: str, value: object) -> str:
    """Return the path of a file.

    >>> path("path", "well.toml")
    'well.toml'
    """
    if isinstance(value, str | os.PathLike):
        return os.fsdecode(cast("str | os.PathLike[str]", value))
    raise InputTypeError(f"`{name}` was given {value!r}: expected the path of a file")


def rotary_speed(name: str, value: Scalar | None) -> float | None:
    """Return a rotary speed in rad/s; a bare number is in rev/min.

    >>> round(rotary_speed("rpm", 120), 3), rotary_speed("rpm", "12 rad/s")
    (12.566, 12.0)
    """
    if value is None or isinstance(value, str) or _is_quantity(value):
        return option(name, value, "rotary speed")
    number = real(value, "rotary speed")
    if not math.isfinite(number):
        raise InputError(f"`{name}` was given {number}: expected a finite number")
    return option(name, f"{number!r} {REV_PER_MIN}", "rotary speed")


def option(name: str, value: Scalar | None, dimension: str) -> float | None:
    """Return the value of an option in SI.

    >>> option("to", "6 km", "length"), option("to", None, "length")
    (6000.0, None)
    """
    if value is None:
        return None
    try:
        found = si(value, dimension)
    except InputError as error:
        raise type(error)(f"`{name}`: {error}") from error
    if not math.isfinite(found):
        raise InputError(f"`{name}` was given {found}: expected a finite number")
    return found


def options(name: str, value: object, dimension: str) -> list[float] | None:
    """Return the values of an option in SI: one, several, or a text with several.

    >>> options("bit_depths", "1000m..2000m/500m", "length")
    [1000.0, 1500.0, 2000.0]
    >>> options("bit_depths", ["1 km", 1500.0], "length")
    [1000.0, 1500.0]
    """
    if value is None:
        return None
    if isinstance(value, str):
        return _core.values(name, value, dimension)
    if _is_quantity(value):
        unit = for_pint(_core.si_unit(dimension))
        value = _magnitude(cast("Quantity", value), unit, f"`{name}`")
    value = plain(value)
    several = cast("Iterable[Scalar]", value if isinstance(value, Iterable) else [value])
    found = (option(name, one, dimension) for one in several)
    return _some(name, [one for one in found if one is not None])


V = TypeVar("V")


def _some(name: str, values: list[V]) -> list[V]:
    """Return values, or refuse that there are none: the default is ``None``."""
    if not values:
        raise InputError(f"`{name}` was given no values: leave it out for the default")
    return values


def mapping(name: str, value: object) -> dict[str, Any]:
    """Return a mapping as a dictionary; an empty one for ``None``.

    >>> mapping("units", None), mapping("units", {"md": "ft"})
    ({}, {'md': 'ft'})
    """
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        raise InputTypeError(f"`{name}` was given {value!r}: expected a mapping of names to values")
    return dict(cast("Mapping[str, Any]", value))


def words(name: str, value: object) -> list[str]:
    """Return words: one or several; none for ``None``.

    >>> words("operation", "drill"), words("operation", ["drill", "ream"]), words("operation", None)
    (['drill'], ['drill', 'ream'], [])
    """
    if value is None:
        return []
    if isinstance(value, str):
        return [value]
    value = plain(value)
    if isinstance(value, bytes | Mapping) or not isinstance(value, Iterable):
        raise InputTypeError(f"`{name}` was given {value!r}: expected a name or a list of names")
    return _some(name, [str(word) for word in cast("Iterable[object]", value)])


def factors(name: str, value: object) -> list[float]:
    """Return friction factors: one, several, or a text with several.

    >>> import numpy as np
    >>> factors("friction", "0.2, 0.3"), factors("friction", np.array([0.25])), factors("f", None)
    ([0.2, 0.3], [0.25], [])
    """
    if value is None:
        return []
    if isinstance(value, str):
        return [_factor(name, part) for part in value.split(",")]
    if _is_quantity(value):
        value = _magnitude(cast("Quantity", value), "dimensionless", f"`{name}`")
    value = plain(value)
    several = cast("Iterable[object]", value if isinstance(value, Iterable) else [value])
    return _some(name, [_factor(name, one) for one in several])


def _factor(name: str, value: object) -> float:
    if _is_quantity(value):
        value = _magnitude(cast("Quantity", value), "dimensionless", f"`{name}`")
    try:
        return float(cast("float", value))
    except (TypeError, ValueError):
        literal = value.strip() if isinstance(value, str) else value
        message = f"`{name}`: {literal!r} is no friction factor: expected such as 0.3"
        raise InputError(message) from None


def written(name: str, value: Scalar | None, dimension: str) -> str | None:
    """Return the value of an option as a text with its unit.

    >>> written("weight_error", 12e3, "force"), written("weight_error", "12 kN", "force")
    ('12000.0 N', '12 kN')
    """
    if value is None or isinstance(value, str):
        return value
    return f"{option(name, value, dimension)!r} {_core.si_unit(dimension)}"
