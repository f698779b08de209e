"""Linear vibration about static equilibrium: frequencies against speed, and mode shapes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..errors import InputError
from ._columns import Columns
from ._house import SMALL, Drawn, Look, colour, curve_width, line_colour, stroke, words
from ._keys import Key, write
from ._labels import Name, name_curves
from ._paper import PAGE_MM, depth_down, frames, given, heading, label_x, label_y, single
from ._shown import Display, Numbers, Units, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FAMILIES = ("lateral", "axial", "torsional")
TURN = 2.0 * np.pi


def campbell(
    results: object,
    *,
    critical: object = None,
    orders: Sequence[float] = (1.0, 2.0, 3.0),
    to_Hz: float | None = None,
    units: Units | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw natural frequencies and orders of excitation against rotary speed.

    Families differ by colour, backward whirl is dotted; dashed lines from the origin are excitation
    once, twice, three times per revolution. Points are critical speeds.

    Parameters
    ----------
    results
        Modes, or a table like their ``campbell``.
    critical
        A table like ``critical_speeds``, if ``results`` is a table; without one, no critical speeds
        are drawn.
    orders
        Orders of excitation per revolution, used without critical speeds.
    to_Hz
        Highest frequency to draw; by default, a little above the lateral ones.
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
    ...     "branch": [0.0, 0.0],
    ...     "family": ["lateral", "lateral"],
    ...     "rotary_speed_rad_per_s": [0.0, 20.0],
    ...     "frequency_Hz": [1.8, 1.9],
    ... }
    >>> ax = ws.plot.campbell(rows)
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('Rotary speed, rpm', 'Natural frequency, Hz')
    """
    subject = "a Campbell diagram"
    display = Display(units, results)
    columns = Columns(results, "campbell", subject)
    columns.need("branch", "family", "rotary_speed_rad_per_s", "frequency_Hz")
    met = _critical(results, critical, subject)
    frame = single(ax, width_mm=PAGE_MM * 0.75, height_mm=85.0, top_mm=13.0)
    speeds = columns.numbers("rotary_speed_rad_per_s")
    fastest = float(speeds.max()) if len(columns) else 1.0
    top = to_Hz or _top(columns, fastest)
    frame.set_xlim(0.0, float(display.values(np.array(fastest), "rotary speed")))
    frame.set_ylim(0.0, top)
    pushes = sorted(set(met.numbers("order").tolist())) if met is not None else orders
    for order in pushes:
        end = min(fastest, top * TURN / order)
        x = display.values(np.array([0.0, end]), "rotary speed")
        y = np.array([0.0, order * end / TURN])
        frame.plot(x, y, color=colour("muted"), linestyle=stroke(1), linewidth=0.6)
        frame.annotate(
            f"{order:g}x",
            xy=(x[1], y[1]),
            xytext=(-3.0, -3.0),
            textcoords="offset points",
            ha="right",
            va="top",
            **words(SMALL, "muted"),
        )
    named: dict[str, Name] = {}
    backward: list[str] = []
    for branch in dict.fromkeys(columns.numbers("branch").tolist()):
        rows = columns.where(branch=branch)
        family = rows.distinct("family")[0]
        whirl = rows.distinct("whirl")
        ink = line_colour(_place(family))
        x = display.values(rows.numbers("rotary_speed_rad_per_s"), "rotary speed")
        y = rows.numbers("frequency_Hz")
        if "backward" in whirl:
            backward.append(ink)
        dash = stroke(2 if "backward" in whirl else 0)
        frame.plot(x, y, color=ink, linestyle=dash, linewidth=curve_width())
        if y.size and y.max() <= top:
            named[family] = Name(family, ink, x, y, at=0.8)
    if met is not None:
        for family in FAMILIES:
            rows = met.where(family=family)
            hertz = rows.numbers("frequency_Hz")
            x = display.values(rows.numbers("rotary_speed_rad_per_s"), "rotary speed")
            mask = hertz <= top
            ink = line_colour(_place(family))
            frame.plot(x[mask], hertz[mask], "o", color=ink, markersize=3.4)
    _working_speed(frame, results, display)
    label_x(frame, display.label("Rotary speed", "rotary speed"))
    label_y(frame, "Natural frequency, Hz")
    if ax is None:
        heading([frame], case_name(results))
    if backward:
        write([frame], [Key("backward whirl", Look(backward[0], stroke(2)))], own=ax is None)
    name_curves(frame, list(named.values()))
    return cast("Axes", frame)


