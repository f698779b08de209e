"""A case: well, string, mud, rig and operations."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, cast

import numpy as np

from . import _case_html, _core, _values
from ._assemblies import Assemblies
from ._columns import content, is_table
from ._planning import Planning
from ._solving import Solving
from ._values import Value
from ._warned import warn
from .errors import CaseError, Diagnostic, InputError, InputTypeError, NotFoundError
from .importing import import_files
from .table import Table

# Name of a survey that was passed as a table.
_SURVEY = "survey.csv"


class Case(Solving, Planning, Assemblies):
    """A fully checked case. It is immutable.

    Parameters
    ----------
    text
        Text of a case file.
    name
        Name of the text in error messages.
    files
        Contents of the files that it refers to, such as its survey, by their names in the case.

    Raises
    ------
    CaseError
        If the case has mistakes: all of them, each with its place.

    Examples
    --------
    >>> import wholestring as ws
    >>> case = ws.Case.example().with_(friction=0.25, operation__bit_depth="1000 m")
    >>> case.soft()["trip_out"].bit_depth_m
    1000.0
    """

    __slots__ = ()

    def __init__(
        self,
        text: str,
        *,
        name: str = "case",
        files: Mapping[str, bytes] | None = None,
    ) -> None:
        if not isinstance(cast("object", text), str):
            raise InputTypeError(f"`text` was given {text!r}: expected the text of a case file")
        self._held = _core.Case.parse(text, name, _values.mapping("files", files))
        warn(self._warnings())

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Read a case file and the files that it refers to.

        Parameters
        ----------
        path
            The case file.

        Raises
        ------
        CaseError
            If the case has mistakes: all of them, each with its place.

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     file = pathlib.Path(place, "well.toml")
        ...     _ = file.write_text(ws.Case.example().to_toml())
        ...     print(ws.Case.load(file) == ws.Case.example())
        True
        """
        case = cls._of(_core.Case.load(_values.path("path", path)))
        warn(case._warnings())
        return case

    @classmethod
    def from_files(
        cls,
        *files: str | PathLike[str],
        units: Mapping[str, str] | None = None,
        values: Mapping[str, str] | None = None,
        picks: Mapping[str, str] | None = None,
        changes: Mapping[str, Value] | None = None,
    ) -> Case:
        r"""Make a case from the files of other programs, with :func:`import_files`, and add values.

        Parameters
        ----------
        *files
            Surveys, tallies, WITSML, Landmark EDM, logs. Several files make one case.
        units
            Units that are missing in the files: ``{"md": "ft"}``.
        values
            Required values that are missing in the files: ``{"block-weight": "25 tf"}``.
        picks
            Choice among several in a file: ``{"tubular": "BHA 7"}``.
        changes
            Dotted keys of the case and their values, as for :meth:`with_`.

        Raises
        ------
        InputError
            If the format of a file is unknown, or required data are missing in it.
        CaseError
            If data that a case requires are missing in all files.

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     survey = pathlib.Path(place, "survey.csv")
        ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
        ...     try:
        ...         ws.Case.from_files(survey)
        ...     except ws.CaseError as error:
        ...         print("mud" in str(error))
        True
        """
        return import_files(*files, units=units, values=values, picks=picks).case(changes)

    @classmethod
    def from_dict(
        cls,
        table: Mapping[str, Value],
        *,
        survey: object | None = None,
        name: str = "case",
        files: Mapping[str, bytes] | None = None,
    ) -> Case:
        """Make a case from Python objects: the tables and keys of a case file.

        Numbers are SI, except rotary speeds, which are in rev/min as in a case file. Texts and
        quantities of pint may have other units. A key that is ``None`` is left out.

        Parameters
        ----------
        table
            The case: ``{"mud": {"density": 1200.0}, "string": [{...}], ...}``.
        survey
            The stations of the well: a list or an array with a row for each, measured depth in m,
            inclination and azimuth in degrees, as in ``well.stations``; or a data frame of
            polars or pandas, or columns, with units in their names: ``md_m``, ``inc_deg``,
            ``azi_deg``.
        name
            Name of the case in error messages.
        files
            Contents of the files that it refers to, by their names in the case.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.from_dict(
        ...     {
        ...         "well": {
        ...             "hole": [
        ...                 {"kind": "open", "to": 900.0, "diameter": 0.2159, "friction": 0.3}
        ...             ]
        ...         },
        ...         "mud": {"density": 1200.0},
        ...         "string": [
        ...             {"component": "bit", "od": 0.2159, "id": "2 in", "length": 0.3},
        ...             {
        ...                 "component": "drill pipe",
        ...                 "catalogue": "DP 5 in 19.50 lb/ft S-135",
        ...                 "length": "to surface",
        ...             },
        ...         ],
        ...         "operation": {"kind": "trip_out"},
        ...     },
        ...     survey=[[0.0, 0.0, 0.0], [500.0, 0.0, 0.0], [900.0, 40.0, 0.0]],
        ... )
        >>> case.soft()["trip_out"].bit_depth_m
        900.0
        """
        table, all_files = _values.mapping("table", table), _values.mapping("files", files)
        if survey is not None:
            well = _values.mapping("well", table.get("well"))
            if is_table(survey):
                well["survey"] = _SURVEY
                all_files[_SURVEY] = content(survey)
            else:
                well["stations"] = _stations(survey)
            table["well"] = well
        return cls(_values.document(table), name=name, files=all_files)

    @classmethod
    def example(cls, name: str = "slant") -> Case:
        """Return an example case of the package: a slant well of 1200 m.

        Parameters
        ----------
        name
            Another example: ``"vertical"``, ``"horizontal"``, ``"np13-x1042"``, ``"forge-16a"`` and
            others. :attr:`files` has the files of the example.

        Raises
        ------
        NotFoundError
            If there is no example of that name.

        Examples
        --------
        >>> import wholestring as ws
        >>> ws.Case.example()
        <Case Slant well: soft, dynamic; trip_out, trip_in, rotate_off_bottom, drill, slide>
        >>> sorted(ws.Case.example("forge-16a").files)
        ['forge-16a-measured.csv', 'forge-16a-survey.csv']
        """
        found = _core.EXAMPLES.get(name)
        if found is None:
            there = ", ".join(_core.EXAMPLES)
            raise NotFoundError(f"there is no example {name!r}: there are {there}")
        text, files = found
        return cls(text, name=f"{name}.toml", files=files)

    def with_(self, changes: Mapping[str, Value] | None = None, /, **keys: Value) -> Case:
        """Return a copy of the case with other values.

        Parameters
        ----------
        changes
            Dotted keys of the case file, lists counted from zero, and their values:
            ``{"well.hole.0.friction": 0.2}``.
        **keys
            The same as keywords, ``__`` for a dot: ``operation__bit_depth="300 m"``. Short keys are
            ``friction`` (every hole section), ``bit_depth``, ``rpm`` and ``wob``.

        Raises
        ------
        CaseError
            If the case would be invalid, or has no key that is to be removed.
        InputError
            If two of the keys set the same value, such as ``friction`` and
            ``well.hole.1.friction``.

        Notes
        -----
        A number is SI, except for rotary speeds: ``rpm=120`` is 120 rev/min. ``None`` removes a
        key, so that its default applies.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> heavier = case.with_({"well.hole.1.friction": 0.35}, mud__density="1.4 sg", wob=60e3)
        >>> heavier.settings["mud"]["density_kg_per_m3"], case == heavier
        (1400.0, False)
        >>> heavier.with_(rpm=60).settings["operation"]["rotary_speed_rad_per_s"]
        6.283185307179586
        >>> case.with_(name="A case").with_(name=None).name
        'slant'
        """
        return self._changed(_values.changes({} if changes is None else changes, keys))

    def check(
        self, model: str | Sequence[str] | None = None, operation: str | None = None
    ) -> tuple[Diagnostic, ...]:
        """Check the case, also for other models or another operation, and return the diagnostics.

        A case is checked when it is made, for its own models and operations. Other models may
        require keys that are missing, or be unable to solve the case. This method solves nothing
        and raises no error for mistakes in the case.

        Parameters
        ----------
        model
            ``"soft"``, ``"stiff"`` or ``"dynamic"``, or several; those of the case by default.
        operation
            The operation to be solved; all of the case by default.

        Returns
        -------
        tuple of Diagnostic
            Warnings as from the ``check`` command, and the mistakes that prevent these models from
            solving the case; empty if there are none.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> case.check()
        ()
        >>> [diagnostic.severity for diagnostic in case.check("stiff", "fish")]
        ['error']
        """
        models = None if model is None else _values.words("model", model)
        try:
            found = self._held.check(models, operation)
        except CaseError as error:
            return error.diagnostics
        return tuple(Diagnostic(**diagnostic) for diagnostic in found)

    def well_path(self) -> Table:
        """Return the path of the well from the surface to the bit, as used by every model.

        The path is the curve through the stations that the case specifies, including tortuosity.
        No model is solved. :func:`wholestring.plot.well` draws the path.

        Returns
        -------
        Table
            A row for each of about 800 evenly spaced depths, and for each station. ``md_m`` is
            measured depth; ``north_m``, ``east_m`` and ``tvd_m`` the position;
            ``vertical_section_m`` the distance along the closure's direction;
            ``inclination_rad`` and ``azimuth_rad`` the direction, with azimuth 0 in vertical hole;
            ``dogleg_severity_rad_per_m`` the curvature.

        Examples
        --------
        >>> import wholestring as ws
        >>> path = ws.Case.example().well_path()
        >>> path.columns[:4], path.unit("tvd_m")
        (('md_m', 'north_m', 'east_m', 'tvd_m'), 'm')
        >>> f"{path['tvd_m'][-1]:.1f} m at {path['md_m'][-1]:.0f} m"
        '1016.9 m at 1200 m'
        """
        return Table(_core.well_path(self._held.settings_json()), "well")

    @property
    def name(self) -> str:
        """Name of the case."""
        return self._held.name

    @property
    def models(self) -> tuple[str, ...]:
        """The models of the case."""
        return tuple(self._held.models)

    @property
    def operations(self) -> tuple[str, ...]:
        """The operations of the case, in their order."""
        return tuple(self._held.operations)

    @property
    def settings(self) -> Mapping[str, Any]:
        """The case with all defaults filled in: SI numbers, units in the names of the keys."""
        return cast("dict[str, Any]", json.loads(self._held.settings_json()))

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """Warnings: probably unintended but computable; also issued as Python warnings."""
        return self._warnings()

    @property
    def files(self) -> Mapping[str, bytes]:
        """Contents of the files that the case refers to, as they were read."""
        return self._held.files()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as text."""
        return _restored, (self.to_toml(), self._held.source, dict(self.files))

    def __eq__(self, other: object) -> bool:
        """Return whether all settings are the same."""
        if not isinstance(other, Case):
            return NotImplemented
        return self._held.identity() == other._held.identity()

    def __hash__(self) -> int:
        """Return a hash of all settings."""
        return hash(self._held.identity())

    def _repr_html_(self) -> str:
        return _case_html.html(self.settings, self._warnings())

    def __repr__(self) -> str:
        """Return a summary with the name, models and operations."""
        return f"<Case {self.name}: {', '.join(self.models)}; {', '.join(self.operations)}>"


def _stations(survey: object) -> list[list[float]]:
    try:
        rows = np.asarray(survey, dtype=np.float64)
    except (TypeError, ValueError):
        rows = np.empty(0)
    if rows.shape[1:] != (3,):
        message = "`survey`: expected rows of measured depth, inclination and azimuth, or a table"
        raise InputError(message)
    # A vertical station needs no azimuth, which is then NaN or None.
    stations = cast("list[list[float]]", rows.tolist())
    return [row[:2] if math.isnan(row[2]) else row for row in stations]


def _restored(text: str, name: str, files: dict[str, bytes]) -> Case:
    # The warnings were issued when the case was made.
    return Case._of(_core.Case.parse(text, name, files))
