"""Studies: sweeps of cases, with the figures and tables made from them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Literal

from . import _values
from ._base import BaseResults, Check
from ._commands import Job, attempted, finished
from ._folder import Place
from ._values import Scalar, Value
from .errors import FindingsError, InputError, NotFoundError
from .sweep import Sweep
from .table import Table


class Study(BaseResults):
    """A study: its sweeps, its figures and its tables.

    :func:`wholestring.study` runs one.

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
    ... set = { model = "soft" }
    ... vary = { friction = [0.2, 0.3] }
    ... '''
    >>> with tempfile.TemporaryDirectory() as place:
    ...     _ = Path(place, "slant.toml").write_text(ws.Case.example().to_toml())
    ...     _ = Path(place, "study.toml").write_text(text)
    ...     done = ws.study(Path(place, "study.toml"))
    >>> done["statics"].names
    ('friction=0.2', 'friction=0.3')
    """

    __slots__ = ()
    _kind = "a study"

    @property
    def _root(self) -> Path:
        folder = self.folder
        if folder is None:
            raise InputError("the study has no folder")
        return folder

    @property
    def sweeps(self) -> tuple[str, ...]:
        """Names of the sweeps."""
        inside = sorted(self._root.iterdir())
        return tuple(entry.name for entry in inside if (entry / "sweep.csv").is_file())

    def __getitem__(self, sweep: str) -> Sweep:
        """Return a sweep by its name.

        The sweep of a study in a temporary folder can be read while the study exists.
        """
        if sweep not in self.sweeps:
            raise NotFoundError(f"there is no sweep {sweep!r}: there are {', '.join(self.sweeps)}")
        return Sweep(self._root / sweep)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.sweeps)

    @property
    def figures(self) -> Mapping[str, Path]:
        """The files of the figures, by their names."""
        return {file.stem: file for file in sorted((self._root / "figures").glob("*.svg"))}

    @property
    def checks(self) -> tuple[Check, ...]:
        """The most severe check of each case whose results have errors."""
        return tuple(check for sweep in self.sweeps for check in _errors(self[sweep].table))

    def _facts(self) -> Sequence[tuple[str, str]]:
        return [(sweep, f"{len(self[sweep])} cases") for sweep in self.sweeps]


def _errors(rows: Table) -> Iterator[Check]:
    for row in range(len(rows)):
        if rows["errors"][row] > 0:
            sentence = f"{rows['folder'][row]}: {rows['worst_check_sentence'][row]}"
            kind = str(rows["worst_check"][row])
            yield Check(kind=kind, severity="error", verdict="error", sentence=sentence)


def study(
    path: str | PathLike[str],
    folder: str | PathLike[str] | None = None,
    *,
    changes: Mapping[str, Value] | None = None,
    keep: Literal["summary", "tables", "all"] | None = None,
    strict: bool = False,
    shard: str | None = None,
    resume: bool = False,
    overwrite: bool = False,
    checkpoint: Scalar | None = None,
    csv: bool = False,
    png: bool = False,
    jobs: int | None = None,
    progress: bool = False,
) -> Study:
    """Solve the cases of a study, and write its figures, its tables and its page.

    Parameters
    ----------
    path
        The study file.
    folder
        Folder for the results; a temporary folder by default.
    changes
        Keys that are set in every case, as for :meth:`Case.with_`.
    keep
        Files kept for each case; by default, its tables if dynamics solve it or a figure
        needs them, otherwise its summary.
    strict
        Whether to raise an error if a result has an error among its checks.
    shard
        Share of the cases to solve, such as ``"1/4"``.
    resume
        Whether to skip the cases that are complete in the folder.
    overwrite
        Whether to replace existing results in the folder, whatever wrote them.
    checkpoint
        Wall-clock time between checkpoints: ``"5 min"``, or seconds.
    csv
        Whether to write the kept tables as CSV as well.
    png
        Whether to write PNG images as well.
    jobs
        Number of parallel jobs, each solving one case; one per core by default.
    progress
        Whether to draw a bar, with tqdm.

    Raises
    ------
    CaseError
        If the study or its cases have mistakes: all of them.
    FolderError
        If the results cannot be written to the folder.
    NoAnswerError
        If cases failed; ``results`` of the error holds the others.
    FindingsError
        If errors were found and ``strict`` is set.
    Interrupted
        If the user interrupted the run; ``results`` of the error holds the results so far.

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
    ... set = { model = "soft" }
    ... vary = { friction = [0.2, 0.3] }
    ... '''
    >>> with tempfile.TemporaryDirectory() as place:
    ...     _ = Path(place, "slant.toml").write_text(ws.Case.example().to_toml())
    ...     _ = Path(place, "study.toml").write_text(text)
    ...     done = ws.study(Path(place, "study.toml"))
    >>> done.sweeps, len(done["statics"])
    (('statics',), 2)
    >>> isinstance(done, ws.Study), isinstance(done["statics"], ws.Sweep)
    (True, True)
    """
    place = Place(folder, overwrite=overwrite, resume=resume)
    job = Job(
        {"kind": "study", "study": "study", "keep": keep, "shard": shard, "csv": csv, "png": png},
        paths={"study": path},
        changes=_values.changes({} if changes is None else changes, {}),
        jobs=jobs,
        checkpoint=checkpoint,
    )
    solved, raised, with_errors = attempted(Study, place, job, progress=progress)
    results = finished(solved, raised)
    if strict and with_errors:
        error = FindingsError("errors were found in\n" + "\n".join(with_errors))
        error.results = results
        raise error
    return results
