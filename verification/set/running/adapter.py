"""What stands between a problem and a program: Python, or a command."""

from __future__ import annotations

import importlib.util
import json
import shlex
import subprocess
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

Problem = Mapping[str, Any]
Answers = Callable[[Problem], object]


class AdapterError(Exception):
    """An adapter that cannot be used, or that breaks the rules; the message says how."""


@dataclass(frozen=True)
class Adapter:
    """A program that is asked."""

    program: str
    answers: Answers
    notes: Mapping[str, str] = field(default_factory=dict)
    """By kind or problem: what the program assumes otherwise."""


def load(given: str) -> Adapter:
    """The adapter of a file, a folder or a command."""
    path = Path(given)
    if path.is_dir():
        path /= "__init__.py"
    if path.suffix == ".py":
        return of_python(path)
    words = shlex.split(given)
    if not words:
        raise AdapterError("no adapter is given")
    return Adapter(program=given, answers=lambda problem: ask(words, problem))


def of_python(path: Path) -> Adapter:
    if not path.is_file():
        raise AdapterError(f"there is no file {path}")
    # A name of its own: an adapter may be called as the package that it imports.
    name = "adapter"
    spec = importlib.util.spec_from_file_location(
        name, path, submodule_search_locations=[str(path.parent)]
    )
    if spec is None or spec.loader is None:
        raise AdapterError(f"{path} is no Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except ImportError as error:
        raise AdapterError(f"{path} cannot be imported: {error}") from error
    answers = getattr(module, "answers", None)
    if not callable(answers):
        raise AdapterError(f"{path} defines no function `answers(problem)`")
    program = str(getattr(module, "PROGRAM", path.stem))
    return Adapter(program=program, answers=answers, notes=dict(getattr(module, "NOTES", {})))


def ask(words: list[str], problem: Problem) -> object:
    """The answers of a command."""
    name = problem["id"]
    try:
        done = subprocess.run(
            words, input=json.dumps(problem), capture_output=True, text=True, check=False
        )
    except OSError as error:
        raise AdapterError(f"{words[0]} cannot be run: {error}") from error
    if done.returncode != 0:
        raise RuntimeError(f"exit status {done.returncode}: {done.stderr.strip()}")
    try:
        answers: object = json.loads(done.stdout)
    except json.JSONDecodeError as error:
        raise AdapterError(f"{name}: the command wrote no JSON: {error}") from error
    if answers is None:
        raise NotImplementedError
    return answers
