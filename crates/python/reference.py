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

# The package has no types.
NumpyDocString: Any = import_module("numpydoc.docscrape").NumpyDocString

PAGE = Path(__file__).parents[2] / "docs/src/python-reference.md"

HEAD = """\
# Python, name by name

Generated from the docstrings of the package by `crates/python/reference.py`; a test compares this
page with them. Start with [Python](python.md).
"""

GROUPS: dict[str, tuple[str, ...]] = {
    "Parameters": ("Parameters",),
    "Attributes": ("Attributes",),
    "Returns": ("Returns",),
    "Raises": ("Raises",),
}


def public() -> Iterator[tuple[str, Any]]:
    """Return the public names of the package and of its figures, with their objects."""
    for name in sorted(ws.__all__, key=lambda key: (key[0].islower(), key.lower())):
        item = getattr(ws, name)
        if inspect.isclass(item) or inspect.isfunction(item):
            yield f"wholestring.{name}", item
    for name in sorted(ws.plot.__all__):
        item = getattr(ws.plot, name)
        if inspect.isfunction(item):
            yield f"wholestring.plot.{name}", item


def members(kind: type) -> Iterator[tuple[str, Any]]:
    """Return the public methods and properties of a class and of its private bases."""
    bases = [base for base in reversed(kind.__mro__) if base is kind or _is_private(base)]
    names = dict.fromkeys(name for base in bases for name in vars(base))
    for name in names:
        if name.startswith("_"):
            continue
        member = inspect.getattr_static(kind, name)
        if isinstance(member, classmethod | staticmethod):
            yield name, member.__func__
        elif isinstance(member, property) or inspect.isfunction(member):
            yield name, member


def page() -> str:
    """Return the page."""
    parts = [HEAD]
    for name, item in public():
        parts.append(f"## `{name}`\n")
        parts.append(_entry(name.rsplit(".", 1)[-1], item))
        if not inspect.isclass(item):
            continue
        bases = [base.__name__ for base in item.__mro__[1:] if base.__name__ in ws.__all__]
        if bases:
            parts.append(f"Also all members of `{bases[0]}`.\n")
        properties = [(at, one) for at, one in members(item) if isinstance(one, property)]
        if properties:
            parts.append("| attribute | meaning |\n|---|---|")
            parts.extend(f"| `{at}` | {_row(one)} |" for at, one in properties)
            parts.append("")
        for at, one in members(item):
            if not isinstance(one, property):
                parts.append(f"### `{name.rsplit('.', 1)[-1]}.{at}`\n")
                parts.append(_entry(at, one))
    return "\n".join(parts).rstrip() + "\n"


def _entry(name: str, item: Any) -> str:
    doc: Any = NumpyDocString(inspect.getdoc(item) or "")
    parts: list[str] = []
    signature = _signature(name, item)
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


def _signature(name: str, item: Any) -> str:
    if inspect.isclass(item) and issubclass(item, BaseException):
        return ""
    try:
        signature = inspect.signature(item)
    except (TypeError, ValueError):
        return ""
    if inspect.isclass(item):
        own = ("core", "data", "place")
        private = [at for at in signature.parameters if at in own or at.startswith("_")]
        if private or getattr(item, "_is_protocol", False):
            return ""
    parameters = [one for at, one in signature.parameters.items() if at not in ("self", "cls")]
    listed = ", ".join(_parameters(parameters))
    gives = "" if signature.return_annotation is signature.empty else signature.return_annotation
    end = f" -> {gives}" if gives and not inspect.isclass(item) else ""
    whole = f"{name}({listed}){end}"
    if len(whole) > 100:
        listed = ",\n    ".join(_parameters(parameters))
        whole = f"{name}(\n    {listed},\n){end}"
    return whole


def _parameters(parameters: list[inspect.Parameter]) -> list[str]:
    parts: list[str] = []
    starred = False
    for one in parameters:
        text = one.name
        # A named tuple wraps the annotation.
        written = getattr(one.annotation, "__forward_arg__", one.annotation)
        typed = "" if written is one.empty else f": {written}"
        if one.kind is one.KEYWORD_ONLY and not starred:
            parts.append("*")
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
        parts.append(text)
        following = parameters[len([part for part in parts if part not in ("*", "/")]) :]
        if one.kind is one.POSITIONAL_ONLY and (
            not following or following[0].kind is not one.POSITIONAL_ONLY
        ):
            parts.append("/")
    return parts


def _item(row: Any) -> str:
    name = row.name or row.type
    text = _prose("\n".join(row.desc)).replace("\n", "\n  ")
    return f"- `{name}`: {text}" if text else f"- `{name}`"


def _row(item: property) -> str:
    doc: Any = NumpyDocString(inspect.getdoc(item.fget) or "")
    parts = [_prose("\n".join(doc[section])) for section in ("Summary", "Extended Summary")]
    for raised in doc["Raises"]:
        text = _prose("\n".join(raised.desc))
        parts.append(f"Raises `{raised.type}` {text[:1].lower()}{text[1:]}")
    return " ".join(filter(None, parts)).replace("\n", " ").replace("|", "\\|")


def _prose(text: str) -> str:
    """Return the text of a docstring as Markdown."""
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
    """Return the code of an example, with its output and its prose as comments."""
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
    """Return whether a base class is private to the package, without an entry of its own."""
    return base.__module__.startswith("wholestring") and base.__name__ not in ws.__all__


def main() -> int:
    """Write the page, or print that it differs from the docstrings."""
    text = page()
    if os.environ.get("WHOLESTRING_UPDATE_DOCS") == "1":
        PAGE.write_text(text, encoding="utf-8")
        return 0
    current = PAGE.read_text(encoding="utf-8") if PAGE.is_file() else ""
    if current != text:
        print(f"{PAGE} differs from the docstrings: WHOLESTRING_UPDATE_DOCS=1 writes it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
