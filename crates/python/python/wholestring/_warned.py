"""Warnings that point to the line of the user's code."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterable

from .errors import CaseWarning, Diagnostic

_PACKAGE = os.path.dirname(__file__)


def outside() -> int:
    """Return the ``stacklevel`` of the nearest line outside this package, for the caller."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_PACKAGE):
        frame, level = frame.f_back, level + 1
    return level


def warn(found: Iterable[Diagnostic], besides: Iterable[Diagnostic] = ()) -> None:
    """Issue the warnings of a case as Python warnings, except the known ones."""
    known = {one.message for one in besides}
    for one in found:
        if one.severity == "warning" and one.message not in known:
            text = one.message + (f"\nhelp: {one.help}" if one.help else "")
            warnings.warn(text, CaseWarning, stacklevel=outside())
