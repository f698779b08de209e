"""Columns at small scale: the values at joints apply to the pipe between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ._shown import Numbers


def rows_of_largest(depths: Numbers, values: Numbers, reach: float) -> NDArray[np.intp]:
    """Return the row with the largest value within ``reach`` of each depth.

    >>> rows_of_largest(np.arange(5.0), np.array([0.0, 0.0, 9.0, 0.0, 0.0]), 1.0).tolist()
    [0, 2, 2, 2, 3]
    """
    starts = np.searchsorted(depths, depths - reach, side="left")
    ends = np.searchsorted(depths, depths + reach, side="right")
    known = np.where(np.isnan(values), -np.inf, values)
    pairs = zip(starts.tolist(), ends.tolist(), strict=True)
    return np.array([start + int(known[start:end].argmax()) for start, end in pairs], dtype=np.intp)


def largest(depths: Numbers, values: Numbers, reach: float) -> Numbers:
    """Return the largest value within ``reach`` of each depth."""
    return values[rows_of_largest(depths, values, reach)] if len(values) else values


def smallest(depths: Numbers, values: Numbers, reach: float) -> Numbers:
    """Return the smallest value within ``reach`` of each depth."""
    return -largest(depths, -values, reach)
