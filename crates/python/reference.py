"""Writes `docs/src/python-reference.md` from the docstrings of the package."""

from __future__ import annotations

import inspect
import os
import re
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import wholestring as ws

# It has no types of its own.
NumpyDocString: Any = import_module("numpydoc.docscrape").NumpyDocString

PAGE = Path(__file__).parents[2] / "docs/src/python-reference.md"

HEAD = """\
# Python, name by name

Written from the docstrings of the package by `crates/python/reference.py`; a test holds this page
to them. [Python](python.md) says how to begin.
"""

GROUPS: dict[str, tuple[str, ...]] = {
    "Parameters": ("Parameters",),
    "Attributes": ("Attributes",),
    "Returns": ("Returns",),
    "Raises": ("Raises",),
}


def public() -> Iterator[tuple[str, Any]]:
    """Give the public names of the package and of its figures, with what they are."""
    for name in sorted(ws.__all__, key=lambda of: (of[0].islower(), of.lower())):
        of = getattr(ws, name)
        if inspect.isclass(of) or inspect.isfunction(of):
            yield f"wholestring.{name}", of
    for name in sorted(ws.plot.__all__):
        of = getattr(ws.plot, name)
        if inspect.isfunction(of):
            yield f"wholestring.plot.{name}", of


def members(of: type) -> Iterator[tuple[str, Any]]:
    """Give the public methods and properties of a class, those of its private bases too."""
    bases = [base for base in reversed(of.__mro__) if base is of or _is_private(base)]
    names = dict.fromkeys(name for base in bases for name in vars(base))
    for name in names:
        if name.startswith("_"):
            continue
        member = inspect.getattr_static(of, name)
        if isinstance(member, classmethod | staticmethod):
            yield name, member.__func__
        elif isinstance(member, property) or inspect.isfunction(member):
            yield name, member


def page() -> str:
    """Give the page."""
    parts = [HEAD]
    for name, of in public():
        parts.append(f"## `{name}`\n")
        parts.append(_entry(name.rsplit(".", 1)[-1], of))
        if not inspect.isclass(of):
            continue
        bases = [base.__name__ for base in of.__mro__[1:] if base.__name__ in ws.__all__]
        if bases:
            parts.append(f"All of `{bases[0]}` besides.\n")
        properties = [(at, one) for at, one in members(of) if isinstance(one, property)]
        if properties:
            parts.append("| attribute | is |\n|---|---|")
            parts.extend(f"| `{at}` | {_row(one)} |" for at, one in properties)
            parts.append("")
        for at, one in members(of):
            if not isinstance(one, property):
                parts.append(f"### `{name.rsplit('.', 1)[-1]}.{at}`\n")
                parts.append(_entry(at, one))
    return "\n".join(parts).rstrip() + "\n"


def _entry(name: str, of: Any) -> str:
    doc: Any = NumpyDocString(inspect.getdoc(of) or "")
    parts: list[str] = []
    signature = _signature(name, of)
    if signature:
        parts.append(f"```python\n{signature}\n```\n")
    parts.append(_prose("\n".join(doc["Summary"])) + "\n")
    extended = _prose("\n".join(doc["Extended Summary"]))
    if extended:
        parts.append(extended + "\n")
    for title, sections in GROUPS.items():
        rows = [row for section in sections for row in doc[section]]
        if rows:
            parts.append(f"{title}:\n")
            parts.extend(_item(row) for row in rows)
            parts.append("")
    example = "\n".join(doc["Examples"]).strip()
    if example:
        parts.append(f"```python\n{_code(example)}\n```\n")
    return "\n".join(parts)


