"""Results of a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from . import _html
from ._base import BaseResults, Check, check_of, most_severe_first
from .plot._house import operation_words
from .plot._shown import Display, about
from .table import Table

if TYPE_CHECKING:
    import pandas
    import polars
from .errors import NotFoundError


class OperationResult:
    """Results of one operation by one model; those of dynamics are means over the window.

    The scalars are attributes. :attr:`data` is the entry of the operation in ``summary.json``.

    Examples
    --------
    >>> import wholestring as ws
    >>> solved = ws.Case.example().soft("drill")["drill"]
    >>> solved.model, solved.operation, solved.status
    ('soft', 'drill', 'complete')
    >>> solved.weight_on_bit_N
    49033.25
    """

    __slots__ = ("_data",)

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data = data

    @property
    def data(self) -> Mapping[str, Any]:
        """The operation's entry in ``summary.json``."""
        return self._data

    @property
    def model(self) -> str:
        """``"soft"``, ``"stiff"`` or ``"dynamic"``."""
        return str(self._data["model"])

    @property
    def operation(self) -> str:
        """``"trip_out"``, ``"drill"``, and so on."""
        return str(self._data["operation"])

    @property
    def status(self) -> str:
        """``"complete"``, ``"interrupted"`` or ``"failed"``."""
        return str(self._data["status"])

    @property
    def friction(self) -> float | list[float]:
        """Kinetic friction of the hole: a number, or a list by hole section."""
        return cast("float | list[float]", self._data["friction"])

    @property
    def checks(self) -> tuple[Check, ...]:
        """The checks of the operation, the most severe first."""
        return tuple(check_of(row) for row in self._data["checks"])

    @property
    def unchecked(self) -> tuple[dict[str, str | None], ...]:
        """Checks that were not possible: ``kind``, ``component`` and the ``missing`` data."""
        return tuple(dict(row) for row in self._data.get("unchecked", []))

    @property
    def findings(self) -> tuple[Check, ...]:
        """The checks that need attention, the most severe first."""
        return most_severe_first(self.checks)

    @property
    def statistics(self) -> Mapping[str, Mapping[str, float]]:
        """Mean, standard deviation and extremes over the window by quantity; dynamics only."""
        return cast("Mapping[str, Mapping[str, float]]", self._data.get("statistics") or {})

    def _number(self, name: str) -> float:
        value = self._data.get(name)
        return float("nan") if value is None else float(value)

    def _number_or_none(self, name: str) -> float | None:
        value = self._data.get(name)
        return None if value is None else float(value)

    @property
    def bit_depth_m(self) -> float:
        """Measured depth of the bit, m."""
        return self._number("bit_depth_m")

    @property
    def weight_on_bit_N(self) -> float:
        """Weight on bit as solved, N."""
        return self._number("weight_on_bit_N")

    @property
    def bit_torque_N_m(self) -> float:
        """Bit torque as solved, N.m."""
        return self._number("bit_torque_N_m")

    @property
    def hook_load_N(self) -> float:
        """Tension at the top of the string, N; block and top drive excluded."""
        return self._number("hook_load_N")

    @property
    def surface_torque_N_m(self) -> float:
        """Torque at the top of the string, N.m."""
        return self._number("surface_torque_N_m")

    @property
    def friction_torque_N_m(self) -> float:
        """Part of the surface torque that comes from wall contact alone, N.m."""
        return self._number("friction_torque_N_m")

    @property
    def axial_friction_N(self) -> float:
        """Axial friction of the wall, N; positive adds to hook load."""
        return self._number("axial_friction_N")

    @property
    def side_force_total_N(self) -> float:
        """Integral of the magnitude of the side force, N."""
        return self._number("side_force_total_N")

    @property
    def twist_rad(self) -> float:
        """Turn of the top against the bit, rad; positive when the top leads."""
        return self._number("twist_rad")

    @property
    def stretch_m(self) -> float:
        """Elongation against the unloaded string, m."""
        return self._number("stretch_m")

    @property
    def neutral_point_m(self) -> float | None:
        """Measured depth of the shallowest zero of effective tension, m; ``None`` if none."""
        return self._number_or_none("neutral_point_m")

    @property
    def cutoff_depth_m(self) -> float | None:
        """Deepest change from high-side to low-side contact in the build, m; ``None`` if none."""
        return self._number_or_none("cutoff_depth_m")

    def __repr__(self) -> str:
        """Return a summary with hook load and torque."""
        return (
            f"<{self.model} {self.operation}: hook load {self.hook_load_N:.6g} N, "
            f"surface torque {self.surface_torque_N_m:.6g} N.m>"
        )


