"""What can go wrong, and where."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Diagnostic:
    """One mistake in a case, as the command line reports it.

    Attributes
    ----------
    severity
        ``"error"`` or ``"warning"``.
    message
        What is wrong, in one sentence.
    expected
        What was expected at that place; may be empty.
    help
        How to put it right; may be empty.
    file
        What the text is called in which it stands.
    line, column
        Where it stands, counted from one; ``None`` where it has no place.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().with_(wob="6 bar")
    ... except ws.CaseError as error:
    ...     found = error.diagnostics[0]
    >>> found.severity, found.file
    ('error', 'with_')
    """

    severity: str
    message: str
    expected: str
    help: str
    file: str | None
    line: int | None
    column: int | None


class Error(Exception):
    """What all errors of this package are."""


class CaseError(Error, ValueError):
    """A case with mistakes: all of them, each with its place.

    Its text is the command line's, with every place underlined.

    Attributes
    ----------
    diagnostics
        The mistakes.
    """

    diagnostics: tuple[Diagnostic, ...]

    def __init__(self, message: str, diagnostics: Iterable[Mapping[str, Any]] = ()) -> None:
        super().__init__(message)
        self.diagnostics = tuple(Diagnostic(**found) for found in diagnostics)


class InputError(Error, ValueError):
    """Something that was requested is not possible."""


class FolderError(Error, OSError):
    """A folder that results cannot go to, or that cannot be continued."""


class ResultsError(Error, OSError):
    """Results that cannot be read or written."""


class NoAnswerError(Error, ArithmeticError):
    """An operation has no answer, or its simulation diverged.

    Attributes
    ----------
    results
        What was computed beside it.
    """

    results: Any = None


class FindingsError(Error, ArithmeticError):
    """An error was found in an answer, and none was to pass.

    Attributes
    ----------
    results
        What was computed.
    """

    results: Any = None


class Interrupted(KeyboardInterrupt):
    """The user interrupted the work.

    Attributes
    ----------
    results
        What was computed until then.
    sweep
        What was solved until then, of a sweep.
    """

    results: Any = None
    sweep: Any = None
