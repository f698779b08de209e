"""Results of a case at every depth of the bit, and friction from readings at the surface."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, SupportsFloat, TypeAlias, TypeVar, cast

from . import _core, _values
from ._checked import Checked
from ._columns import content
from ._commands import Job, carry_out, count, quantity
from ._folder import Place
from ._listener import Listener
from ._values import Scalar
from .calibration import Calibration
from .errors import InputTypeError, Interrupted
from .planning import Plan, Reach
from .table import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

C = TypeVar("C", bound=Checked)

Values: TypeAlias = "Scalar | NDArray[Any] | Iterable[Scalar]"
"""One value, several, or a text with several: ``"500m..1200m/100m"``."""

Factors: TypeAlias = "str | SupportsFloat | NDArray[Any] | Iterable[SupportsFloat]"
"""One friction factor, several, or a text with several: ``"0.2, 0.3"``."""

Units = Literal["si", "metric", "field"]


class Planning(Checked):
    """The methods that solve a case at every depth of the bit."""

    __slots__ = ()

    def broomstick(
        self,
        *,
        model: str | Sequence[str] | None = None,
        frictions: Factors | None = None,
        bit_depths: Values | None = None,
        operations: str | Sequence[str] | None = None,
        jobs: int | None = None,
    ) -> Table:
        """Solve every operation at every depth with every friction, about 1 ms per point.

        No files are written. A point without an answer is a row with its reason.

        Parameters
        ----------
        model
            ``"soft"`` or ``"stiff"``, or both; those of the case's plan by default.
        frictions
            Friction factors of all hole sections, in the column ``friction`` of the table. By
            default, the ``"low"``, ``"expected"`` and ``"high"`` friction of the case's plan.
        bit_depths
            Depths of the bit, such as ``"500m..1200m/100m"`` or a list, m; those of the plan by
            default.
        operations
            ``"trip_out"`` and so on; the plan's by default.
        jobs
            Number of parallel jobs; one per core by default.

        Raises
        ------
        InputError
            If a friction factor, a depth or an operation is invalid.
        Interrupted
            If the user interrupted the run; ``results`` of the error is the table so far.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> table = case.broomstick(frictions=[0.2, 0.3], bit_depths=[900.0, 1200.0])
        >>> len(table), table.columns[:4]
        (20, ('model', 'friction', 'operation', 'bit_depth_m'))
        """
        options: _core.BroomstickOptions = {
            "models": _values.words("model", model),
            "frictions": _values.factors("frictions", frictions),
            "bit_depths_m": _values.options("bit_depths", bit_depths, "length") or [],
            "operations": _values.words("operations", operations),
            "jobs": count(jobs),
        }
        with Listener(progress=False) as listener:
            held, missing, raised = _core.broomstick_of(self._held, options, listener)
        table = Table(held, "plan_broomstick")
        if isinstance(raised, KeyboardInterrupt):
            interrupted = Interrupted(f"interrupted: {missing} points are missing in `results`")
            interrupted.results = table
            raise interrupted from raised
        if raised is not None:
            raise raised
        return table

    def plan(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        resume: bool = False,
        overwrite: bool = False,
        checkpoint: Scalar | None = None,
        units: Units | None = None,
        png: bool = False,
        jobs: int | None = None,
        overlay: str | PathLike[str] | None = None,
        progress: bool = False,
    ) -> Plan:
        """Compute torque and drag at every depth of the bit, with low, expected and high friction.

        The keys under ``plan`` of the case set its scope: ``case.with_(plan__depths=20).plan()``.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        resume
            Whether to continue an interrupted plan in the folder.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        checkpoint
            Wall-clock time between checkpoints: ``"5 min"``, or seconds.
        units
            Units of the page and in the workbook; the case's by default.
        png
            Whether to write PNG images as well.
        jobs
            Number of parallel jobs; one per core by default.
        overlay
            File of hook loads and torques from another program, overlaid on the curves of the plan.
        progress
            Whether to draw a bar, with tqdm.

        Raises
        ------
        FolderError
            If the results cannot be written to the folder.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds the results so far.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]})
        >>> plan = case.plan(jobs=1)
        >>> plan.deepest_m, plan.missing
        (1200.0, 0)
        """
        place = Place(folder, overwrite=overwrite, resume=resume)
        laid = None if overlay is None else "overlay"
        job = Job(
            {"kind": "plan", "overlay": laid, "png": png},
            [self._held],
            paths={} if overlay is None else {"overlay": overlay},
            units=units,
            jobs=jobs,
            checkpoint=checkpoint,
        )
        return carry_out(Plan, place, job, progress=progress)

    def reach(
        self,
        folder: str | PathLike[str] | None = None,
        *,
        from_: Scalar | None = None,
        to: Scalar | None = None,
        friction: Factors | None = None,
        operation: str | Sequence[str] | None = None,
        no_helix_friction: bool = False,
        stop_at_helix: bool = False,
        resume: bool = False,
        overwrite: bool = False,
        units: Units | None = None,
        png: bool = False,
        jobs: int | None = None,
        progress: bool = False,
    ) -> Reach:
        """Find the depth that the well can reach, and the limit that stops it.

        Parameters
        ----------
        folder
            Folder for the results; a temporary folder by default.
        from_
            First depth of the bit: ``"4000 m"``, or m; by default the end of the
            survey, or of the hole where that is shallower.
        to
            Last depth of the bit; by default, 15 km or twice the first depth, whichever is deeper.
        friction
            Friction factors, each applied to all sections; those of the case by default.
        operation
            Operations; by default, the usual ones and those of the case for which it has the set
            points.
        no_helix_friction
            Whether to leave out the friction from the contact force of a helix, so that the string
            cannot lock up.
        stop_at_helix
            Whether the onset of helical buckling counts as a stop, except in vertical hole; the
            string is run on in the buckled state otherwise.
        resume
            Whether to skip the samples of uncertain numbers that are already solved.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        units
            Units of the page; the case's by default.
        png
            Whether to write PNG images as well.
        jobs
            Number of parallel jobs; one per core by default.
        progress
            Whether to draw a bar, with tqdm, for the samples of uncertain numbers.

        Raises
        ------
        InputError
            If a depth, a friction factor or an operation is invalid.
        FolderError
            If the results cannot be written to the folder.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(rig__top_drive_torque="12 kN.m")
        >>> reach = case.reach(to="6 km", operation="drill", friction=0.3)
        >>> reach.stops[0].limit, 1200.0 < reach.depth_m < 6000.0
        ('top_drive', True)
        """
        place = Place(folder, overwrite=overwrite, resume=resume)
        work = {
            "kind": "reach",
            "from": quantity("from_", from_, "length"),
            "to": quantity("to", to, "length"),
            "frictions": _values.factors("friction", friction),
            "operations": _values.words("operation", operation),
            "no_helix_friction": no_helix_friction,
            "stop_at_helix": stop_at_helix,
            "png": png,
        }
        job = Job(work, [self._held], units=units, jobs=jobs)
        return carry_out(Reach, place, job, progress=progress)

    def calibrate(
        self: C,
        data: str | PathLike[str] | bytes | Mapping[str, Any] | object,
        folder: str | PathLike[str] | None = None,
        *,
        others: Sequence[C] = (),
        one_factor: bool = False,
        by_section: bool = False,
        friction_around: bool = False,
        block_weight: bool = False,
        bit_torque: bool = False,
        hold: Mapping[str, Scalar] | None = None,
        weight_error: Scalar | None = None,
        rotating_error: Scalar | None = None,
        torque_error: Scalar | None = None,
        outlier: float = 3.0,
        without_outliers: bool = False,
        band: float = 90.0,
        model: Literal["soft", "stiff"] = "soft",
        check_dynamics: bool | Values = False,
        overwrite: bool = False,
        units: Units | None = None,
        png: bool = False,
        jobs: int | None = None,
        progress: bool = False,
    ) -> Calibration[C]:
        """Estimate friction from readings at the surface.

        Parameters
        ----------
        data
            The readings: a file, CSV or Excel, or its content as bytes; a data frame of polars or
            pandas, or columns by their names. Names have units: ``bit_depth_m``, ``pick_up_kN``,
            ``slack_off_kN``, ``rotating_kN``, ``torque_kN_m``, ``torque_on_bottom_kN_m``, as the
            headings of a file.
        folder
            Folder for the results; a temporary folder by default.
        others
            Other strings that were in the hole; a column ``case`` of the readings has the name of
            the case of each row.
        one_factor
            Whether to fit one friction factor for casing and open hole.
        by_section
            Whether to fit a friction factor for each section of the hole.
        friction_around
            Whether to fit rotational friction apart from axial friction.
        block_weight
            Whether to fit the block weight.
        bit_torque
            Whether to fit the torque of the bit on bottom.
        hold
            Parameters to keep fixed: ``{"friction_cased": 0.2, "block_weight": "180 kN"}``.
        weight_error, rotating_error, torque_error
            Standard errors of pick-up and slack-off weights, of rotating weights and of torques;
            estimated by default.
        outlier
            Limit of a residual in standard errors; larger residuals are outliers.
        without_outliers
            Whether to exclude the outliers from the fit; otherwise
            ``summary["comparison"]`` has the estimates without them.
        band
            Confidence of the bands, %.
        model
            Model of the predictions; ``"stiff"`` takes minutes.
        check_dynamics
            Whether to simulate the string dynamically with the estimates, or the depths of the
            readings at which to do so.
        overwrite
            Whether to replace existing results in the folder, whatever wrote them.
        units
            Units of the page; the case's by default.
        png
            Whether to write PNG images as well.
        jobs
            Number of parallel simulations of that check; one per core by default.
        progress
            Whether to draw a bar, with tqdm, for that check.

        Raises
        ------
        CaseError
            If the readings cannot be read, with the place of each mistake.
        InputError
            If an option is invalid, or the readings do not determine the parameters.
        FolderError
            If the results cannot be written to the folder.
        Interrupted
            If the user interrupted the run; ``results`` of the error holds the results so far.

        Examples
        --------
        Readings of the slant well of the examples, computed with more friction:

        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(rig__block_weight="200 kN")
        >>> depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
        >>> table = case.broomstick(
        ...     frictions=0.25, bit_depths=depths, operations="trip_out", model="soft"
        ... )
        >>> data = {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}
        >>> found = case.calibrate(data, one_factor=True)
        >>> round(found.friction_open, 3)
        0.25
        """
        place = Place(folder, overwrite=overwrite)
        for other in _sequence("others", others):
            if not isinstance(other, Checked):
                raise InputTypeError(f"`others` was given {other!r}: expected a sequence of cases")
        is_path = isinstance(data, str | os.PathLike)
        path = cast("str | PathLike[str]", data)
        check = check_dynamics is not False
        depths = None if isinstance(check_dynamics, bool) else check_dynamics
        unit = _core.si_unit("length")
        work = {
            "kind": "calibrate",
            "data": "readings",
            "other_cases": [str(number) for number in range(1, 1 + len(others))],
            "one_factor": one_factor,
            "by_section": by_section,
            "friction_around": friction_around,
            "block_weight": block_weight,
            "bit_torque": bit_torque,
            "hold": [
                f"{name}={_held(name, value)}"
                for name, value in _values.mapping("hold", hold).items()
            ],
            "weight_error": _values.written("weight_error", weight_error, "force"),
            "rotating_error": _values.written("rotating_error", rotating_error, "force"),
            "torque_error": _values.written("torque_error", torque_error, "torque"),
            "outlier": str(_values.real(outlier, "outlier")),
            "without_outliers": without_outliers,
            "band": str(_values.real(band, "band")),
            "model": model,
            "check_dynamics": check,
            "check_depths": [
                f"{depth!r} {unit}"
                for depth in _values.options("check_dynamics", depths, "length") or ()
            ],
            "png": png,
        }
        job = Job(
            work,
            [self._held, *(other._held for other in others)],
            paths={"readings": path} if is_path else {},
            content=None if is_path else data if isinstance(data, bytes) else content(data),
            units=units,
            jobs=jobs,
        )
        found = carry_out(Calibration[C], place, job, progress=progress)
        found._calibrated = found.applied_to(self)
        return found


def _sequence(name: str, value: object) -> Sequence[object]:
    if isinstance(value, Sequence):
        return cast("Sequence[object]", value)
    raise InputTypeError(f"`{name}` was given {value!r}: expected a sequence of cases")


def _held(name: str, value: Scalar) -> str:
    dimension = _core.held_dimension(name)
    if dimension is None:
        return str(value)
    return _values.written("hold", value, dimension) or ""
