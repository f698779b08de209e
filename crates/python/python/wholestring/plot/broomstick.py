"""Hook load and torque against the depth of the bit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from ..errors import InputError
from ._columns import Columns
from ._curves import models_words
from ._house import (
    Dash,
    Drawn,
    Look,
    colour,
    curve_width,
    operation_colour,
    operation_words,
    stroke,
)
from ._keys import Key, write
from ._labels import Name, name_curves
from ._paper import COLUMN_MM, depth_down, finite, frames, given, heading, label_x, limits
from ._shown import Display, Numbers, Units, about, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEVELS = ("low", "expected", "high")


def broomstick(
    plan: object,
    quantity: str = "hook_load_N",
    *,
    operations: Sequence[str] | None = None,
    models: Sequence[str] | None = None,
    limit: float | None = None,
    units: Units | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw hook load, or another scalar, against the depth of the bit: depth down.

    Operations differ by colour: slack-off to the left, rotating, pick-up to the right. Friction
    differs by stroke: low is dotted, expected solid, high dashed; the first of several friction
    factors is solid. A second model is drawn as points.

    Parameters
    ----------
    plan
        A plan, or a table like its ``plan_broomstick``: ``operation``, ``bit_depth_m`` and the
        quantity; optionally ``friction`` and ``model``.
    quantity
        The column to draw: ``"hook_load_N"``, ``"surface_torque_N_m"``, ...
    operations, models
        Operations and models to draw; all by default, for a torque all rotating operations.
    limit
        Rating of the rig, SI, drawn as a line.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    ax
        Axes to draw in; those of a new figure by default.

    Returns
    -------
    matplotlib.axes.Axes
        The axes.

    Raises
    ------
    ValueError
        If a column is missing.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "operation": ["trip_out", "trip_out", "trip_in", "trip_in"],
    ...     "bit_depth_m": [500.0, 1000.0, 500.0, 1000.0],
    ...     "hook_load_N": [3.0e5, 4.1e5, 2.5e5, 2.8e5],
    ... }
    >>> ax = ws.plot.broomstick(rows)
    >>> ax.get_xlabel(), bool(ax.yaxis_inverted())
    ('Hook load without block, kN', True)
    """
    subject = "a broomstick"
    display = Display(units, plan)
    columns = Columns(plan, "plan_broomstick", subject)
    columns.need("operation", "bit_depth_m", quantity)
    title, dimension = about(quantity)
    own = ax is None
    frame = _frame() if ax is None else given(ax, 1, subject)[0]
    solved = _models(columns, models)
    levels = _levels(columns)
    named_level = "expected" if "expected" in levels else list(levels)[len(levels) // 2]
    every: list[Numbers] = []
    depths: list[Numbers] = []
    named: list[Name] = []
    for operation in _operations(columns, quantity, operations):
        look = operation_colour(operation)
        widest: tuple[Numbers, Numbers] | None = None
        for place, model in enumerate(solved):
            for level, dash in levels.items():
                rows = columns.where(
                    model=model or None, operation=operation, friction=level or None
                )
                if not len(rows):
                    continue
                values = display.values(rows.numbers(quantity), dimension)
                depth = display.values(rows.numbers("bit_depth_m"), "length")
                every.append(values)
                depths.append(depth)
                _curve(frame, values, depth, Look(look, dash), is_first=place == 0)
                if place == 0 and level == named_level:
                    widest = (values, depth)
        if widest is not None:
            named.append(Name(operation_words(operation), look, *widest, at=0.85))
    rating = None if limit is None else float(display.values(np.array(limit), dimension))
    ends = limits([*every, np.array([rating])] if rating is not None else every, zero=True)
    frame.set_xlim(*ends)
    if rating is not None:
        frame.axvline(rating, color=colour("muted"), linewidth=0.6, linestyle=(0, (3.3, 2.7)))
    label_x(frame, display.label(title, dimension), on_top=True)
    depth_down(frame, depths, display.label("Measured depth of the bit", "length"))
    if own:
        heading([frame], case_name(plan))
    write([frame], _keys(levels, solved), own=own)
    name_curves(frame, named)
    return cast("Axes", frame)


def _frame() -> Drawn:
    return frames(
        1,
        columns=1,
        width_mm=COLUMN_MM + 15.0,
        height_mm=95.0,
        top_mm=21.0,
        bottom_mm=4.0,
    )[0]


def _curve(ax: Drawn, values: Numbers, depth: Numbers, look: Look, *, is_first: bool) -> None:
    if is_first:
        ax.plot(values, depth, color=look.colour, linestyle=look.stroke, linewidth=curve_width())
    else:
        ax.plot(values, depth, "o", color=look.colour, markersize=2.2, markeredgewidth=0.0)


def _levels(columns: Columns) -> dict[str, Dash]:
    """Return the strokes of friction levels, or of friction factors, by their names."""
    there = columns.distinct("friction")
    if all(level in LEVELS for level in there):
        strokes: dict[str, Dash] = {}
        strokes.update(low=stroke(2), expected=stroke(0), high=stroke(1))
        nothing: dict[str, Dash] = {"": stroke(0)}
        return {level: strokes[level] for level in LEVELS if level in there} or nothing
    return {level: stroke(place) for place, level in enumerate(sorted(there, key=_size))}


def _size(word: str) -> tuple[bool, float, str]:
    """Return a sort key: numbers by size, then words."""
    try:
        return (False, float(word), "")
    except ValueError:
        return (True, 0.0, word)


def _models(columns: Columns, models: Sequence[str] | None) -> list[str]:
    there = columns.distinct("model")
    for model in models or ():
        if model not in there:
            message = f"a broomstick: no model {model!r} solved it: {', '.join(there)} did"
            raise InputError(message)
    return list(models) if models is not None else there or [""]


def _operations(columns: Columns, quantity: str, operations: Sequence[str] | None) -> list[str]:
    there = columns.distinct("operation")
    for operation in operations or ():
        if operation not in there:
            message = f"a broomstick: there is no {operation!r}: there are {', '.join(there)}"
            raise InputError(message)
    if operations is not None:
        return list(operations)
    if "torque" not in quantity:
        return there
    # For a torque, the operations that have one: a trip without rotation has none.
    turning = [
        operation
        for operation in there
        if np.any(finite([columns.where(operation=operation).numbers(quantity)]) != 0.0)
    ]
    return turning or there


def _keys(levels: Mapping[str, Dash], models: Sequence[str]) -> list[Key]:
    ink = colour("muted")
    several = len(levels) > 1
    keys = [
        Key(f"{level} friction" if level in LEVELS else f"friction {level}", Look(ink, dash))
        for level, dash in levels.items()
        if several
    ]
    if len(models) > 1:
        words = models_words()
        keys += [Key(words.get(model, model), Look(ink), marker="o") for model in models[1:]]
    return keys
