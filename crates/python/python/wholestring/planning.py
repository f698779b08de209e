"""Plans, and the depth that a well can reach."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

from ._base import BaseResults, Check
from .table import Table


@dataclass(frozen=True, kw_only=True)
class PlanCheck(Check):
    """A check of a plan, the most severe of its kind and operation.

    Attributes
    ----------
    model
        The model.
    operation
        The operation, or the event.
    friction
        Level of friction: ``low``, ``expected`` or ``high``.
    bit_depth_m
        Measured depth of the bit.

    Examples
    --------
    >>> import wholestring as ws
    >>> plan = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]}).plan()
    >>> least = min(plan.checks, key=lambda check: check.reserve)
    >>> isinstance(least, ws.PlanCheck), least.reserve > 0.0
    (True, True)
    """

    model: str
    operation: str
    friction: str
    bit_depth_m: float


_KEYS = {field.name for field in fields(PlanCheck)}


def _plan_check(row: dict[str, Any]) -> PlanCheck:
    return PlanCheck(**{key: value for key, value in row.items() if key in _KEYS})


class Plan(BaseResults):
    """Torque and drag at every depth of the bit, with low, expected and high friction.

    :meth:`Case.plan` returns one.

    Examples
    --------
    >>> import wholestring as ws
    >>> plan = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]}).plan()
    >>> plan.deepest_m
    1200.0
    >>> broomstick = plan.broomstick.to_polars()
    >>> sorted(set(broomstick["friction"]))
    ['expected', 'high', 'low']
    """

    __slots__ = ()
    _kind = "a plan"

    @property
    def broomstick(self) -> Table:
        """Hook load, torque and more, a row for each depth, operation, friction and model."""
        return self.table("plan_broomstick")

    @property
    def limits(self) -> Table:
        """Utilisation of the capacities of string and rig at each point."""
        return self.table("plan_limits")

    @property
    def buckling(self) -> Table:
        """The weight on bit at which the string begins to buckle."""
        return self.table("plan_buckling")

    @property
    def deepest_m(self) -> float:
        """Deepest bit, m."""
        return float(max(self.summary["bit_depths_m"]))

    @property
    def checks(self) -> tuple[PlanCheck, ...]:
        """The most severe check of each kind and operation over all depths and frictions."""
        return tuple(map(_plan_check, self.summary["checks"]))

    @property
    def governing(self) -> tuple[PlanCheck, ...]:
        """The limit that governs each operation: the least reserve of all that break or stop it."""
        return tuple(map(_plan_check, self.summary["governing"]))

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Checks that were not possible because data are missing in the case, in words."""
        return tuple(self.summary["unchecked"])

    @property
    def counted(self) -> tuple[str, ...]:
        """The parts of the campaign included in fatigue and casing wear, with their hours."""
        return tuple(self.summary.get("counted", ()))

    @property
    def not_counted(self) -> tuple[str, ...]:
        """The parts of the campaign left out of fatigue and casing wear, with the reasons."""
        return tuple(self.summary.get("not_counted", ()))

    @property
    def missing(self) -> int:
        """Number of points that are not solved because the plan was interrupted."""
        return int(self.summary["missing"])

    def _facts(self) -> Sequence[tuple[str, str]]:
        last = max(float(point["bit_depth_m"]) for point in self.summary["points"])
        facts = [("deepest bit", f"{last:.6g} m")]
        for point in self.summary["points"]:
            expected = point["friction"] == "expected" and point["bit_depth_m"] == last
            if expected and point["scalars"] is not None:
                name = f"{point['operation'].replace('_', ' ')} ({point['model']})"
                hook_N = point["scalars"]["hook_load_N"]
                torque_N_m = point["scalars"]["surface_torque_N_m"]
                facts.append((name, f"{hook_N / 1e3:.1f} kN, {torque_N_m / 1e3:.2f} kN.m"))
        return facts

    def __repr__(self) -> str:
        """Return a summary with the operations and the number of depths."""
        operations = ", ".join(self.summary["operations"])
        depths = len(self.summary["bit_depths_m"])
        return f"<Plan of {self.case_name}: {operations} at {depths} depths>"


@dataclass(frozen=True, kw_only=True)
class Stop:
    """The limit that stops a well.

    Attributes
    ----------
    friction
        Friction factor of all sections; ``None`` for the friction of the case.
    operation, limit
        The operation and the limit: ``"slide"``, ``"lock_up"``.
    depth_m
        Depth of the bit, m.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(rig__top_drive_torque="12 kN.m")
    >>> stop = case.reach(to="6 km", friction=0.3).stops[0]
    >>> isinstance(stop, ws.Stop), stop.limit
    (True, 'top_drive')
    """

    friction: float | None
    operation: str
    limit: str
    depth_m: float


class Reach(BaseResults):
    """The depth that a well can reach, and the limit that stops it.

    :meth:`Case.reach` returns one.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(rig__top_drive_torque="12 kN.m")
    >>> reach = case.reach(to="6 km", friction=[0.2, 0.4])
    >>> [stop.friction for stop in reach.stops]
    [0.2, 0.4]
    >>> reach.stops[0].depth_m > reach.stops[1].depth_m
    True
    """

    __slots__ = ()
    _kind = "a reach"

    @property
    def margins(self) -> Table:
        """The margin to each limit of each operation against the depth of the bit."""
        return self.table("reach")

    @property
    def limits(self) -> Table:
        """Each limit of each operation, and the depth at which it is reached."""
        return self.table("reach_limits")

    @property
    def from_m(self) -> float:
        """First depth of the bit in the search, m."""
        return float(self.summary["from_m"])

    @property
    def to_m(self) -> float:
        """Last depth of the bit in the search, m."""
        return float(self.summary["to_m"])

    @property
    def inclination_rad(self) -> float:
        """Inclination of the direction in which the well is extended, rad."""
        return float(self.summary["inclination_rad"])

    @property
    def stops(self) -> tuple[Stop, ...]:
        """The first limit that stops the well, for each friction at which one does."""
        frictions = self.summary["frictions"]
        return tuple(
            Stop(friction=row["friction"], **row["first"]) for row in frictions if row["first"]
        )

    @property
    def depth_m(self) -> float | None:
        """Depth reached at the first friction factor, m; ``None`` where no limit stops it."""
        first: Any = self.summary["frictions"][0]["first"]
        return None if first is None else float(first["depth_m"])

    @property
    def left_out(self) -> tuple[str, ...]:
        """Operations that were left out, each with the reason, in a sentence."""
        return tuple(self.summary["left_out"])

    def _facts(self) -> Sequence[tuple[str, str]]:
        where = f"{self.from_m:.0f} m to {self.to_m:.0f} m"
        depth = "not stopped" if self.depth_m is None else f"to {self.depth_m:.0f} m"
        return [("depths", where), ("reach", depth)]
