"""Plans, and how far a well can go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ._base import BaseResults, Finding, by_gravity
from .table import Table

# What findings are called of a limit that is kept no more, or not by enough.
_LEVELS = {"passed": "error", "short": "warning", "near": "note"}


@dataclass(frozen=True, kw_only=True)
class Limit:
    """How near a load comes to what string or rig bears, where it comes nearest.

    Attributes
    ----------
    kind
        The limit, as a word: ``"top_drive"``, ``"von_mises"``.
    model, operation, friction
        Whose it is; friction is ``"low"``, ``"expected"`` or ``"high"``.
    bit_depth_m
        Measured depth of the bit, m.
    component, md_m
        Where in the string, measured depth in m; ``None`` of the rig.
    load, capacity
        What it bears and what it could.
    unit
        SI unit of both.
    factor, required
        Factor between them, and the one that is to be kept.
    standing
        ``"kept"``, ``"near"``, ``"short"`` of what is required, or ``"passed"``.

    Examples
    --------
    >>> import wholestring as ws
    >>> plan = ws.Case.example().with_({"plan.bit_depths": [800.0, 1200.0]}).plan()
    >>> nearest = min(plan.worst_limits, key=lambda of: of.reserve)
    >>> isinstance(nearest, ws.Limit), nearest.reserve > 0.0
    (True, True)
    """

    kind: str
    model: str
    operation: str
    friction: str
    bit_depth_m: float
    component: str | None
    md_m: float | None
    load: float
    capacity: float
    unit: str
    factor: float
    required: float
    standing: str

    @property
    def reserve(self) -> float:
        """The factor as a part of what is required: less than one is not enough."""
        return self.factor / self.required


class Plan(BaseResults):
    """Torque and drag at every depth of the bit, with low, expected and high friction.

    :meth:`Case.plan` makes one.

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
        """How near each point comes to what string and rig bear."""
        return self.table("plan_limits")

    @property
    def buckling(self) -> Table:
        """The weight on bit under which the string begins to buckle."""
        return self.table("plan_buckling")

    @property
    def deepest_m(self) -> float:
        """Deepest bit, m."""
        return float(max(self.summary["bit_depths_m"]))

    @property
    def worst_limits(self) -> tuple[Limit, ...]:
        """Of each kind and operation the limit that comes nearest to what it bears."""
        return tuple(Limit(**of) for of in self.summary["worst_limits"])

    @property
    def unchecked(self) -> tuple[str, ...]:
        """What could not be checked, in words, as the case does not give it."""
        return tuple(self.summary["unchecked"])

    @property
    def missing(self) -> int:
        """Points that are not solved: the plan was interrupted."""
        return int(self.summary["missing"])

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The limits that are not kept by as much as is required, the gravest first."""
        found = [of for of in self.worst_limits if of.standing in _LEVELS]
        return by_gravity([_of_limit(of) for of in found])

    def _facts(self) -> Sequence[tuple[str, str]]:
        last = max(float(of["bit_depth_m"]) for of in self.summary["points"])
        facts = [("deepest bit", f"{last:.6g} m")]
        for of in self.summary["points"]:
            expected = of["friction"] == "expected" and of["bit_depth_m"] == last
            if expected and of["scalars"] is not None:
                name = f"{of['operation'].replace('_', ' ')} ({of['model']})"
                hook_N = of["scalars"]["hook_load_N"]
                torque_N_m = of["scalars"]["surface_torque_N_m"]
                facts.append((name, f"{hook_N / 1e3:.1f} kN, {torque_N_m / 1e3:.2f} kN.m"))
        return facts

    def __repr__(self) -> str:
        """Give its size."""
        operations = ", ".join(self.summary["operations"])
        depths = len(self.summary["bit_depths_m"])
        return f"<Plan of {self.case_name}: {operations} at {depths} depths>"


def _of_limit(of: Limit) -> Finding:
    where = "" if of.component is None else f", {of.component}"
    message = (
        f"{of.standing}: {of.kind.replace('_', ' ')} in {of.operation.replace('_', ' ')}{where}, "
        f"{of.friction} friction, the bit at {of.bit_depth_m:.0f} m: factor {of.factor:.2f}, "
        f"required {of.required:.2f}"
    )
    return Finding(
        kind=of.kind,
        level=_LEVELS[of.standing],
        message=message,
        md_m=of.md_m,
        value=of.load,
        limit=of.capacity,
        unit=of.unit,
    )


@dataclass(frozen=True, kw_only=True)
class Stop:
    """What stops a well.

    Attributes
    ----------
    friction
        Friction factor of all sections; ``None`` where they have the case's own.
    operation, limit
        In which operation, and what: ``"slide"``, ``"lock_up"``.
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
    """How far a well can go, and what stops it.

    :meth:`Case.reach` finds it.

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
        """Each limit of each operation, and at which depth it is met."""
        return self.table("reach_limits")

    @property
    def from_m(self) -> float:
        """First depth of the bit that was looked at, m."""
        return float(self.summary["from_m"])

    @property
    def to_m(self) -> float:
        """Last depth of the bit, m."""
        return float(self.summary["to_m"])

    @property
    def inclination_rad(self) -> float:
        """Inclination of the direction in which the well goes on, rad."""
        return float(self.summary["inclination_rad"])

    @property
    def stops(self) -> tuple[Stop, ...]:
        """What stops the well first, at each friction at which anything does."""
        frictions = self.summary["frictions"]
        return tuple(
            Stop(friction=of["friction"], **of["first"]) for of in frictions if of["first"]
        )

    @property
    def depth_m(self) -> float | None:
        """How far it goes at the friction asked for first, m; ``None`` where nothing stops it."""
        first: Any = self.summary["frictions"][0]["first"]
        return None if first is None else float(first["depth_m"])

    @property
    def left_out(self) -> tuple[str, ...]:
        """Operations that were left out, and why, a sentence for each."""
        return tuple(self.summary["left_out"])

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What stops the well at each friction."""
        return tuple(
            Finding(
                kind=of.limit,
                level="note",
                message=f"{_at(of)} stops it at {of.depth_m:.0f} m",
                md_m=of.depth_m,
            )
            for of in self.stops
        )

    def _facts(self) -> Sequence[tuple[str, str]]:
        where = f"{self.from_m:.0f} m to {self.to_m:.0f} m"
        depth = "not stopped" if self.depth_m is None else f"to {self.depth_m:.0f} m"
        return [("looked at", where), ("reach", depth)]


def _at(of: Stop) -> str:
    friction = "the case's friction" if of.friction is None else f"friction {of.friction:g}"
    return f"at {friction} {of.limit.replace('_', ' ')} in {of.operation.replace('_', ' ')}"
