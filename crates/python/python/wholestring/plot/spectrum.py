"""Power spectral densities."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

import numpy as np

from ..errors import InputError
from ._columns import Columns
from ._house import curve_width, line_colour, operation_words, stroke
from ._labels import Name, name_curves
from ._paper import COLUMN_MM, PAGE_MM, frames, given, heading, label_x, label_y
from ._shown import Display, Numbers, Units, about, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def spectrum(
    results: object,
    *signals: str,
    operation: str | None = None,
    to_Hz: float | None = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw power spectral densities of signals over the window of the statistics.

    The case must request them: ``records.spectra = ["hook_load", "surface_torque"]``.

    Parameters
    ----------
    results
        Results, or a table like their ``spectra``.
    *signals
        ``"hook_load"``, ``"surface_torque"``, ...; all by default.
    operation
        The operation, if there are several.
    to_Hz
        Highest frequency to draw; all by default.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Axes to draw in, one per signal; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per signal.

    Raises
    ------
    ValueError
        If there are no spectra, or none of that signal or operation.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "signal": ["hook_load", "hook_load"],
    ...     "unit": ["N", "N"],
    ...     "frequency_Hz": [0.1, 0.2],
    ...     "density": [4.0e6, 1.0e6],
    ... }
    >>> (ax,) = ws.plot.spectrum(rows)
    >>> ax.get_ylabel()
    'Hook load without block, kN²/Hz'
    """
    subject = "a picture of spectra"
    display = Display(units, results)
    columns = Columns(results, "spectra", subject)
    columns.need("signal", "unit", "frequency_Hz", "density")
    solved = columns.distinct("operation")
    if operation is not None and operation not in solved:
        raise InputError(f"{subject}: there is no {operation!r}: there are {', '.join(solved)}")
    if operation is None and len(solved) > 1:
        raise InputError(f"{subject} is of one operation: name one of {', '.join(solved)}")
    one = operation or (solved[0] if solved else None)
    rows = columns.where(operation=one)
    there = rows.distinct("signal")
    for signal in signals:
        if signal not in there:
            signal_names = ", ".join(there)
            raise InputError(f"{subject}: there is no signal {signal!r}: there are {signal_names}")
    shows = list(signals) or there
    count = len(shows)
    across = 1 if count == 1 else 2
    made = (
        frames(
            count,
            columns=across,
            width_mm=PAGE_MM if across > 1 else COLUMN_MM + 20.0,
            height_mm=60.0,
            between_mm=(18.0, 14.0),
            top_mm=9.0,
            left_mm=16.0,
        )
        if axes is None
        else given(axes, count, subject)
    )
    for ax, signal in zip(made, shows, strict=True):
        mine = rows.where(signal=signal)
        title, dimension = _about(signal, mine)
        factor = display.factor(dimension) ** 2
        lowest, highest = np.inf, -np.inf
        named: list[Name] = []
        for place, (md_m, nodes) in enumerate(_nodes(mine)):
            hertz = nodes.numbers("frequency_Hz")
            mask = (hertz > 0.0) & (hertz <= (np.inf if to_Hz is None else to_Hz))
            hertz, density = hertz[mask], nodes.numbers("density")[mask] / factor
            ink = line_colour(place)
            ax.plot(hertz, density, color=ink, linestyle=stroke(place), linewidth=curve_width())
            if md_m is not None:
                text = display.quantity(md_m, "length")
                named.append(Name(text, ink, hertz, np.log10(np.maximum(density, 1e-300)), 0.7))
            if hertz.size:
                lowest, highest = min(lowest, hertz.min()), max(highest, hertz.max())
        ax.set_yscale("log")
        if highest > lowest:
            ax.set_xlim(0.0, highest)
        label_x(ax, "Frequency, Hz")
        symbol = display.symbol(dimension)
        unit = f"({symbol})²/Hz" if "/" in symbol or "·" in symbol else f"{symbol}²/Hz"
        label_y(ax, f"{title}, {unit if symbol else '1/Hz'}")
        name_curves(ax, [_in_data(name) for name in named])
    if axes is None:
        words = operation_words(one) if one else ""
        heading(made, ": ".join(part for part in (case_name(results), words) if part))
    return cast("list[Axes]", made)


def _nodes(rows: Columns) -> list[tuple[float | None, Columns]]:
    """Return the rows of a scalar, or those of each node with its measured depth, m."""
    if "md_m" not in rows:
        return [(None, rows)]
    every = rows.numbers("md_m")
    depths = list(dict.fromkeys(depth for depth in every.tolist() if np.isfinite(depth)))
    if not depths:
        return [(None, rows)]
    return [(depth, rows.where(md_m=depth)) for depth in depths]


def _about(signal: str, rows: Columns) -> tuple[str, str]:
    """Return title and dimension of a signal, whose name is a column name without the unit."""
    unit = rows.words("unit")[0]
    for sign, name in (("·", "_"), ("/", "_per_"), ("²", "2"), ("³", "3")):
        unit = unit.replace(sign, name)
    return about(f"{signal}_{unit}")


def _in_data(name: Name) -> Name:
    values: Numbers = 10.0**name.y
    return Name(name.text, name.colour, name.x, values, name.at)
