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
    """Return every public name, with methods and properties."""
    for name, item in reference.public():
        yield name, item
        if inspect.isclass(item):
            for member, one in reference.members(item):
                yield f"{name}.{member}", one


def example(item: Any) -> str:
    doc: Any = reference.NumpyDocString(inspect.getdoc(item) or "")
    return "\n".join(doc["Examples"])


NAMES = dict(public())
CALLED = [name for name, item in NAMES.items() if not isinstance(item, property)]


@pytest.mark.parametrize("name", NAMES)
def test_it_is_documented(name: str) -> None:
    item = NAMES[name]
    if isinstance(item, property):
        text = inspect.getdoc(item.fget) or ""
        assert text.strip().endswith("."), "a sentence"
        return
    found = [(code, text) for code, text in validate(name)["errors"] if code in CHECKED]
    last = name.rsplit(".", 1)[-1]
    # Constructors of classes that only the package instantiates are not documented; fields of
    # dataclasses and of named tuples are attributes.
    made_here = inspect.isclass(item) and not reference._signature(last, item)
    has_fields = dataclasses.is_dataclass(item)
    if inspect.isclass(item) and issubclass(item, tuple):
        has_fields = True
    if made_here or has_fields:
        found = [(code, text) for code, text in found if not code.startswith("PR")]
    assert not found


@pytest.mark.parametrize("name", CALLED)
def test_it_has_an_example_of_its_own(name: str) -> None:
    """Require an example in the docstring, run by doctest, that calls the function."""
    item = NAMES[name]
    text = example(item)
    assert ">>> " in text
    last = name.rsplit(".", 1)[-1]
    if not inspect.isclass(item):
        assert re.search(rf"\b{last}\(", text)


def test_every_example_is_run() -> None:
    """Require that doctest collects the docstring of each name, as it collects modules only."""
    finder = doctest.DocTestFinder(exclude_empty=True)
    found: set[str] = set()
    for module in pkgutil.walk_packages(ws.__path__, "wholestring."):
        if module.name != "wholestring._core":
            tests = finder.find(import_module(module.name))
            found |= {test.docstring or "" for test in tests if test.examples}
    for name in CALLED:
        assert inspect.getdoc(NAMES[name]) in {inspect.cleandoc(text) for text in found}, name


def test_names_are_public_on_purpose() -> None:
    assert all(hasattr(ws, name) for name in ws.__all__)
    assert all(hasattr(ws.plot, name) for name in ws.plot.__all__)
