"""Figures and axes in the style of the reports."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..errors import InputError
from ._house import SMALL, TEXT, TITLE, Drawn, colour, family, pyplot, style, words
from ._shown import Numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INCH = 25.4
PAGE_MM = 180.0
COLUMN_MM = 85.0
# Margins of a frame for its labels, mm.
LEFT, RIGHT, TOP, BOTTOM, BETWEEN = 14.0, 4.0, 12.0, 10.0, 5.0


def frames(
    count: int,
    *,
    columns: int,
    width_mm: float,
    height_mm: float,
    between_mm: tuple[float, float] = (BETWEEN, BETWEEN),
    widths: Sequence[float] | None = None,
    top_mm: float = TOP,
    left_mm: float = LEFT,
    right_mm: float = RIGHT,
    bottom_mm: float = BOTTOM,
    share_x: bool = False,
    share_y: bool = False,
) -> list[Drawn]:
    """Make a figure with ``count`` frames of the same height, and return its axes."""
    plt = pyplot()
    lines = -(-count // columns)
    across, down = between_mm
    free_mm = width_mm - left_mm - right_mm - across * (columns - 1)
    parts = np.asarray(widths if widths is not None else [1.0] * columns, dtype=float)
    parts = parts / parts.sum() * free_mm
    whole_mm = top_mm + bottom_mm + lines * height_mm + (lines - 1) * down
    # Outside the style, because the first figure configures how a notebook displays all figures.
    figure: Any = plt.figure(figsize=(width_mm / INCH, whole_mm / INCH), facecolor=colour("paper"))
    made: list[Drawn] = []
    with style():
        for place in range(count):
            row, column = divmod(place, columns)
            left = left_mm + float(parts[:column].sum()) + across * column
            bottom = whole_mm - top_mm - (row + 1) * height_mm - row * down
            box = (left / width_mm, bottom / whole_mm, parts[column] / width_mm)
            first = made[0] if made else None
            made.append(
                figure.add_axes(
                    (*box, height_mm / whole_mm),
                    sharex=first if share_x else None,
                    sharey=first if share_y else None,
                )
            )
    for ax in made:
        dress(ax)
    return made


def given(axes: Sequence[Axes] | Axes, count: int, subject: str) -> list[Drawn]:
    """Return the caller's axes; there must be ``count`` of them."""
    all_ = list(cast("Any", axes).flat) if isinstance(axes, np.ndarray) else None
    if all_ is None:
        all_ = list(axes) if isinstance(axes, Sequence) else [axes]
    if len(all_) != count:
        noun = "frame" if count == 1 else "frames"
        raise InputError(f"{subject} here has {count} {noun} and was given {len(all_)} axes")
    for ax in all_:
        dress(ax)
    return cast("list[Drawn]", all_)


def single(
    ax: Axes | None, *, width_mm: float = COLUMN_MM, height_mm: float = 60.0, top_mm: float = 8.0
) -> Drawn:
    """Return the caller's axes, or those of a new figure."""
    if ax is None:
        return frames(1, columns=1, width_mm=width_mm, height_mm=height_mm, top_mm=top_mm)[0]
    dress(ax)
    return ax


def dress(ax: Drawn) -> None:
    """Apply frame, grid and fonts of the style to axes."""
    ax.grid(True, color=colour("grid"), linewidth=0.6)
    ax.set_axisbelow(True)
    ax.tick_params(labelsize=SMALL, color=colour("frame"), labelcolor=colour("text"), width=0.6)
    for axis in ("x", "y"):
        ax.tick_params(axis=axis, labelfontfamily=family())
    for spine in ax.spines.values():
        spine.set_color(colour("frame"))
        spine.set_linewidth(0.6)


def label_x(ax: Drawn, text: str, *, on_top: bool = False) -> None:
    """Label the horizontal axis."""
    if on_top:
        ax.xaxis.tick_top()
        ax.xaxis.set_label_position("top")
    ax.set_xlabel(text, labelpad=2.5, **words(TEXT))


def label_y(ax: Drawn, text: str) -> None:
    """Label the vertical axis."""
    label = ax.set_ylabel(text, labelpad=2.5, **words(TEXT))
    if label.get_window_extent().height > ax.get_window_extent().height:
        label.set_text(halved(text))


def halved(text: str) -> str:
    r"""Return a text in two lines of nearly equal length.

    >>> halved("Neutral point and cut-off depth, m")
    'Neutral point and\ncut-off depth, m'
    """
    gaps = [at for at, letter in enumerate(text) if letter == " "]
    if not gaps:
        return text
    middle = min(gaps, key=lambda at: abs(2 * at - len(text)))
    return text[:middle] + "\n" + text[middle + 1 :]


def title(ax: Drawn, text: str) -> None:
    """Set a title above a frame."""
    ax.set_title(text, loc="left", **words(TITLE))


def heading(axes: Sequence[Drawn], text: str) -> None:
    """Set the name of the case above a figure made here."""
    figure = axes[0].figure
    height_mm = figure.get_size_inches()[1] * INCH
    left = min(ax.get_position().x0 for ax in axes)
    figure.text(left, 1.0 - 4.5 / height_mm, text, va="center", **words(TITLE))


def finite(values: Sequence[Numbers]) -> Numbers:
    """Return all finite numbers of several columns."""
    if not values:
        return np.zeros(0)
    every: Numbers = np.concatenate([np.ravel(column) for column in values])
    known: Numbers = every[np.isfinite(every)]
    return known


def limits(
    values: Sequence[Numbers], *, zero: bool = False, min_span: float = 0.0
) -> tuple[float, float]:
    """Return the limits of an axis: a little beyond the values, extended to zero if that is near.

    >>> limits([np.array([0.0, 100.0])])
    (0.0, 104.0)
    >>> limits([np.array([100.0, 100.1])], min_span=20.0)
    (89.25, 110.85)
    """
    known = finite(values)
    if not known.size:
        return (0.0, 1.0)
    low, high = float(known.min()), float(known.max())
    if zero or (low > 0.0 and low < 0.25 * high):
        low = min(low, 0.0)
    if zero or (high < 0.0 and high > 0.25 * low):
        high = max(high, 0.0)
    span = high - low
    if span < min_span:
        middle = 0.5 * (low + high)
        if low == 0.0:
            high = min_span
        elif high == 0.0:
            low = -min_span
        else:
            low, high = middle - 0.5 * min_span, middle + 0.5 * min_span
        span = min_span
    if span == 0.0:
        span = abs(high) or 1.0
    beyond = 0.04 * span
    return (low if low == 0.0 else low - beyond, high if high == 0.0 else high + beyond)


def depth_down(ax: Drawn, depths: Sequence[Numbers], text: str) -> None:
    """Set the depth axis, pointing down, from the least to the largest depth."""
    known = finite(depths)
    top, bottom = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
    # A string begins at the surface, or one node length below it.
    if top < 0.05 * bottom:
        top = 0.0
    if top == bottom:
        top, bottom = top - 1.0, bottom + 1.0
    ax.set_ylim(bottom, top)
    label_y(ax, text)
