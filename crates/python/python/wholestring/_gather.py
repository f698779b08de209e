"""Many small tasks on an executor: a few in flight, recorded as they complete."""

from __future__ import annotations

import math
from collections import Counter, deque
from collections.abc import Iterable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import Any, Protocol

from ._pool import Pool, is_lost
from ._task import Done

PER_WORKER = 3
"""Bundles in flight for each worker: one that it solves, one that waits at the worker, and one in
transfer."""

MOST_IN_A_BUNDLE = 1000

LOOK_S = 0.05
"""Interval at which Python checks for an interrupt received by another thread, s."""


class Cases(Protocol):
    """Owner of the cases."""

    def submit(self, pool: Pool, numbers: list[int], first: bool) -> Future[Any]:
        """Submit a bundle of cases."""
        ...

    def take(self, done: Done) -> list[int]:
        """Record the results of a bundle, and return the cases that have ended."""
        ...

    def fail(self, number: int, reason: str) -> None:
        """Record a case that cannot be solved."""
        ...


class Gathering:
    """Cases that are submitted and whose results are recorded.

    Parameters
    ----------
    pool
        Pool that solves the cases.
    cases
        Owner of the cases.
    order
        Numbers of the cases, the longest case first.
    in_flight
        Largest number of bundles in flight; :data:`PER_WORKER` for each worker by default.
    bundle_s
        Approximate time of a bundle of short cases, s.
    tries
        Number of times to submit a case whose worker is lost.
    """

    def __init__(
        self,
        pool: Pool,
        cases: Cases,
        order: Iterable[int],
        *,
        in_flight: int | None,
        bundle_s: float,
        tries: int,
    ) -> None:
        self._pool = pool
        self._cases = cases
        self._order = deque(order)
        self._in_flight = in_flight
        self._bundle_s = bundle_s
        self._tries = tries
        # Cases whose worker was lost: each is submitted alone, and for the last time when nothing
        # else is in flight that could be the cause.
        self._again: deque[int] = deque()
        self._at_last: deque[int] = deque()
        self._losses: Counter[int] = Counter()
        self._futures: dict[Future[Any], tuple[list[int], int]] = {}
        self._case_s = math.inf

    def run(self) -> None:
        """Submit and record until no case is left."""
        while self._fill():
            done, _ = wait(self._futures, timeout=LOOK_S, return_when=FIRST_COMPLETED)
            for future in done:
                self._end(future)

    def stop(self, grace_s: float) -> None:
        """Stop submitting, and record the results that arrive within a time."""
        for future in self._futures:
            future.cancel()
        wait(self._futures, timeout=grace_s)
        for future in self._futures:
            if future.done() and not future.cancelled() and future.exception() is None:
                self._cases.take(future.result())
        self._futures.clear()

    def _fill(self) -> bool:
        """Submit as many bundles as may be in flight; return whether any is."""
        most = self._in_flight or PER_WORKER * self._pool.workers()
        while len(self._futures) < most:
            if self._again:
                numbers = [self._again.popleft()]
            elif self._order:
                numbers = [self._order.popleft() for _ in range(self._bundle())]
            elif self._at_last and not self._futures:
                numbers = [self._at_last.popleft()]
            else:
                break
            first = not self._losses[numbers[0]]
            generation = self._pool.generation
            try:
                future = self._cases.submit(self._pool, numbers, first)
            except BaseException as error:
                if not is_lost(error):
                    raise
                self._lose(numbers, generation, error)
                continue
            self._futures[future] = (numbers, generation)
        return bool(self._futures)

    def _bundle(self) -> int:
        """Return the size of the next bundle: smaller near the end, so that no worker waits."""
        by_time = self._bundle_s / self._case_s if self._case_s > 0.0 else math.inf
        share = math.ceil(len(self._order) / (2 * self._pool.workers()))
        return max(1, min(int(min(by_time, MOST_IN_A_BUNDLE)), share, len(self._order)))

    def _end(self, future: Future[Any]) -> None:
        numbers, generation = self._futures.pop(future)
        try:
            done: Done = future.result()
        except BaseException as error:
            if not is_lost(error):
                raise
            self._lose(numbers, generation, error)
            return
        if done.solved:
            self._case_s = done.took_s / len(done.solved)
        ended = set(self._cases.take(done))
        left = [number for number in numbers if number not in ended]
        if left:
            self._lose(left, generation, InterruptedError("it was stopped there"))

    def _lose(self, numbers: list[int], generation: int, error: BaseException) -> None:
        self._pool.renew(generation)
        for number in numbers:
            self._losses[number] += 1
            losses = self._losses[number]
            if losses >= self._tries:
                reason = f"its worker was lost {losses} times, the last time by: "
                self._cases.fail(number, reason + (str(error) or type(error).__name__))
            elif losses == self._tries - 1:
                self._at_last.append(number)
            else:
                self._again.append(number)
