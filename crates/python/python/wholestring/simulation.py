"""A dynamic run that you take forward yourself."""

from __future__ import annotations

from collections.abc import Mapping

from . import _core, _values
from ._listener import Listener
from ._values import Scalar
from .errors import Interrupted
from .results import Results
from .table import Table


class Simulation:
    """A dynamic run in hand: for a controller, a digital twin, an environment to learn in.

    :meth:`Case.simulation` makes one.

    Examples
    --------
    Bring the string to 120 rev/min in five seconds, and look at the torque:

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

    __slots__ = ("_held",)

    def __init__(self, core: _core.Simulation) -> None:
        self._held = core

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
        """Time at which the window of the case's statistics ends, s; at the latest while settling.

        Nothing happens then: a simulation in hand goes on as long as you like.
        """
        return self._held.clock()[1]

    @property
    def sample_interval_s(self) -> float:
        """Time between two samples, s."""
        return self._held.clock()[2]

    @property
    def is_settling(self) -> bool:
        """Whether the window of the case's statistics is yet to begin."""
        return self._held.clock()[3]

    def advance(self, time: Scalar, *, progress: bool = False) -> None:
        """Advance by a time, to the nearest sample.

        Parameters
        ----------
        time
            Such as ``"10 s"``, or seconds.
        progress
            Whether to draw a bar, with tqdm.

        Raises
        ------
        NoAnswerError
            If the run diverged.
        Interrupted
            If the user interrupted it; it stands where it was then.
        """
        seconds = _values.si(time, "time")
        with Listener(progress) as listener:
            try:
                self._held.advance(seconds, listener)
            except KeyboardInterrupt as error:
                interrupted = Interrupted("interrupted: the simulation stands where it was then")
                interrupted.results = self.results()
                raise interrupted from error

    def set(
        self,
        *,
        rpm: Scalar | None = None,
        block_velocity: Scalar | None = None,
        weight_on_bit: Scalar | None = None,
        flow_rate: Scalar | None = None,
        ramp: Scalar = 0.0,
    ) -> None:
        """Change set points from now on, as a line of the case's schedule does.

        Parameters
        ----------
        rpm
            Rotary speed at surface: ``"120 rpm"``, or rad/s.
        block_velocity
            Speed of the block, positive downwards: ``"0.3 m/s"``, or m/s.
        weight_on_bit
            What the autodriller holds: ``"60 kN"``, or N.
        flow_rate
            What the pumps deliver: ``"2000 L/min"``, or m³/s.
        ramp
            Time in which the set points go to their new values: ``"5 s"``, or seconds.
        """
        if block_velocity is not None and weight_on_bit is not None:
            raise ValueError("the hoist follows either the block's velocity or a weight on bit")

        def of(value: Scalar | None, dimension: str) -> float | None:
            return None if value is None else _values.si(value, dimension)

        self._held.set(
            _values.si(ramp, "time"),
            of(rpm, "rotary speed"),
            of(block_velocity, "speed"),
            of(weight_on_bit, "force"),
            of(flow_rate, "flow rate"),
        )

    @property
    def now(self) -> Mapping[str, float]:
        """The last sample by the names of the columns of the table against time, SI."""
        return dict(self._held.last())

    def state(self) -> Table:
        """Give the whole string as it is now: a row a node, from the surface down."""
        return Table(self._held.state(), "frames")

    def results(self) -> Results:
        """Give the answers so far: over the window if it has begun, else over all samples.

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
        """Give all of it as bytes, for :meth:`Case.simulation` to continue from."""
        return self._held.checkpoint()

    def __repr__(self) -> str:
        """Give the operation and the time."""
        return f"<Simulation of {self.operation} at {self.time_s:.6g} s>"
