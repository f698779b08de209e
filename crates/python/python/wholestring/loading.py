"""Results of any command in a folder."""

from __future__ import annotations

from os import PathLike

from . import _core
from ._base import BaseResults
from .assembly import Bha, BitTest, Modes
from .calibration import Calibration
from .planning import Plan, Reach
from .results import Results
from .studies import Study
from .sweep import Sweep

_KINDS: dict[str, type[BaseResults]] = {
    kind._kind: kind for kind in (Results, Plan, Reach, Calibration, Modes, Bha, BitTest, Study)
}


def load(folder: str | PathLike[str]) -> BaseResults | Sweep:
    """Read the results of any command from a folder.

    Parameters
    ----------
    folder
        The folder.

    Examples
    --------
    >>> import tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     saved = ws.Case.example().soft().save(place + "/here")
    ...     print(type(ws.load(saved)).__name__)
    Results

    Raises
    ------
    ResultsError
        If the folder has no results.
    """
    core = _core.Answers.load(folder)
    return Sweep(folder) if core.kind == "a sweep" else _KINDS[core.kind](core)
