"""What a case comes to by each model."""

from __future__ import annotations

from os import PathLike

from ._checked import Checked
from ._commands import count, finished
from ._folder import Place
from ._listener import Listener
from ._values import Scalar
from .laws import BitLaw, Excitation
from .laws import bit_law as of_bit
from .laws import excitation as of_shaking
from .results import Results
from .simulation import Simulation


class Solving(Checked):
    """The verbs that solve a case's operations by its models."""

    __slots__ = ()

    def soft(self, operation: str | None = None) -> Results:
        """Solve with the soft string: milliseconds.

        Parameters
        ----------
        operation
            The one to solve; all of the case where none is named.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> out, into = (case.soft(of)[of].hook_load_N for of in ("trip_out", "trip_in"))
        >>> out > into  # friction holds the string back either way
        True
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
            Threads that work on solid rock under the bit; one per core where nothing is said.

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
            Threads that work on solid rock under the bit; one per core where nothing is said.

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
        return Simulation(held)

    def _solve(
        self, models: list[str], operation: str | None, jobs: int | None, *, progress: bool
    ) -> Results:
        with Listener(progress) as listener:
            core, raised = self._held.answer(models, operation, count(jobs), listener)
        return finished(Results(core), raised)
