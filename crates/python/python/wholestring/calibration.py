"""Friction from readings at the surface."""

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
    """One estimated parameter.

    Attributes
    ----------
    parameter
        Name, with its unit: ``friction_cased``, ``block_weight_N``, ...
    words
        The parameter in words.
    value
        Its value, SI.
    standard_error
        Its standard error; none for a factor at zero.
    interval
        The interval by the profile likelihood; an end that is not found is none.
    at_bound
        Whether the unconstrained value is negative, so that it is set to zero.

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
    standard_error: float | None = None
    interval: tuple[float | None, float | None]
    at_bound: bool


def _estimate(row: dict[str, Any]) -> Estimate:
    lower, upper = row.pop("interval")
    return Estimate(**row, interval=(lower, upper))


def _with_case(
    make: Callable[..., Calibration[C]], arguments: tuple[Any, ...], case: C | None
) -> Calibration[C]:
    found = make(*arguments)
    found._calibrated = case
    return found


class Calibration(BaseResults, Generic[C]):
    """Friction factors, block weight and bit torque from readings at the surface.

    :meth:`Case.calibrate` returns one.

    Examples
    --------
    Readings of the slant well of the examples, computed with more friction:

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
        """The estimated parameters with their values."""
        return tuple(_estimate(dict(row)) for row in self.summary["estimates"])

    def __getitem__(self, parameter: str) -> Estimate:
        """Return the estimate of a parameter by its name."""
        for estimate in self.estimates:
            if parameter == estimate.parameter:
                return estimate
        there = ", ".join(estimate.parameter for estimate in self.estimates)
        raise NotFoundError(f"{parameter!r} is not an estimated parameter: there are {there}")

    @property
    def held(self) -> Mapping[str, float]:
        """Parameters that were kept fixed, by name, SI."""
        return dict(self.summary["held"])

    def _found(self, *parameters: str) -> float | None:
        held = self.held
        values = {estimate.parameter: estimate.value for estimate in self.estimates}
        for name in parameters:
            if name in values or name in held:
                return float(values.get(name, held.get(name, 0.0)))
        return None

    @property
    def friction_cased(self) -> float | None:
        """Axial friction factor of casing, estimated or fixed."""
        return self._found("friction_cased", "friction")

    @property
    def friction_open(self) -> float | None:
        """Axial friction factor of open hole, estimated or fixed."""
        return self._found("friction_open", "friction")

    @property
    def block_weight_N(self) -> float | None:
        """Weight of the block, estimated or fixed, N."""
        return self._found("block_weight_N")

    @property
    def bit_torque_N_m(self) -> float | None:
        """Torque of the bit on bottom, estimated or fixed, N.m."""
        return self._found("bit_torque_N_m")

    @property
    def correlation(self) -> NDArray[np.float64]:
        """Correlations of the estimates, a row and a column for each."""
        return np.array(self.summary["correlation"], dtype=np.float64)

    @property
    def covariance(self) -> NDArray[np.float64]:
        """Covariances of the estimates, SI; zero for one that is at a bound."""
        errors = np.array([estimate.standard_error or 0.0 for estimate in self.estimates])
        return np.asarray(self.correlation * np.outer(errors, errors))

    @property
    def residuals(self) -> Table:
        """Readings and the corresponding predictions."""
        return self.table("calibration")

    @property
    def posterior(self) -> Table:
        """Loss of fit with each parameter fixed at other values.

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
        """Keys of the case with the estimates as TOML, to 4 decimals."""
        folder = self.folder
        return {} if folder is None else dict(_core.calibrated(folder))

    @property
    def case(self) -> C:
        """The case with the estimated friction.

        Raises
        ------
        ValueError
            If the calibration was loaded from a folder, which has no case file; pass the case to
            :meth:`applied_to`.
        """
        if self._calibrated is None:
            message = "a folder has no case file: pass the case to `applied_to`"
            raise InputError(message)
        return self._calibrated

    @property
    def toml(self) -> str:
        """The case file with the estimated friction."""
        return self.case.to_toml()

    def applied_to(self, case: D) -> D:
        """Return a case with the estimated friction.

        Parameters
        ----------
        case
            A case with the same hole sections.

        Raises
        ------
        CaseError
            If the case has fewer hole sections.

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
        """Name of the first case."""
        return str(self.summary["cases"][0])

    def _facts(self) -> Sequence[tuple[str, str]]:
        def error(estimate: Estimate) -> str:
            return "" if estimate.standard_error is None else f" ± {estimate.standard_error:.4g}"

        return [
            (estimate.parameter, f"{estimate.value:.6g}{error(estimate)}")
            for estimate in self.estimates
        ]
