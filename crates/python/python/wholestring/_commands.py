"""Common parts of the methods that write a folder."""

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
"""Largest number of threads: more than any machine has cores, so a larger one is a mistake."""


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
    """Return the options common to all commands, in the form of the compiled module."""
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
    """Return the number of threads after checking it."""
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
    """Run a command and return its results."""
    with Listener(progress) as listener:
        folder, raised = work(listener)
    return finished(found(kind, place, folder), raised)


def found(kind: type[R], place: Place, folder: Path | None) -> R | None:
    """Return the results in a folder; ``None`` if the work ended before it wrote any."""
    if folder is None:
        return None
    try:
        return kind(_core.Answers.load(folder), place)
    except ResultsError:
        return None


def finished(results: R | None, raised: BaseException | None) -> R:
    """Return the results, or raise the exception that was raised, with the results."""
    if isinstance(raised, KeyboardInterrupt):
        extent = "no results yet" if results is None else "`results` holds the results so far"
        raised = Interrupted(f"interrupted: {extent}")
    if isinstance(raised, Interrupted | NoAnswerError):
        raised.results = results
    if raised is not None:
        raise raised
    if results is None:
        raise ResultsError("the results that were just written cannot be read")
    return results
