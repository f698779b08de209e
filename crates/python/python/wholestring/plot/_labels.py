"""Labels at curves, in the places with the least overlap."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ._house import SMALL, Drawn, colour, family
from ._shown import Numbers

Box = tuple[float, float, float, float]

HALO = 2.0
GAP = 3.0
TRIED = 40


@dataclass(frozen=True)
class Name:
    """The label of a curve.

    Attributes
    ----------
    text, colour
        Text of the label and its colour.
    x, y
        Points of the curve, in data coordinates.
    at
        Preferred position along the curve: 0 at its beginning, 1 at its end.
    """

    text: str
    colour: str
    x: Numbers
    y: Numbers
    at: float = 1.0


def name_curves(ax: Drawn, names: Sequence[Name], *, size: float = SMALL) -> None:
    """Write the labels at their curves; limits and positions of all axes must be final."""
    from matplotlib import patheffects

    curves = _pixels(ax)
    frame = ax.get_window_extent()
    inside: Box = (frame.x0 + 1.0, frame.y0 + 1.0, frame.x1 - 1.0, frame.y1 - 1.0)
    taken: list[Box] = []
    point = ax.figure.dpi / 72.0
    for name in names:
        points = np.column_stack((name.x, name.y))
        points = points[np.isfinite(points).all(axis=1)]
        if not len(points):
            continue
        text = ax.annotate(
            name.text,
            xy=points[0],
            xytext=(0.0, 0.0),
            textcoords="offset pixels",
            fontsize=size,
            fontfamily=family(),
            color=name.colour,
            ha="left",
            va="bottom",
            annotation_clip=False,
            path_effects=[patheffects.withStroke(linewidth=HALO, foreground=colour("paper"))],
        )
        extent = text.get_window_extent()
        at, offset, box = _best(
            _along(ax.transData.transform(points)),
            (extent.width, extent.height),
            (curves, taken, inside),
            name.at,
            GAP * point,
        )
        anchor = ax.transData.inverted().transform(at)
        text.xy = tuple(anchor)
        # In points, so that the position does not depend on the resolution.
        text.set_position((offset[0] / point, offset[1] / point))
        text.anncoords = "offset points"
        taken.append(box)


def _along(pixels: Numbers) -> Numbers:
    """Return evenly spaced points along a curve on the page."""
    steps = np.hypot(*np.diff(pixels, axis=0).T) if len(pixels) > 1 else np.zeros(0)
    way = np.concatenate(([0.0], np.cumsum(steps)))
    whole = float(way[-1])
    if whole == 0.0:
        return pixels[:1]
    at: Numbers = np.linspace(0.0, whole, TRIED, dtype=np.float64)
    return np.column_stack([np.interp(at, way, pixels[:, axis]) for axis in (0, 1)])


def _pixels(ax: Drawn) -> Numbers:
    """Return closely spaced points along all curves of a frame."""
    every: list[Numbers] = [np.zeros((0, 2), dtype=np.float64)]
    for line in ax.get_lines():
        data = np.column_stack(line.get_data(orig=False))
        points: Numbers = line.get_transform().transform(data)
        points = points[np.isfinite(points).all(axis=1)]
        if len(points) < 2:
            every.append(points)
            continue
        steps = np.hypot(*np.diff(points, axis=0).T)
        way = np.concatenate(([0.0], np.cumsum(steps)))
        whole = float(way[-1])
        count = int(min(max(whole / 2.0, 2.0), 4000.0))
        at: Numbers = np.linspace(0.0, whole, count, dtype=np.float64)
        every.append(np.column_stack([np.interp(at, way, points[:, axis]) for axis in (0, 1)]))
    return np.concatenate(every)


def _best(
    anchors: Numbers,
    size: tuple[float, float],
    obstacles: tuple[Numbers, list[Box], Box],
    preferred: float,
    gap: float,
) -> tuple[Numbers, tuple[float, float], Box]:
    """Return anchor, offset and box of the position with the least overlap."""
    width, height = size
    curves, taken, frame = obstacles
    offsets = [
        (gap, -0.5 * height),
        (-gap - width, -0.5 * height),
        (-0.5 * width, gap),
        (-0.5 * width, -gap - height),
        (gap, gap),
        (-gap - width, gap),
        (gap, -gap - height),
        (-gap - width, -gap - height),
    ]
    best: tuple[float, Numbers, tuple[float, float], Box] | None = None
    last = max(len(anchors) - 1, 1)
    for place, anchor in enumerate(anchors):
        for rank, offset in enumerate(offsets):
            left, bottom = anchor[0] + offset[0], anchor[1] + offset[1]
            box: Box = (left, bottom, left + width, bottom + height)
            cost = 12.0 * abs(place / last - preferred) + 0.05 * rank
            cost += 2.0 * _inside(curves, box)
            cost += sum(40.0 + _shared(box, other) for other in taken if _shared(box, other) > 0.0)
            outside = width * height - _shared(box, frame)
            if outside > 0.5:
                cost += 60.0 + outside
            if best is None or cost < best[0]:
                best = (cost, anchor, offset, box)
    assert best is not None
    return best[1], best[2], best[3]


def _inside(points: Numbers, box: Box) -> int:
    x, y = points[:, 0], points[:, 1]
    return int(((x > box[0]) & (x < box[2]) & (y > box[1]) & (y < box[3])).sum())


def _shared(a: Box, b: Box) -> float:
    """Return the area that two boxes share."""
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    return max(width, 0.0) * max(height, 0.0)
