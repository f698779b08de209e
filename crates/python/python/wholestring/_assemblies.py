"""Static analysis of the assembly of a case, linear vibration, and the bit alone on its rock."""

from __future__ import annotations

from os import PathLike

from ._checked import Checked
from ._commands import Job, carry_out, quantities, quantity
from ._folder import Place
from ._planning import Units, Values
from ._values import Scalar
from .assembly import Bha, BitTest, Modes


class Assemblies(Checked):
    """The methods that analyse the assembly, linear vibration and the bit."""

    __slots__ = ()

    def bha(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        operation: str | None = None,
        toolface: Values | None = None,
        weight: Values | None = None,
        inclination: Values | None = None,
        build: Scalar = 0.0,
        whole: bool = False,
        overwrite: bool = False,
        units: Units | None = None,
        csv: bool = False,
        jobs: int | None = None,
    ) -> Bha:
        """Solve the bottom-hole assembly statically.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        operation
            The operation; the first drilling operation by default.
        toolface
            Tool faces of the bend: ``"0deg..360deg/15deg"``, or a list, rad; a revolution in steps
            of 15 degrees by default.
        weight
            Weights on bit: ``"20kN..120kN/20kN"``, or a list, N; seven up to 1.5 times the
            operation's by default.
        inclination
            Inclinations of a straight hole, or a list, rad; every 5 degrees by default.
        build
            Rate at which those holes build down to the bit: ``"2 deg/30m"``, or rad/m.
        whole
            Whether to solve the whole string, not only the assembly and 100 m of pipe above it.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        units
            Units of the page; the case's by default.
        csv
            Whether to write the tables as CSV as well.
        jobs
            Number of parallel jobs, each solving one point; one per core by default.

        Raises
        ------
        InputError
            If the case has no such operation, or does not have the quantity that is varied.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds any results so far.
        NoAnswerError
            If the assembly has no equilibrium.
        FolderError
            If the results cannot be written to the folder.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> bha = case.bha(operation="drill", weight=["20 kN", "60 kN"], inclination="30deg")
        >>> high_N, right_N = bha.side_force_N
        >>> high_N < 0.0  # a pendulum drops
        True
        >>> sorted(set(bha.varied["varied"]))
        ['inclination', 'weight']
        """
        place = Place(folder, overwrite=overwrite)
        work = {
            "kind": "bha",
            "operation": operation,
            "toolface": quantities("toolface", toolface, "angle"),
            "weight": quantities("weight", weight, "force"),
            "inclination": quantities("inclination", inclination, "angle"),
            "build": quantity("build", build, "dogleg severity"),
            "whole": whole,
            "csv": csv,
        }
        return carry_out(Bha, place, Job(work, [self._held], units=units, jobs=jobs))

    def modes(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        operation: str | None = None,
        overwrite: bool = False,
        units: Units | None = None,
        png: bool = False,
        jobs: int | None = None,
    ) -> Modes:
        """Find natural frequencies, critical speeds and the response to a rotating force.

        The case sets the number of modes and the excitations:
        ``case.with_(modes__count=10).modes()``.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        operation
            The operation whose static equilibrium the modes are about; the first of the case by
            default.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        units
            Units of the page; the case's by default.
        png
            Whether to write PNG images as well.
        jobs
            Number of parallel jobs, each solving one weight of the map of torsional stability; one
            per core by default.

        Raises
        ------
        InputError
            If the case has no such operation.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds any results so far.
        NoAnswerError
            If no equilibrium is found.
        FolderError
            If the results cannot be written to the folder.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="20 m", modes__count=2)
        >>> modes = case.modes(operation="rotate_off_bottom", jobs=1)
        >>> len(modes.frequencies_Hz("lateral"))
        2
        """
        place = Place(folder, overwrite=overwrite)
        work = {"kind": "modes", "operation": operation, "png": png}
        return carry_out(Modes, place, Job(work, [self._held], units=units, jobs=jobs))

    def bit_test(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        shard: str | None = None,
        resume: bool = False,
        overwrite: bool = False,
        checkpoint: Scalar | None = None,
        units: Units | None = None,
        csv: bool = False,
        jobs: int | None = None,
        progress: bool = False,
    ) -> BitTest:
        """Drill with the bit alone on its rock, at every combination of weight and speed.

        The case sets weights and speeds under ``bit_test``.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        shard
            Share of the points to drill, such as ``"1/4"``.
        resume
            Whether to skip the points that are complete in the folder.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        checkpoint
            Wall-clock time between checkpoints: ``"5 min"``, or seconds.
        units
            Units of the page; the case's by default.
        csv
            Whether to write the tables as CSV as well.
        jobs
            Number of parallel jobs, each drilling one point; one per core by default.
        progress
            Whether to draw a bar, with tqdm.

        Raises
        ------
        InputError
            If the case has no rock.
        FolderError
            If the results cannot be written to the folder.
        NoAnswerError
            If points failed; ``results`` of the error holds the others.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds the results so far.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(
        ...     {
        ...         "string.0.od": "120 mm",
        ...         "bit.face.cutter_diameter": "19 mm",
        ...         "rock.strength": "10 MPa",
        ...         "rock.element_size": "15 mm",
        ...         "rock.density_factor": 60,
        ...         "bit_test.wob": ["10 kN"],
        ...         "bit_test.rpm": ["240 rpm"],
        ...         "bit_test.settle_revolutions": 0.25,
        ...         "bit_test.revolutions": 1,
        ...     }
        ... )
        >>> tried = case.bit_test()
        >>> isinstance(tried, ws.BitTest), len(tried.points)
        (True, 1)
        """
        place = Place(folder, overwrite=overwrite, resume=resume)
        work = {"kind": "bit_test", "shard": shard, "csv": csv}
        job = Job(work, [self._held], units=units, jobs=jobs, checkpoint=checkpoint)
        return carry_out(BitTest, place, job, progress=progress)
