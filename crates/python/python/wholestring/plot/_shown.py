"""Numbers in the units of the reader."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from .. import _core
from ..errors import InputError
from ._house import conventions

Units: TypeAlias = Literal["si", "metric", "field"]
"""A set of units: SI, metric as a rig in Europe has it, or field."""

SETS: tuple[Units, ...] = ("si", "metric", "field")

Numbers: TypeAlias = "NDArray[np.float64]"


class Display:
    """Units in which numbers are displayed.

    Parameters
    ----------
    units
        The set of units; by default, that of the case of ``thing``, otherwise SI.
    thing
        Data to draw.
    """

    def __init__(self, units: Units | None, thing: object = None) -> None:
        name = units or of_the_case(thing) or "si"
        if name not in SETS:
            raise InputError(f"there are no units {name!r}: there are {', '.join(SETS)}")
        self.units: Units = name
        self._place = SETS.index(name)

    def symbol(self, dimension: str) -> str:
        """Return the symbol of the unit of a dimension; empty if it has none."""
        unit = self._unit(dimension)
        return "" if unit is None else str(unit["symbol"])

    def factor(self, dimension: str) -> float:
        """Return the number of SI units in one unit of the reader."""
        unit = self._unit(dimension)
        return 1.0 if unit is None else float(unit["factor"])

    def values(self, si: Numbers, dimension: str) -> Numbers:
        """Return numbers in the units of the reader."""
        return np.asarray(si, dtype=np.float64) / self.factor(dimension)

    def label(self, title: str, dimension: str) -> str:
        """Return the label of an axis, with its unit.

        >>> Display("field").label("Hook load", "force")
        'Hook load, klbf'
        """
        symbol = self.symbol(dimension)
        return f"{title}, {symbol}" if symbol else title

    def quantity(self, si: float, dimension: str) -> str:
        """Return a number in four digits with its unit."""
        symbol = self.symbol(dimension)
        between = "" if symbol in ("", "°") else " "
        return f"{si / self.factor(dimension):.4g}{between}{symbol}"

    def _unit(self, dimension: str) -> Mapping[str, Any] | None:
        sets = conventions()["units"].get(dimension)
        return None if sets is None else cast("Mapping[str, Any]", sets[self._place])


def about(column: str) -> tuple[str, str]:
    """Return title and dimension of a column; an undeclared column has its name as title.

    >>> about("hook_load_N")
    ('Hook load without block', 'force')
    >>> about("my_column")
    ('My column', '')
    >>> about("rpm")
    ('Rotary speed', 'rotary speed')
    """
    quantities = conventions()["quantities"]
    found = quantities.get(column)
    if found is not None:
        return str(found[0]), str(found[1])
    for ending, words in _STATISTICS.items():
        quantity = quantities.get(column.removesuffix(ending)) if column.endswith(ending) else None
        if quantity is not None:
            return f"{quantity[0]}, {words}", str(quantity[1])
    # A key of the case file.
    short = column.rsplit(".", 1)[-1]
    dimension = _core.dimension_of(column) or ""
    named = quantities.get(_KEYS.get(short, "")) if dimension else None
    title = str(named[0]) if named is not None else short.replace("_", " ")
    return title[:1].upper() + title[1:], dimension


_KEYS = {
    "wob": "weight_on_bit_N",
    "rpm": "rotary_speed_rad_per_s",
    "bit_depth": "bit_depth_m",
    "flow_rate": "flow_rate_m3_per_s",
}
"""Keys of the case that share the title of a column, and that column."""

_STATISTICS = {
    "_mean": "mean",
    "_std": "standard deviation",
    "_min": "least",
    "_max": "largest",
    "_p05": "5th percentile",
    "_p95": "95th percentile",
    "_std_error": "standard error of the mean",
    "_drift": "drift",
}


def of_the_case(thing: object) -> Units | None:
    """Return the units of the case of ``thing``; ``None`` if it has no settings."""
    settings = getattr(thing, "settings", None)
    if settings is None:
        summary = getattr(thing, "summary", None)
        if isinstance(summary, Mapping):
            settings = cast("Mapping[str, Any]", summary).get("settings")
    if not isinstance(settings, Mapping):
        return None
    units = cast("Mapping[str, Any]", settings).get("units")
    return units if units in SETS else None


def case_name(thing: object) -> str:
    """Return the name of the case of ``thing``; empty if it has none."""
    own = getattr(thing, "case_name", None)
    if isinstance(own, str):
        return own
    name = getattr(thing, "name", None)
    return name if isinstance(name, str) and hasattr(thing, "settings") else ""
