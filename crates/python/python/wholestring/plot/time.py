"""Scalars against time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..errors import InputError
from ._columns import Columns
from ._house import Drawn, Look, colour, curve_width, line_colour, operation_words, pictures, stroke
from ._keys import Key, write
from ._labels import Name, name_curves
from ._paper import PAGE_MM, frames, given, heading, label_x, label_y, limits
from ._shown import Display, Numbers, Units, about, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class History:
    """Content of a frame: columns, and the label of each."""

    title: str
    dimension: str
    columns: tuple[tuple[str, str], ...]
    min_span: float = 0.0
    points: bool = False


def time(
    results: object,
    *names: str,
    operation: str | None = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw scalars of a dynamic run against time, one frame below the other.

    The time before the statistics window is grey.

    Parameters
    ----------
    results
        Results, or a table like their ``time``.
    *names
        Curves to draw: ``"hook-load"``, ``"torque"``, ``"rotary-speed"``, ``"block-velocity"``,
        ``"axial-friction"``, ``"depths"``, ``"bit-weight"`` and other curves of the bit, or any
        column of the table; hook load, torque and rotary speed by default.
    operation
        The operation, if there are several.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Axes to draw in, one per name; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per name.

    Raises
    ------
    ValueError
        If there is no table against time, or no such column or operation.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {"time_s": [0.0, 1.0, 2.0], "hook_load_N": [9.0e5, 9.1e5, 9.0e5]}
    >>> (hook_load,) = ws.plot.time(rows, "hook-load", units="metric")
    >>> hook_load.get_ylabel()
    'Hook load without block, t'
    """
    subject = "a picture against time"
    display = Display(units, results)
    columns = Columns(results, "time", subject)
    columns.need("time_s")
    one = _operation(columns, operation)
    rows = columns.where(operation=one)
    shows = _chosen(names, rows)
    made = _frames(len(shows)) if axes is None else given(axes, len(shows), subject)
    seconds = display.values(rows.numbers("time_s"), "time")
    ends = (float(seconds[0]), float(seconds[-1])) if len(seconds) else (0.0, 1.0)
    window = _window(results, one)
    for ax, history in zip(made, shows, strict=True):
        ax.set_xlim(*ends)
        if window is not None and window > ends[0]:
            before = min(float(display.values(np.array(window), "time")), ends[1])
            ax.axvspan(ends[0], before, color=colour("settling"), zorder=0, linewidth=0)
        _draw(ax, history, rows, seconds, display)
    last = display.label("Time", "time")
    for ax in made if axes is not None else made[-1:]:
        label_x(ax, last)
    if axes is None:
        for ax in made[:-1]:
            ax.tick_params(labelbottom=False)
        made[0].figure.align_ylabels(made)
        heading(made, _title(results, one))
        if window is not None and window > ends[0]:
            settling = Key("before the window", Look(colour("settling")), area=True)
            write(made, [settling], own=True)
    return cast("list[Axes]", made)


def _frames(count: int) -> list[Drawn]:
    return frames(
        count,
        columns=1,
        width_mm=PAGE_MM,
        height_mm=32.0 if count > 1 else 50.0,
        between_mm=(0.0, 4.0),
        top_mm=13.0,
        left_mm=18.0,
        share_x=True,
    )


def _draw(ax: Drawn, history: History, rows: Columns, seconds: Numbers, display: Display) -> None:
    every: list[Numbers] = []
    named: list[Name] = []
    known = [(column, word) for column, word in history.columns if rows.known(column)]
    for place, (column, word) in enumerate(known):
        values = display.values(rows.numbers(column), history.dimension)
        every.append(values)
        look = Look(line_colour(place), stroke(place))
        if history.points:
            ax.plot(seconds, values, ".", color=look.colour, markersize=2.0)
        else:
            ax.plot(
                seconds,
                values,
                color=look.colour,
                linestyle=look.stroke,
                linewidth=curve_width(),
            )
        if len(known) > 1:
            named.append(Name(word, look.colour, seconds, values, at=0.9))
    low, high = limits(every, min_span=history.min_span / display.factor(history.dimension))
    ax.set_ylim(*((high, low) if history.points else (low, high)))
    label_y(ax, display.label(history.title, history.dimension))
    name_curves(ax, named)


def _operation(columns: Columns, operation: str | None) -> str | None:
    there = columns.distinct("operation")
    if operation is None:
        if len(there) > 1:
            message = f"a picture against time is of one operation: name one of {', '.join(there)}"
            raise InputError(message)
        return there[0] if there else None
    if there and operation not in there:
        message = f"a picture against time: there is no {operation!r}: there are {', '.join(there)}"
        raise InputError(message)
    return operation


def _chosen(names: Sequence[str], rows: Columns) -> list[History]:
    declared = _declared()
    if not names:
        usual = [declared[name] for name in ("hook-load", "torque", "rotary-speed")]
        known = [entry for entry in usual if any(rows.known(column) for column, _ in entry.columns)]
        if not known:
            rows.need(*(column for entry in usual for column, _ in entry.columns))
        return known
    chosen: list[History] = []
    for name in names:
        history = declared.get(name)
        if history is None:
            title, dimension = about(name)
            alike = (entry for entry in declared.values() if name in dict(entry.columns))
            least = next((entry.min_span for entry in alike), 0.0)
            history = History(title, dimension, ((name, title),), least)
        if not any(rows.known(column) for column, _ in history.columns):
            rows.need(*(column for column, _ in history.columns))
            raise InputError(f"a picture against time: `{name}` has no values here")
        chosen.append(history)
    return chosen


def _declared() -> dict[str, History]:
    made: dict[str, History] = {}
    for row in [*pictures()["time"], *pictures()["bit"]]:
        made[str(row["name"]).removeprefix("time-")] = History(
            title=row["title"],
            dimension=row["dimension"],
            columns=tuple((column, word) for column, word in row["columns"]),
            min_span=row["min_span"],
            points=row["points"],
        )
    return made


def _solved(results: object, operation: str | None) -> Mapping[str, Any] | None:
    """Return the entry of the dynamic operation in the summary."""
    summary = getattr(results, "summary", None)
    if not isinstance(summary, Mapping):
        return None
    every = cast("Iterable[Mapping[str, Any]]", cast("Any", summary).get("operations", ()))
    dynamic = (entry for entry in every if entry["model"] == "dynamic")
    return next((entry for entry in dynamic if operation in (None, entry["operation"])), None)


def _window(results: object, operation: str | None) -> float | None:
    """Return the time at which the statistics window begins, s."""
    solved = _solved(results, operation)
    numerics = solved.get("numerics") if solved is not None else None
    return float(numerics["settle_s"]) if numerics else None


def _title(results: object, operation: str | None) -> str:
    words = operation_words(operation) if operation else ""
    return ": ".join(part for part in (case_name(results), words) if part)
