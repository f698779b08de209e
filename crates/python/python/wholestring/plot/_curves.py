"""Whose curves a figure shows, and how each looks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..errors import InputError
from ._columns import Columns
from ._house import Look, colour, line_colour, operation_colour, operation_words, pictures, stroke
from ._keys import Key


def models_words() -> dict[str, str]:
    """Give what curves of models are called, the most detailed model first."""
    return {name: words for name, words in pictures()["models"]}


@dataclass(frozen=True)
class Curve:
    """Rows of one operation by one model of one run.

    Attributes
    ----------
    run
        Place of the run.
    model, operation
        Whose the rows are.
    name
        What is written beside it; empty where there is nothing to tell apart.
    look
        Colour and stroke.
    """

    run: int
    model: str
    operation: str
    name: str
    look: Look

    def rows(self, columns: Columns) -> Columns:
        """Give its rows."""
        return columns.where(model=self.model or None, operation=self.operation or None)


def curves(
    runs: Sequence[Columns],
    names: Sequence[str],
    *,
    operations: Sequence[str] | None,
    models: Sequence[str] | None,
    what: str,
) -> list[Curve]:
    """Give the curves of one run or several.

    Of one run, operations differ by colour, of several the runs do; by stroke too where one model
    solved them. Where several did, models differ by stroke, and by colour too where nothing else
    does.
    """
    there = _united(runs, "operation")
    for operation in operations or ():
        if operation not in there:
            raise InputError(f"{what}: there is no {operation!r}: there are {', '.join(there)}")
    shown = list(operations) if operations is not None else there or [""]
    solved = _united(runs, "model")
    for model in models or ():
        if model not in solved:
            raise InputError(f"{what}: no model {model!r} solved it: {', '.join(solved)} did")
    solved = list(models) if models is not None else solved
    known = [of for of in models_words() if of in solved]
    shown_models = known or solved or [""]
    made: list[Curve] = []
    for run, columns in enumerate(runs):
        for place, operation in enumerate(shown):
            for rank, model in enumerate(shown_models):
                curve = _curve(
                    (run, len(runs)),
                    (place, operation, len(shown)),
                    (rank, model, len(shown_models)),
                    names,
                )
                if len(curve.rows(columns)):
                    made.append(curve)
    return made


def _curve(
    run: tuple[int, int],
    operation: tuple[int, str, int],
    model: tuple[int, str, int],
    names: Sequence[str],
) -> Curve:
    several = model[2] > 1
    words = models_words().get(model[1], model[1])
    parts: list[str] = []
    if run[1] > 1:
        parts.append(names[run[0]])
    if operation[2] > 1:
        parts.append(operation_words(operation[1]))
    elsewhere = run[1] > 1 or operation[2] > 1
    if several and not elsewhere:
        parts.append(words)
    elif several and model[0] > 0:
        # A key says what strokes mean.
        parts.clear()
    if run[1] > 1:
        look = Look(line_colour(run[0]), stroke(model[0] if several else run[0]))
    elif operation[2] > 1:
        look = Look(operation_colour(operation[1]), stroke(model[0] if several else operation[0]))
    elif several:
        look = Look(line_colour(model[0]), stroke(model[0]))
    else:
        look = Look(line_colour(0))
    return Curve(run[0], model[1], operation[1], ", ".join(parts), look)


def _united(runs: Sequence[Columns], column: str) -> list[str]:
    return list(dict.fromkeys(word for of in runs for word in of.distinct(column)))


def stroke_keys(whose: Sequence[Curve]) -> list[Key]:
    """Give what strokes mean, where they tell models apart that no name does."""
    models = [of for of in models_words() if any(curve.model == of for curve in whose)]
    if len(models) < 2 or len({(of.run, of.operation) for of in whose}) < 2:
        return []
    ink = colour("muted")
    return [Key(models_words()[of], Look(ink, stroke(at))) for at, of in enumerate(models)]
