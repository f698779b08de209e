"""What can go wrong, and where."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
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
    """What all errors of this package are.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case("")
    ... except ws.Error as error:
    ...     print(type(error).__name__)
    CaseError
    """


class CaseError(Error, ValueError):
    """A case with mistakes: all of them, each with its place.

    Its text is the command line's, with every place underlined.

    Attributes
    ----------
    diagnostics
        The mistakes.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().with_(frictoin=0.3)
    ... except ws.CaseError as error:
    ...     print(error.diagnostics[0].message)
    there is no key `frictoin`
    """

    diagnostics: tuple[Diagnostic, ...]

    def __init__(self, message: str, diagnostics: Iterable[Mapping[str, Any]] = ()) -> None:
        super().__init__(message)
        self.diagnostics = tuple(Diagnostic(**found) for found in diagnostics)


class InputError(Error, ValueError):
    """Something that was requested is not possible.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().modes(operation="fish")
    ... except ws.InputError as error:
    ...     print(str(error).split(":")[0])
    the case has no operation `fish`
    """


class InputTypeError(InputError, TypeError):
    """An argument of a kind that is not taken: a list where a number belongs, and so on.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().with_(wob=object())
    ... except ws.InputTypeError as error:
    ...     print(isinstance(error, TypeError))
    True
    """


class NotFoundError(Error, KeyError):
    """A name that there is not: of a table, a column, an operation, a case of a sweep.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().soft("drill")["slide"]
    ... except ws.NotFoundError as error:
    ...     print(error)
    there is no 'slide': there are soft drill
    """

    def __str__(self) -> str:
        """Return the message as it is: ``KeyError`` quotes it."""
        return str(self.args[0]) if self.args else ""


class MissingPackageError(Error, ImportError):
    """Another package is needed and not installed; the message says how to install it.

    Examples
    --------
    >>> import wholestring as ws
    >>> issubclass(ws.MissingPackageError, ImportError)
    True
    """


class CaseWarning(UserWarning):
    """A case has something that is probably not meant, but can be computed.

    Such a warning goes to ``warnings.warn`` once, as the case is made. :attr:`Case.warnings` has
    them all, each with its place.

    Examples
    --------
    >>> import warnings
    >>> import wholestring as ws
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always")
    ...     _ = ws.Case.example().with_(mud__density=1.2)
    >>> [issubclass(warning.category, ws.CaseWarning) for warning in caught]
    [True]
    """


class FolderError(Error, OSError):
    """A folder that results cannot go to, or that cannot be continued.

    Examples
    --------
    >>> import tempfile
    >>> import wholestring as ws
    >>> case = ws.Case.example()
    >>> with tempfile.TemporaryDirectory() as place:
    ...     saved = case.soft().save(place + "/here")
    ...     try:
    ...         case.with_(friction=0.1).soft().save(saved)
    ...     except ws.FolderError:
    ...         print("other results lie there")
    other results lie there
    """


class ResultsError(Error, OSError):
    """Results that cannot be read or written.

    Examples
    --------
    >>> import tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     try:
    ...         ws.load(place)
    ...     except ws.ResultsError:
    ...         print("nothing lies there")
    nothing lies there
    """


class NoAnswerError(Error, ArithmeticError):
    """An operation has no answer, or its simulation diverged.

    Attributes
    ----------
    results
        What was computed beside it.

    Examples
    --------
    More weight than the string can take in one of two operations:

    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(friction=1.2, wob="900 kN")
    >>> try:
    ...     case.with_(operation__kind=["trip_out", "drill"]).stiff()
    ... except ws.NoAnswerError as error:
    ...     print([of.status for of in error.results])
    ['complete', 'failed']
    """

    results: Any = None


class FindingsError(Error, ArithmeticError):
    """An error was found in an answer, and none was to pass.

    Attributes
    ----------
    results
        What was computed.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import wholestring as ws
    >>> text = '''
    ... name = "Friction"
    ... [[sweep]]
    ... name = "statics"
    ... case = "slant.toml"
    ... set = { model = "soft", operation.kind = "slide" }
    ... vary = { friction = [0.2, 1.5] }
    ... '''
    >>> with tempfile.TemporaryDirectory() as place:
    ...     _ = Path(place, "slant.toml").write_text(ws.Case.example().to_toml())
    ...     _ = Path(place, "study.toml").write_text(text)
    ...     try:
    ...         ws.study(Path(place, "study.toml"), strict=True)
    ...     except ws.FindingsError as error:
    ...         print(error.results.sweeps)
    ('statics',)
    """

    results: Any = None


class Interrupted(KeyboardInterrupt):
    """The user interrupted the work.

    Attributes
    ----------
    sweep
        What was solved until then, of a sweep.

    Examples
    --------
    Whoever waits for Python's own interrupt gets this one:

    >>> import wholestring as ws
    >>> issubclass(ws.Interrupted, KeyboardInterrupt)
    True
    """

    sweep: Any = None

    def __init__(self, *args: object, make_results: Callable[[], Any] | None = None) -> None:
        """Say what was interrupted; results that take long to make are made when asked for."""
        super().__init__(*args)
        self._results: Any = None
        # The summary of simulated hours takes longer than an interrupt may.
        self._make_results = make_results

    @property
    def results(self) -> Any:
        """What was computed until then.

        Those of a simulation in hand are made when they are first asked for, as it stands by then.
        """
        if self._make_results is not None:
            self._results = self._make_results()
            self._make_results = None
        return self._results

    @results.setter
    def results(self, results: Any) -> None:
        self._results = results

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle what was computed, not how."""
        return type(self), self.args, {"results": self.results, "sweep": self.sweep}
