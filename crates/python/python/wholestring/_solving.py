"""Solutions of a case by each model."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Literal

from . import _values
from ._checked import Checked
from ._columns import rows
from ._commands import Job, carry_out, count, finished
from ._folder import Place
from ._listener import Listener
from ._values import Scalar
from .laws import BitLaw, Excitation
from .laws import bit_law as of_bit
from .laws import excitation as of_shaking
from .plot._shown import of_the_case
from .results import Results
from .simulation import Simulation
from .table import Table


class Solving(Checked):
    """The methods that solve the operations of a case with each model."""

    __slots__ = ()

    def soft(self, operation: str | Sequence[str] | None = None) -> Results:
        """Solve with the soft-string model, in milliseconds.

        Parameters
        ----------
        operation
            The operation to solve, or several; all of the case by default.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> out, into = (case.soft(name)[name].hook_load_N for name in ("trip_out", "trip_in"))
        >>> out > into  # friction opposes motion in both directions
        True
        """
        return self._solve(["soft"], operation, None, progress=False)

    def soft_many(
        self,
        changes: object,
        operation: str | None = None,
        *,
        model: Literal["soft", "stiff"] = "soft",
        jobs: int | None = None,
    ) -> Table:
        """Solve many variations of the case in memory, into one table, about 1 ms each.

        No files are written; use :func:`sweep` for dynamics, for results on disk and for other
        machines. Every variation is checked before the table is returned.

        Parameters
        ----------
        changes
            The changes of each variation: a list of mappings as for :meth:`Case.with_`, or a data
            frame or a mapping of columns with a row for each variation.
        operation
            The operation to solve; all of the case by default.
        model
            ``"soft"`` or ``"stiff"``.
        jobs
            Number of parallel jobs; one per core by default.

        Returns
        -------
        Table
            A row for each variation and operation: the changed keys, SI; scalars, findings and
            status, as in the table of a sweep; ``case``, the number of the variation from zero.

        Raises
        ------
        CaseError
            If a variation is not valid.
        Interrupted
            If the user interrupted the run.

        Examples
        --------
        >>> import numpy as np
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> table = case.soft_many({"friction": np.linspace(0.2, 0.3, 3)}, "trip_out")
        >>> [f"{load / 1e3:.0f} kN" for load in table["hook_load_N"]]
        ['400 kN', '419 kN', '438 kN']
        """
        variations = [_values.changes(one, {}) for one in rows(changes)]
        with Listener(progress=False) as listener:
            held, _ = self._held.many(variations, model, operation, count(jobs), listener)
        return Table(held, "sweep")

    def stiff(self, operation: str | Sequence[str] | None = None) -> Results:
        """Solve with the static stiff-string model, in tens of milliseconds.

        Parameters
        ----------
        operation
            The operation to solve, or several; all of the case by default.

        Raises
        ------
        NoAnswerError
            If an operation has no equilibrium; ``results`` of the error holds the others.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> stiff, soft = case.stiff("drill")["drill"], case.soft("drill")["drill"]
        >>> abs(stiff.hook_load_N / soft.hook_load_N - 1.0) < 0.01
        True
        """
        return self._solve(["stiff"], operation, None, progress=False)

    def dynamic(
        self,
        operation: str | Sequence[str] | None = None,
        *,
        progress: bool = False,
        jobs: int | None = None,
    ) -> Results:
        """Solve the dynamics of the whole string, in seconds.

        Parameters
        ----------
        operation
            The operation to solve, or several; all of the case by default.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Number of threads for solid rock under the bit; one per core by default.

        Raises
        ------
        NoAnswerError
            If an operation diverged; ``results`` of the error holds the results so far.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds the results so far.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="20 m", dynamics__duration="1 s")
        >>> drilling = case.dynamic("drill")["drill"]
        >>> drilling.statistics["hook_load_N"]["std"] < 1e-3 * drilling.hook_load_N
        True
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

        Checkpoints are written during the run, so that an interrupted run can be resumed.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        resume
            Whether to continue an interrupted run in the folder.
        csv
            Whether to write the tables as CSV as well.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Number of threads for solid rock under the bit; one per core by default.

        Raises
        ------
        FolderError
            If the results cannot be written to the folder.
        NoAnswerError
            If an operation has no answer; ``results`` of the error holds the others.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds the results so far.

        Examples
        --------
        >>> import tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     results = ws.Case.example().with_(model="soft").run(place + "/here")
        ...     print((results.folder / "report.html").is_file())
        True
        """
        place = Place(folder, overwrite=overwrite, resume=resume)
        job = Job({"kind": "run", "csv": csv}, [self._held], jobs=jobs)
        return carry_out(Results, place, job, progress=progress)

    def simulation(
        self,
        operation: str | None = None,
        *,
        checkpoint: bytes | None = None,
        bit_law: BitLaw | None = None,
        excitation: Excitation | None = None,
        rate: Scalar = 1000.0,
        jobs: int | None = None,
    ) -> Simulation:
        """Begin a dynamic run that the caller advances.

        Parameters
        ----------
        operation
            The operation; the only one of the case by default.
        checkpoint
            Bytes from :meth:`Simulation.checkpoint`; the run continues from them with bit-identical
            results.
        bit_law
            Bit-rock law in place of the law of the case: a function of a :class:`BitReading` that
            returns the depth of cut per revolution, m, and the torque, N·m. Between two calls both
            are scaled in proportion to the weight, and the rate of penetration to the speed. This
            is exact for a proportional law; for others the error is proportional to the interval
            between calls. The rock front keeps the stiffness from the case.
        excitation
            Excitation of the bit: a function of a :class:`ShakeReading` that returns the added
            depth of the rock front, m, and the relative increase of the torque. It is evaluated
            one period ahead and interpolated linearly, which is second order in the period.
        rate
            Rate of calls to both functions: ``"1 kHz"``, or 1/s; at most one call per step.
        jobs
            Number of threads for solid rock under the bit; one per core by default.

        Raises
        ------
        FolderError
            If the checkpoint is of another case, or of laws with other names or another rate.
        InputError
            If the case has no such operation, or no bit-rock law that a function can replace.

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
        threads = count(jobs)
        with Listener(progress=False) as listener:
            held = self._held.simulation(operation, checkpoint, *laws, threads, listener)
        return Simulation(held, of_the_case(self))

    def _solve(
        self,
        models: list[str],
        operation: str | Sequence[str] | None,
        jobs: int | None,
        *,
        progress: bool,
    ) -> Results:
        held = self._held
        if operation is not None and not isinstance(operation, str):
            key = "operation.kind"
            held = held.changed([(key, _values.toml(_values.words("operation", operation), key))])
            operation = None
        with Listener(progress) as listener:
            core, raised = held.answer(models, operation, count(jobs), listener)
        return finished(Results(core), raised)
