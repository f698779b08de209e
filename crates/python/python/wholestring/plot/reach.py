"""The depth that a well can reach: margins of its limits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from ..errors import InputError
from ._columns import Columns
from ._house import Drawn, Look, colour, curve_width, line_colour, operation_words, pictures, stroke
from ._keys import Key, write
from ._labels import Name, name_curves
from ._paper import COLUMN_MM, PAGE_MM, frames, given, heading, label_x, label_y
from ._shown import Display, Numbers, Units, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BELOW, ABOVE = -25.0, 105.0
"""Lower and upper end of the axis of margins, per cent."""


def reach(
    results: object,
    *,
    operations: Sequence[str] | None = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw the margin of each limit against the depth of the bit, a frame per operation.

    The limit is reached where a curve crosses zero, and the well cannot go deeper.

    Parameters
    ----------
    results
        A reach, or a table like its ``reach``.
    operations
        Operations to draw; all by default.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Axes to draw in, one per operation; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per operation.

    Raises
    ------
    ValueError
        If a column or an operation is missing.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "operation": ["slide", "slide"],
    ...     "limit": ["push_absorbed", "push_absorbed"],
    ...     "bit_depth_m": [2000.0, 3000.0],
    ...     "margin": [0.6, -0.1],
    ... }
    >>> (sliding,) = ws.plot.reach(rows)
    >>> sliding.get_ylabel()
    'Slide: margin, %'
    """
    subject = "a picture of reach"
    display = Display(units, results)
    columns = Columns(results, "reach", subject)
    columns.need("operation", "limit", "bit_depth_m", "margin")
    there = columns.distinct("operation")
    for operation in operations or ():
        if operation not in there:
            raise InputError(f"{subject}: there is no {operation!r}: there are {', '.join(there)}")
    shows = list(operations) if operations is not None else there
    across = 1 if len(shows) == 1 else 2
    made = (
        frames(
            len(shows),
            columns=across,
            width_mm=PAGE_MM if across > 1 else COLUMN_MM + 25.0,
            height_mm=52.0,
            between_mm=(14.0, 13.0),
            top_mm=14.0,
        )
        if axes is None
        else given(axes, len(shows), subject)
    )
    limits = columns.distinct("limit")
    ink = {limit: _ink(place) for place, limit in enumerate(limits)}
    frictions = _frictions(columns)
    depths = display.values(columns.numbers("bit_depth_m"), "length")
    for ax, operation in zip(made, shows, strict=True):
        ax.set_xlim(float(depths.min()), float(depths.max()))
        ax.set_ylim(BELOW, ABOVE)
        ax.axhline(0.0, color=colour("muted"), linewidth=0.6)
        words = operation_words(operation)
        label_y(ax, f"{words[:1].upper()}{words[1:]}: margin, %")
        label_x(ax, display.label("Measured depth of the bit", "length"))
        _curves(ax, columns.where(operation=operation), ink, frictions, display)
    if axes is None:
        heading(made, case_name(results))
    if len(frictions) > 1:
        keys = [
            Key("the case's own friction" if friction is None else f"friction {friction:g}", look)
            for place, friction in enumerate(frictions)
            for look in [Look(colour("muted"), stroke(place))]
        ]
        write(made, keys, own=axes is None)
    return cast("list[Axes]", made)


def _curves(
    ax: Drawn,
    rows: Columns,
    ink: dict[str, str],
    frictions: Sequence[float | None],
    display: Display,
) -> None:
    named: list[Name] = []
    for limit in rows.distinct("limit"):
        for place, friction in enumerate(frictions):
            mine = rows.where(limit=limit, friction=np.nan if friction is None else friction)
            depth = display.values(mine.numbers("bit_depth_m"), "length")
            margin = 100.0 * mine.numbers("margin")
            seen = np.where((margin >= BELOW) & (margin <= ABOVE), margin, np.nan)
            ax.plot(
                depth,
                margin,
                color=ink[limit],
                linestyle=stroke(place),
                linewidth=curve_width(),
            )
            if place == 0:
                named.append(Name(limit.replace("_", " "), ink[limit], depth, seen, at=0.5))
            _met(ax, depth, margin, ink[limit])
    name_curves(ax, named)


def _met(ax: Drawn, depth: Numbers, margin: Numbers, ink: str) -> None:
    """Mark the first depth at which a margin is zero."""
    spent = np.flatnonzero((margin[:-1] > 0.0) & (margin[1:] <= 0.0))
    if not spent.size:
        return
    at = int(spent[0])
    part = margin[at] / (margin[at] - margin[at + 1])
    ax.plot([depth[at] + part * (depth[at + 1] - depth[at])], [0.0], "o", color=ink, markersize=3.4)


def _frictions(columns: Columns) -> list[float | None]:
    if "friction" not in columns:
        return [None]
    every = dict.fromkeys(
        None if np.isnan(friction) else friction
        for friction in columns.numbers("friction").tolist()
    )
    return list(every)


def _ink(place: int) -> str:
    """Return the colour of a limit: line colours first, then those of rock and casing."""
    more = ("rock", "casing")
    lines = int(pictures()["lines"])
    return line_colour(place) if place < lines else colour(more[(place - lines) % len(more)])
