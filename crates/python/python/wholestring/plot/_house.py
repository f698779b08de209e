"""Colours, strokes and words of figures, from the compiled module."""

from __future__ import annotations

import json
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, TypeAlias, cast

from .. import _core
from ..errors import MissingPackageError

Drawn: TypeAlias = Any
"""Axes of matplotlib, untyped because its own types lack most of the arguments in use here."""

Dash: TypeAlias = "Literal['-'] | tuple[float, tuple[float, float]]"

FAMILIES = ("Helvetica", "Arial", "Arimo", "Liberation Sans", "DejaVu Sans")
TITLE = 9.5
TEXT = 7.5
SMALL = 6.5


@cache
def conventions() -> dict[str, Any]:
    """Return all conventions."""
    return cast("dict[str, Any]", json.loads(_core.conventions()))


def pictures() -> dict[str, Any]:
    """Return the conventions of pictures: colours, strokes and the curves of a run."""
    return cast("dict[str, Any]", conventions()["pictures"])


def colour(name: str) -> str:
    """Return the colour for a light background by its name.

    >>> colour("line-1")
    '#e85800'
    """
    return str(pictures()["colours"][name][0])


def line_colour(place: int) -> str:
    """Return the colour of a curve by its index; the colours repeat after the last."""
    return colour(f"line-{place % pictures()['lines']}")


def curve_width() -> float:
    """Return the width of a curve, points."""
    return float(pictures()["curve"])


def stroke(place: int) -> Dash:
    """Return the stroke of a curve by its index, in the form of matplotlib."""
    strokes = pictures()["strokes"]
    dash = strokes[place % len(strokes)]
    if dash is None:
        return "-"
    # Dashes of matplotlib are in units of the line width.
    width = curve_width()
    return (0.0, (dash[0] / width, dash[1] / width))


@dataclass(frozen=True)
class Look:
    """Colour and stroke of a curve."""

    colour: str
    stroke: Dash = "-"


def operation_colour(operation: str) -> str:
    """Return the colour of an operation, the same in every picture."""
    for look in pictures()["operations"]:
        if look["operation"] == operation:
            return line_colour(look["colour"])
    return line_colour(pictures()["lines"] - 1)


def operation_words(operation: str) -> str:
    """Return an operation in words.

    >>> operation_words("trip_in")
    'trip in'
    """
    for look in pictures()["operations"]:
        if look["operation"] == operation:
            return str(look["words"])
    return operation.replace("_", " ")


def pyplot() -> Any:
    """Return ``matplotlib.pyplot``, or raise an error with the command to install it."""
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        message = "a figure needs matplotlib: pip install matplotlib"
        raise MissingPackageError(message) from error
    return plt


@cache
def family() -> str:
    """Return the first font family of the style that is installed on this machine."""
    pyplot()
    from matplotlib import font_manager

    here = set(font_manager.get_font_names())
    return next((name for name in FAMILIES if name in here), "sans-serif")


def words(size: float, ink: str = "text") -> dict[str, Any]:
    """Return the text properties for a size in points and the name of a colour."""
    return {"fontsize": size, "fontfamily": family(), "color": colour(ink)}


@contextmanager
def style() -> Generator[None]:
    """Apply the style of the figures to axes that are created meanwhile."""
    context = pyplot().rc_context
    look: dict[str, Any] = {
        "axes.edgecolor": colour("frame"),
        "axes.facecolor": colour("paper"),
        "axes.labelcolor": colour("text"),
        "axes.labelsize": TEXT,
        "axes.linewidth": 0.6,
        "axes.titlecolor": colour("text"),
        "axes.titlesize": TITLE,
        "axes.unicode_minus": True,
        "font.family": [family()],
        "font.size": TEXT,
        "grid.color": colour("grid"),
        "grid.linewidth": 0.6,
        "lines.linewidth": curve_width(),
        "svg.fonttype": "none",
        "text.color": colour("text"),
        "xtick.color": colour("frame"),
        "xtick.labelcolor": colour("text"),
        "xtick.labelsize": SMALL,
        "xtick.major.size": 2.5,
        "xtick.major.width": 0.6,
        "ytick.color": colour("frame"),
        "ytick.labelcolor": colour("text"),
        "ytick.labelsize": SMALL,
        "ytick.major.size": 2.5,
        "ytick.major.width": 0.6,
    }
    with context(look):
        yield
