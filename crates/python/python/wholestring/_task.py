"""Cases of a sweep for a worker in another process or on another machine."""

from __future__ import annotations

import functools
import pickle
import socket
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from . import _core
from .errors import Error, FolderError


@dataclass(frozen=True, kw_only=True)
class Job:
    """Data common to all cases of a sweep.

    Attributes
    ----------
    name, text, files
        The case that is varied, and the files that it refers to.
    options
        Options of the sweep for its cases.
    running
        A file in the folder of the sweep that exists while the sweep runs.
    shared
        Whether workers write to the folder of the sweep; ``None``: those that see it do.
    version
        The version of this package in the process that submits.
    """

    name: str
    text: str
    files: dict[str, bytes]
    options: str
    running: str
    shared: bool | None
    version: str


@dataclass(frozen=True, kw_only=True)
class Task:
    """A case: its number, its changes, its folder, and files with which it continues."""

    number: int
    name: str
    changes: list[tuple[str, str]]
    folder: str
    begun: list[tuple[str, bytes]]


@dataclass(frozen=True, kw_only=True)
class Solved:
    """Outcome of a case, with its files if the worker does not see the folder of the sweep."""

    number: int
    ended: bytes
    files: list[tuple[str, bytes]] | None


@dataclass(kw_only=True)
class Done:
    """Results of a bundle of cases.

    Attributes
    ----------
    solved
        The cases that were solved, from the first on.
    warnings
        Messages received meanwhile.
    took_s
        Wall-clock time.
    stopped
        Whether the folder of the sweep existed and the sweep had ended.
    """

    solved: list[Solved] = field(default_factory=list[Solved])
    warnings: list[str] = field(default_factory=list[str])
    took_s: float = 0.0
    stopped: bool = False

    def said(self, is_warning: bool, sentence: str) -> None:
        """Receive a message."""
        if is_warning:
            self.warnings.append(sentence)

    def progress(self, name: str, time_s: float, end_s: float) -> None:
        """Receive the progress of a simulation, which is not displayed here."""

    def batch(self, ended: int, cases: int, part: float) -> None:
        """Receive the progress of a batch, which is not displayed here."""


@functools.lru_cache(maxsize=4)
def _opened(job: bytes) -> tuple[Job, _core.Variations]:
    held: Job = pickle.loads(job)
    if held.version != _core.__version__:
        raise Error(
            f"the worker on {socket.gethostname()} has wholestring {_core.__version__}, and the "
            f"sweep was begun with {held.version}: their answers may differ"
        )
    return held, _core.Variations(held.name, held.text, held.files)


def solve(job: bytes, tasks: Sequence[Task]) -> Done:
    """Solve cases one after the other.

    Parameters
    ----------
    job
        A pickled :class:`Job`, which a worker opens once.
    tasks
        The cases.
    """
    begin = time.monotonic()
    held, variations = _opened(job)
    done = Done()
    running = Path(held.running)
    shared = running.exists() if held.shared is None else held.shared
    if (shared or held.shared is None) and not running.exists() and running.parent.is_dir():
        done.stopped = True
    elif shared:
        if not running.exists():
            raise FolderError(
                f"the worker on {socket.gethostname()} does not see {running.parent}: with "
                "shared_folder=False it sends the files of its cases back"
            )
        cases = [(task.name, task.changes, task.folder) for task in tasks]
        ended = _solve(held, variations, cases, running, done)
        done.solved = [
            Solved(number=task.number, ended=how, files=None)
            for task, how in zip(tasks, ended, strict=False)
        ]
    else:
        with tempfile.TemporaryDirectory(prefix="wholestring-") as place:
            done.solved = _solve_apart(held, variations, tasks, Path(place), done)
    done.took_s = time.monotonic() - begin
    return done


def _solve_apart(
    held: Job, variations: _core.Variations, tasks: Sequence[Task], place: Path, done: Done
) -> list[Solved]:
    folders = [place / str(task.number) for task in tasks]
    for task, folder in zip(tasks, folders, strict=True):
        folder.mkdir()
        for name, content in task.begun:
            (folder / name).write_bytes(content)
    cases = [
        (task.name, task.changes, str(folder)) for task, folder in zip(tasks, folders, strict=True)
    ]
    ended = _solve(held, variations, cases, None, done)
    return [
        Solved(
            number=task.number,
            ended=how,
            files=[
                (file.name, file.read_bytes())
                for file in sorted(folder.iterdir())
                if file.is_file()
            ],
        )
        for task, folder, how in zip(tasks, folders, ended, strict=False)
    ]


def _solve(
    held: Job,
    variations: _core.Variations,
    cases: list[tuple[str, list[tuple[str, str]], str]],
    running: Path | None,
    done: Done,
) -> list[bytes]:
    return variations.solve(cases, held.options, running, done)
