"""Static analysis of the assembly, linear vibration, and the bit alone on its rock."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._base import BaseResults
from .errors import InputError
from .table import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Bha(BaseResults):
    """Static analysis of the bottom-hole assembly: side force, contacts, bending, sag.

    :meth:`Case.bha` returns one.

    Examples
    --------
    >>> import wholestring as ws
    >>> bha = ws.Case.example().bha(inclination="20deg..40deg/10deg")
    >>> high_N, right_N = bha.side_force_N
    >>> high_N < 0.0  # a pendulum drops
    True
    >>> len(bha.varied)
    10
    """

    __slots__ = ()
    _kind = "a static BHA analysis"

    @property
    def nodes(self) -> Table:
        """The assembly along its length."""
        return self.table("bha")

    @property
    def contacts(self) -> Table:
        """Contacts of the assembly with the wall."""
        return self.table("bha_contacts")

    @property
    def varied(self) -> Table:
        """The bit's side force at other tool faces, weights and inclinations."""
        return self.table("bha_sweep")

    @property
    def operation(self) -> str:
        """The operation."""
        return str(self.summary["operation"])

    @property
    def _state(self) -> Any:
        return self.summary["state"]

    @property
    def side_force_N(self) -> tuple[float, float]:
        """Side force of the bit on the hole, towards its high side and to the right of it, N."""
        high, right = self._state["side_force_N"]
        return float(high), float(right)

    @property
    def tilt_rad(self) -> tuple[float, float]:
        """Tilt of the bit against the hole, towards its high side and to the right of it, rad."""
        high, right = self._state["tilt_rad"]
        return float(high), float(right)

    @property
    def length_m(self) -> float:
        """Length of the assembly, m."""
        return float(self._state["length_m"])

    @property
    def weight_on_bit_N(self) -> float:
        """Weight on bit, N."""
        return float(self.summary["weight_on_bit_N"])

    @property
    def largest_bending_moment_N_m(self) -> float:
        """Largest bending moment, N.m."""
        return float(self._state["largest_bending_moment_N_m"]["value"])

    @property
    def largest_bending_stress_Pa(self) -> float:
        """Largest bending stress, Pa."""
        return float(self._state["largest_bending_stress_Pa"]["value"])

    @property
    def largest_von_mises_stress_Pa(self) -> float:
        """Largest von Mises stress, Pa."""
        return float(self._state["largest_von_mises_stress_Pa"]["value"])

    @property
    def holding_inclinations_rad(self) -> NDArray[np.float64]:
        """Inclinations at which the assembly neither builds nor drops, rad."""
        return np.array(self.summary["holding_inclinations_rad"], dtype=np.float64)

    @property
    def holding_weights_N(self) -> NDArray[np.float64]:
        """Weights on bit at which the assembly neither builds nor drops, N."""
        return np.array(self.summary["holding_weights_N"], dtype=np.float64)

    def _facts(self) -> Sequence[tuple[str, str]]:
        high, right = self.side_force_N
        stress_MPa = self.largest_bending_stress_Pa / 1e6
        return [
            ("side force towards high side", f"{high / 1e3:.3f} kN"),
            ("side force to the right", f"{right / 1e3:.3f} kN"),
            ("largest bending stress", f"{stress_MPa:.1f} MPa"),
        ]


class Modes(BaseResults):
    """Natural frequencies, critical speeds and the response to a rotating force.

    :meth:`Case.modes` returns them.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(mesh__element_length="20 m", modes__count=2)
    >>> modes = case.modes(operation="rotate_off_bottom")
    >>> torsional = modes.frequencies_Hz("torsional")
    >>> bool(torsional[0] < 0.65)  # 0.65 Hz: a uniform rod of 1200 m; collars lower it
    True
    """

    __slots__ = ()
    _kind = "modes"

    @property
    def modes(self) -> Table:
        """The modes, a row for each."""
        return self.table("modes")

    @property
    def shapes(self) -> Table:
        """Mode shapes along the string."""
        return self.table("mode_shapes")

    @property
    def campbell(self) -> Table:
        """Frequencies against rotary speed."""
        return self.table("campbell")

    @property
    def critical_speeds(self) -> Table:
        """Rotary speeds at which an excitation meets a natural frequency."""
        return self.table("critical_speeds")

    @property
    def response(self) -> Table:
        """The response to a rotating force, against rotary speed."""
        return self.table("response")

    @property
    def operation(self) -> str:
        """The operation whose static equilibrium the modes are about."""
        return str(self.summary["operation"])

    @property
    def rotary_speed_rad_per_s(self) -> float:
        """Rotary speed of the operation, rad/s."""
        return float(self.summary["rotary_speed_rad_per_s"])

    def frequencies_Hz(self, family: str) -> NDArray[np.float64]:
        """Return the natural frequencies of a family, Hz.

        Parameters
        ----------
        family
            ``"lateral"``, ``"axial"`` or ``"torsional"``.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(mesh__element_length="20 m", modes__count=2)
        >>> axial = case.modes(operation="rotate_off_bottom").frequencies_Hz("axial")
        >>> bool(axial[0] < axial[1])
        True
        """
        families = ("lateral", "axial", "torsional")
        if family not in families:
            raise InputError(f"`family` was given {family!r}: expected one of {families}")
        found = [mode["frequency_Hz"] for mode in self.summary["modes"] if mode["family"] == family]
        return np.array(found, dtype=np.float64)

    @property
    def critical_speeds_rad_per_s(self) -> NDArray[np.float64]:
        """Critical rotary speeds in ascending order, rad/s."""
        found = [speed["rotary_speed_rad_per_s"] for speed in self.summary["critical_speeds"]]
        return np.array(sorted(found), dtype=np.float64)

    def _facts(self) -> Sequence[tuple[str, str]]:
        lowest = (
            (family, self.frequencies_Hz(family)) for family in ("lateral", "axial", "torsional")
        )
        return [
            (f"lowest {family}", f"{values.min():.4g} Hz")
            for family, values in lowest
            if values.size
        ]


class BitTest(BaseResults):
    """The bit alone on its rock, at every combination of weight and speed.

    :meth:`Case.bit_test` returns one.

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
    >>> round(tried.rock_strength_Pa), tried.law_file.name
    (10000000, 'bit-table.csv')
    """

    __slots__ = ()
    _kind = "a bit test"

    @property
    def points(self) -> Table:
        """Rate of penetration, torque and more, a row for each weight and speed."""
        return self.table("bit-test")

    @property
    def rock_strength_Pa(self) -> float:
        """Strength of the rock, Pa."""
        return float(self.summary["rock_strength_Pa"])

    @property
    def bit_radius_m(self) -> float:
        """Radius of the bit, m."""
        return float(self.summary["bit_radius_m"])

    @property
    def law_file(self) -> Path | None:
        """File for the bit law ``"table"`` of a case; ``None`` until all points are drilled."""
        folder = self.folder
        file = None if folder is None else folder / "bit-table.csv"
        return file if file is not None and file.is_file() else None

    def _facts(self) -> Sequence[tuple[str, str]]:
        points = self.summary["points"]
        done = sum(point["status"] == "complete" for point in points)
        strength_MPa = self.rock_strength_Pa / 1e6
        return [("points", f"{done} of {len(points)}"), ("rock", f"{strength_MPa:.4g} MPa")]
