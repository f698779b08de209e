"""The hole next to tracks: casing, shoe and rock."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from ._house import SMALL, Drawn, colour, words
from ._shown import Display


@dataclass(frozen=True)
class Section:
    """A section of the hole, m."""

    cased: bool
    from_m: float
    to_m: float
    diameter_m: float


def sections(settings: Mapping[str, Any]) -> list[Section]:
    """Return the sections of the hole down to the bit."""
    bit_m = float(settings["operation"]["bit_depth_m"])
    hole = cast("Sequence[Mapping[str, Any]]", settings["well"]["hole"])
    every = (
        Section(
            row["kind"] == "casing",
            max(float(row["from_m"]), 0.0),
            float(row["to_m"]),
            float(row["diameter_m"]),
        )
        for row in hole
    )
    return [section for section in every if section.from_m < bit_m]


def draw(ax: Drawn, hole: Sequence[Section], bit_m: float, display: Display) -> None:
    """Draw the hole in a narrow frame that shares the depth axis of the tracks."""
    ax.grid(False)
    ax.set_xlim(0.0, 1.0)
    ax.xaxis.set_visible(False)
    for spine in ax.spines.values():
        spine.set_visible(False)
    ax.tick_params(left=False, labelleft=False)
    for section in hole:
        ends = display.values(np.array([section.from_m, min(section.to_m, bit_m)]), "length")
        ax.fill_betweenx(ends, 0.25, 0.75, color=colour("bore"), linewidth=0)
        ink = colour("casing" if section.cased else "rock")
        for side in (0.25, 0.75):
            ax.plot([side, side], ends, color=ink, linewidth=1.6 if section.cased else 0.9)
        if section.cased and section.to_m <= bit_m:
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
        noun = "casing" if section.cased else "open hole"
        text = f"{noun}, {display.quantity(section.diameter_m, 'diameter')}"
        middle = 0.5 * float(ends[0] + ends[1])
        frame = ax.get_window_extent()
        top, bottom = ax.transData.transform([(0.0, ends[0]), (0.0, ends[1])])[:, 1]
        label = ax.text(
            0.5, middle, text, rotation=90, ha="center", va="center", **words(SMALL, "muted")
        )
        if label.get_window_extent().height > min(abs(top - bottom), frame.height) - 4.0:
            label.remove()
