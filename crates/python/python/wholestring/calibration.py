"""Friction from what was read at the surface."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from . import _core
from ._base import BaseResults
from ._checked import Checked
from ._folder import Place
from ._pickled import Reduced
from .errors import InputError, NotFoundError
from .table import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

C = TypeVar("C", bound=Checked)
D = TypeVar("D", bound=Checked)


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A number that was looked for.

    Attributes
    ----------
    parameter
        Its name: ``"friction_open"``, ``"block_weight_N"``.
    words
        The same in words.
    value
        What was found, SI.
    standard_error
        How far it may be off; ``None`` where it is held at a bound.
    interval
        Ends of its confidence interval; ``None`` where one was not found.
    at_bound
        Whether it lies at an end of what it may be.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(rig__block_weight="200 kN")
    >>> depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    >>> table = case.broomstick(
    ...     frictions=[0.25], bit_depths=depths, operations="trip_out", model="soft"
    ... )
    >>> data = {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}
    >>> found = case.calibrate(data, one_factor=True)
    >>> estimate = found["friction"]
    >>> isinstance(estimate, ws.Estimate), round(estimate.value, 3)
    (True, 0.25)
    """

    parameter: str
    words: str
    value: float
    standard_error: float | None
    interval: tuple[float | None, float | None]
    at_bound: bool


def _estimate(of: dict[str, Any]) -> Estimate:
    lower, upper = of.pop("interval")
    return Estimate(**of, interval=(lower, upper))


def _with_case(
    make: Callable[..., Calibration[C]], arguments: tuple[Any, ...], case: C | None
) -> Calibration[C]:
    found = make(*arguments)
    found._calibrated = case
    return found


class Calibration(BaseResults, Generic[C]):
    """Friction factors, block weight and bit torque from readings at the surface.

    :meth:`Case.calibrate` makes one.

    Examples
    --------
    Readings that the slant well of the examples would give with more friction:

    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(rig__block_weight="200 kN")
    >>> depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    >>> def read(operation):
    ...     table = case.broomstick(frictions=0.25, bit_depths=depths, operations=operation)
    ...     return table["hook_load_with_block_N"]
    >>> data = {"bit_depth_m": depths, "pick_up_N": read("trip_out")}
    >>> found = case.calibrate(data, one_factor=True)
    >>> round(found["friction"].value, 3)
    0.25
    >>> round(found.case.settings["well"]["hole"][1]["friction"]["kinetic"], 3)
    0.25
    """

    __slots__ = ("_calibrated",)
    _kind = "a calibration"

    def __init__(self, core: _core.Answers, place: Place | None = None) -> None:
        super().__init__(core, place)
        self._calibrated: C | None = None

    def __reduce__(self) -> Reduced:
        """Pickle with the case that was calibrated."""
        return _with_case, (*super().__reduce__(), self._calibrated)

    @property
    def estimates(self) -> tuple[Estimate, ...]:
        """What was looked for, with what was found."""
        return tuple(_estimate(dict(of)) for of in self.summary["estimates"])

    def __getitem__(self, parameter: str) -> Estimate:
        """Give what was found of a number, by its name."""
        for of in self.estimates:
            if parameter == of.parameter:
                return of
        there = ", ".join(of.parameter for of in self.estimates)
        raise NotFoundError(f"{parameter!r} was not looked for: looked for were {there}")

    @property
    def held(self) -> Mapping[str, float]:
        """What was held, by name, SI."""
        return dict(self.summary["held"])

    def _found(self, *parameters: str) -> float | None:
        held = self.held
        values = {of.parameter: of.value for of in self.estimates}
        for name in parameters:
            if name in values or name in held:
                return float(values.get(name, held.get(name, 0.0)))
        return None

    @property
    def friction_cased(self) -> float | None:
        """Friction factor of casing along the hole, found or held."""
        return self._found("friction_cased", "friction")

    @property
    def friction_open(self) -> float | None:
        """Friction factor of open hole along the hole, found or held."""
        return self._found("friction_open", "friction")

    @property
    def block_weight_N(self) -> float | None:
        """Weight of the block, found or held, N."""
        return self._found("block_weight_N")

    @property
    def bit_torque_N_m(self) -> float | None:
        """Torque of the bit on bottom, found or held, N.m."""
        return self._found("bit_torque_N_m")

    @property
    def correlation(self) -> NDArray[np.float64]:
        """Correlations of the estimates, a row and a column for each."""
        return np.array(self.summary["correlation"], dtype=np.float64)

    @property
    def covariance(self) -> NDArray[np.float64]:
        """Covariances of the estimates, SI; zero of one that is held at a bound."""
        errors = np.array([of.standard_error or 0.0 for of in self.estimates])
        return np.asarray(self.correlation * np.outer(errors, errors))

    @property
    def residuals(self) -> Table:
        """What was read, beside what is predicted."""
        return self.table("calibration")

    @property
    def posterior(self) -> Table:
        """By how much the fit is worse with each number held elsewhere.

        ``excess`` is the likelihood ratio in units of chi-square: with a flat prior the profile of
        the posterior density is ``exp(-excess / 2)``.
        """
        return self.table("calibration_profiles")

    @property
    def bands(self) -> Table:
        """Bands of predictions and of readings against depth."""
        return self.table("calibration_bands")

    @property
    def changes(self) -> Mapping[str, str]:
        """Keys of the case with what was found, as TOML has it, to 4 decimals."""
        folder = self.folder
        return {} if folder is None else dict(_core.calibrated(folder))

    @property
    def case(self) -> C:
        """The case with the friction that was found.

        Raises
        ------
        ValueError
            If it was loaded from a folder, which has no case file: :meth:`applied_to` takes one.
        """
        if self._calibrated is None:
            message = "a folder has no case file: give one to `applied_to`"
            raise InputError(message)
        return self._calibrated

    @property
    def toml(self) -> str:
        """The case file with the friction that was found."""
        return self.case.to_toml()

    def applied_to(self, case: D) -> D:
        """Give a case with the friction that was found.

        Parameters
        ----------
        case
            One with the same hole sections.

        Raises
        ------
        CaseError
            If it has fewer.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(rig__block_weight="200 kN")
        >>> depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
        >>> table = case.broomstick(
        ...     frictions=[0.25], bit_depths=depths, operations="trip_out", model="soft"
        ... )
        >>> data = {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}
        >>> found = case.calibrate(data, one_factor=True)
        >>> other = found.applied_to(case.with_(bit_depth="1000 m"))
        >>> round(other.settings["well"]["hole"][0]["friction"]["kinetic"], 3)
        0.25
        """
        return case._changed(list(self.changes.items()))

    @property
    def case_name(self) -> str:
        """What the first case is called."""
        return str(self.summary["cases"][0])

    def _facts(self) -> Sequence[tuple[str, str]]:
        def error(of: Estimate) -> str:
            return "" if of.standard_error is None else f" ± {of.standard_error:.4g}"

        return [(of.parameter, f"{of.value:.6g}{error(of)}") for of in self.estimates]
