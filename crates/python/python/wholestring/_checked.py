"""A case in which everything has been checked, without its verbs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core

if TYPE_CHECKING:
    from typing_extensions import Self


class Checked:
    """What the verbs of a case work on."""

    __slots__ = ("_held",)
    _held: _core.Case

    @classmethod
    def _of(cls, core: _core.Case) -> Self:
        case = cls.__new__(cls)
        case._held = core
        return case

    def _changed(self, changes: list[tuple[str, str]]) -> Self:
        return self._of(self._held.changed(changes))

    def to_toml(self) -> str:
        """Give the case as the text of a case file, with its comments and its changes.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example().with_(friction=0.25)
        >>> ws.Case(case.to_toml()) == case
        True
        """
        return self._held.to_toml()
