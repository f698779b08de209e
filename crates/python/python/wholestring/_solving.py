"""What a case comes to by each model."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Literal

from . import _values
from ._checked import Checked
from ._columns import rows
from ._commands import count, finished
from ._folder import Place
from ._listener import Listener
from ._planning import words
from ._values import Scalar
from .laws import BitLaw, Excitation
from .laws import bit_law as of_bit
from .laws import excitation as of_shaking
from .plot._shown import of_the_case
from .results import Results
from .simulation import Simulation
from .table import Table


class Solving(Checked):
    """The verbs that solve a case's operations by its models."""

    __slots__ = ()

    def soft(self, operation: str | Sequence[str] | None = None) -> Results:
        """Solve with the soft string: milliseconds.

        Parameters
        ----------
        operation
            The one to solve, or several; all of the case where none is named.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> out, into = (case.soft(of)[of].hook_load_N for of in ("trip_out", "trip_in"))
        >>> out > into  # friction holds the string back either way
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
        """Solve many variations of the case in memory, into one table: a millisecond each.

        Nothing is written: for dynamics, for what is to be kept and for other machines there is
        :func:`sweep`. Every variation is checked before the table is returned.

        Parameters
        ----------
        changes
            The changes of each variation: a list of mappings such as :meth:`Case.with_` takes, or a
            data frame or a mapping of columns, a row for each variation.
        operation
            The one to solve; all of the case where none is named.
        model
            ``"soft"`` or ``"stiff"``.
        jobs
            Number of parallel jobs; one per core by default.

        Returns
        -------
        Table
            A row for each variation and operation: the keys that were changed, SI; scalars,
            findings and how it ended, as the table of a sweep has them; ``case``, the number of the
            variation from zero.

        Raises
        ------
        CaseError
            If a variation is not valid.
        Interrupted
            If the user interrupted it.

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
        """Solve with the stiff string, at rest: tens of milliseconds.

        Parameters
        ----------
        operation
            The one to solve, or several; all of the case where none is named.

        Raises
        ------
        NoAnswerError
            If an operation has no equilibrium; its ``results`` hold the others.

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
        """Solve with the dynamics of the whole string: seconds.

        Parameters
        ----------
        operation
            The one to solve, or several; all of the case where none is named.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Threads that work on solid rock under the bit; one per core by default.

        Raises
        ------
        NoAnswerError
            If an operation diverged; its ``results`` hold what was computed.
        Interrupted
            If the user interrupted it; its ``results`` hold what was computed.

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

        Checkpoints are written as it goes: what was interrupted can be resumed.

        Parameters
        ----------
        folder
            Where the results go; a temporary folder where none is given.
        overwrite
            Whether to replace what lies there, whatever it is of.
        resume
            Whether to continue what lies there.
        csv
            Whether to write the tables as CSV too.
        progress
            Whether to draw a bar, with tqdm.
        jobs
            Threads that work on solid rock under the bit; one per core by default.

        Raises
        ------
        FolderError
            If the results cannot go there.
        NoAnswerError
            If an operation has no answer; its ``results`` hold the others.
        Interrupted
            If the user interrupted it; its ``results`` hold what was computed.

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
        with Listener(progress) as listener:
            core, raised = self._held.run(
                None, None, place.path, place.existing, csv, count(jobs), listener
            )
        return finished(Results(core, place), raised)

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
        jobs
            Threads that work on solid rock under the bit; one per core by default.

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
            held = held.changed([(key, _values.toml(words(operation), key))])
            operation = None
        with Listener(progress) as listener:
            core, raised = held.answer(models, operation, count(jobs), listener)
        return finished(Results(core), raised)
