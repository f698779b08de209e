"""Errors and warnings of the package."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Diagnostic:
    """One mistake or warning in a case, as reported by the command line.

    Attributes
    ----------
    severity
        ``"error"`` or ``"warning"``.
    message
        The problem, in one sentence.
    expected
        Expected input at that place; may be empty.
    help
        Suggested correction; may be empty.
    file
        Name of the text with the mistake.
    line, column
        Place of the mistake, counted from one; ``None`` where it has no place.

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
    """Base class of all errors of this package.

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

    The message is that of the command line, with every place underlined.

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
    """A request that is not possible.

    Examples
    --------
    >>> import wholestring as ws
    >>> try:
    ...     ws.Case.example().modes(operation="ream")
    ... except ws.InputError as error:
    ...     print(str(error).split(":")[0])
    the case has no operation `ream`
    """


class InputTypeError(InputError, TypeError):
    """An argument of an unsupported type, such as a list where a number is expected.

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
    """An unknown name of a table, a column, an operation or a case of a sweep.

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
        """Return the message without the quotes that ``KeyError`` adds."""
        return str(self.args[0]) if self.args else ""


class MissingPackageError(Error, ImportError):
    """A required package is not installed; the message has the command to install it.

    Examples
    --------
    >>> import wholestring as ws
    >>> issubclass(ws.MissingPackageError, ImportError)
    True
    """


class CaseWarning(UserWarning):
    """A warning about a case: probably unintended, but computable.

    It is issued with ``warnings.warn`` once, when the case is made. :attr:`Case.warnings` has all
    warnings, each with its place.

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
    """A folder that results cannot be written to, or that cannot be continued.

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
    ...         print("the folder holds other results")
    the folder holds other results
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
    ...         print("no results")
    no results
    """


class NoAnswerError(Error, ArithmeticError):
    """An operation has no answer, or its simulation diverged.

    Attributes
    ----------
    results
        Results of the other operations.

    Examples
    --------
    A weight above the capacity of the string in one of two operations:

    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(friction=1.2, wob="900 kN")
    >>> try:
    ...     case.with_(operation__kind=["trip_out", "drill"]).stiff()
    ... except ws.NoAnswerError as error:
    ...     print([operation.status for operation in error.results])
    ['complete', 'failed']
    """

    results: Any = None


class FindingsError(Error, ArithmeticError):
    """A result has an error among its checks, and ``strict`` allows none.

    Attributes
    ----------
    results
        Results that were computed.

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
    """The user interrupted the run.

    Attributes
    ----------
    sweep
        Cases solved before the interrupt, for a sweep.

    Examples
    --------
    A handler of Python's own interrupt also catches this one:

    >>> import wholestring as ws
    >>> issubclass(ws.Interrupted, KeyboardInterrupt)
    True
    """

    sweep: Any = None

    def __init__(self, *args: object, make_results: Callable[[], Any] | None = None) -> None:
        """Make the exception; ``make_results`` is called when the results are first read."""
        super().__init__(*args)
        self._results: Any = None
        # The summary of simulated hours would delay the interrupt.
        self._make_results = make_results

    @property
    def results(self) -> Any:
        """Results computed before the interrupt.

        Those of a :class:`Simulation` are made when first read, from its state at that time.
        """
        if self._make_results is not None:
            self._results = self._make_results()
            self._make_results = None
        return self._results

    @results.setter
    def results(self, results: Any) -> None:
        self._results = results

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle with the results, not with the function that makes them."""
        return type(self), self.args, {"results": self.results, "sweep": self.sweep}
