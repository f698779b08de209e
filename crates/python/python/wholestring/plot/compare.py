"""Several runs on the same axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..errors import InputError
from ._columns import Columns
from ._shown import Units, case_name
from .tracks import draw

if TYPE_CHECKING:
    from matplotlib.axes import Axes

USUAL = ("tension", "torque", "side-force")


def compare(
    *results: object,
    names: Sequence[str] | None = None,
    show: Sequence[str] = USUAL,
    operation: str | None = None,
    models: Sequence[str] | None = None,
    units: Units | None = None,
    axes: Sequence[Axes] | Axes | None = None,
) -> list[Axes]:
    """Draw the profiles of several runs on the same tracks: a colour and a stroke per run.

    Parameters
    ----------
    *results
        Results, or tables like their ``nodes``: two to seven.
    names
        Names of the runs; by default, the names of their cases if they differ, otherwise numbers.
    show
        Names of the tracks to draw, as in :func:`tracks`.
    operation
        The operation, if the runs have several in common.
    models
        Models to draw; all by default.
    units
        ``"si"``, ``"metric"`` or ``"field"``; those of the first case by default.
    axes
        Axes to draw in, one per name in ``show``; those of a new figure by default.

    Returns
    -------
    list of matplotlib.axes.Axes
        One per track.

    Raises
    ------
    ValueError
        If the runs have no operation in common, or have several and ``operation`` is missing.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example()
    >>> runs = [case.with_(friction=friction).soft("trip_out") for friction in (0.2, 0.3)]
    >>> (tension,) = ws.plot.compare(*runs, names=["0.2", "0.3"], show=["tension"])
    >>> [text.get_text() for text in tension.texts]
    ['0.2', '0.3']
    """
    subject = "a comparison"
    if not 2 <= len(results) <= 7:
        raise InputError(f"{subject} is of two to seven runs, and was given {len(results)}")
    called = list(names) if names is not None else _names(results)
    if len(called) != len(results):
        raise InputError(f"{subject} of {len(results)} runs was given {len(called)} names")
    return draw(
        results,
        called,
        show,
        operations=_operation(results, operation, subject),
        models=models,
        units=units,
        to=axes,
    )


def _names(results: Sequence[object]) -> list[str]:
    cases = [case_name(run) for run in results]
    different = len(set(cases)) == len(cases) and all(cases)
    return cases if different else [f"run {place + 1}" for place in range(len(results))]


def _operation(results: Sequence[object], operation: str | None, subject: str) -> list[str] | None:
    every = [Columns(run, "nodes", subject).distinct("operation") for run in results]
    if not any(every):
        return None
    common = [name for name in every[0] if all(name in others for others in every)]
    if operation is not None:
        if operation not in common:
            there = ", ".join(common) or "none"
            raise InputError(f"{subject}: not all have {operation!r}; in common they have {there}")
        return [operation]
    if not common:
        raise InputError(f"{subject}: the runs have no operation in common")
    if len(common) > 1:
        raise InputError(f"{subject} is of one operation: name one of {', '.join(common)}")
    return common
