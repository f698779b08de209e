"""Executors, and what differs between them."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from typing import Any, Protocol, runtime_checkable

from .errors import InputTypeError

ASK_EVERY_S = 5.0
"""How often a cluster that grows and shrinks is asked for its workers, s."""


@runtime_checkable
class HasExecutor(Protocol):
    """What has an executor, as a ``Client`` of Dask does."""

    def get_executor(self, **keywords: Any) -> Executor:
        """Give it."""
        ...


class Pool:
    """An executor, or what has one.

    Parameters
    ----------
    executor
        A ``concurrent.futures.Executor``, or a ``Client`` of Dask.
    """

    def __init__(self, executor: Executor | HasExecutor) -> None:
        if isinstance(executor, HasExecutor) and not isinstance(executor, Executor):
            # Not pure: what was solved before in the same session is in its folder, not in memory.
            executor = executor.get_executor(pure=False)
        if not hasattr(executor, "submit"):
            raise InputTypeError(
                f"executor is {executor!r}: expected a concurrent.futures.Executor, or a Client of "
                "Dask"
            )
        self._executor = executor
        self._ours = False
        self._asked = -ASK_EVERY_S
        self._workers = 1
        self.generation = 0

    def submit(self, work: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Hand out a piece of work."""
        return self._executor.submit(work, *arguments)

    def workers(self) -> int:
        """Give how many pieces of work are done side by side."""
        if time.monotonic() - self._asked >= ASK_EVERY_S:
            self._workers = max(1, self._count())
            self._asked = time.monotonic()
        return self._workers

    def _count(self) -> int:
        client = getattr(self._executor, "_client", None)
        if client is not None and hasattr(client, "nthreads"):
            return sum(client.nthreads().values())
        count = getattr(self._executor, "_max_workers", None)
        return count if isinstance(count, int) else os.cpu_count() or 1

    def renew(self, generation: int) -> None:
        """Make a pool of processes anew that lost one: it takes no more work.

        Parameters
        ----------
        generation
            That of the pool that was found broken.
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
        """End a pool that was made here; that of the user stays."""
        if self._ours:
            self._executor.shutdown(wait=True, cancel_futures=True)


def is_lost(error: BaseException) -> bool:
    """Tell whether an error says that a worker was lost, and nothing of the work."""
    if isinstance(error, BrokenExecutor | CancelledError | ConnectionError | EOFError):
        return True
    return any(of.__module__.split(".")[0] == "distributed" for of in type(error).__mro__)
