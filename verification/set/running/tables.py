"""The outcome as a table by kind: on the screen, in Markdown, and every number as JSON."""

from __future__ import annotations

import json
import math
import textwrap
from collections.abc import Sequence
from itertools import groupby

from .adapter import Adapter
from .judge import Compared, Outcome

HEADINGS = (
    "kind",
    "problems",
    "passed",
    "failed",
    "not answered",
    "out of scope",
    "numbers asked",
    "answered",
    "held",
    "worst, of its tolerance",
)


def rows(outcomes: Sequence[Outcome]) -> list[tuple[str, ...]]:
    """A row for each kind, and their sum."""
    by_kind = sorted(outcomes, key=lambda of: of.problem["kind"])
    table = [
        row(kind, list(group)) for kind, group in groupby(by_kind, lambda of: of.problem["kind"])
    ]
    return [*table, row("all", outcomes)]


def row(name: str, outcomes: Sequence[Outcome]) -> tuple[str, ...]:
    compared = [number for outcome in outcomes for number in outcome.compared]
    answered = [of for of in outcomes if of.compared or of.fault]
    silent = [of for of in outcomes if not (of.compared or of.fault or of.out_of_scope)]
    worst = max((of.error for of in compared), default=None)
    counts = (
        len(outcomes),
        sum(of.passed for of in answered),
        sum(of.failed for of in answered),
        len(silent),
        sum(of.out_of_scope for of in outcomes),
        sum(asked(of) for of in outcomes),
        len(compared),
        sum(of.holds for of in compared),
    )
    return (name, *map(str, counts), "" if worst is None else f"{worst:.2g}")


def asked(outcome: Outcome) -> int:
    """How many numbers a problem asks for."""
    values = [of["value"] for of in outcome.problem["expected"].values()]
    return sum(len(of) if isinstance(of, list) else 1 for of in values)


def failures(outcomes: Sequence[Outcome]) -> list[tuple[str, str]]:
    """Problems that failed, each with its worst number or its fault."""
    return [(of.problem["id"], said(of.fault) or told(of)) for of in outcomes if of.failed]


def said(fault: str) -> str:
    """On one line, and short enough for a table."""
    return textwrap.shorten(fault, 200, placeholder=" ...")


def told(outcome: Outcome) -> str:
    worst = outcome.worst
    if worst is None:
        return ""
    more = sum(not of.holds for of in outcome.compared) - 1
    rest = f", and {more} more" if more else ""
    return f"{worst.name} {worst.answer:.6g} for {worst.expected:.6g}, {apart(worst)}{rest}"


def apart(number: Compared) -> str:
    if number.expected == 0 or not math.isfinite(number.answer):
        return f"{number.error:.3g} times its tolerance"
    part = (number.answer - number.expected) / abs(number.expected)
    return f"{100 * part:+.2g} %"


def notes(adapter: Adapter, outcomes: Sequence[Outcome]) -> list[tuple[str, str]]:
    """What the adapter says of the kinds and problems that were asked for."""
    asked = {name for of in outcomes for name in (of.problem["kind"], of.problem["id"])}
    return [(name, note) for name, note in adapter.notes.items() if name in asked]


def as_text(adapter: Adapter, outcomes: Sequence[Outcome]) -> str:
    table = [HEADINGS, *rows(outcomes)]
    widths = [max(len(of[column]) for of in table) for column in range(len(HEADINGS))]
    lines = [adapter.program]
    for cells in table:
        padded = [cells[0].ljust(widths[0])]
        padded += [cell.rjust(width) for cell, width in zip(cells[1:], widths[1:], strict=True)]
        lines.append("  ".join(padded))
    lines += [f"failed: {name}: {what}" for name, what in failures(outcomes)]
    lines += [f"note on {name}: {note}" for name, note in notes(adapter, outcomes)]
    return "\n".join(lines) + "\n"


def as_markdown(adapter: Adapter, outcomes: Sequence[Outcome]) -> str:
    lines = [
        f"**{adapter.program}**",
        "",
        "| " + " | ".join(HEADINGS) + " |",
        "|---" + "|---:" * (len(HEADINGS) - 1) + "|",
    ]
    lines += ["| " + " | ".join(cells) + " |" for cells in rows(outcomes)]
    failed = failures(outcomes)
    if failed:
        lines += ["", "| failed | its worst number |", "|---|---|"]
        lines += [f"| `{name}` | {what} |" for name, what in failed]
    remarks = notes(adapter, outcomes)
    if remarks:
        lines += ["", *(f"- `{name}`: {note}" for name, note in remarks)]
    return "\n".join(lines) + "\n"


def as_json(adapter: Adapter, outcomes: Sequence[Outcome]) -> str:
    """Every number that was compared."""
    found = [
        {
            "id": of.problem["id"],
            "kind": of.problem["kind"],
            "out_of_scope": of.out_of_scope,
            "fault": of.fault or None,
            "not_answered": of.not_answered,
            "numbers": [
                {
                    "name": number.name,
                    "expected": number.expected,
                    "answer": number.answer if math.isfinite(number.answer) else None,
                    "tolerance": number.tolerance,
                    "holds": number.holds,
                }
                for number in of.compared
            ],
        }
        for of in outcomes
    ]
    return json.dumps({"program": adapter.program, "problems": found}, indent=1) + "\n"
