"""Cases from the files of other programs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from . import _core
from .errors import FolderError

if TYPE_CHECKING:
    from ._values import Value
    from .case import Case

# What an imported case is called until it is saved.
_NAME = "case"


@dataclass(frozen=True, slots=True)
class ImportNote:
    """A sentence on how a file was understood.

    Attributes
    ----------
    file
        The file that it is of; None where it is of all.
    kind
        ``"assumed"``, ``"left out"``, ``"checked"`` or ``"read"``.
    text
        The sentence.

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
    r"""A case that was made of files.

    Attributes
    ----------
    text
        The case file: TOML, each value with where it was found.
    files
        Each file by its name, and what it is.
    notes
        What was assumed, left out, checked and read.
    missing
        What the case still needs, in sentences.

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
        r"""Give the case, with other values.

        Parameters
        ----------
        changes
            Dotted keys of the case and their values, as :meth:`Case.with_` takes them.

        Raises
        ------
        CaseError
            If something is missing or cannot be.

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
        return case.with_(changes) if changes else case

    def save(self, path: str | PathLike[str]) -> Path:
        r"""Write the case file, and what stands beside it. Nothing is written over.

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
        whole |= {path.with_name(names[name]): of for name, of in self._beside.items()}
        for there in whole:
            if there.exists():
                message = f"{there} is there already"
                raise FolderError(message)
        for file, content in whole.items():
            file.write_bytes(content)
        return path


@dataclass(frozen=True, slots=True)
class Contents:
    r"""What a file is, and what it holds.

    Attributes
    ----------
    what
        What it is: ``"WITSML 1.4.1.1"``.
    lines
        What it holds, in words.

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
    r"""Make one case of the files of other programs.

    Parameters
    ----------
    *files
        Surveys and tallies as text or Excel, WITSML, Landmark EDM, LAS and logs. What a file is,
        its content tells.
    units
        Units that the files do not tell: ``{"md": "ft"}``. Nothing is guessed: a unit that is
        needed and not told is an error that names it.
    values
        Values that no file tells and that are asked for: ``{"block-weight": "25 tf"}``.
    picks
        Which of several is meant: ``{"tubular": "BHA 7"}``; or which file a part of the case is
        taken from: ``{"survey": "survey.csv"}``.

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
        If a file is not one that is known, or does not tell what is needed of it.
    """
    found = _core.import_files(
        files, _NAME, dict(units or {}), dict(values or {}), dict(picks or {})
    )
    notes = tuple(ImportNote(*note) for note in found.notes)
    return Imported(found.text, dict(found.files), notes, tuple(found.missing), found.beside)


def contents(file: str | PathLike[str]) -> Contents:
    r"""Tell what a file of another program is, and what it holds.

    Parameters
    ----------
    file
        The file.

    Raises
    ------
    InputError
        If it is none that is known.

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
    what, lines = _core.contents(file)
    return Contents(what, tuple(lines))
