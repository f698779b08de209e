"""Common parts of the methods that write a folder."""

from __future__ import annotations

import json
import operator
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
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


@dataclass(frozen=True)
class Job:
    """A command of the program with its options, as the runner reads it."""

    work: Mapping[str, object]
    """The command under ``kind``, and its options; ``None`` stands for the default."""

    cases: Sequence[_core.Case] = ()
    """Cases; the command names them by their numbers."""

    paths: Mapping[str, str | PathLike[str]] = field(
        default_factory=dict[str, "str | PathLike[str]"]
    )
    """Paths of other files by their names in the options."""

    content: bytes | None = None
    """Content of the readings that are not a file."""

    changes: Sequence[tuple[str, str | None]] = ()
    """Changes of every case of a study."""

    units: str | None = None
    jobs: int | None = None
    checkpoint: Scalar | None = None

    def text(self, existing: str) -> str:
        """Return the job as JSON, with the treatment of existing results in its folder."""
        settings = {
            "case": "0" if self.cases else None,
            "work": {key: value for key, value in self.work.items() if value is not None},
            "output": {"existing": existing},
            "units": self.units,
            "jobs": count(self.jobs),
            "checkpoint": quantity("checkpoint", self.checkpoint, "time"),
        }
        return json.dumps({key: value for key, value in settings.items() if value is not None})


def carry_out(kind: type[R], place: Place, job: Job, *, progress: bool = False) -> R:
    """Run a command and return its results."""
    results, raised, _ = attempted(kind, place, job, progress=progress)
    return finished(results, raised)


def attempted(
    kind: type[R], place: Place, job: Job, *, progress: bool = False
) -> tuple[R | None, BaseException | None, list[str]]:
    """Run a command and return its results, the exception it ended with, and its errors."""
    cases = [(stem(case), case) for case in job.cases]
    files = (job.paths, job.content, job.changes)
    with Listener(progress) as listener:
        folder, raised, errors = _core.carry_out(
            job.text(place.existing), cases, *files, place.path, listener
        )
    return found(kind, place, folder), raised, errors


def stem(case: _core.Case) -> str:
    """Return the name of the file of a case, without its ending."""
    return os.path.splitext(os.path.basename(case.source))[0]


def quantity(name: str, value: Scalar | None, dimension: str) -> str | None:
    """Return an option as a text with its unit; it must be finite."""
    found = _values.option(name, value, dimension)
    return None if found is None else f"{found!r} {_core.si_unit(dimension)}"


def quantities(name: str, values: object, dimension: str) -> str | None:
    """Return the values of an option as a text with their unit."""
    found = _values.options(name, values, dimension)
    if found is None:
        return None
    return ",".join(f"{value!r} {_core.si_unit(dimension)}" for value in found)


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
