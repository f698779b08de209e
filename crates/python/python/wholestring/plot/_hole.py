"""The hole beside tracks: casing, shoe and rock."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from ._house import SMALL, Drawn, colour, words
from ._shown import Shown


@dataclass(frozen=True)
class Section:
    """A stretch of hole, m."""

    cased: bool
    from_m: float
    to_m: float
    diameter_m: float


def sections(settings: Mapping[str, Any]) -> list[Section]:
    """Give the sections of the hole down to the bit."""
    bit_m = float(settings["operation"]["bit_depth_m"])
    hole = cast("Sequence[Mapping[str, Any]]", settings["well"]["hole"])
    every = (
        Section(
            of["kind"] == "casing",
            max(float(of["from_m"]), 0.0),
            float(of["to_m"]),
            float(of["diameter_m"]),
        )
        for of in hole
    )
    return [of for of in every if of.from_m < bit_m]


def draw(ax: Drawn, hole: Sequence[Section], bit_m: float, shown: Shown) -> None:
    """Draw the hole in a narrow frame whose axis of depth is that of the tracks."""
    ax.grid(False)
    ax.set_xlim(0.0, 1.0)
    ax.xaxis.set_visible(False)
    for spine in ax.spines.values():
        spine.set_visible(False)
    ax.tick_params(left=False, labelleft=False)
    for of in hole:
        ends = shown.values(np.array([of.from_m, min(of.to_m, bit_m)]), "length")
        ax.fill_betweenx(ends, 0.25, 0.75, color=colour("bore"), linewidth=0)
        ink = colour("casing" if of.cased else "rock")
        for side in (0.25, 0.75):
            ax.plot([side, side], ends, color=ink, linewidth=1.6 if of.cased else 0.9)
        if of.cased and of.to_m <= bit_m:
            for side, turn in ((0.25, -1.0), (0.75, 1.0)):
                ax.plot(
                    [side + 0.12 * turn],
                    [ends[1]],
                    marker=(3, 0, 0),
                    markersize=4.0,
                    color=ink,
                    linestyle="none",
                    clip_on=False,
                )
        noun = "casing" if of.cased else "open hole"
        text = f"{noun}, {shown.quantity(of.diameter_m, 'diameter')}"
        middle = 0.5 * float(ends[0] + ends[1])
        frame = ax.get_window_extent()
        top, bottom = ax.transData.transform([(0.0, ends[0]), (0.0, ends[1])])[:, 1]
        drawn = ax.text(
            0.5, middle, text, rotation=90, ha="center", va="center", **words(SMALL, "muted")
        )
        if drawn.get_window_extent().height > min(abs(top - bottom), frame.height) - 4.0:
            drawn.remove()
