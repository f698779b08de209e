"""Results of a sweep against a varied key."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, cast

import numpy as np

from .. import _core
from ..errors import InputError
from ._columns import Columns, Rows
from ._house import (
    Drawn,
    Look,
    colour,
    curve_width,
    line_colour,
    operation_colour,
    operation_words,
    stroke,
)
from ._labels import Name, name_curves
from ._paper import (
    COLUMN_MM,
    depth_down,
    finite,
    frames,
    given,
    heading,
    label_x,
    label_y,
    limits,
)
from ._shown import Display, Numbers, Units, about, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MARKERS = ("o", "s", "^", "D", "v")


def sweep(
    table: object,
    *,
    x: str,
    y: str = "hook_load_N",
    by: str | None = None,
    operation: str | None = None,
    model: str | None = None,
    units: Units | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw a result of a sweep against a varied key, with a curve for each value of another key.

    A varied depth points down.

    Parameters
    ----------
    table
        The table of a sweep: a row per case, model and operation, with varied keys and scalars.
    x
        The column of the varied key along the axis: ``"friction"``, ``"bit_depth_m"``, ...
    y
        The scalar to draw.
    by
        The column with a curve for each of its values: ``"friction"``, ``"operation"``, ...
    operation, model
        Operation and model to draw; required if the table has several and ``by`` is another column.
    units
        ``"si"``, ``"metric"`` or ``"field"``; SI by default.
    ax
        Axes to draw in; those of a new figure by default.

    Returns
    -------
    matplotlib.axes.Axes
        The axes.

    Raises
    ------
    ValueError
        If a column is missing, or several rows have the same position on a curve.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "friction": [0.2, 0.3, 0.2, 0.3],
    ...     "bit_depth_m": [900.0, 900.0, 1200.0, 1200.0],
    ...     "surface_torque_N_m": [4.0e3, 6.0e3, 5.5e3, 8.0e3],
    ... }
    >>> ax = ws.plot.sweep(rows, x="friction", y="surface_torque_N_m", by="bit_depth_m")
    >>> [text.get_text() for text in ax.texts]
    ['900 m', '1200 m']
    """
    subject = "a picture of a sweep"
    display = Display(units, table)
    columns = Columns(table, "sweep", subject)
    columns.need(x, y, *([by] if by is not None else []))
    rows = columns.where(operation=operation, model=model)
    if not len(rows):
        selection = ", ".join(name for name in (operation, model) if name)
        raise InputError(f"{subject}: there are no rows of {selection}")
    along, label, is_depth = _varied(rows, x, display)
    title, dimension = about(y)
    values = display.values(rows.numbers(y), dimension)
    own = ax is None
    frame = _frame(is_depth=is_depth) if ax is None else given(ax, 1, subject)[0]
    named: list[Name] = []
    for place, (name, kind, mask) in enumerate(_families(rows, by, display)):
        order = np.argsort(along[mask], kind="stable")
        at, value = along[mask][order], values[mask][order]
        if np.any(np.diff(at) == 0.0):
            message = (
                f"{subject}: several rows have the same `{x}`"
                f"{f' and `{by}`' if by else ''}: name operation and model, or select rows"
            )
            raise InputError(message)
        ink = operation_colour(kind) if by == "operation" else line_colour(place)
        look = Look(ink, stroke(place))
        points: tuple[Numbers, Numbers] = (value, at) if is_depth else (at, value)
        frame.plot(
            *points,
            color=look.colour,
            linestyle=look.stroke,
            linewidth=curve_width(),
            marker=MARKERS[place % len(MARKERS)],
            markersize=3.2,
            markeredgecolor=colour("paper"),
            markeredgewidth=0.4,
        )
        if name:
            named.append(Name(name, look.colour, *points, at=0.95))
    least = limits([values])
    if is_depth:
        frame.set_xlim(*least)
        label_x(frame, display.label(title, dimension), on_top=True)
        depth_down(frame, [along], label)
        known = finite([along])
        frame.set_ylim(known.max() + 0.03 * np.ptp(known), known.min() - 0.03 * np.ptp(known))
    else:
        frame.set_ylim(*least)
        known = finite([along])
        beyond = 0.04 * float(np.ptp(known)) or 0.5
        frame.set_xlim(known.min() - beyond, known.max() + beyond)
        label_x(frame, label)
        label_y(frame, display.label(title, dimension))
    if own:
        heading([frame], case_name(table))
    name_curves(frame, named)
    return cast("Axes", frame)


def _varied(rows: Columns, x: str, display: Display) -> tuple[Numbers, str, bool]:
    """Return the numbers along the axis, its label, and whether they are a depth."""
    title, dimension = about(x)
    short = x.rsplit(".", 1)[-1]
    is_depth = short in ("bit_depth", "bit_depth_m")
    texts = _texts(rows, x)
    if texts is not None:
        numbers, unit = texts
        return numbers, f"{title}, {unit}" if unit else title, is_depth
    return display.values(_si(rows, x), dimension), display.label(title, dimension), is_depth


def _si(rows: Columns, name: str) -> Numbers:
    """Return the numbers of a column in SI; a varied rotary speed is in rev/min."""
    unit, dimension = _core.unit_of(name), _core.dimension_of(name)
    factor = 1.0 if unit is None or dimension is None else _core.quantity(f"1 {unit}", dimension)
    return rows.numbers(name) * factor


def _texts(rows: Columns, name: str) -> tuple[Numbers, str] | None:
    """Return numbers and unit of a column of texts such as ``900m``; ``None`` for numbers."""
    try:
        rows.numbers(name)
    except ValueError:
        pass
    else:
        return None
    words = rows.words(name)
    split = [re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*?)\s*", word) for word in words]
    if not all(split):
        message = (
            f"a picture of a sweep: `{name}` has no numbers: {', '.join(dict.fromkeys(words))}"
        )
        raise InputError(message)
    pairs = [(match[1], match[2]) for match in split if match is not None]
    units = {unit for _, unit in pairs}
    if len(units) > 1:
        raise InputError(f"a picture of a sweep: `{name}` has several units: {sorted(units)}")
    return np.array([float(number) for number, _ in pairs]), units.pop()


def _families(rows: Columns, by: str | None, display: Display) -> list[tuple[str, str, Rows]]:
    """Return the name, the word and the rows of each curve."""
    if by is None:
        return [("", "", np.ones(len(rows), dtype=bool))]
    try:
        numbers = _si(rows, by)
    except ValueError:
        words = rows.words(by)
        label_of = operation_words if by == "operation" else str
        return [(label_of(word), word, words == word) for word in dict.fromkeys(words)]
    title, dimension = about(by)
    every = sorted(set(numbers[np.isfinite(numbers)].tolist()))
    # A number without a unit needs its title.
    before = "" if display.symbol(dimension) else f"{title.lower()} "
    return [
        (before + display.quantity(number, dimension), "", numbers == number) for number in every
    ]


def _frame(*, is_depth: bool) -> Drawn:
    top, bottom, height = (15.0, 4.0, 90.0) if is_depth else (9.0, 10.0, 62.0)
    return frames(
        1, columns=1, width_mm=COLUMN_MM + 20.0, height_mm=height, top_mm=top, bottom_mm=bottom
    )[0]
