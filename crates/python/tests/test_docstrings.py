"""Docstrings: every public name has one in numpy's style, and an example."""

import dataclasses
import inspect
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
SHOWN = "\n".join(example(of) for of in NAMES.values() if not isinstance(of, property))
PAGE = (PACKAGE.parents[1] / "docs/src/python.md").read_text(encoding="utf-8")
BOOK = "".join(re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL))


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


@pytest.mark.parametrize("name", NAMES)
def test_it_has_an_example(name: str) -> None:
    of = NAMES[name]
    if isinstance(of, property):
        return
    # What is raised, the page shows with what raises it.
    if inspect.isclass(of) and issubclass(of, BaseException):
        return
    last = name.rsplit(".", 1)[-1]
    if example(of):
        assert ">>> " in example(of)
    else:
        assert re.search(rf"\b{last}\b" if inspect.isclass(of) else rf"\.{last}\(", SHOWN + BOOK)


def test_names_are_public_on_purpose() -> None:
    assert all(hasattr(ws, name) for name in ws.__all__)
    assert all(hasattr(ws.plot, name) for name in ws.plot.__all__)
