"""Base class of all results."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from os import PathLike
from pathlib import Path
from typing import Any, ClassVar, TypeVar

from . import _core, _html
from ._folder import Place
from ._listener import Listener
from ._pickled import Reduced, reduced
from .errors import ResultsError
from .table import Table

R = TypeVar("R", bound="BaseResults")


@dataclass(frozen=True, kw_only=True)
class Check:
    """Comparison of one result with a limit, or a state that is reported.

    Attributes
    ----------
    kind
        Quantity that is compared, or state that is reported: ``lock_up``, ``top_drive``,
        ``von_mises``.
    severity
        Its severity: ``ok``, ``note``, ``warning`` or ``error``.
    sentence
        The check as a sentence in the user's units.
    verdict
        The verdict in words: ``OK``, ``marginal``, ``below required factor``, ``exceeded``; the
        severity where there is no limit.
    component
        The component; none for the rig and for the whole string.
    md_m
        Measured depth of the place, or of the upper end of its interval, m; none without a place.
    to_md_m
        Measured depth of the lower end of its interval, m; none for a point and without a place.
    value
        The value, for a limit the load, in ``unit``; none where it is not a number.
    limit
        Number that the value is compared with, for a limit the capacity; none where there is no
        such number.
    factor
        Capacity over load; none for a kind that is not a limit.
    required
        The required factor; none for a kind that is not a limit.
    unit
        SI unit of value and limit; empty for a ratio.

    Examples
    --------
    >>> import wholestring as ws
    >>> results = ws.Case.example().with_(friction=1.5).soft("slide")
    >>> results.checks[0].severity
    'error'
    """

    kind: str
    severity: str
    sentence: str
    verdict: str = ""
    component: str | None = None
    md_m: float | None = None
    to_md_m: float | None = None
    value: float | None = None
    limit: float | None = None
    factor: float | None = None
    required: float | None = None
    unit: str = ""

    @property
    def reserve(self) -> float:
        """Factor over the required factor: below 1 is too low; infinite where there is no limit."""
        if self.factor is None or self.required is None:
            return math.inf
        return self.factor / self.required


_CHECK_KEYS = frozenset(field.name for field in fields(Check))


def check_of(row: Mapping[str, Any]) -> Check:
    """Return the check in a row of a summary; other keys of the row are ignored."""
    return Check(**{key: value for key, value in row.items() if key in _CHECK_KEYS})


class BaseResults:
    """Results of a command: a summary, tables, and the folder that contains them.

    Results of a command without a folder are in a temporary folder, which is removed with them;
    :meth:`save` writes the same folder as the command line. Results can be pickled: those in a
    folder of the user as the path of that folder, all others with their numbers.

    Examples
    --------
    >>> import wholestring as ws
    >>> plan = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]}).plan()
    >>> isinstance(plan, ws.BaseResults), plan.case_name
    (True, 'Slant well')
    """

    __slots__ = ("_core", "_place", "_summary", "_tables")

    _kind: ClassVar[str]

    def __init__(self, core: _core.Answers, place: Place | None = None) -> None:
        self._core = core
        self._place = place
        self._summary: dict[str, Any] | None = None
        self._tables: dict[str, Table] = {}

    @classmethod
    def load(cls: type[R], folder: str | PathLike[str]) -> R:
        """Read the results of a command from a folder.

        Parameters
        ----------
        folder
            The folder.

        Raises
        ------
        ResultsError
            If the folder has no results, or those of another command.

        Examples
        --------
        >>> import tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     saved = ws.Case.example().soft("drill").save(place + "/here")
        ...     loaded = ws.Results.load(saved)
        >>> loaded["drill"].operation
        'drill'
        """
        core = _core.Answers.load(folder)
        if core.kind != cls._kind:
            message = f"{folder} holds {core.kind} and not {cls._kind}: wholestring.load reads both"
            raise ResultsError(message)
        return cls(core)

    def save(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        overwrite: bool = False,
        csv: bool = False,
    ) -> Path:
        """Write the same folder as the command line, with its page, and return its path.

        :attr:`folder` is this folder afterwards.

        Parameters
        ----------
        folder
            The folder; ``out/<name of the case>`` by default, as on the command line.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        csv
            Whether to write all tables as CSV as well.

        Raises
        ------
        FolderError
            If the folder holds other results.

        Examples
        --------
        >>> import tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     saved = ws.Case.example().soft("drill").save(place + "/here", csv=True)
        ...     print(sorted(file.name for file in saved.glob("nodes.*")))
        ['nodes.csv', 'nodes.parquet']
        """
        with Listener(progress=False) as listener:
            saved = Path(self._core.save(folder, overwrite, csv, listener))
        self._core = _core.Answers.load(saved)
        self._place = None
        return saved

    def __reduce__(self) -> Reduced:
        """Pickle a folder of the user by its path, and other results with their content."""
        return reduced(self)

    @property
    def folder(self) -> Path | None:
        """Folder of the results; ``None`` while they are in memory."""
        return self._core.folder

    @property
    def summary(self) -> Mapping[str, Any]:
        """All of ``summary.json``."""
        if self._summary is None:
            self._summary = dict(json.loads(self._core.summary_json()))
        return self._summary

    @property
    def case_name(self) -> str:
        """Name of the case."""
        return str(self.summary.get("case", self.folder.name if self.folder else ""))

    @property
    def tables(self) -> tuple[str, ...]:
        """Names of the tables."""
        return tuple(self._core.table_names())

    def table(self, name: str) -> Table:
        """Return a table by its name, one of :attr:`tables`.

        Parameters
        ----------
        name
            ``"nodes"``, ``"time"``, and so on.

        Raises
        ------
        KeyError
            If there is no table of that name.

        Examples
        --------
        >>> import wholestring as ws
        >>> results = ws.Case.example().soft("drill")
        >>> results.tables
        ('nodes', 'wear')
        >>> results.table("nodes").unit("torque_N_m")
        'N·m'
        """
        if name not in self._tables:
            self._tables[name] = Table(self._core.table(name), name)
        return self._tables[name]

    @property
    def checks(self) -> tuple[Check, ...]:
        """All checks of the result, as its summary has them."""
        rows = self.summary.get("checks", [])
        return tuple(check_of(row) for row in rows)

    @property
    def findings(self) -> tuple[Check, ...]:
        """The checks that need attention, the most severe first."""
        return most_severe_first(self.checks)

    def _facts(self) -> Sequence[tuple[str, str]]:
        """Return the facts to display: names, and numbers with their units."""
        return ()

    def __repr__(self) -> str:
        """Return the name of the case with the main numbers."""
        facts = ", ".join(f"{name} {value}" for name, value in self._facts())
        name = type(self).__name__
        return (
            f"<{name} of {self.case_name}: {facts}>" if facts else f"<{name} of {self.case_name}>"
        )

    def _repr_html_(self) -> str:
        rows = [*self._facts(), *((check.severity, check.sentence) for check in self.findings)]
        return _html.facts(rows, caption=f"{type(self).__name__} of {self.case_name}")


def most_severe_first(checks: Iterable[Check]) -> tuple[Check, ...]:
    """Return the checks that need attention, the most severe first."""
    order = ("error", "warning", "note")
    found = [check for check in checks if check.severity in order]
    return tuple(sorted(found, key=lambda check: order.index(check.severity)))
