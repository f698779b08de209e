"""What a case comes to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from . import _html
from ._base import BaseResults, Check, check_of, most_severe_first
from .plot._house import operation_words
from .plot._shown import Shown, about
from .table import Table

if TYPE_CHECKING:
    import pandas
    import polars
from .errors import NotFoundError


class OperationResult:
    """One operation as one model solved it; a dynamic one holds means over its window.

    The scalars are attributes. All that ``summary.json`` says of the operation stands in
    :attr:`data`.

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
        """The checks of the answer, the most severe first."""
        return tuple(check_of(row) for row in self._data["checks"])

    @property
    def unchecked(self) -> tuple[dict[str, str | None], ...]:
        """What could not be checked: ``kind``, ``component`` and what is ``missing``."""
        return tuple(dict(row) for row in self._data.get("unchecked", []))

    @property
    def findings(self) -> tuple[Check, ...]:
        """The checks that need attention, the most severe first."""
        return most_severe_first(self.checks)

    @property
    def statistics(self) -> Mapping[str, Mapping[str, float]]:
        """Mean, standard deviation and extremes over the window by quantity; of dynamics alone."""
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
        """Give what it is, with hook load and torque."""
        return (
            f"<{self.model} {self.operation}: hook load {self.hook_load_N:.6g} N, "
            f"surface torque {self.surface_torque_N_m:.6g} N.m>"
        )


class Results(BaseResults):
    """What a case comes to: operations, and tables.

    In memory until :meth:`save` writes the folder that the command line writes; :meth:`load` reads
    such a folder.

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
        """The operations, each by each model, in the order they were solved."""
        return tuple(OperationResult(of) for of in self.summary["operations"])

    def __iter__(self) -> Iterator[OperationResult]:
        """Give the operations."""
        return iter(self.operations)

    def __len__(self) -> int:
        """Give the number of operations."""
        return len(self.summary["operations"])

    def __getitem__(self, key: str | tuple[str, str]) -> OperationResult:
        """Give an operation by its name, or by model and name where several models solved it."""
        model, name = key if isinstance(key, tuple) else (None, key)
        found = [of for of in self if of.operation == name and (model is None or of.model == model)]
        if len(found) == 1:
            return found[0]
        there = ", ".join(f"{of.model} {of.operation}" for of in self)
        if found:
            message = f"several models solved {name!r}: name one, as in results['soft', {name!r}]"
            raise NotFoundError(message)
        raise NotFoundError(f"there is no {key!r}: there are {there}")

    @property
    def scalars(self) -> Table:
        """A row for each operation: scalars, statistics and indicators, as a sweep has them."""
        if "" not in self._tables:
            self._tables[""] = Table(self._core.scalars(), "scalars")
        return self._tables[""]

    def to_pandas(self) -> pandas.DataFrame:
        """Give :attr:`scalars` as a pandas data frame, a row for each operation.

        Examples
        --------
        >>> import wholestring as ws
        >>> frame = ws.Case.example().soft().to_pandas()
        >>> frame.set_index("operation")["hook_load_N"].idxmax()
        'trip_out'
        """
        return self.scalars.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """Give :attr:`scalars` as a polars data frame, a row for each operation.

        Examples
        --------
        >>> import wholestring as ws
        >>> ws.Case.example().soft("drill").to_polars()["operation"].to_list()
        ['drill']
        """
        return self.scalars.to_polars()

    def _ipython_key_completions_(self) -> list[str]:
        return list(dict.fromkeys(of.operation for of in self))

    @property
    def nodes(self) -> Table:
        """The profile along the string."""
        return self.table("nodes")

    @property
    def time(self) -> Table:
        """Scalars against time; of dynamics alone."""
        return self.table("time")

    @property
    def checks(self) -> tuple[Check, ...]:
        """The checks of all operations."""
        return tuple(check for solved in self for check in solved.checks)

    def __repr__(self) -> str:
        """Give the operations."""
        inside = ", ".join(f"{of.model} {of.operation}" for of in self)
        return f"<Results of {self.summary['case']}: {inside}>"

    def _repr_html_(self) -> str:
        shown = Shown(None, self)
        solved = list(self)

        def scalar(name: str) -> _html.Column:
            title, dimension = about(name)
            values = shown.values(np.array([getattr(of, name) for of in solved]), dimension)
            return _html.Column(
                title=title,
                cells=["" if np.isnan(of) else f"{of:.4g}" for of in values.tolist()],
                unit=shown.symbol(dimension),
            )

        findings = ["; ".join(found.sentence for found in of.findings) for of in solved]
        columns = [
            _html.Column("Model", [of.model for of in solved], numbers=False),
            _html.Column(
                "Operation", [operation_words(of.operation) for of in solved], numbers=False
            ),
            scalar("hook_load_N"),
            scalar("surface_torque_N_m"),
            scalar("axial_friction_N"),
            _html.Column("Checks", findings, numbers=False),
        ]
        if any(of.status != "complete" for of in solved):
            columns.insert(2, _html.Column("Status", [of.status for of in solved], numbers=False))
        return _html.table(columns, caption=str(self.summary["case"]))
