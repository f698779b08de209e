"""Torque, drag and dynamics of a whole drill string in a deviated well.

A :class:`Case` describes well, string, mud, rig and operations, as a case file does. It is
immutable: :meth:`Case.with_` makes another. :meth:`Case.soft`, :meth:`Case.stiff` and
:meth:`Case.dynamic` solve it and give :class:`Results`: scalars with their unit in their name,
findings, and a :class:`Table` that polars, pandas, DuckDB and NumPy take without a copy.

Numbers are SI. Where a number goes in, a text with a unit does as well (``"45 klbf"``), and so does
anything with ``.to(unit).magnitude``, such as a quantity of pint.
"""

from . import plot
from ._core import __version__
from ._values import Quantity, Value
from .case import Case
from .errors import (
    CaseError,
    Diagnostic,
    Error,
    FolderError,
    InputError,
    Interrupted,
    NoAnswerError,
    ResultsError,
)
from .results import Finding, OperationResult, Results
from .simulation import Simulation
from .table import Table

__all__ = [
    "Case",
    "CaseError",
    "Diagnostic",
    "Error",
    "Finding",
    "FolderError",
    "InputError",
    "Interrupted",
    "NoAnswerError",
    "OperationResult",
    "Quantity",
    "Results",
    "ResultsError",
    "Simulation",
    "Table",
    "Value",
    "__version__",
    "plot",
]
