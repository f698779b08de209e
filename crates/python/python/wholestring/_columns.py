"""Data frames and columns in the form of files."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping
from typing import Any, cast

import numpy as np

from ._values import Value
from .errors import InputError, InputTypeError


def content(data: object) -> bytes:
    r"""Return a data frame or columns as CSV, the form of files of readings and surveys.

    >>> content({"bit_depth_m": [300.0, 500.0], "pick_up_kN": [210.5, None]})
    b'bit_depth_m,pick_up_kN\r\n300.0,210.5\r\n500.0,\r\n'
    """
    columns = _columns(data)
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        raise InputError(f"the columns differ in length: {lengths}")
    text = io.StringIO()
    rows = csv.writer(text)
    rows.writerow(columns)
    rows.writerows([_cell(value) for value in row] for row in zip(*columns.values(), strict=True))
    return text.getvalue().encode()


def rows(data: object) -> list[Mapping[str, Value]]:
    """Return the changes of each case: the items of a list, or the rows of columns.

    >>> rows({"friction": [0.2, 0.3]})
    [{'friction': 0.2}, {'friction': 0.3}]
    """
    if is_table(data):
        columns = _columns(data)
        if len({len(values) for values in columns.values()}) > 1:
            lengths = {name: len(values) for name, values in columns.items()}
            raise InputError(f"the columns differ in length: {lengths}")
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    if isinstance(data, str | bytes) or not isinstance(data, Iterable):
        message = f"expected a list of changes, a data frame or a mapping of columns: {data!r}"
        raise InputTypeError(message)
    mappings = list(cast("Iterable[object]", data))
    for one in mappings:
        if not isinstance(one, Mapping):
            raise InputTypeError(f"expected a mapping of keys to values in the list, not {one!r}")
    return cast("list[Mapping[str, Value]]", mappings)


def _columns(data: object) -> dict[str, list[Any]]:
    if not isinstance(data, Mapping):
        # A frame of polars or pandas, or a `Table`: columns by their names.
        frame = cast("Any", data)
        names = getattr(frame, "columns", None)
        if names is None:
            message = f"expected a path, a data frame or a mapping of columns, and got {data!r}"
            raise InputTypeError(message)
        data = {str(name): frame[name] for name in names}
    table = cast("Mapping[str, Any]", data)
    return {str(name): _column(str(name), values) for name, values in table.items()}


def _column(name: str, values: object) -> list[Any]:
    """Return the values of a column.

    >>> _column("a", 1)
    Traceback (most recent call last):
    wholestring.errors.InputTypeError: the column 'a' was given 1: expected a value for each row
    """
    wrong = f"the column {name!r} was given {values!r}: expected a value for each row"
    try:
        array = np.asarray(values)
    except ValueError:
        # Rows of different lengths.
        raise InputTypeError(wrong) from None
    if array.ndim != 1:
        raise InputTypeError(wrong)
    return list(array.tolist())


def _cell(value: object) -> object:
    return "" if value is None or value != value else value


def is_table(data: object) -> bool:
    """Return whether the data are a data frame or columns by their names.

    >>> is_table({"md_m": [0.0]}), is_table([[0.0, 0.0, 0.0]])
    (True, False)
    """
    return isinstance(data, Mapping) or hasattr(data, "columns")
