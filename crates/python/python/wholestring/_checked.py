"""A fully checked case, without the methods that solve it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._values import Change
from ._warned import warn
from .errors import Diagnostic

if TYPE_CHECKING:
    from typing_extensions import Self


class Checked:
    """A checked case: base of the classes that solve it."""

    __slots__ = ("_held",)
    _held: _core.Case

    @classmethod
    def _of(cls, core: _core.Case) -> Self:
        case = cls.__new__(cls)
        case._held = core
        return case

    def _changed(self, changes: list[Change]) -> Self:
        case = self._of(self._held.changed(changes))
        warn(case._warnings(), besides=self._warnings())
        return case

    def _warnings(self) -> tuple[Diagnostic, ...]:
        return tuple(Diagnostic(**found) for found in self._held.warnings())

    def to_toml(self) -> str:
        """Return the case as the text of a case file, with its comments and its changes.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(friction=0.25)
        >>> ws.Case(case.to_toml()) == case
        True
        """
        return self._held.to_toml()
