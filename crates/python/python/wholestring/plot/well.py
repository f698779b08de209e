"""The path of a well: from above, and as a vertical section."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from .. import _core
from ..errors import InputError, InputTypeError
from ..table import Table
from . import _hole
from ._columns import Columns
from ._house import SMALL, Drawn, Look, colour, curve_width, words
from ._keys import Key, write
from ._paper import PAGE_MM, finite, frames, given, heading, label_x, label_y
from ._shown import Display, Numbers, Units, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DEPTHS = 6
"""Approximate number of measured depths that are written at the path."""


def well(
    case: object,
    *,
    units: Units | None = None,
    axes: Sequence[Axes] | None = None,
) -> list[Axes]:
    """Draw the path of a well from above, and its vertical section: both to scale.

    The section is along the direction from the wellhead to the end of the path. Cased hole is a
    heavy line; measured depths are written at the path.

    Parameters
    ----------
    case
        A case, or results.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Two axes to draw in, plan and section; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        Plan and section.

    Raises
    ------
    TypeError
        If ``case`` is neither a case nor results.

    Examples
    --------
    >>> import wholestring as ws
    >>> plan, section = ws.plot.well(ws.Case.example())
    >>> plan.get_xlabel(), section.get_ylabel()
    ('East, m', 'True vertical depth, m')
    """
    display = Display(units, case)
    settings = _settings(case)
    path = Columns(
        Table(_core.well_path(json.dumps(settings)), "well"), "well", "a picture of a well"
    )
    if not len(path):
        raise InputError("a picture of a well: the case has no path")
    hole = _hole.sections(settings)
    made = (
        frames(
            2,
            columns=2,
            width_mm=PAGE_MM,
            height_mm=75.0,
            between_mm=(18.0, 0.0),
            top_mm=15.0,
            bottom_mm=11.0,
        )
        if axes is None
        else given(axes, 2, "a picture of a well")
    )
    plan, section = made
    column = {
        name: display.values(path.numbers(name), "length")
        for name in ("md_m", "north_m", "east_m", "tvd_m", "vertical_section_m")
    }
    _path(plan, column["east_m"], column["north_m"], column["md_m"], hole, display)
    _path(section, column["vertical_section_m"], column["tvd_m"], column["md_m"], hole, display)
    _from_the_surface(section, column["tvd_m"])
    label_x(plan, display.label("East", "length"))
    label_y(plan, display.label("North", "length"))
    label_x(section, display.label("Along the section", "length"))
    label_y(section, display.label("True vertical depth", "length"))
    if axes is None:
        heading(made, case_name(case))
        keys = [
            Key("casing", Look(colour("casing"))),
            Key("open hole", Look(colour("rock"))),
            Key(display.label("measured depth", "length"), Look(colour("text")), marker="o"),
        ]
        write(made, keys if any(stretch.cased for stretch in hole) else keys[1:], own=True)
    return cast("list[Axes]", made)


def _path(
    ax: Drawn,
    x: Numbers,
    y: Numbers,
    md: Numbers,
    hole: Sequence[_hole.Section],
    display: Display,
) -> None:
    for stretch in hole:
        ends_m = np.array([stretch.from_m, stretch.to_m])
        start, end = display.values(ends_m, "length").tolist()
        inside = np.concatenate(
            ([max(start, md[0])], md[(md > start) & (md < end)], [min(end, md[-1])])
        )
        ax.plot(
            np.interp(inside, md, x),
            np.interp(inside, md, y),
            color=colour("casing" if stretch.cased else "rock"),
            linewidth=2.4 if stretch.cased else 1.4 * curve_width(),
            solid_capstyle="butt",
        )
    _to_scale(ax, x, y)
    last: Numbers | None = None
    depths: Numbers = _round_depths(float(md[-1]))
    places: Numbers = np.column_stack((np.interp(depths, md, x), np.interp(depths, md, y)))
    for depth, at in zip(depths, places, strict=True):
        pixels = ax.transData.transform(at)
        # In plan view, a vertical hole is a point.
        if last is not None and np.hypot(*(pixels - last)) < 14.0 * ax.figure.dpi / 72.0:
            continue
        last = pixels
        ax.plot(*at, "o", color=colour("text"), markersize=2.6)
        ax.annotate(
            f"{depth:,.0f}".replace(",", "\N{NARROW NO-BREAK SPACE}"),
            xy=tuple(at),
            xytext=(4.0, 0.0),
            textcoords="offset points",
            va="center",
            **words(SMALL),
        )


def _to_scale(ax: Drawn, x: Numbers, y: Numbers) -> None:
    """Set both axes to the same scale, with the path in the middle."""
    box = ax.get_window_extent()
    spans = [float(np.ptp(finite([coordinate]))) for coordinate in (x, y)]
    largest = max(*spans, 1.0)
    scale = max(spans[0] / box.width, spans[1] / box.height, 0.2 * largest / box.width)
    per_pixel = 1.3 * scale
    for coordinate, size, limit in ((x, box.width, ax.set_xlim), (y, box.height, ax.set_ylim)):
        middle = 0.5 * (float(coordinate.min()) + float(coordinate.max()))
        half = 0.5 * per_pixel * size
        limit(middle - half, middle + half)
    ax.set_aspect("equal", adjustable="box")


def _from_the_surface(ax: Drawn, tvd: Numbers) -> None:
    """Set the depth axis, pointing down, from a little above the surface, with the same span."""
    low, high = ax.get_ylim()
    top = float(tvd.min()) - 0.06 * (high - low)
    ax.set_ylim(top + (high - low), top)


def _round_depths(last: float) -> Numbers:
    """Return round depths down to the last depth, and the last depth itself."""
    rough = last / DEPTHS
    power = 10.0 ** np.floor(np.log10(rough))
    factors = (1.0, 2.0, 5.0, 10.0)
    step = float(next(factor for factor in factors if factor * power >= rough) * power)
    every = np.arange(0.0, last - 0.4 * step, step)
    return np.append(every, last)


def _settings(case: object) -> Mapping[str, Any]:
    settings: object = getattr(case, "settings", None)
    if settings is None:
        summary = cast("Mapping[str, object]", getattr(case, "summary", {}))
        settings = summary.get("settings")
    if not isinstance(settings, Mapping):
        raise InputTypeError(f"a picture of a well takes a case or results, not {case!r}")
    return cast("Mapping[str, Any]", settings)
