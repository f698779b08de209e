"""Figures on matplotlib, as the house draws them.

Depth points down, axes name their units, curves have their names beside them, and their colours
are told apart by every eye. Each function takes results, a :class:`wholestring.Table`, a data frame
or a mapping of columns; draws in the axes that it is given, or in a figure of its own; and gives
the axes back, for you to add to or to save::

    ax = ws.plot.broomstick(plan)
    ax.figure.savefig("broomstick.svg")
"""

from ._shown import Units
from .broomstick import broomstick
from .calibration import calibration
from .compare import compare
from .modes import campbell, modes
from .reach import reach
from .spectrum import spectrum
from .sweep import sweep
from .time import time
from .tracks import tracks
from .well import well

__all__ = [
    "Units",
    "broomstick",
    "calibration",
    "campbell",
    "compare",
    "modes",
    "reach",
    "spectrum",
    "sweep",
    "time",
    "tracks",
    "well",
]
