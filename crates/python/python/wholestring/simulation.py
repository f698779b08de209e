"""A dynamic run that the caller advances."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import cast

from . import _core, _html, _values
from ._listener import Listener
from ._planning import Factors
from ._values import Scalar
from .errors import InputError, InputTypeError, Interrupted
from .plot._house import operation_words
from .plot._shown import Display, Units, about
from .results import Results
from .table import Table

_SHOWN = (
    "hook_load_N",
    "surface_torque_N_m",
    "weight_on_bit_N",
    "rotary_speed_rad_per_s",
    "bit_rotary_speed_rad_per_s",
    "bit_depth_m",
)
"""The columns of the last sample that notebooks display."""


class Simulation:
    """A dynamic run that the caller advances, for controllers, digital twins and learning.

    :meth:`Case.simulation` returns one.

    Examples
    --------
    Bring the string to 120 rev/min in two seconds, and read the rotary speed:

    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(mesh__element_length="10 m")
    >>> sim = case.simulation("rotate_off_bottom")
    >>> sim.set(rpm="120 rpm", ramp="2 s")
    >>> sim.advance("2 s")
    >>> round(sim.now["rotary_speed_set_rad_per_s"] * 60 / 6.2832)
    120
    >>> bool(sim.state()["rotary_speed_rad_per_s"][0] > 12.0)
    True
    """

    __slots__ = ("_held", "_units")

    def __init__(self, core: _core.Simulation, units: Units | None = None) -> None:
        self._held = core
        self._units: Units | None = units

    @property
    def operation(self) -> str:
        """The operation: ``"drill"``, ``"trip_in"``, and so on."""
        return self._held.operation

    @property
    def time_s(self) -> float:
        """Time since the start, s."""
        return self._held.clock()[0]

    @property
    def end_time_s(self) -> float:
        """Time at which the statistics window of the case ends, s; the latest end while settling.

        The simulation does not stop at this time: it can be advanced without limit.
        """
        return self._held.clock()[1]

    @property
    def sample_interval_s(self) -> float:
        """Time between two samples, s."""
        return self._held.clock()[2]

    @property
    def is_settling(self) -> bool:
        """Whether the statistics window of the case has not begun yet."""
        return self._held.clock()[3]

    def advance(self, time: Scalar, *, progress: bool = False) -> None:
        """Advance by a time, to the nearest sample.

        Times add up, because the remainder of one call is added to the next. A hundred calls of
        0.01 s advance by 1 s, and so do a thousand calls of 0.001 s, of which nine in ten do not
        move the string if samples are 0.01 s apart. :attr:`sample_interval_s` is
        ``dynamics.sample_interval`` of the case.

        An exception in a law of the caller is raised here. The simulation is then at the sample
        after the exception, up to which the last values of the law were used; the results so far
        are available.

        Parameters
        ----------
        time
            Time to advance by: ``"10 s"``, or seconds.
        progress
            Whether to draw a bar, with tqdm.

        Raises
        ------
        NoAnswerError
            If the run diverged.
        Interrupted
            If the user interrupted the run; the simulation keeps its state at that time.

        Examples
        --------
        >>> import wholestring as ws
        >>> sim = ws.Case.example().with_(mesh__element_length="20 m").simulation("drill")
        >>> sim.advance("0.5 s")
        >>> sim.advance(0.5)
        >>> round(sim.time_s, 2)
        1.0
        """
        if cast("object", time) is None:
            raise InputTypeError("`time` was given None: expected a text with a unit, or seconds")
        seconds = cast("float", _values.option("time", time, "time"))
        with Listener(progress) as listener:
            try:
                self._held.advance(seconds, listener)
            except KeyboardInterrupt as error:
                message = "interrupted: the simulation keeps its state at that time"
                raise Interrupted(message, make_results=self.results) from error

    def set(
        self,
        *,
        rpm: Scalar | None = None,
        rotary_speed: Scalar | None = None,
        block_velocity: Scalar | None = None,
        weight_on_bit: Scalar | None = None,
        flow_rate: Scalar | None = None,
        friction: Factors | None = None,
        ramp: Scalar = 0.0,
    ) -> None:
        """Change set points from now on, as a line of the case's schedule does, or friction.

        Parameters
        ----------
        rpm
            Rotary speed at surface: 120 or ``"120 rpm"``; a number is in rev/min.
        rotary_speed
            Rotary speed at surface, rad/s, as in the columns.
        block_velocity
            Speed of the block, positive downwards: ``"0.3 m/s"``, or m/s.
        weight_on_bit
            Set point of the autodriller: ``"60 kN"``, or N.
        flow_rate
            Flow rate of the pumps: ``"2000 L/min"``, or m³/s.
        friction
            Kinetic coefficient between string and wall: one for the whole hole, or one for each of
            its sections from the surface down. The static and the rotational coefficients keep
            their ratios to it.
        ramp
            Time over which each value changes to the new one: ``"5 s"``, or seconds.

        Raises
        ------
        InputError
            If a value is outside the limits of the keys of ``operation.schedule``.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="10 m")
        >>> sim = case.simulation("trip_out")
        >>> sim.friction
        (0.2, 0.3)
        >>> sim.set(friction=(0.25, 0.4), ramp="1 s")
        >>> sim.advance("0.5 s")
        >>> tuple(round(factor, 2) for factor in sim.friction)
        (0.22, 0.35)
        """
        if block_velocity is not None and weight_on_bit is not None:
            raise InputError("the hoist follows either the block's velocity or a weight on bit")
        if rpm is not None and rotary_speed is not None:
            raise InputError("`rpm` and `rotary_speed` set the same speed: give one of them")
        speed = _values.rotary_speed("rpm", rpm)
        if rotary_speed is not None:
            speed = _values.option("rotary_speed", rotary_speed, "rotary speed")
        ramp_s = cast("float", _values.option("ramp", ramp, "time"))
        points = (
            speed,
            _values.option("block_velocity", block_velocity, "speed"),
            _values.option("weight_on_bit", weight_on_bit, "force"),
            _values.option("flow_rate", flow_rate, "flow rate"),
        )
        sections = _values.factors("friction", friction)
        if any(point is not None for point in points):
            self._held.set(ramp_s, *points)
        if sections:
            self._held.set_friction(ramp_s, sections)

    @property
    def friction(self) -> tuple[float, ...]:
        """The kinetic coefficient of each section of the hole now, from the surface down."""
        return tuple(self._held.friction())

    @property
    def now(self) -> Mapping[str, float]:
        """The last sample, SI, by the column names of the table against time.

        It is empty before the first sample.
        """
        return dict(self._held.last())

    @property
    def history(self) -> Table:
        """The table against time so far."""
        return Table(self._held.samples(-math.inf), "time")

    def since(self, time: Scalar) -> Table:
        """Return the rows of the table against time after a time.

        Parameters
        ----------
        time
            Time of the simulation: ``"10 s"``, or seconds.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="10 m")
        >>> sim = case.simulation("rotate_off_bottom")
        >>> sim.advance("0.2 s")
        >>> before = sim.time_s
        >>> sim.advance("0.1 s")
        >>> new = sim.since(before)
        >>> bool(new["time_s"][0] > before), bool(new["time_s"][-1] == sim.time_s)
        (True, True)
        """
        after_s = cast("float", _values.option("time", time, "time"))
        return Table(self._held.samples(after_s), "time")

    def forget(self, before: Scalar | None = None) -> None:
        """Drop the samples before a time, so that memory does not grow with the simulated time.

        Otherwise a simulation keeps about 15 kB per second, also in every checkpoint. The last
        sample is kept, and during settling also the samples that determine whether the string is
        steady. Statistics of :meth:`results` are then over the remaining samples of the window;
        profiles along the string remain means over the whole window. The motion is not affected.

        Parameters
        ----------
        before
            Time of the simulation: ``"10 s"``, or seconds; now by default.

        Examples
        --------
        Keep the samples of the last second:

        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="20 m", dynamics__settle="0 s")
        >>> sim = case.simulation("drill")
        >>> for _ in range(4):
        ...     sim.advance("0.5 s")
        ...     sim.forget(sim.time_s - 1.0)
        >>> round(float(sim.history["time_s"][0]), 2), round(sim.time_s, 2)
        (1.0, 2.0)
        """
        before_s = math.inf if before is None else _values.option("before", before, "time")
        self._held.forget(cast("float", before_s))

    def state(self) -> Table:
        """Return the current state of the whole string: a row per node, from the surface down.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="10 m")
        >>> sim = case.simulation("rotate_off_bottom")
        >>> sim.advance("0.1 s")
        >>> state = sim.state()
        >>> state.unit("torque_N_m"), len(state["torque_N_m"]) == len(state)
        ('N·m', True)
        """
        return Table(self._held.state(), "frames")

    def results(self) -> Results:
        """Return the results so far: over the window if it has begun, otherwise over all samples.

        Examples
        --------
        >>> import wholestring as ws
        >>> sim = ws.Case.example().with_(mesh__element_length="20 m").simulation("drill")
        >>> sim.advance("0.5 s")
        >>> sim.results()["drill"].model
        'dynamic'
        """
        return Results(self._held.answers())

    def checkpoint(self) -> bytes:
        """Return the state as bytes, from which :meth:`Case.simulation` continues bit-identically.

        The bytes include set points, friction and the last values of laws of the caller. They do
        not include these laws or their own state: pass the same laws to :meth:`Case.simulation`.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="20 m")
        >>> sim = case.simulation("drill")
        >>> sim.advance("0.5 s")
        >>> again = case.simulation(checkpoint=sim.checkpoint())
        >>> for run in (sim, again):
        ...     run.advance("0.5 s")
        >>> again.now["hook_load_N"] == sim.now["hook_load_N"]
        True
        """
        return self._held.checkpoint()

    def __repr__(self) -> str:
        """Return a summary with the operation and the time."""
        return f"<Simulation of {self.operation} at {self.time_s:.6g} s>"

    def _repr_html_(self) -> str:
        display = Display(self._units)
        now = self.now
        rows = [
            ("Time", f"{self.time_s:.6g} s"),
            ("State", "settling" if self.is_settling else "in the window of the statistics"),
            ("Friction", ", ".join(f"{one:.3g}" for one in self.friction)),
        ]
        for name in _SHOWN:
            value = now.get(name, math.nan)
            if not math.isnan(value):
                title, dimension = about(name)
                rows.append((title, display.quantity(value, dimension)))
        return _html.facts(rows, caption=f"Simulation: {operation_words(self.operation)}")
