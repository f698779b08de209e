"""HTML of a case for notebooks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, cast

from . import _html
from .errors import Diagnostic
from .plot._house import operation_words
from .plot._shown import Display


class _Settings:
    """Settings, whose units the numbers are displayed in."""

    def __init__(self, settings: Mapping[str, Any]) -> None:
        self.settings = settings


def html(settings: Mapping[str, Any], warnings: Sequence[Diagnostic]) -> str:
    """Return the main facts of a case as HTML, in its units."""
    display = Display(None, _Settings(settings))
    operation = cast("Mapping[str, Any]", settings["operation"])
    depth = display.quantity(float(operation["bit_depth_m"]), "length")
    hole = cast("Sequence[Mapping[str, Any]]", settings["well"]["hole"])
    string = cast("Sequence[Mapping[str, Any]]", settings["string"])
    kinds = operation.get("kind")
    kinds = [kinds] if isinstance(kinds, str) else list(cast("Sequence[str]", kinds or ()))
    models = settings.get("model")
    models = [models] if isinstance(models, str) else list(cast("Sequence[str]", models or ()))
    density = display.quantity(float(settings["mud"]["density_kg_per_m3"]), "density")
    rows = [
        ("Operations", ", ".join(operation_words(kind) for kind in kinds)),
        ("Models", ", ".join(models)),
        ("Bit depth", depth),
        ("Hole", "; ".join(_section(section, display) for section in hole)),
        ("String", f"{len(string)} components: {_string(string)}"),
        ("Mud", density),
        *(("Warning", warning.message) for warning in warnings),
    ]
    return _html.facts(
        [(name, words) for name, words in rows if words], caption=str(settings["name"])
    )


def _section(section: Mapping[str, Any], display: Display) -> str:
    noun = "casing" if section["kind"] == "casing" else "open hole"
    size = display.quantity(float(section["diameter_m"]), "diameter")
    return f"{noun}, {size}, to {display.quantity(float(section['to_m']), 'length')}"


def _string(string: Sequence[Mapping[str, Any]]) -> str:
    names = (str(component.get("component", "component")) for component in string)
    return ", ".join(dict.fromkeys(names))