class Results(BaseResults):
    """Results of a run: operations and tables.

    They are in memory until :meth:`save` writes the same folder as the command line; :meth:`load`
    reads such a folder.

    Examples
    --------
    >>> import wholestring as ws
    >>> results = ws.Case.example().soft()
    >>> [solved.operation for solved in results]
    ['trip_out', 'trip_in', 'rotate_off_bottom', 'drill', 'slide']
    >>> results["trip_out"].hook_load_N > results["trip_in"].hook_load_N
    True
    """

    __slots__ = ()
    _kind = "a run"

    @property
    def operations(self) -> tuple[OperationResult, ...]:
        """Results of each operation by each model, in the order in which they were solved."""
        return tuple(OperationResult(row) for row in self.summary["operations"])

    def __iter__(self) -> Iterator[OperationResult]:
        """Return an iterator over the operations."""
        return iter(self.operations)

    def __len__(self) -> int:
        """Return the number of operations."""
        return len(self.summary["operations"])

    def __getitem__(self, key: str | tuple[str, str]) -> OperationResult:
        """Return an operation by its name, or by model and name if several models solved it."""
        model, name = key if isinstance(key, tuple) else (None, key)
        found = [
            result
            for result in self
            if result.operation == name and (model is None or result.model == model)
        ]
        if len(found) == 1:
            return found[0]
        there = ", ".join(f"{result.model} {result.operation}" for result in self)
        if found:
            message = f"several models solved {name!r}: name one, as in results['soft', {name!r}]"
            raise NotFoundError(message)
        raise NotFoundError(f"there is no {key!r}: there are {there}")

    @property
    def scalars(self) -> Table:
        """A row for each operation: scalars, statistics and indicators, as in a sweep."""
        if "" not in self._tables:
            self._tables[""] = Table(self._core.scalars(), "scalars")
        return self._tables[""]

    def to_pandas(self) -> pandas.DataFrame:
        """Return :attr:`scalars` as a pandas data frame, a row for each operation.

        Examples
        --------
        >>> import wholestring as ws
        >>> frame = ws.Case.example().soft().to_pandas()
        >>> frame.set_index("operation")["hook_load_N"].idxmax()
        'trip_out'
        """
        return self.scalars.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """Return :attr:`scalars` as a polars data frame, a row for each operation.

        Examples
        --------
        >>> import wholestring as ws
        >>> ws.Case.example().soft("drill").to_polars()["operation"].to_list()
        ['drill']
        """
        return self.scalars.to_polars()

    def _ipython_key_completions_(self) -> list[str]:
        return list(dict.fromkeys(result.operation for result in self))

    @property
    def nodes(self) -> Table:
        """The profile along the string."""
        return self.table("nodes")

    @property
    def time(self) -> Table:
        """Scalars against time; dynamics only."""
        return self.table("time")

    @property
    def checks(self) -> tuple[Check, ...]:
        """The checks of all operations."""
        return tuple(check for solved in self for check in solved.checks)

    def __repr__(self) -> str:
        """Return a summary with the operations."""
        inside = ", ".join(f"{result.model} {result.operation}" for result in self)
        return f"<Results of {self.summary['case']}: {inside}>"

    def _repr_html_(self) -> str:
        display = Display(None, self)
        solved = list(self)

        def scalar(name: str) -> _html.Column:
            title, dimension = about(name)
            numbers = np.array([getattr(result, name) for result in solved])
            values = display.values(numbers, dimension)
            return _html.Column(
                title=title,
                cells=["" if np.isnan(value) else f"{value:.4g}" for value in values.tolist()],
                unit=display.symbol(dimension),
            )

        findings = ["; ".join(found.sentence for found in result.findings) for result in solved]
        columns = [
            _html.Column("Model", [result.model for result in solved], numbers=False),
            _html.Column(
                "Operation", [operation_words(result.operation) for result in solved], numbers=False
            ),
            scalar("hook_load_N"),
            scalar("surface_torque_N_m"),
            scalar("axial_friction_N"),
            _html.Column("Checks", findings, numbers=False),
        ]
        if any(result.status != "complete" for result in solved):
            statuses = [result.status for result in solved]
            columns.insert(2, _html.Column("Status", statuses, numbers=False))
        return _html.table(columns, caption=str(self.summary["case"]))
