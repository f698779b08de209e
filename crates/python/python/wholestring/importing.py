"""Cases from the files of other programs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from . import _core
from ._values import mapping
from .errors import FolderError, InputError

if TYPE_CHECKING:
    from ._values import Value
    from .case import Case

# Name of an imported case until it is saved.
_NAME = "case"


@dataclass(frozen=True, slots=True)
class ImportNote:
    """A note on the interpretation of a file.

    Attributes
    ----------
    file
        The file that the note is about; ``None`` for all files.
    kind
        ``"assumed"``, ``"left out"``, ``"checked"`` or ``"read"``.
    text
        The note, a sentence.

    Examples
    --------
    >>> from wholestring import ImportNote
    >>> ImportNote(None, "assumed", "friction is 0.2 in casing").kind
    'assumed'
    """

    file: str | None
    kind: str
    text: str


@dataclass(frozen=True, slots=True)
class Imported:
    r"""A case that was made from files.

    Attributes
    ----------
    text
        The case file: TOML, each value with its source.
    files
        Format of each file, by its name.
    notes
        Notes on the data that were assumed, left out, checked and read.
    missing
        Data that the case still requires, in sentences.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     survey = pathlib.Path(place, "survey.csv")
    ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
    ...     imported = ws.import_files(survey)
    ...     saved = imported.save(pathlib.Path(place, "well.toml"))
    >>> imported.missing[1]
    'the density of the mud: write it in the case ([mud])'
    """

    text: str
    files: Mapping[str, str]
    notes: tuple[ImportNote, ...]
    missing: tuple[str, ...]
    _beside: Mapping[str, bytes]

    def case(self, changes: Mapping[str, Value] | None = None) -> Case:
        r"""Return the case, optionally with other values.

        Parameters
        ----------
        changes
            Dotted keys of the case and their values, as for :meth:`Case.with_`.

        Raises
        ------
        CaseError
            If required data are missing or invalid.

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     survey = pathlib.Path(place, "survey.csv")
        ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
        ...     imported = ws.import_files(survey)
        >>> try:
        ...     imported.case()
        ... except ws.CaseError as error:
        ...     print(len(error.diagnostics) > 0)
        True
        """
        from .case import Case

        case = Case(self.text, name=f"{_NAME}.toml", files=self._beside)
        return case if changes is None else case.with_(changes)

    def save(self, path: str | PathLike[str]) -> Path:
        r"""Write the case file and the files that it refers to. No file is overwritten.

        Parameters
        ----------
        path
            The case file, such as ``well.toml``.

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import wholestring as ws
        >>> with tempfile.TemporaryDirectory() as place:
        ...     survey = pathlib.Path(place, "survey.csv")
        ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
        ...     case_file = ws.import_files(survey).save(pathlib.Path(place, "well.toml"))
        ...     print(case_file.is_file())
        True
        """
        path = Path(path)
        names = {name: path.stem + name.removeprefix(_NAME) for name in self._beside}
        text = self.text
        for old, new in names.items():
            text = text.replace(f'"{old}"', f'"{new}"')
        whole = {path: text.encode()}
        whole |= {path.with_name(names[name]): data for name, data in self._beside.items()}
        for there in whole:
            if there.exists():
                message = f"{there} already exists: choose another name or remove it"
                raise FolderError(message)
        for file, content in whole.items():
            file.write_bytes(content)
        return path


@dataclass(frozen=True, slots=True)
class Contents:
    r"""Format and content of a file.

    Attributes
    ----------
    what
        Format of the file: ``"WITSML 1.4.1.1"``.
    lines
        Content of the file, in words.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     survey = pathlib.Path(place, "survey.csv")
    ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
    ...     print(ws.contents(survey).what)
    a survey of 3 stations
    """

    what: str
    lines: tuple[str, ...]


def import_files(
    *files: str | PathLike[str],
    units: Mapping[str, str] | None = None,
    values: Mapping[str, str] | None = None,
    picks: Mapping[str, str] | None = None,
) -> Imported:
    r"""Make one case from the files of other programs.

    Parameters
    ----------
    *files
        Surveys and tallies as text or Excel, WITSML, Landmark EDM, LAS and logs. The format of a
        file is determined from its content.
    units
        Units that are missing in the files: ``{"md": "ft"}``. No unit is guessed: a required unit
        that is missing is an error with its name.
    values
        Required values that are missing in the files: ``{"block-weight": "25 tf"}``.
    picks
        Choice among several in a file: ``{"tubular": "BHA 7"}``; or the file that a part of the
        case is taken from: ``{"survey": "survey.csv"}``.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     survey = pathlib.Path(place, "survey.csv")
    ...     _ = survey.write_text("MD,Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n")
    ...     imported = ws.import_files(survey, units={"md": "ft"})
    >>> len(imported.missing)
    3

    Raises
    ------
    InputError
        If the format of a file is unknown, or required data are missing in it.
    """
    if not files:
        raise InputError("no file is given: expected a survey, a tally, a log or another file")
    found = _core.import_files(
        files,
        _NAME,
        mapping("units", units),
        mapping("values", values),
        mapping("picks", picks),
    )
    notes = tuple(ImportNote(*note) for note in found.notes)
    return Imported(found.text, dict(found.files), notes, tuple(found.missing), found.beside)


def contents(file: str | PathLike[str]) -> Contents:
    r"""Return the format and the content of a file of another program.

    Parameters
    ----------
    file
        The file.

    Raises
    ------
    InputError
        If the format of the file is unknown.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wholestring as ws
    >>> with tempfile.TemporaryDirectory() as place:
    ...     survey = pathlib.Path(place, "survey.csv")
    ...     _ = survey.write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
    ...     ws.contents(survey).what
    'a survey of 3 stations'
    """
    format_name, lines = _core.contents(file)
    return Contents(format_name, tuple(lines))
