"""What the verbs that leave a folder have in common."""

from __future__ import annotations

import operator
from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import TypeVar

from . import _core, _values
from ._base import BaseResults
from ._folder import Place
from ._listener import Listener
from ._values import Scalar
from .errors import InputError, InputTypeError, Interrupted, NoAnswerError, ResultsError

R = TypeVar("R", bound=BaseResults)

Folder = str | PathLike[str] | None

MOST_JOBS = 1024
"""More threads than any machine has cores have a mistake for their cause."""


def common(
    place: Place,
    *,
    units: str | None = None,
    jobs: int | None = None,
    checkpoint: Scalar | None = None,
    shard: str | None = None,
    csv: bool = False,
    png: bool = False,
) -> _core.Common:
    """Give what all commands take, as the compiled half takes it."""
    return {
        "folder": place.path,
        "existing": place.existing,
        "units": units,
        "jobs": count(jobs),
        "checkpoint_s": _values.option("checkpoint", checkpoint, "time"),
        "shard": shard,
        "csv": csv,
        "png": png,
    }


def count(jobs: int | None) -> int | None:
    """Give the number of threads, if it is one."""
    if jobs is None:
        return None
    try:
        number = operator.index(jobs)
    except TypeError:
        message = f"`jobs` was given {jobs!r}: expected a whole number from 1 to {MOST_JOBS}"
        raise InputTypeError(message) from None
    if not 1 <= number <= MOST_JOBS:
        message = f"`jobs` was given {number}: expected a whole number from 1 to {MOST_JOBS}"
        raise InputError(message)
    return number


def carry_out(
    kind: type[R],
    place: Place,
    progress: bool,
    work: Callable[[Listener], tuple[Path | None, BaseException | None]],
) -> R:
    """Do the work of a command, and give what it came to."""
    with Listener(progress) as listener:
        folder, raised = work(listener)
    return finished(found(kind, place, folder), raised)


def found(kind: type[R], place: Place, folder: Path | None) -> R | None:
    """Give what lies in a folder; nothing where the work ended before it left anything."""
    if folder is None:
        return None
    try:
        return kind(_core.Answers.load(folder), place)
    except ResultsError:
        return None


def finished(results: R | None, raised: BaseException | None) -> R:
    """Give the results, or raise what was raised, with them."""
    if isinstance(raised, KeyboardInterrupt):
        kept = "nothing was computed yet" if results is None else "`results` has what was computed"
        raised = Interrupted(f"interrupted: {kept}")
    if isinstance(raised, Interrupted | NoAnswerError):
        raised.results = results
    if raised is not None:
        raise raised
    if results is None:
        raise ResultsError("the results that were just written cannot be read")
    return results
