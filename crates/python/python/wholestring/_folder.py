"""Folders for results."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from os import PathLike
from pathlib import Path

from .errors import InputError


class Place:
    """Folder for results: one of the user, or a temporary one removed with its last reference.

    Parameters
    ----------
    folder
        The folder; a temporary one by default.
    overwrite, resume
        Whether to replace or to continue existing results in the folder.
    """

    def __init__(
        self,
        folder: str | PathLike[str] | None,
        *,
        overwrite: bool = False,
        resume: bool = False,
    ) -> None:
        if overwrite and resume:
            raise InputError("overwrite and resume exclude each other")
        if folder is None and resume:
            raise InputError("resume needs the folder that is to be continued")
        self.is_temporary = folder is None
        self.existing = "resume" if resume else "overwrite" if overwrite else "protect"
        if folder is not None:
            self.path = Path(folder)
            return
        self.path = Path(tempfile.mkdtemp(prefix="wholestring-"))
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)
