"""Columns of the data to draw: a table of the package, a data frame, a mapping of lists."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError, InputTypeError
from ..table import Table
from ._shown import Numbers

Rows = NDArray[np.bool_]


class Columns:
    """Columns by their names, and a selection of their rows.

    Parameters
    ----------
    thing
        Results that have a table of the name ``table``, or an object with one table; or such a
        table itself, as a :class:`wholestring.Table`, a data frame, or a mapping of columns.
    table
        Name of the table.
    subject
        Name of the figure for error messages.
    """

    def __init__(self, thing: object, table: str, subject: str) -> None:
        self._subject = subject
        self._columns = _columns(thing, table, subject)
        self._rows: Rows | None = None

    def __contains__(self, name: object) -> bool:
        """Return whether there is such a column."""
        return name in self._names()

    def __len__(self) -> int:
        """Return the number of rows."""
        if self._rows is not None:
            return int(self._rows.sum())
        names = self._names()
        return len(self._column(names[0])) if names else 0

    def numbers(self, name: str) -> Numbers:
        """Return a column of numbers, NaN where there is no number."""
        values = self._column(name)
        try:
            numbers = np.asarray(values, dtype=np.float64)
        except (TypeError, ValueError):
            message = f"{self._subject} needs numbers in `{name}`: it holds {values[:1].tolist()}"
            raise InputError(message) from None
        return numbers if self._rows is None else numbers[self._rows]

    def words(self, name: str) -> NDArray[Any]:
        """Return a column of words."""
        values = np.asarray([str(value) for value in self._column(name)], dtype=object)
        return values if self._rows is None else values[self._rows]

    def distinct(self, name: str) -> list[str]:
        """Return the distinct words of a column, in their order; none without the column."""
        return list(dict.fromkeys(self.words(name))) if name in self else []

    def known(self, name: str) -> bool:
        """Return whether there is such a column with a number in it."""
        return name in self and bool(np.isfinite(self.numbers(name)).any())

    def where(self, **words: str | float | None) -> Columns:
        """Return the rows with these values; columns whose value is ``None`` match all rows."""
        rows = np.ones(len(self), dtype=bool)
        for name, value in words.items():
            if value is None or name not in self:
                continue
            if isinstance(value, str):
                rows &= self.words(name) == value
            elif np.isnan(value):
                rows &= np.isnan(self.numbers(name))
            else:
                rows &= self.numbers(name) == value
        return self.rows(rows)

    def rows(self, rows: Rows) -> Columns:
        """Return a selection of the rows."""
        other = Columns.__new__(Columns)
        other._subject = self._subject
        other._columns = self._columns
        if self._rows is None:
            other._rows = rows
        else:
            every = self._rows.copy()
            every[self._rows] = rows
            other._rows = every
        return other

    def need(self, *names: str) -> None:
        """Raise an error with the names of the missing columns, if any."""
        missing = [f"`{name}`" for name in names if name not in self]
        if missing:
            noun = "column" if len(missing) == 1 else "columns"
            there = ", ".join(self._names())
            message = f"{self._subject} needs the {noun} {', '.join(missing)}: there are {there}"
            raise InputError(message)

    def _names(self) -> list[str]:
        return list(self._columns)

    def _column(self, name: str) -> NDArray[Any]:
        self.need(name)
        return np.asarray(self._columns[name])


def _columns(thing: object, table: str, subject: str) -> Mapping[str, Any]:
    if isinstance(thing, Table):
        return thing.to_numpy()
    member = getattr(thing, "table", None)
    if isinstance(member, Table):
        return member.to_numpy()
    if callable(member):
        try:
            return cast("Table", member(table)).to_numpy()
        except KeyError as error:
            there = ", ".join(cast("Sequence[str]", getattr(thing, "tables", ())))
            message = f"{subject} needs the table `{table}`: there are {there}"
            raise InputError(message) from error
    if isinstance(thing, Mapping):
        return {str(name): column for name, column in cast("Any", thing).items()}
    # A data frame of polars or pandas, or a table of pyarrow.
    frame = cast("Any", thing)
    names = getattr(frame, "column_names", getattr(frame, "columns", None))
    if names is None:
        message = f"{subject} takes results, a table, a data frame or a mapping, not {thing!r}"
        raise InputTypeError(message)
    return {str(name): frame[name] for name in names}
