"""Pickled forms of results and tables."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _core
from ._folder import Place

if TYPE_CHECKING:
    from ._base import BaseResults

R = TypeVar("R", bound="BaseResults")

Reduced = tuple[Callable[..., Any], tuple[Any, ...]]


def reduced(results: BaseResults) -> Reduced:
    """Return the function and the arguments that restore results.

    Results in a folder of the user are restored from that folder; those in a temporary folder,
    which is removed with them, from its files; those in memory from their summary and tables.
    """
    kind, core = type(results), results._core
    parts = core.parts()
    if parts is not None:
        summary, tables, with_spectra = parts
        columns = [(name, table.parts()) for name, table in tables]
        return in_memory, (kind, summary, columns, with_spectra)
    folder = Path(core.folder or "")
    place = results._place
    if place is None or not place.is_temporary:
        return in_folder, (kind, str(folder.absolute()))
    files = sorted(file for file in folder.rglob("*") if file.is_file())
    named = [(file.relative_to(folder).as_posix(), file.read_bytes()) for file in files]
    return in_files, (kind, named)


def in_memory(
    kind: type[R],
    summary: str,
    tables: Sequence[tuple[str, Sequence[_core.Part]]],
    with_spectra: bool,
) -> R:
    """Return results restored in memory."""
    restored = [(name, _core.Table.restore(parts)) for name, parts in tables]
    return kind(_core.Answers.restore(summary, restored, with_spectra))


def in_folder(kind: type[R], folder: str) -> R:
    """Return results in a folder of the user."""
    return kind(_core.Answers.load(folder))


def in_files(kind: type[R], files: Sequence[tuple[str, bytes]]) -> R:
    """Return results restored from their files in a temporary folder."""
    place = Place(None)
    for name, content in files:
        file = place.path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    return kind(_core.Answers.load(place.path), place)
