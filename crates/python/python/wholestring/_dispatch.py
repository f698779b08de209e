"""A sweep's cases on their way to workers and back."""

from __future__ import annotations

import pickle
import secrets
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from typing import Any

from . import _core
from ._gather import Gathering
from ._listener import Listener
from ._pool import Pool
from ._task import Done, Job, Task, solve

RUNNING = ".running-"
"""How the name of the file begins that is in a sweep's folder as long as workers solve it."""

GRACE_S = 10.0
"""How long an interrupted sweep waits for the checkpoints of the cases under way, s."""


def running_file(folder: Path) -> str:
    """Give the name of a file that is in a sweep's folder as long as it goes on."""
    return str((folder / f"{RUNNING}{secrets.token_hex(8)}").absolute())


class Dispatcher:
    """A sweep's cases on their way to workers and back."""

    def __init__(self, core: _core.Sweep, job: Job, listener: Listener) -> None:
        self._core = core
        self._job = job
        self._pickled = pickle.dumps(job)
        self._listener = listener
        self._names = core.names()
        self._ended = 0

    def run(self, pool: Pool, *, in_flight: int | None, bundle_s: float, tries: int) -> bool:
        """Hand out all cases, and tell whether the user interrupted it."""
        order = self._core.left()
        self._ended = len(self._names) - len(order)
        self._tell()
        running = Path(self._job.running)
        for left in running.parent.glob(f"{RUNNING}*"):
            # Workers of one whose driver was killed: they stop.
            left.unlink(missing_ok=True)
        running.touch()
        gathering = Gathering(
            pool, self, order, in_flight=in_flight, bundle_s=bundle_s, tries=tries
        )
        interrupted = False
        try:
            try:
                gathering.run()
            except KeyboardInterrupt:
                interrupted = True
        finally:
            running.unlink(missing_ok=True)
            try:
                gathering.stop(0.0 if self._job.shared is False else GRACE_S)
            finally:
                pool.close()
                self._core.end(interrupted)
        return interrupted

    def submit(self, pool: Pool, numbers: list[int], first: bool) -> Future[Any]:
        """Hand out a bundle of cases."""
        tasks = [self._task(number, first) for number in numbers]
        return pool.submit(solve, self._pickled, tasks)

    def _task(self, number: int, first: bool) -> Task:
        core = self._core
        folder = core.make_ready(number) if first else Path(core.folder()) / self._names[number]
        sent = self._job.shared is False
        return Task(
            number=number,
            name=self._names[number],
            changes=core.changes(number),
            folder=str(folder.absolute()),
            begun=core.begun(number) if sent else [],
        )

    def take(self, done: Done) -> list[int]:
        """Take back what came of a bundle."""
        for sentence in done.warnings:
            self._listener.said(True, sentence)
        if done.stopped and Path(self._job.running).exists():
            # A folder of the same name, but not this one.
            self._send_files()
        ended: list[int] = []
        for solved in done.solved:
            if solved.files is not None:
                self._core.put(solved.number, solved.files)
            if self._core.take(solved.number, solved.ended):
                ended.append(solved.number)
        self._count(len(ended))
        return ended

    def fail(self, number: int, reason: str) -> None:
        """Take note of a case that cannot be solved."""
        self._core.fail(number, reason)
        self._count(1)

    def _send_files(self) -> None:
        self._job = replace(self._job, shared=False)
        self._pickled = pickle.dumps(self._job)

    def _count(self, ended: int) -> None:
        self._ended += ended
        self._tell()

    def _tell(self) -> None:
        cases = len(self._names)
        self._listener.batch(self._ended, cases, self._ended / max(cases, 1))
