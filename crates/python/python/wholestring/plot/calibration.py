"""Readings at the surface, with the predictions of the calibrated model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from ._columns import Columns
from ._house import Drawn, Look, colour, curve_width, operation_colour, pictures
from ._keys import Key, band_key, write
from ._labels import Name, name_curves
from ._paper import PAGE_MM, depth_down, frames, given, heading, label_x, limits
from ._shown import Display, Numbers, Units, case_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MARKERS = ("o", "s", "^", "D", "v")


@dataclass(frozen=True)
class Reading:
    """A kind of reading at the surface.

    Attributes
    ----------
    name, words
        Name in tables, and label.
    colour, marker
        Look of the points.
    """

    name: str
    words: str
    colour: str
    marker: str

    @property
    def is_torque(self) -> bool:
        """Whether it is a torque rather than a weight."""
        return self.name.startswith("torque")


def calibration(
    results: object,
    *,
    bands: object = None,
    units: Units | None = None,
    axes: Sequence[Axes] | None = None,
) -> list[Axes]:
    """Draw readings against the depth of the bit, and the predictions of the calibrated model.

    Points are readings; grey points were excluded from the fit. A line is the prediction; its inner
    band is that of the mean, its outer band that of a reading.

    Parameters
    ----------
    results
        A calibration, or a table like its ``calibration``.
    bands
        A table like ``calibration_bands``, if ``results`` is a table; without one, no bands are
        drawn.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the case by default.
    axes
        Two axes to draw in, weights and torques, or one where no torque was read; those of a new
        figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        Weights, and torques if there are any.

    Raises
    ------
    ValueError
        If a column is missing.

    Examples
    --------
    >>> import wholestring as ws
    >>> rows = {
    ...     "reading": ["pick_up", "slack_off"],
    ...     "bit_depth_m": [1500.0, 1500.0],
    ...     "measured_N": [8.1e5, 6.9e5],
    ... }
    >>> (weights,) = ws.plot.calibration(rows, units="field")
    >>> weights.get_xlabel()
    'Weight with block, klbf'
    """
    subject = "a picture of a calibration"
    display = Display(units, results)
    read = Columns(results, "calibration", subject)
    read.need("reading", "bit_depth_m")
    predicted = _bands(results, bands, subject)
    there = set(read.distinct("reading"))
    kinds = [False, True] if any(name.startswith("torque") for name in there) else [False]
    count = len(kinds)
    made = (
        frames(
            count,
            columns=count,
            width_mm=PAGE_MM if count > 1 else 100.0,
            height_mm=100.0,
            between_mm=(8.0, 0.0),
            top_mm=21.0,
            bottom_mm=4.0,
            share_y=True,
        )
        if axes is None
        else given(axes, count, subject)
    )
    depths: list[Numbers] = []
    for ax, torques in zip(made, kinds, strict=True):
        _frame(ax, (read, predicted), torques, display, depths)
    for place, ax in enumerate(made):
        is_first = place == 0 or axes is not None
        text = display.label("Measured depth of the bit", "length") if is_first else ""
        depth_down(ax, depths, text)
        bottom, top = ax.get_ylim()
        beyond = 0.03 * (bottom - top)
        ax.set_ylim(bottom + beyond, max(top - beyond, 0.0))
        if axes is None and place > 0:
            ax.tick_params(labelleft=False)
    if axes is None:
        heading(made, case_name(results))
    ink = Look(colour("muted"))
    keys = [Key("read", ink, marker="o")]
    if predicted is not None:
        keys = [Key("read", ink, marker="o"), Key("predicted", ink)]
        keys.append(band_key(ink, "bands of mean and reading"))
    write(made, keys, own=axes is None)
    return cast("list[Axes]", made)


def _frame(
    ax: Drawn,
    tables: tuple[Columns, Columns | None],
    torques: bool,
    display: Display,
    depths: list[Numbers],
) -> None:
    read, predicted = tables
    suffix, dimension = ("N_m", "torque") if torques else ("N", "force")
    every: list[Numbers] = []
    named: list[Name] = []
    title = "Torque" if torques else "Weight with block"
    label_x(ax, display.label(title, dimension), on_top=True)
    readings = [reading for reading in _readings() if reading.is_torque == torques]
    readings = [reading for reading in readings if reading.name in read.distinct("reading")]
    for reading in readings:
        if predicted is not None:
            rows = predicted.where(reading=reading.name)
            for case in rows.distinct("case") or [""]:
                mine = rows.where(case=case or None)
                if not len(mine):
                    continue
                curve = _predicted(ax, mine, reading, (suffix, dimension), display, every)
                depths.append(curve[1])
                named = [name for name in named if name.text != reading.words]
                named.append(Name(reading.words, reading.colour, *curve, at=0.9))
    for reading in readings:
        rows = read.where(reading=reading.name)
        used = rows.numbers("used") > 0.0 if "used" in rows else np.ones(len(rows), dtype=bool)
        values = display.values(rows.numbers(f"measured_{suffix}"), dimension)
        depth = display.values(rows.numbers("bit_depth_m"), "length")
        every.append(values)
        depths.append(depth)
        for mask, ink in ((used, reading.colour), (~used, colour("muted"))):
            ax.plot(
                values[mask],
                depth[mask],
                reading.marker,
                color=ink,
                markersize=3.6,
                markeredgecolor=colour("paper"),
                markeredgewidth=0.4,
            )
        if reading.words not in {name.text for name in named} and values.size:
            named.append(Name(reading.words, reading.colour, values, depth, at=0.9))
    ax.set_xlim(*limits(every))
    depth_down(ax, depths, "")
    name_curves(ax, named)


def _predicted(
    ax: Drawn,
    rows: Columns,
    reading: Reading,
    kind: tuple[str, str],
    display: Display,
    every: list[Numbers],
) -> tuple[Numbers, Numbers]:
    suffix, dimension = kind
    depth = display.values(rows.numbers("bit_depth_m"), "length")
    alpha = float(pictures()["band"])
    for band in ("reading", "mean"):
        low, high = (
            display.values(rows.numbers(f"{band}_{end}_{suffix}"), dimension)
            for end in ("low", "high")
        )
        every.extend((low, high))
        ax.fill_betweenx(depth, low, high, color=reading.colour, alpha=alpha, linewidth=0)
    values = display.values(rows.numbers(f"predicted_{suffix}"), dimension)
    ax.plot(values, depth, color=reading.colour, linewidth=curve_width())
    return values, depth


def _bands(results: object, bands: object, subject: str) -> Columns | None:
    if bands is not None:
        return Columns(bands, "calibration_bands", subject)
    if "calibration_bands" in getattr(results, "tables", ()):
        return Columns(results, "calibration_bands", subject)
    return None


def _readings() -> list[Reading]:
    return [
        Reading(name, words, operation_colour(operation), MARKERS[place])
        for place, (name, words, operation) in enumerate(pictures()["readings"])
    ]
