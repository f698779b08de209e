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
"""Prefix of the file that is in the folder of a sweep while workers solve it."""

GRACE_S = 10.0
"""Time for which an interrupted sweep waits for checkpoints of the running cases, s."""


def running_file(folder: Path) -> str:
    """Return the name of a file that is in the folder of a sweep while it runs."""
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
        """Submit all cases, and return whether the user interrupted the sweep."""
        order = self._core.left()
        self._ended = len(self._names) - len(order)
        self._report()
        running = Path(self._job.running)
        for left in running.parent.glob(f"{RUNNING}*"):
            # Workers of a sweep whose driver was killed stop when this file is gone.
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
        """Submit a bundle of cases."""
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
        """Record the results of a bundle."""
        for sentence in done.warnings:
            self._listener.said(True, sentence)
        if done.stopped and Path(self._job.running).exists():
            # The worker has another folder of the same path.
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
        """Record a case that cannot be solved."""
        self._core.fail(number, reason)
        self._count(1)

    def _send_files(self) -> None:
        self._job = replace(self._job, shared=False)
        self._pickled = pickle.dumps(self._job)

    def _count(self, ended: int) -> None:
        self._ended += ended
        self._report()

    def _report(self) -> None:
        cases = len(self._names)
        self._listener.batch(self._ended, cases, self._ended / max(cases, 1))
