"""Curves of a figure, and their look."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..errors import InputError
from ._columns import Columns
from ._house import Look, colour, line_colour, operation_colour, operation_words, pictures, stroke
from ._keys import Key


def models_words() -> dict[str, str]:
    """Return the labels of models, the most detailed model first."""
    return {name: words for name, words in pictures()["models"]}


@dataclass(frozen=True)
class Curve:
    """Rows of one operation by one model of one run.

    Attributes
    ----------
    run
        Index of the run.
    model, operation
        Model and operation of the rows.
    name
        Label at the curve; empty where a single curve requires none.
    look
        Colour and stroke.
    """

    run: int
    model: str
    operation: str
    name: str
    look: Look

    def rows(self, columns: Columns) -> Columns:
        """Return the rows of the curve."""
        return columns.where(model=self.model or None, operation=self.operation or None)


def curves(
    runs: Sequence[Columns],
    names: Sequence[str],
    *,
    operations: Sequence[str] | None,
    models: Sequence[str] | None,
    subject: str,
) -> list[Curve]:
    """Return the curves of one run or several.

    Operations of one run differ by colour, and so do several runs; they also differ by stroke if
    one model solved them. Several models differ by stroke, and also by colour if neither operations
    nor runs do.
    """
    there = _united(runs, "operation")
    for operation in operations or ():
        if operation not in there:
            raise InputError(f"{subject}: there is no {operation!r}: there are {', '.join(there)}")
    drawn_operations = list(operations) if operations is not None else there or [""]
    solved = _united(runs, "model")
    for model in models or ():
        if model not in solved:
            raise InputError(f"{subject}: no model {model!r} solved it: {', '.join(solved)} did")
    solved = list(models) if models is not None else solved
    known = [model for model in models_words() if model in solved]
    drawn_models = known or solved or [""]
    made: list[Curve] = []
    for run, columns in enumerate(runs):
        for place, operation in enumerate(drawn_operations):
            for rank, model in enumerate(drawn_models):
                curve = _curve(
                    (run, len(runs)),
                    (place, operation, len(drawn_operations)),
                    (rank, model, len(drawn_models)),
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
        # A key explains the strokes.
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
    return list(dict.fromkeys(word for run in runs for word in run.distinct(column)))


def stroke_keys(drawn: Sequence[Curve]) -> list[Key]:
    """Return the keys of strokes that distinguish models without labels."""
    models = [model for model in models_words() if any(curve.model == model for curve in drawn)]
    if len(models) < 2 or len({(curve.run, curve.operation) for curve in drawn}) < 2:
        return []
    ink = colour("muted")
    return [Key(models_words()[model], Look(ink, stroke(at))) for at, model in enumerate(models)]
