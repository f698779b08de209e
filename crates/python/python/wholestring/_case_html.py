"""A case as notebooks show it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

from . import _html
from .errors import Diagnostic
from .plot._house import operation_words
from .plot._shown import Shown


class _Settings:
    """Settings, in whose units numbers are shown."""

    def __init__(self, settings: Mapping[str, Any]) -> None:
        self.settings = settings


def html(settings: Mapping[str, Any], warnings: Sequence[Diagnostic]) -> str:
    """Return what a case is of, in its units."""
    shown = Shown(None, _Settings(settings))
    operation = cast("Mapping[str, Any]", settings["operation"])
    depth = shown.quantity(float(operation["bit_depth_m"]), "length")
    hole = cast("Sequence[Mapping[str, Any]]", settings["well"]["hole"])
    string = cast("Sequence[Mapping[str, Any]]", settings["string"])
    kinds = operation.get("kind")
    kinds = [kinds] if isinstance(kinds, str) else list(cast("Sequence[str]", kinds or ()))
    models = settings.get("model")
    models = [models] if isinstance(models, str) else list(cast("Sequence[str]", models or ()))
    density = shown.quantity(float(settings["mud"]["density_kg_per_m3"]), "density")
    rows = [
        ("Operations", ", ".join(operation_words(kind) for kind in kinds)),
        ("Models", ", ".join(models)),
        ("Bit depth", depth),
        ("Hole", "; ".join(_section(section, shown) for section in hole)),
        ("String", f"{len(string)} components: {_string(string)}"),
        ("Mud", density),
        *(("Warning", warning.message) for warning in warnings),
    ]
    return _html.facts(
        [(name, words) for name, words in rows if words], caption=str(settings["name"])
    )


def _section(section: Mapping[str, Any], shown: Shown) -> str:
    noun = "casing" if section["kind"] == "casing" else "open hole"
    size = shown.quantity(float(section["diameter_m"]), "diameter")
    return f"{noun}, {size}, to {shown.quantity(float(section['to_m']), 'length')}"


def _string(string: Sequence[Mapping[str, Any]]) -> str:
    names = (str(component.get("component", "component")) for component in string)
    return ", ".join(dict.fromkeys(names))
