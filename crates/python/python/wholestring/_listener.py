"""Who hears what long work says."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from ._warned import outside
from .errors import MissingPackageError

if TYPE_CHECKING:
    from typing_extensions import Self


class Listener:
    """Draws a bar where one is wanted, and warns.

    Parameters
    ----------
    progress
        Whether to draw a bar, with tqdm.
    """

    def __init__(self, progress: bool) -> None:
        self._wanted = progress
        self._bar: Any = None
        self._name = ""

    def said(self, is_warning: bool, sentence: str) -> None:
        """Hear a sentence."""
        if is_warning:
            warnings.warn(sentence.removeprefix("warning: "), stacklevel=outside())

    def progress(self, name: str, time_s: float, end_s: float) -> None:
        """Hear how far a simulation has come."""
        if not self._wanted:
            return
        if self._bar is None or name != self._name:
            self.close()
            self._bar = _tqdm()(total=end_s, desc=name, bar_format=_RUN)
            self._name = name
        self._bar.total = end_s
        self._bar.n = min(time_s, end_s)
        self._bar.refresh()

    def batch(self, ended: int, of: int, part: float) -> None:
        """Hear how far a batch has come: cases that have ended, and how much of all is done."""
        if not self._wanted:
            return
        if self._bar is None:
            self._bar = _tqdm()(total=1.0, bar_format=_BATCH)
        self._bar.n = max(self._bar.n, min(part, 1.0))
        self._bar.set_postfix_str(f"{ended} of {of}", refresh=False)
        self._bar.refresh()

    def close(self) -> None:
        """End the bar."""
        if self._bar is not None:
            self._bar.close()
            self._bar = None

    def __enter__(self) -> Self:
        """Listen."""
        return self

    def __exit__(self, *_: object) -> None:
        """Listen no more."""
        self.close()


_RUN = "{l_bar}{bar}| {n:.0f}/{total:.0f} s [{elapsed}<{remaining}]"
_BATCH = "{l_bar}{bar}|{postfix} [{elapsed}<{remaining}]"


def _tqdm() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError as error:
        message = "a progress bar needs tqdm: pip install tqdm"
        raise MissingPackageError(message) from error
    return tqdm