def modes(
    results: object,
    *,
    family: str = "lateral",
    count: int = 4,
    frequencies: object = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw the shapes of the first modes of a family along the string, depth down.

    A lateral mode has a component towards the high side (solid) and one to its right (dashed).

    Parameters
    ----------
    results
        Modes, or a table like their ``mode_shapes``.
    family
        ``"lateral"``, ``"axial"`` or ``"torsional"``.
    count
        Number of modes to draw.
    frequencies
        A table like ``modes``, if ``results`` is a table; without one, no frequencies are written.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Axes to draw in, one per mode; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per mode.

    Raises
    ------
    ValueError
        If a column or the family is missing, or ``count`` is below 1.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "family": ["torsional", "torsional"],
    ...     "number": [1.0, 1.0],
    ...     "md_m": [0.0, 1200.0],
    ...     "turn_rad": [0.0, 1.0],
    ... }
    >>> (first,) = ws.plot.modes(rows, family="torsional")
    >>> first.get_xlabel(), bool(first.yaxis_inverted())
    ('Mode 1', True)
    """
    if count < 1:
        raise InputError(f"`count` was given {count!r}: expected at least 1")
    subject = "a picture of modes"
    display = Display(units, results)
    columns = Columns(results, "mode_shapes", subject)
    columns.need("family", "number", "md_m")
    there = columns.distinct("family")
    if family not in there:
        raise InputError(f"{subject}: there is no {family!r}: there are {', '.join(there)}")
    rows = columns.where(family=family)
    components = {
        "lateral": ("high_m", "right_m"),
        "axial": ("along_m",),
        "torsional": ("turn_rad",),
    }.get(family, ())
    rows.need(*components)
    numbers = sorted(dict.fromkeys(rows.numbers("number").tolist()))[:count]
    hertz = _frequencies(results, frequencies, family, subject)
    made = (
        frames(
            len(numbers),
            columns=len(numbers),
            width_mm=min(PAGE_MM, 30.0 + 38.0 * len(numbers)),
            height_mm=100.0,
            between_mm=(4.0, 0.0),
            top_mm=21.0,
            bottom_mm=4.0,
            share_y=True,
        )
        if axes is None
        else given(axes, len(numbers), subject)
    )
    depths: list[Numbers] = []
    for ax, number in zip(made, numbers, strict=True):
        mine = rows.where(number=number)
        depth = display.values(mine.numbers("md_m"), "length")
        depths.append(depth)
        for place, column in enumerate(components):
            ax.plot(
                mine.numbers(column),
                depth,
                color=line_colour(place),
                linestyle=stroke(place),
                linewidth=curve_width(),
            )
        ax.axvline(0.0, color=colour("frame"), linewidth=0.6, zorder=0.9)
        ax.set_xlim(-1.1, 1.1)
        title = f"Mode {number:g}"
        label_x(ax, f"{title}: {hertz[number]:.3g} Hz" if number in hertz else title, on_top=True)
    low, high = min(depth.min() for depth in depths), max(depth.max() for depth in depths)
    for place, ax in enumerate(made):
        is_first = place == 0 or axes is not None
        depth_down(ax, depths, display.label("Measured depth", "length") if is_first else "")
        # Lateral modes are those of the assembly alone.
        ax.set_ylim(high, 0.0 if low < 0.05 * high else low)
        if axes is None and place > 0:
            ax.tick_params(labelleft=False)
    if axes is None:
        case = case_name(results)
        heading(made, f"{case}: {family} modes" if case else f"{family.capitalize()} modes")
    if family == "lateral":
        sides = ("towards the high side", "to the right of it")
        looks = [Look(line_colour(place), stroke(place)) for place in (0, 1)]
        write(made, [Key(*pair) for pair in zip(sides, looks, strict=True)], own=axes is None)
    return cast("list[Axes]", made)


def _top(columns: Columns, fastest: float) -> float:
    """Return the highest frequency to draw, such that lateral modes fill the picture."""
    lateral = columns.where(family="lateral").numbers("frequency_Hz")
    every = lateral if lateral.size else columns.numbers("frequency_Hz")
    return 1.15 * max(float(every.max()) if every.size else 0.0, fastest / TURN)


def _place(family: str) -> int:
    return FAMILIES.index(family) if family in FAMILIES else len(FAMILIES)


def _critical(results: object, critical: object, subject: str) -> Columns | None:
    name = "critical_speeds"
    if critical is None and name not in getattr(results, "tables", ()):
        return None
    met = Columns(critical if critical is not None else results, name, subject)
    met.need("order", "rotary_speed_rad_per_s", "frequency_Hz", "family")
    return met


def _frequencies(
    results: object, frequencies: object, family: str, subject: str
) -> Mapping[float, float]:
    if frequencies is None and "modes" not in getattr(results, "tables", ()):
        return {}
    rows = Columns(frequencies if frequencies is not None else results, "modes", subject)
    rows.need("family", "number", "frequency_Hz")
    mine = rows.where(family=family)
    pairs = zip(mine.numbers("number").tolist(), mine.numbers("frequency_Hz").tolist(), strict=True)
    return dict(pairs)


def _working_speed(ax: Drawn, results: object, display: Display) -> None:
    """Draw the rotary speed of the operation, if the results have it."""
    summary = getattr(results, "summary", None)
    if not isinstance(summary, Mapping):
        return
    settings = cast("Mapping[str, Any]", summary).get("settings", {})
    speed = settings.get("operation", {}).get("rotary_speed_rad_per_s")
    if speed:
        at = float(display.values(np.array(speed), "rotary speed"))
        ax.axvline(at, color=colour("muted"), linewidth=0.6, linestyle=(0, (3.3, 2.7)))
