"""A case with many values: on all cores here, or on any executor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import Executor
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from . import _core, _task, _values
from ._commands import Job, quantity
from ._dispatch import Dispatcher, running_file
from ._listener import Listener
from ._pool import HasExecutor, Pool
from ._values import Scalar, Value
from .case import Case
from .errors import InputError, InputTypeError, Interrupted, NotFoundError
from .results import Results
from .table import Table, html

if TYPE_CHECKING:
    import pandas
    import polars


class Sweep:
    """Results of a sweep: a table with a row for each case, model and operation, and folders.

    Parameters
    ----------
    folder
        Folder of the sweep.

    Examples
    --------
    >>> import tempfile, wholestring as ws
    >>> case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
    >>> swept = ws.sweep(case, {"friction": [0.2, 0.3]}, folder=tempfile.mkdtemp())
    >>> swept.names
    ('friction=0.2', 'friction=0.3')
    >>> [f"{load / 1e3:.0f} kN" for load in swept.table["hook_load_N"]]
    ['400 kN', '438 kN']
    >>> swept["friction=0.2"]["trip_out"].model
    'soft'
    """

    def __init__(self, folder: str | PathLike[str]) -> None:
        self._folder = Path(folder)
        self._varied, table = _core.sweep_table(self._folder)
        self._table = Table(table, "sweep")

    @classmethod
    def load(cls, folder: str | PathLike[str]) -> Sweep:
        """Read the results of a sweep from a folder, also one of the command line.

        Parameters
        ----------
        folder
            The folder.

        Raises
        ------
        ResultsError
            If the folder has no sweep.

        Examples
        --------
        >>> import tempfile
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
        >>> with tempfile.TemporaryDirectory() as place:
        ...     swept = ws.sweep(case, {"friction": [0.2, 0.3]}, folder=place + "/here")
        ...     print(ws.Sweep.load(swept.folder).names)
        ('friction=0.2', 'friction=0.3')
        """
        return cls(folder)

    @property
    def folder(self) -> Path:
        """Folder of the results."""
        return self._folder

    @property
    def table(self) -> Table:
        """The table of ``sweep.csv``: varied keys, scalars, indicators, findings."""
        return self._table

    def to_pandas(self) -> pandas.DataFrame:
        """Return :attr:`table` as a pandas data frame.

        Examples
        --------
        >>> import tempfile, wholestring as ws
        >>> case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
        >>> swept = ws.sweep(case, {"friction": [0.2, 0.3]}, folder=tempfile.mkdtemp())
        >>> swept.to_pandas()["friction"].tolist()
        [0.2, 0.3]
        """
        return self._table.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """Return :attr:`table` as a polars data frame.

        Examples
        --------
        >>> import tempfile, wholestring as ws
        >>> case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
        >>> swept = ws.sweep(case, {"friction": [0.2, 0.3]}, folder=tempfile.mkdtemp())
        >>> swept.to_polars()["friction"].to_list()
        [0.2, 0.3]
        """
        return self._table.to_polars()

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.names)

    @property
    def keys(self) -> tuple[str, ...]:
        """The keys that were varied."""
        return self._table.columns[: self._varied]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the cases that have ended, in their order; also the names of their folders."""
        return tuple(dict.fromkeys(str(name) for name in self._table["folder"]))

    @cached_property
    def failed(self) -> Mapping[str, str]:
        """Cases that have no answer, each with the reason."""
        table = self._table
        failed: dict[str, str] = {}
        rows = zip(
            table["folder"], table["status"], table["operation"], table["message"], strict=True
        )
        for name, status, operation, message in rows:
            if status == "failed":
                reason = f"{operation}: {message}" if operation else str(message)
                failed[name] = f"{failed[name]}; {reason}" if name in failed else reason
        return failed

    def __getitem__(self, case: str | int) -> Results:
        """Return the results of a case, by its name or its number in :attr:`names`.

        Raises
        ------
        ResultsError
            If the case has no results.
        """
        name = self.names[case] if isinstance(case, int) else case
        if name not in self.names:
            raise NotFoundError(
                f"there is no case {name!r}: the first are {', '.join(self.names[:3])}"
            )
        return Results.load(self._folder / name)

    def __len__(self) -> int:
        """Return the number of cases that have ended."""
        return len(self.names)

    def __iter__(self) -> Iterator[str]:
        """Return an iterator over the names of the cases."""
        return iter(self.names)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle by the folder."""
        return type(self), (str(self._folder.absolute()),)

    def __repr__(self) -> str:
        """Return a summary with the number of cases."""
        failed = f", {len(self.failed)} failed" if self.failed else ""
        return f"<Sweep of {', '.join(self.keys)}: {len(self)} cases{failed}; {self._folder}>"

    def _repr_html_(self) -> str:
        names = [*self.keys, "model", "operation", "hook_load_N", "surface_torque_N_m"]
        names += ["errors", "status"]
        size = f"{len(self._table)} rows"
        return html(self._table, names, caption=repr(self)[1:-1], size=size, count=20)


def sweep(
    case: Case,
    vary: Mapping[str, str | Iterable[Value]],
    *,
    together: bool = False,
    folder: str | PathLike[str] | None = None,
    executor: Executor | HasExecutor | None = None,
    resume: bool = True,
    overwrite: bool = False,
    keep: Literal["summary", "tables", "all"] | None = None,
    csv: bool = False,
    progress: bool = False,
    jobs: int | None = None,
    checkpoint_every: Scalar | None = None,
    shared_folder: bool | None = None,
    in_flight: int | None = None,
    bundle: Scalar = "0.5 s",
    tries: int = 3,
) -> Sweep:
    """Solve a case with all combinations of some values, into a folder, as ``wholestring sweep``.

    Every case is checked before any is solved. The folder has the same form as that of the command
    line, so that either continues a sweep of the other. Completed cases are not solved again.

    Parameters
    ----------
    case
        The case that is varied.
    vary
        Keys, as for :meth:`Case.with_`, each with its values: ``{"friction": [0.2, 0.3]}``. A text
        has the form of the command line: ``{"bit_depth": "300m..4305m/300m"}``. The last key varies
        fastest.
    together
        Whether the keys are varied together instead: the first value of each, the second of each,
        and so on, as for samples.
    folder
        Folder for the results; ``out/<name of the case> sweep`` by default.
    executor
        Executor that solves the cases: any ``concurrent.futures.Executor``, or a ``Client`` of
        Dask. By default, threads of this process that run without Python.
    resume
        Whether to continue a sweep in the folder. Otherwise completed cases are solved again, and
        a folder with an incomplete sweep is refused.
    overwrite
        Whether to replace existing results in the folder, whatever wrote them.
    keep
        Files kept for each case: its summary, also its tables, or also its page. By default, the
        tables if dynamics solve it, otherwise the summary.
    csv
        Whether to write the kept tables as CSV as well.
    progress
        Whether to draw a bar, with tqdm.
    jobs
        Number of threads that check the cases, and solve them if there is no executor; one per core
        by default.
    checkpoint_every
        Wall-clock time between checkpoints; the case's by default.
    shared_folder
        Whether workers see the folder and write to it themselves, or send the files of their cases
        back. By default, each worker looks for a file with a random name that exists while the
        sweep runs.
    in_flight
        Largest number of bundles of cases in the executor at a time; three for each worker by
        default, so that no worker waits and no scheduler is flooded.
    bundle
        Approximate time of a bundle of short cases. Longer cases are submitted one by one.
    tries
        Number of times to submit a case whose worker is lost before it is marked as failed.

    Raises
    ------
    CaseError
        If cases are invalid; no case was solved.
    FolderError
        If the folder holds other results.
    Interrupted
        If the user interrupted the sweep; ``sweep`` of the error holds the solved cases.

    Notes
    -----
    A case that has no answer is a row with its reason, and an entry of :attr:`Sweep.failed`.

    Examples
    --------
    On two threads of another pool, which may also be processes or workers of Dask:

    >>> import tempfile
    >>> from concurrent.futures import ThreadPoolExecutor
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(model="soft", operation__kind="trip_out")
    >>> vary = {"friction": [0.2, 0.3], "bit_depth": "800m..1200m/200m"}
    >>> with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(2) as pool:
    ...     swept = ws.sweep(case, vary, folder=place + "/here", executor=pool)
    ...     print(len(swept), swept.failed)
    6 {}
    """
    if min(tries, 1 if in_flight is None else in_flight) < 1:
        raise InputError("`tries` and `in_flight` must be at least 1")
    bundle_s = cast("float", _values.option("bundle", bundle, "time"))
    checkpoint = quantity("checkpoint_every", checkpoint_every, "time")
    pool = None if executor is None else Pool(executor)
    varied = _values.mapping("vary", vary)
    if not varied:
        raise InputError("vary names no key: expected such as {'friction': [0.2, 0.3]}")
    written = [_written(key, values) for key, values in varied.items()]
    _values.refuse_conflicts(list(varied))
    job = Job(
        {"kind": "sweep", "vary": written, "together": together, "keep": keep, "csv": csv},
        cases=[case._held],
        jobs=jobs,
        checkpoint=checkpoint,
    )
    existing = "overwrite" if overwrite else "resume" if resume else "protect"
    with Listener(progress) as listener:
        core = _core.Sweep.begin(job.text(existing), case._held, folder, listener)
        into = core.folder()
        try:
            if pool is None:
                (_, interrupted), raised = core.run(listener)
                interrupted = interrupted or isinstance(raised, KeyboardInterrupt)
                if raised is not None and not interrupted:
                    raise raised
            else:
                remote = _task.Job(
                    name=case._held.source,
                    text=case._held.template_text(),
                    files=dict(case.files),
                    options=core.remote_options(),
                    running=running_file(into),
                    shared=shared_folder,
                    version=_core.__version__,
                )
                dispatcher = Dispatcher(core, remote, listener)
                interrupted = dispatcher.run(
                    pool, in_flight=in_flight, bundle_s=bundle_s, tries=tries
                )
        finally:
            core.close()
    swept = Sweep(into)
    if interrupted:
        error = Interrupted("interrupted: `sweep` of this error holds the solved cases")
        error.sweep = swept
        raise error
    return swept


def _written(key: str, values: str | Iterable[Value]) -> object:
    if isinstance(values, str):
        return f"{key}={values}"
    if isinstance(values, Mapping) or not isinstance(cast("object", values), Iterable):
        message = f"`{key}` was given {values!r}: expected a list of values, or a text"
        raise InputTypeError(message)
    return {"key": key, "values": [_values.toml(_short(value), key) for value in values]}


def _short(value: Value) -> Value:
    """Return a whole number as an integer, so that a folder is ``bit_depth=300 m``, not 300.0."""
    value = cast("Value", _values.plain(value))
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return int(value)
    return value
