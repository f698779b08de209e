"""A case: well, string, mud, rig and operations."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike
from typing import Any, cast

from . import _core, _values
from ._listener import Listener
from ._values import Scalar, Value
from .errors import Diagnostic, Interrupted, NoAnswerError
from .laws import BitLaw, Excitation
from .laws import bit_law as of_bit
from .laws import excitation as of_shaking
from .results import Results
from .simulation import Simulation


class Case:
    """A case in which everything has been checked. It is immutable.

    Parameters
    ----------
    text
        A case file's text.
    name
        What errors call the text.
    files
        The files that it names, such as its survey, each by the name that it has there.

    Raises
    ------
    CaseError
        With all mistakes of the case, each with its place.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(friction=0.25, operation__bit_depth="1000 m")
    >>> case.soft()["trip_out"].bit_depth_m
    1000.0
    """

    __slots__ = ("_held",)
    _held: _core.Case

    def __init__(
        self,
        text: str,
        *,
        name: str = "case",
        files: Mapping[str, bytes] | None = None,
    ) -> None:
        self._held = _core.Case.parse(text, name, dict(files or {}))

    @classmethod
    def _of(cls, core: _core.Case) -> Case:
        case = cls.__new__(cls)
        case._held = core
        return case

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Read a case file, and the files that it names.

        Raises
        ------
        CaseError
            With all mistakes of the case, each with its place.
        """
        return cls._of(_core.Case.load(path))

    @classmethod
    def from_dict(
        cls,
        table: Mapping[str, Value],
        *,
        name: str = "case",
        files: Mapping[str, bytes] | None = None,
    ) -> Case:
        """Make a case of Python objects: the tables and keys of a case file.

        Numbers are SI, texts may have units, and so may quantities of pint.

        Parameters
        ----------
        table
            The case: ``{"mud": {"density": 1200.0}, "string": [{...}], ...}``.
        name
            What errors call it.
        files
            The files that it names, each by the name that it has there.
        """
        return cls(_values.document(table), name=name, files=files)

    @classmethod
    def example(cls) -> Case:
        """Give a slant well of 1200 m, to try things on."""
        return cls(_core.EXAMPLE, name="slant.toml")

    def with_(self, changes: Mapping[str, Value] | None = None, /, **keys: Value) -> Case:
        """Make another case: this one with other values.

        Parameters
        ----------
        changes
            Dotted keys of the case file, lists counted from zero, and their values:
            ``{"well.hole.0.friction": 0.2}``.
        **keys
            The same as keywords, ``__`` for a dot: ``operation__bit_depth="300 m"``. Short keys are
            ``friction`` (every hole section), ``bit_depth``, ``rpm`` and ``wob``.

        Raises
        ------
        CaseError
            If the case would not be sound.
        """
        return Case._of(self._held.changed(list(_values.changes(changes or {}, keys))))

    @property
    def name(self) -> str:
        """What the case is called."""
        return self._held.name

    @property
    def models(self) -> tuple[str, ...]:
        """The models that the case names."""
        return tuple(self._held.models)

    @property
    def operations(self) -> tuple[str, ...]:
        """The operations, in their order."""
        return tuple(self._held.operations)

    @property
    def settings(self) -> Mapping[str, Any]:
        """The case with all defaults filled in: SI numbers, units in the names of the keys."""
        return cast("dict[str, Any]", json.loads(self._held.settings_json()))

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """What is probably not meant, but can be computed."""
        return tuple(Diagnostic(**found) for found in self._held.warnings())

    @property
    def files(self) -> Mapping[str, bytes]:
        """The files that the case names, as they were read."""
        return self._held.files()

    def to_toml(self) -> str:
        """Give the case as the text of a case file, with its comments and its changes."""
        return self._held.to_toml()

    def soft(self, operation: str | None = None) -> Results:
        """Solve with the soft string: milliseconds.

        Parameters
        ----------
        operation
            The one to solve; all of the case where none is named.
        """
        return self._solve(["soft"], operation, None, progress=False)

    def stiff(self, operation: str | None = None) -> Results:
        """Solve with the stiff string, at rest: tens of milliseconds.

        Parameters
        ----------
        operation
            The one to solve; all of the case where none is named.

        Raises
        ------
        NoAnswerError
            If an operation has no equilibrium; its ``results`` hold the others.
        """
        return self._solve(["stiff"], operation, None, progress=False)

    def dynamic(
        self,
        operation: str | None = None,
        *,
        progress: bool = False,
        jobs: int | None = None,
    ) -> Results:
        """Solve with the dynamics of the whole string: seconds.

        Parameters
        ----------
        operation
            The one to solve; all of the case where none is named.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Threads that work on solid rock under the bit; one per core where nothing is said.

        Raises
        ------
        NoAnswerError
            If an operation diverged; its ``results`` hold what was computed.
        Interrupted
            If the user interrupted it; its ``results`` hold what was computed.
        """
        return self._solve(["dynamic"], operation, jobs, progress=progress)

    def run(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        overwrite: bool = False,
        resume: bool = False,
        csv: bool = False,
        progress: bool = False,
        jobs: int | None = None,
    ) -> Results:
        """Solve with the models that the case names, into a folder, as the command line does.

        Checkpoints are written as it goes: what was interrupted can be resumed.

        Parameters
        ----------
        folder
            Where to; ``out/<name of the case>`` where none is given.
        overwrite
            Whether to replace what lies there, whatever it is of.
        resume
            Whether to continue what lies there.
        csv
            Whether to write the tables as CSV too.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Threads that work on solid rock under the bit; one per core where nothing is said.
        """
        if overwrite and resume:
            raise ValueError("overwrite and resume exclude each other")
        existing = "resume" if resume else "overwrite" if overwrite else "protect"
        with Listener(progress) as listener:
            core, raised = self._held.run(None, None, folder, existing, csv, jobs, listener)
        return _finished(Results(core), raised)

    def simulation(
        self,
        operation: str | None = None,
        *,
        checkpoint: bytes | None = None,
        bit_law: BitLaw | None = None,
        excitation: Excitation | None = None,
        rate: Scalar = 1000.0,
    ) -> Simulation:
        """Begin a dynamic run that you take forward yourself.

        Parameters
        ----------
        operation
            The operation; the case's only one where none is named.
        checkpoint
            What :meth:`Simulation.checkpoint` gave: the run continues from there, to the same
            bits.
        bit_law
            How the rock answers the bit, in place of the case's law: a function of a
            :class:`BitReading` that gives the depth of cut per revolution, m, and the torque, N·m.
            Between two questions both are in proportion to the weight, and the rate of penetration
            to the speed: exact of a law that is so, of others an error in proportion to the time
            between. The rock front keeps the stiffness that the case has for it.
        excitation
            What shakes the bit: a function of a :class:`ShakeReading` that gives how much deeper
            the rock front stands, m, and by which part the torque is larger. It is asked a period
            ahead and followed on a straight line, to the second order in the period.
        rate
            How often they are asked: ``"1 kHz"``, or 1/s; once a step at most.

        Raises
        ------
        FolderError
            If the checkpoint is of another case, or of other laws: by their names and their rate.
        InputError
            If the case has no such operation, or its bit no law to follow.

        Examples
        --------
        A bit that takes 20 mm per revolution and MN, with 50 N·m per kN:

        >>> import wholestring as ws
        >>> def law(bit: ws.BitReading) -> tuple[float, float]:
        ...     return 2e-8 * bit.weight_on_bit_N, 0.05 * bit.weight_on_bit_N
        >>> case = ws.Case.example().with_(mesh__element_length="10 m")
        >>> sim = case.simulation("drill", bit_law=law, rate="500 Hz")
        >>> sim.advance("0.2 s")
        >>> bool(sim.now["depth_of_cut_m"] > 0.5e-3)
        True
        """
        laws = of_bit(bit_law, rate), of_shaking(excitation, rate)
        with Listener(progress=False) as listener:
            return Simulation(self._held.simulation(operation, checkpoint, *laws, listener))

    def _solve(
        self, models: list[str], operation: str | None, jobs: int | None, *, progress: bool
    ) -> Results:
        with Listener(progress) as listener:
            core, raised = self._held.answer(models, operation, jobs, listener)
        return _finished(Results(core), raised)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as text."""
        return _restored, (self.to_toml(), self._held.source, dict(self.files))

    def __eq__(self, other: object) -> bool:
        """Tell whether all settings are the same."""
        if not isinstance(other, Case):
            return NotImplemented
        return self._held.settings_json() == other._held.settings_json()

    def __hash__(self) -> int:
        """Give a hash of all settings."""
        return hash(self._held.settings_json())

    def __repr__(self) -> str:
        """Give its name, models and operations."""
        return f"<Case {self.name}: {', '.join(self.models)}; {', '.join(self.operations)}>"


def _restored(text: str, name: str, files: dict[str, bytes]) -> Case:
    return Case(text, name=name, files=files)


def _finished(results: Results, raised: BaseException | None) -> Results:
    if raised is None:
        return results
    if isinstance(raised, KeyboardInterrupt):
        raised = Interrupted("interrupted: `results` of this error has what was computed")
    if isinstance(raised, Interrupted | NoAnswerError):
        raised.results = results
    raise raised
