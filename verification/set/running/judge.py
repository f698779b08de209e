"""Whether the answers to a problem hold."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

from .adapter import AdapterError, Answers, Problem


@dataclass(frozen=True)
class Compared:
    """A number beside what came out for it."""

    name: str
    expected: float
    answer: float
    tolerance: float
    """How far they may be apart, in the number's unit."""
    reason: str

    @property
    def error(self) -> float:
        """How far they are apart, over how far they may be: beyond 1 it fails."""
        if not math.isfinite(self.answer):
            return math.inf
        return abs(self.answer - self.expected) / self.tolerance

    @property
    def holds(self) -> bool:
        return self.error <= 1.0


@dataclass
class Outcome:
    """What came of a problem."""

    problem: Problem
    compared: list[Compared] = field(default_factory=list[Compared])
    not_answered: list[str] = field(default_factory=list[str])
    out_of_scope: bool = False
    fault: str = ""
    """What the program said instead of an answer."""

    @property
    def failed(self) -> bool:
        return bool(self.fault) or any(not of.holds for of in self.compared)

    @property
    def passed(self) -> bool:
        """All of it that was answered holds, and something was."""
        return bool(self.compared) and not self.failed

    @property
    def worst(self) -> Compared | None:
        return max(self.compared, key=lambda of: of.error, default=None)


def judge(problem: Problem, answers: Answers) -> Outcome:
    """Asks and compares."""
    outcome = Outcome(problem)
    try:
        found = answers(problem)
    except NotImplementedError:
        outcome.out_of_scope = True
        return outcome
    except AdapterError:
        raise
    except Exception as error:
        outcome.fault = f"{type(error).__name__}: {error}"
        return outcome
    if not isinstance(found, Mapping):
        raise AdapterError(f"{problem['id']}: answers are a mapping, not {found!r}")
    expected: Mapping[str, Any] = problem["expected"]
    for name in found:
        if name not in expected:
            known = ", ".join(expected)
            raise AdapterError(f"{problem['id']}: {name!r} is not asked for; known are {known}")
    for name, of in expected.items():
        for label, value, answer in paired(problem["id"], name, of["value"], found.get(name)):
            if answer is None:
                outcome.not_answered.append(label)
                continue
            tolerance = of["tolerance"]
            most = tolerance.get("absolute", abs(value) * tolerance.get("relative", 0.0))
            outcome.compared.append(Compared(label, value, answer, most, of["reason"]))
    return outcome


def paired(
    problem: str, name: str, value: float | Sequence[float], answer: object
) -> Iterator[tuple[str, float, float | None]]:
    """The numbers of an expected one, each with its answer or none."""
    if not isinstance(value, Sequence):
        yield name, value, number(f"{problem}: {name}", answer)
        return
    if answer is None:
        answer = [None] * len(value)
    if isinstance(answer, str | Mapping) or not hasattr(answer, "__len__"):
        raise AdapterError(f"{problem}: {name} is a list of {len(value)} numbers, not {answer!r}")
    listed: list[object] = list(answer)  # type: ignore[call-overload]
    if len(listed) != len(value):
        raise AdapterError(f"{problem}: {name} has {len(value)} numbers, answered {len(listed)}")
    for at, (each, found) in enumerate(zip(value, listed, strict=True)):
        label = f"{name}[{at}]"
        yield label, each, number(f"{problem}: {label}", found)


def number(place: str, answer: object) -> float | None:
    """A number, or none where it is left out. NumPy's numbers are real ones."""
    if answer is None:
        return None
    if isinstance(answer, bool) or not isinstance(answer, Real):
        raise AdapterError(f"{place} is a number, not {answer!r}")
    return float(answer)
