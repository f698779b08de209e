"""A case with many values: on all cores here, or on any executor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import Executor
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from . import _core, _values
from ._commands import count
from ._dispatch import Dispatcher, running_file
from ._listener import Listener
from ._pool import HasExecutor, Pool
from ._task import Job
from ._values import Scalar, Value
from .case import Case
from .errors import InputError, InputTypeError, Interrupted, NotFoundError
from .results import Results
from .table import Table, html

if TYPE_CHECKING:
    import pandas
    import polars


class Sweep:
    """What a sweep came to: a table with a row for each case, model and operation, and folders.

    Parameters
    ----------
    folder
        Where it lies.

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
        """Read what a sweep left in a folder, of the command line's too.

        Parameters
        ----------
        folder
            The folder.

        Raises
        ------
        ResultsError
            If there is none.

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
        """Where the results lie."""
        return self._folder

    @property
    def table(self) -> Table:
        """The table of ``sweep.csv``: keys that were varied, scalars, indicators, findings."""
        return self._table

    def to_pandas(self) -> pandas.DataFrame:
        """Give :attr:`table` as a pandas data frame.

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
        """Give :attr:`table` as a polars data frame.

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
        """Names of the cases that have ended, in their order; their folders bear them."""
        return tuple(dict.fromkeys(str(of) for of in self._table["folder"]))

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
        """Give the answers of a case, by its name or its number in :attr:`names`.

        Raises
        ------
        ResultsError
            If it has none.
        """
        name = self.names[case] if isinstance(case, int) else case
        if name not in self.names:
            raise NotFoundError(
                f"there is no case {name!r}: the first are {', '.join(self.names[:3])}"
            )
        return Results.load(self._folder / name)

    def __len__(self) -> int:
        """Give the number of cases that have ended."""
        return len(self.names)

    def __iter__(self) -> Iterator[str]:
        """Give the names of the cases."""
        return iter(self.names)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle by the folder."""
        return type(self), (str(self._folder.absolute()),)

    def __repr__(self) -> str:
        """Give its size."""
        failed = f", {len(self.failed)} failed" if self.failed else ""
        return f"<Sweep of {', '.join(self.keys)}: {len(self)} cases{failed}; {self._folder}>"

    def _repr_html_(self) -> str:
        names = [*self.keys, "model", "operation", "hook_load_N", "surface_torque_N_m"]
        names += ["errors", "status"]
        size = f"{len(self._table)} rows"
        return html(self._table, names, caption=repr(self)[1:-1], size=size, shown=20)


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

    Every case is checked before any is solved. The folder is the command line's: either continues
    what the other began, and what is finished is not solved again.

    Parameters
    ----------
    case
        What is varied.
    vary
        Keys, as :meth:`Case.with_` has them, each with its values: ``{"friction": [0.2, 0.3]}``. A
        text has them as the command line does: ``{"bit_depth": "300m..4305m/300m"}``. The last key
        varies fastest.
    together
        Whether the keys are varied together instead: the first value of each, the second of each,
        and so on, as samples are.
    folder
        Where to; ``out/<name of the case> sweep`` where none is given.
    executor
        Who solves the cases: any ``concurrent.futures.Executor``, or a ``Client`` of Dask. Threads
        of this process, without Python, where none is given.
    resume
        Whether to continue what lies in the folder. Otherwise what is finished there is solved
        again, and what was begun there is refused.
    overwrite
        Whether to replace what lies there, whatever it is of.
    keep
        What is kept of each case: its summary, its tables too, or its page too. Where nothing is
        said: the tables where dynamics solve it, else the summary.
    csv
        Whether to write the tables that are kept as CSV too.
    progress
        Whether to draw a bar, with tqdm.
    jobs
        Threads that check the cases, and without an executor solve them; one per core where nothing
        is said.
    checkpoint_every
        Wall-clock time between checkpoints; the case's by default.
    shared_folder
        Whether workers see the folder and write to it themselves, or send the files of their cases
        back. By default, each looks: a file of a random name is there as long as the
        sweep goes on.
    in_flight
        Most bundles of cases that the executor has at a time; three for each worker where nothing
        is said, so that none waits and no scheduler is flooded.
    bundle
        About the time that a bundle of short cases takes. Longer ones come one by one.
    tries
        How often a case is handed out whose worker is lost; then it has failed.

    Raises
    ------
    CaseError
        If cases are invalid; nothing was solved.
    FolderError
        If the folder holds other results.
    Interrupted
        If the user interrupted it; its ``sweep`` holds what was solved.

    Notes
    -----
    A case that has no answer is a row with its reason, and an entry of :attr:`Sweep.failed`.

    Examples
    --------
    On two threads of another pool, which may as well be processes, or Dask's workers:

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
        raise InputError("tries and in_flight are at least 1")
    threads = count(jobs)
    existing = "overwrite" if overwrite else "resume" if resume else "protect"
    bundle_s = cast("float", _values.option("bundle", bundle, "time"))
    checkpoint_s = _values.option("checkpoint_every", checkpoint_every, "time")
    pool = None if executor is None else Pool(executor)
    varied = [(key, _written(key, values)) for key, values in vary.items()]
    if not varied:
        raise InputError("vary names no key: expected such as {'friction': [0.2, 0.3]}")
    _values.refuse_conflicts([key for key, _ in varied])
    with Listener(progress) as listener:
        core = _core.Sweep.begin(
            case._held,
            varied,
            together,
            folder,
            existing,
            keep,
            csv,
            threads,
            checkpoint_s,
            listener,
        )
        into = core.folder()
        try:
            if pool is None:
                (_, interrupted), raised = core.run(listener)
                interrupted = interrupted or isinstance(raised, KeyboardInterrupt)
                if raised is not None and not interrupted:
                    raise raised
            else:
                job = Job(
                    name=case._held.source,
                    text=case._held.template_text(),
                    files=dict(case.files),
                    keep=keep,
                    csv=csv,
                    checkpoint_s=checkpoint_s,
                    running=running_file(into),
                    shared=shared_folder,
                    version=_core.__version__,
                )
                dispatcher = Dispatcher(core, job, listener)
                interrupted = dispatcher.run(
                    pool, in_flight=in_flight, bundle_s=bundle_s, tries=tries
                )
        finally:
            core.close()
    swept = Sweep(into)
    if interrupted:
        error = Interrupted("interrupted: `sweep` of this error has what was solved")
        error.sweep = swept
        raise error
    return swept


def _written(key: str, values: str | Iterable[Value]) -> str | list[str]:
    if isinstance(values, str):
        return values
    if isinstance(values, Mapping) or not isinstance(cast("object", values), Iterable):
        message = f"`{key}` was given {values!r}: expected a list of values, or a text"
        raise InputTypeError(message)
    return [_values.toml(_short(value), key) for value in values]


def _short(value: Value) -> Value:
    """Give a whole number as such: its folder is called ``bit_depth=300 m``, not 300.0."""
    value = cast("Value", _values.plain(value))
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return int(value)
    return value
