"""A case: well, string, mud, rig and operations."""

from __future__ import annotations

import json
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
from .errors import CaseError, Diagnostic, InputError, NotFoundError
from .importing import import_files
from .table import Table

# What a survey is called that was given as a table.
_SURVEY = "survey.csv"


class Case(Solving, Planning, Assemblies):
    """A case in which everything has been checked. It is immutable.

    Parameters
    ----------
    text
        A case file's text.
    name
        What errors call the text.
    files
        The files that it names, such as its survey, each by the name that it has there.

    Raises
    ------
    CaseError
        With all mistakes of the case, each with its place.

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
        self._held = _core.Case.parse(text, name, dict(files or {}))
        warn(self._warnings())

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Read a case file, and the files that it names.

        Parameters
        ----------
        path
            The case file.

        Raises
        ------
        CaseError
            With all mistakes of the case, each with its place.

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
        case = cls._of(_core.Case.load(path))
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
        r"""Make a case of the files of other programs: :func:`import_files`, and what they lack.

        Parameters
        ----------
        *files
            Surveys, tallies, WITSML, Landmark EDM, logs. Several files make one case.
        units
            Units that the files do not tell: ``{"md": "ft"}``.
        values
            Values that no file tells and that are asked for: ``{"block-weight": "25 tf"}``.
        picks
            Which of several is meant: ``{"tubular": "BHA 7"}``.
        changes
            Dotted keys of the case and their values, as :meth:`with_` takes them.

        Raises
        ------
        InputError
            If a file is not one that is known, or does not tell what is needed of it.
        CaseError
            If the files lack something that a case needs.

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
        """Make a case of Python objects: the tables and keys of a case file.

        Numbers are SI, but for rotary speeds, which are in rev/min as in a case file. Texts may
        have units, and so may quantities of pint. A key that is ``None`` is left out.

        Parameters
        ----------
        table
            The case: ``{"mud": {"density": 1200.0}, "string": [{...}], ...}``.
        survey
            The stations of the well: a list or an array with a row for each, measured depth in m,
            inclination and azimuth in degrees, as ``well.stations`` has them; or a data frame of
            polars or pandas, or columns, with units in their names: ``md_m``, ``inc_deg``,
            ``azi_deg``.
        name
            What errors call it.
        files
            The files that it names, each by the name that it has there.

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
        table, all_files = dict(table), dict(files or {})
        if survey is not None:
            well = dict(cast("Mapping[str, Value]", table.get("well") or {}))
            if is_table(survey):
                well["survey"] = _SURVEY
                all_files[_SURVEY] = content(survey)
            else:
                well["stations"] = _stations(survey)
            table["well"] = well
        return cls(_values.document(table), name=name, files=all_files)

    @classmethod
    def example(cls, name: str = "slant") -> Case:
        """Return a case that comes with the package, to try things on: a slant well of 1200 m.

        Parameters
        ----------
        name
            Another one: ``"vertical"``, ``"horizontal"``, ``"np13-x1042"``, ``"forge-16a"``, and so
            on. :attr:`files` has the files that it comes with.

        Raises
        ------
        NotFoundError
            If there is none of that name.

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
        """Make another case: this one with other values.

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
            If the case would not be valid, or has no key that is to be removed.
        InputError
            If two of the keys set the same thing, such as ``friction`` and
            ``well.hole.1.friction``.

        Notes
        -----
        A number is SI, but for rotary speeds: ``rpm=120`` is 120 rev/min. ``None`` removes a key,
        so that its default holds.

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
        return self._changed(_values.changes(changes or {}, keys))

    def check(
        self, model: str | Sequence[str] | None = None, operation: str | None = None
    ) -> tuple[Diagnostic, ...]:
        """Give what there is to say of the case, with other models or another operation too.

        A case is checked as it is made, for the models and operations that it names. Others may
        need what it does not say, or cannot be solved with what it says: nothing is solved here,
        and nothing raised.

        Parameters
        ----------
        model
            ``"soft"``, ``"stiff"`` or ``"dynamic"``, or several; the case's where none is named.
        operation
            The one to be solved; all of the case where none is named.

        Returns
        -------
        tuple of Diagnostic
            Warnings, as the command line's ``check`` has them, and the mistakes for which these
            models could not solve it. Nothing is to be said of a case without either.

        Examples
        --------
        >>> import wholestring as ws
        >>> case = ws.Case.example()
        >>> case.check()
        ()
        >>> [of.severity for of in case.check("stiff", "fish")]
        ['error']
        """
        models = [model] if isinstance(model, str) else None if model is None else list(model)
        try:
            found = self._held.check(models, operation)
        except CaseError as error:
            return error.diagnostics
        return tuple(Diagnostic(**of) for of in found)

    def well_path(self) -> Table:
        """Give the path of the well from the surface to the bit, as every model has it.

        The path is the curve that the case asks for through its stations, tortuosity included.
        Nothing is solved. :func:`wholestring.plot.well` draws it.

        Returns
        -------
        Table
            A row for each of some 800 depths, evenly, and for each station. ``md_m`` is measured
            depth; ``north_m``, ``east_m`` and ``tvd_m`` the place; ``vertical_section_m`` the
            distance along the closure's direction; ``inclination_rad`` and ``azimuth_rad`` the
            direction, an azimuth of 0 where it is vertical; ``dogleg_severity_rad_per_m`` the
            curvature.

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
        """What the case is called."""
        return self._held.name

    @property
    def models(self) -> tuple[str, ...]:
        """The models that the case names."""
        return tuple(self._held.models)

    @property
    def operations(self) -> tuple[str, ...]:
        """The operations, in their order."""
        return tuple(self._held.operations)

    @property
    def settings(self) -> Mapping[str, Any]:
        """The case with all defaults filled in: SI numbers, units in the names of the keys."""
        return cast("dict[str, Any]", json.loads(self._held.settings_json()))

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """What is probably not meant, but can be computed; Python's warnings have it too."""
        return self._warnings()

    @property
    def files(self) -> Mapping[str, bytes]:
        """The files that the case names, as they were read."""
        return self._held.files()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle as text."""
        return _restored, (self.to_toml(), self._held.source, dict(self.files))

    def __eq__(self, other: object) -> bool:
        """Tell whether all settings are the same."""
        if not isinstance(other, Case):
            return NotImplemented
        return self._held.identity() == other._held.identity()

    def __hash__(self) -> int:
        """Give a hash of all settings."""
        return hash(self._held.identity())

    def _repr_html_(self) -> str:
        return _case_html.html(self.settings, self._warnings())

    def __repr__(self) -> str:
        """Give its name, models and operations."""
        return f"<Case {self.name}: {', '.join(self.models)}; {', '.join(self.operations)}>"


def _stations(survey: object) -> list[list[float]]:
    try:
        rows = np.asarray(survey, dtype=np.float64)
    except (TypeError, ValueError):
        rows = np.empty(0)
    if rows.shape[1:] != (3,):
        message = "`survey`: expected rows of measured depth, inclination and azimuth, or a table"
        raise InputError(message)
    return cast("list[list[float]]", rows.tolist())


def _restored(text: str, name: str, files: dict[str, bytes]) -> Case:
    # Who made it has heard of its warnings.
    return Case._of(_core.Case.parse(text, name, files))
