"""Docstrings: every public name has one in numpy's style, and an example."""

import dataclasses
import doctest
import inspect
import pkgutil
import re
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
import wholestring as ws

PACKAGE = Path(__file__).parents[1]
sys.path.insert(0, str(PACKAGE))

import reference  # noqa: E402

validate: Any = import_module("numpydoc.validate").validate

# Of numpydoc's checks: a docstring, a summary, and parameters as the signature has them.
CHECKED = {"GL08", "SS01", "PR01", "PR02", "PR03", "PR07", "YD01"}


def public() -> Iterator[tuple[str, Any]]:
    """Give every public name, with methods and properties."""
    for name, of in reference.public():
        yield name, of
        if inspect.isclass(of):
            for member, one in reference.members(of):
                yield f"{name}.{member}", one


def example(of: Any) -> str:
    doc: Any = reference.NumpyDocString(inspect.getdoc(of) or "")
    return "\n".join(doc["Examples"])


NAMES = dict(public())
CALLED = [name for name, of in NAMES.items() if not isinstance(of, property)]


@pytest.mark.parametrize("name", NAMES)
def test_it_is_documented(name: str) -> None:
    of = NAMES[name]
    if isinstance(of, property):
        text = inspect.getdoc(of.fget) or ""
        assert text.strip().endswith("."), "a sentence"
        return
    found = [(code, said) for code, said in validate(name)["errors"] if code in CHECKED]
    last = name.rsplit(".", 1)[-1]
    # Of classes that the package alone makes, what makes them is no part of what they are; fields
    # of dataclasses and of named tuples are attributes.
    made_here = inspect.isclass(of) and not reference._signature(last, of)
    has_fields = dataclasses.is_dataclass(of) or (inspect.isclass(of) and issubclass(of, tuple))
    if made_here or has_fields:
        found = [(code, said) for code, said in found if not code.startswith("PR")]
    assert not found


@pytest.mark.parametrize("name", CALLED)
def test_it_has_an_example_of_its_own(name: str) -> None:
    """In its own docstring, where doctest runs it; of what is called, one that calls it."""
    of = NAMES[name]
    shown = example(of)
    assert ">>> " in shown
    last = name.rsplit(".", 1)[-1]
    if not inspect.isclass(of):
        assert re.search(rf"\b{last}\(", shown)


def test_every_example_is_run() -> None:
    """Doctest finds those of the modules alone: each name's lies in one that is collected."""
    finder = doctest.DocTestFinder(exclude_empty=True)
    found: set[str] = set()
    for module in pkgutil.walk_packages(ws.__path__, "wholestring."):
        if module.name != "wholestring._core":
            tests = finder.find(import_module(module.name))
            found |= {of.docstring or "" for of in tests if of.examples}
    for name in CALLED:
        assert inspect.getdoc(NAMES[name]) in {inspect.cleandoc(of) for of in found}, name


def test_names_are_public_on_purpose() -> None:
    assert all(hasattr(ws, name) for name in ws.__all__)
    assert all(hasattr(ws.plot, name) for name in ws.plot.__all__)
