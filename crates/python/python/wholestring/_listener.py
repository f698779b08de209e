"""Receiver of the messages and the progress of long work."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from ._warned import outside
from .errors import MissingPackageError

if TYPE_CHECKING:
    from typing_extensions import Self


class Listener:
    """Receives progress and messages: draws a bar if requested, and issues warnings.

    Parameters
    ----------
    progress
        Whether to draw a bar, with tqdm.
    """

    def __init__(self, progress: bool) -> None:
        self._draws_bar = progress
        self._bar: Any = None
        self._name = ""

    def said(self, is_warning: bool, sentence: str) -> None:
        """Receive a message."""
        if is_warning:
            warnings.warn(sentence.removeprefix("warning: "), stacklevel=outside())

    def progress(self, name: str, time_s: float, end_s: float) -> None:
        """Receive the progress of a simulation."""
        if not self._draws_bar:
            return
        if self._bar is None or name != self._name:
            self.close()
            self._bar = _tqdm()(total=end_s, desc=name, bar_format=_RUN)
            self._name = name
        self._bar.total = end_s
        self._bar.n = min(time_s, end_s)
        self._bar.refresh()

    def batch(self, ended: int, cases: int, part: float) -> None:
        """Receive the progress of a batch: number of ended cases, and completed share of all."""
        if not self._draws_bar:
            return
        if self._bar is None:
            self._bar = _tqdm()(total=1.0, bar_format=_BATCH)
        self._bar.n = max(self._bar.n, min(part, 1.0))
        self._bar.set_postfix_str(f"{ended} of {cases}", refresh=False)
        self._bar.refresh()

    def close(self) -> None:
        """Close the bar."""
        if self._bar is not None:
            self._bar.close()
            self._bar = None

    def __enter__(self) -> Self:
        """Begin to receive."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the bar."""
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
