"""Torque, drag and dynamics of a whole drill string in a deviated well.

A :class:`Case` describes well, string, mud, rig and operations, as a case file does. It is
immutable: :meth:`Case.with_` makes another. :meth:`Case.soft`, :meth:`Case.stiff` and
:meth:`Case.dynamic` solve it and return :class:`Results`: scalars with their unit in their name,
checks, and a :class:`Table` that polars, pandas, DuckDB and NumPy read without a copy.
:meth:`Case.broomstick`, :meth:`Case.plan`, :meth:`Case.reach`, :meth:`Case.calibrate`,
:meth:`Case.bha`, :meth:`Case.modes`, :meth:`Case.bit_test` and :func:`study` run the commands of
the command line; :func:`load` reads the results of any of them from a folder.
:func:`import_files` makes a case from the files of other programs.

Numbers are SI, except ``rpm``, which is in rev/min. Wherever a number is accepted, so are a text
with a unit (``"45 klbf"``), any object with ``.to(unit).magnitude``, such as a quantity of pint,
and any number or array of NumPy or pandas.
"""

from . import plot
from ._base import BaseResults, Check
from ._core import __version__
from ._values import Quantity, Value
from .assembly import Bha, BitTest, Modes
from .calibration import Calibration, Estimate
from .case import Case
from .errors import (
    CaseError,
    CaseWarning,
    Diagnostic,
    Error,
    FindingsError,
    FolderError,
    InputError,
    InputTypeError,
    Interrupted,
    MissingPackageError,
    NoAnswerError,
    NotFoundError,
    ResultsError,
)
from .importing import Contents, Imported, ImportNote, contents, import_files
from .laws import BitLaw, BitReading, Excitation, ShakeReading
from .loading import load
from .planning import Plan, PlanCheck, Reach, Stop
from .results import OperationResult, Results
from .simulation import Simulation
from .studies import Study, study
from .sweep import Sweep, sweep
from .table import Table

__all__ = [
    "BaseResults",
    "Bha",
    "BitLaw",
    "BitReading",
    "BitTest",
    "Calibration",
    "Case",
    "CaseError",
    "CaseWarning",
    "Check",
    "Contents",
    "Diagnostic",
    "Error",
    "Estimate",
    "Excitation",
    "FindingsError",
    "FolderError",
    "ImportNote",
    "Imported",
    "InputError",
    "InputTypeError",
    "Interrupted",
    "MissingPackageError",
    "Modes",
    "NoAnswerError",
    "NotFoundError",
    "OperationResult",
    "Plan",
    "PlanCheck",
    "Quantity",
    "Reach",
    "Results",
    "ResultsError",
    "ShakeReading",
    "Simulation",
    "Stop",
    "Study",
    "Sweep",
    "Table",
    "Value",
    "__version__",
    "contents",
    "import_files",
    "load",
    "plot",
    "study",
    "sweep",
]
