"""Values so far from all others that an axis that includes them would flatten the curves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ._house import SMALL, Drawn, colour, pictures, words
from ._paper import finite
from ._shown import Numbers


def reached(values: Sequence[Numbers], *, zero: bool) -> tuple[float, float] | None:
    """Return the interval that an axis must include, without outliers; ``None`` without values.

    >>> few = np.array([0.0, 1.0, 900.0])
    >>> reached([few], zero=False)
    (0.0, 900.0)
    >>> reached([np.append(np.linspace(0.0, 1.0, 500), 230.0)], zero=True)
    (0.0, 1.0)
    """
    known = np.sort(finite(values))
    if not known.size:
        return None
    rule = pictures()["rules"]["outliers"]
    whole = (float(known[0]), float(known[-1]))
    if known.size < rule["fewest"]:
        return whole
    tail = int(np.ceil(rule["tail"] * known.size))
    low, high = float(known[tail]), float(known[-1 - tail])
    if zero:
        low, high = min(low, 0.0), max(high, 0.0)
    far = (rule["times_as_long"] - 1.0) * (high - low)
    if far == 0.0:
        return whole
    near = known[(low - known <= far) & (known - high <= far)]
    return float(near[0]), float(near[-1])


def mark(ax: Drawn, curves: Sequence[tuple[Numbers, Numbers, str]]) -> None:
    """Mark values beyond the ends of the horizontal axis: an arrow, and the outermost value.

    ``curves`` has the values, the depths and the colour of each curve; the limits of the axes must
    be final.
    """
    ends = ax.get_xlim()
    for end, sign, marker in ((ends[0], -1.0, "<"), (ends[1], 1.0, ">")):
        outermost: tuple[float, float] | None = None
        for across, depth, ink in curves:
            beyond = np.flatnonzero(sign * (across - end) > 0.0)
            if not beyond.size:
                continue
            # The outermost value of every run of values beyond the end.
            for run in np.split(beyond, np.flatnonzero(np.diff(beyond) > 1) + 1):
                at = run[np.argmax(sign * across[run])]
                ax.plot([end], [depth[at]], marker, color=ink, markersize=4.0, clip_on=False)
                if outermost is None or sign * across[at] > sign * outermost[0]:
                    outermost = (float(across[at]), float(depth[at]))
        if outermost is not None:
            ax.annotate(
                f"{outermost[0]:.3g}".replace("-", "\N{MINUS SIGN}"),
                xy=(end, outermost[1]),
                xytext=(-5.0 * sign, 0.0),
                textcoords="offset points",
                ha="right" if sign > 0.0 else "left",
                va="center",
                bbox={"facecolor": colour("paper"), "alpha": 0.75, "linewidth": 0, "pad": 0.5},
                **words(SMALL),
            )