def _signature(name: str, of: Any) -> str:
    if inspect.isclass(of) and issubclass(of, BaseException):
        return ""
    try:
        signature = inspect.signature(of)
    except (TypeError, ValueError):
        return ""
    if inspect.isclass(of):
        own = ("core", "data", "place")
        private = [at for at in signature.parameters if at in own or at.startswith("_")]
        if private or getattr(of, "_is_protocol", False):
            return ""
    kept = [one for at, one in signature.parameters.items() if at not in ("self", "cls")]
    given = ", ".join(_parameters(kept))
    gives = "" if signature.return_annotation is signature.empty else signature.return_annotation
    end = f" -> {gives}" if gives and not inspect.isclass(of) else ""
    whole = f"{name}({given}){end}"
    if len(whole) > 100:
        given = ",\n    ".join(_parameters(kept))
        whole = f"{name}(\n    {given},\n){end}"
    return whole


def _parameters(kept: list[inspect.Parameter]) -> list[str]:
    made: list[str] = []
    starred = False
    for one in kept:
        text = one.name
        # A named tuple wraps what is written.
        written = getattr(one.annotation, "__forward_arg__", one.annotation)
        typed = "" if written is one.empty else f": {written}"
        if one.kind is one.KEYWORD_ONLY and not starred:
            made.append("*")
            starred = True
        if one.kind is one.VAR_POSITIONAL:
            text = f"*{text}{typed}"
            starred = True
        elif one.kind is one.VAR_KEYWORD:
            text = f"**{text}{typed}"
        elif one.default is not one.empty:
            equals = " = " if typed else "="
            text = f"{text}{typed}{equals}{one.default!r}"
        else:
            text = f"{text}{typed}"
        made.append(text)
        following = kept[len([of for of in made if of not in ("*", "/")]) :]
        if one.kind is one.POSITIONAL_ONLY and (
            not following or following[0].kind is not one.POSITIONAL_ONLY
        ):
            made.append("/")
    return made


def _item(row: Any) -> str:
    name = row.name or row.type
    said = _prose("\n".join(row.desc)).replace("\n", "\n  ")
    return f"- `{name}`: {said}" if said else f"- `{name}`"


def _row(of: property) -> str:
    doc: Any = NumpyDocString(inspect.getdoc(of.fget) or "")
    parts = [_prose("\n".join(doc[section])) for section in ("Summary", "Extended Summary")]
    for raised in doc["Raises"]:
        said = _prose("\n".join(raised.desc))
        parts.append(f"Raises `{raised.type}` {said[:1].lower()}{said[1:]}")
    return " ".join(filter(None, parts)).replace("\n", " ").replace("|", "\\|")


def _prose(text: str) -> str:
    """Give a docstring's text as Markdown."""
    text = re.sub(r":(?:class|meth|attr|func|mod):`~?([^`]+)`", r"`\1`", text)
    text = text.replace("``", "`")
    blocks: list[str] = []
    for block in re.split(r"\n\s*\n", text.strip()):
        lines = block.splitlines()
        if all(line.startswith("    ") for line in lines) and lines:
            code = "\n".join(line[4:] for line in lines)
            blocks.append(f"```python\n{code}\n```")
        else:
            blocks.append("\n".join(line.strip() for line in lines))
    return re.sub(r"::(?=\n|$)", ":", "\n\n".join(blocks))


def _code(example: str) -> str:
    """Give an example's code with what it gives as comments, and its prose as comments too."""
    lines: list[str] = []
    for line in example.splitlines():
        if line.startswith(">>> ") or line.startswith("... "):
            lines.append(line[4:])
        elif line in (">>>", "..."):
            lines.append("")
        else:
            lines.append(f"# {line}".rstrip() if line.strip() else "")
    return "\n".join(lines)


def _is_private(base: type) -> bool:
    """Tell whether a base is the package's and has no entry of its own."""
    return base.__module__.startswith("wholestring") and base.__name__ not in ws.__all__


def main() -> int:
    """Write the page, or say that it is not what the docstrings make of it."""
    made = page()
    if os.environ.get("WHOLESTRING_UPDATE_DOCS") == "1":
        PAGE.write_text(made, encoding="utf-8")
        return 0
    there = PAGE.read_text(encoding="utf-8") if PAGE.is_file() else ""
    if there != made:
        print(f"{PAGE} is not what the docstrings say: WHOLESTRING_UPDATE_DOCS=1 writes it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
