"""Keys of strokes and areas, for curves that cannot be labelled directly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ._house import TEXT, Drawn, Look, curve_width, family, pictures

INCH = 25.4


@dataclass(frozen=True)
class Key:
    """A sample and its meaning.

    Attributes
    ----------
    text
        Meaning of the sample.
    look
        Colour and stroke of the sample.
    area
        Whether it is an area rather than a line.
    alpha
        Opacity of an area.
    marker
        Marker of single points; empty for a line.
    """

    text: str
    look: Look
    area: bool = False
    alpha: float = 1.0
    marker: str = ""


def band_key(look: Look, text: str = "5–95 % of the time") -> Key:  # noqa: RUF001
    """Return the key of a band."""
    return Key(text, look, area=True, alpha=float(pictures()["band"]))


def write(axes: Sequence[Drawn], keys: Sequence[Key], *, own: bool, top_mm: float = 9.5) -> None:
    """Write keys above a figure made here, or in the first of the caller's axes."""
    if not keys:
        return
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handles: list[object] = []
    for key in dict.fromkeys(keys):
        if key.area:
            handles.append(
                Patch(facecolor=key.look.colour, alpha=key.alpha, linewidth=0, label=key.text)
            )
            continue
        handles.append(
            Line2D(
                [],
                [],
                color=key.look.colour,
                linestyle="none" if key.marker else key.look.stroke,
                linewidth=curve_width(),
                marker=key.marker,
                markersize=4.0,
                label=key.text,
            )
        )
    look = {
        "frameon": False,
        "prop": {"family": family(), "size": TEXT},
        "handlelength": 2.4,
        "borderaxespad": 0.0,
        "borderpad": 0.0,
        "columnspacing": 1.4,
        "handletextpad": 0.5,
    }
    if not own:
        axes[0].legend(handles=handles, loc="best", **look)
        return
    figure = axes[0].figure
    height_mm = figure.get_size_inches()[1] * INCH
    left = min(ax.get_position().x0 for ax in axes)
    figure.legend(
        handles=handles,
        loc="center left",
        bbox_to_anchor=(left, 1.0 - top_mm / height_mm),
        bbox_transform=figure.transFigure,
        ncols=len(handles),
        **look,
    )
