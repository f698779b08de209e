"""Figures on matplotlib, in the style of the reports.

Depth points down, axes have units, curves are labelled directly, and their colours are
distinguishable with every type of colour vision. Each function takes results, a
:class:`wholestring.Table`, a data frame or a mapping of columns; draws in the given axes or in a
figure of its own; and returns the axes, to add to or to save::

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
