"""Executors, and the differences between them."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from typing import Any, Protocol, runtime_checkable

from .errors import InputTypeError

COUNT_EVERY_S = 5.0
"""Interval between counts of the workers of a cluster that grows and shrinks, s."""


@runtime_checkable
class HasExecutor(Protocol):
    """An object that has an executor, such as a ``Client`` of Dask."""

    def get_executor(self, **keywords: Any) -> Executor:
        """Return the executor."""
        ...


class Pool:
    """An executor, or an object that has one.

    Parameters
    ----------
    executor
        A ``concurrent.futures.Executor``, or a ``Client`` of Dask.
    """

    def __init__(self, executor: Executor | HasExecutor) -> None:
        if isinstance(executor, HasExecutor) and not isinstance(executor, Executor):
            # Not pure: results of an earlier call in the session are in its folder, not in memory.
            executor = executor.get_executor(pure=False)
        if not hasattr(executor, "submit"):
            raise InputTypeError(
                f"executor is {executor!r}: expected a concurrent.futures.Executor, or a Client of "
                "Dask"
            )
        self._executor = executor
        self._ours = False
        self._counted_s = -COUNT_EVERY_S
        self._workers = 1
        self.generation = 0

    def submit(self, work: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Submit a task."""
        return self._executor.submit(work, *arguments)

    def workers(self) -> int:
        """Return the number of tasks that run in parallel."""
        if time.monotonic() - self._counted_s >= COUNT_EVERY_S:
            self._workers = max(1, self._count())
            self._counted_s = time.monotonic()
        return self._workers

    def _count(self) -> int:
        client = getattr(self._executor, "_client", None)
        if client is not None and hasattr(client, "nthreads"):
            return sum(client.nthreads().values())
        count = getattr(self._executor, "_max_workers", None)
        return count if isinstance(count, int) else os.cpu_count() or 1

    def renew(self, generation: int) -> None:
        """Replace a pool of processes that lost one, because it accepts no more work.

        Parameters
        ----------
        generation
            Generation of the pool that was found broken.
        """
        old = self._executor
        if generation < self.generation or not isinstance(old, ProcessPoolExecutor):
            return
        held: Any = old
        self._executor = ProcessPoolExecutor(
            held._max_workers,
            mp_context=held._mp_context,
            initializer=held._initializer,
            initargs=held._initargs,
        )
        if self._ours:
            old.shutdown(wait=False)
        self._ours = True
        self.generation += 1

    def close(self) -> None:
        """Shut down a pool that was made here; a pool of the user is left running."""
        if self._ours:
            self._executor.shutdown(wait=True, cancel_futures=True)


def is_lost(error: BaseException) -> bool:
    """Return whether an error means a lost worker rather than a failure of the task."""
    if isinstance(error, BrokenExecutor | CancelledError | ConnectionError | EOFError):
        return True
    return any(kind.__module__.split(".")[0] == "distributed" for kind in type(error).__mro__)
