"""Tables as notebooks show them, in light and in dark."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape

import numpy as np

# Colours are the notebook's own: text inherits, lines are that text thinned, so that both stand out
# on paper and on a dark screen alike.
STYLE = """\
<style scoped>
.wholestring{border-collapse:collapse;color:inherit;font-variant-numeric:tabular-nums}
.wholestring caption{caption-side:top;text-align:left;font-weight:600;\
padding:0 0 .4em;color:inherit}
.wholestring th,.wholestring td{padding:.2em .7em;border:0;background:none;\
color:inherit;text-align:left}
.wholestring thead th{font-weight:600;white-space:nowrap;\
border-bottom:1px solid color-mix(in srgb,currentColor 45%,transparent)}
.wholestring tbody tr+tr td{border-top:1px solid color-mix(in srgb,currentColor 14%,transparent)}
.wholestring .number{text-align:right;white-space:nowrap}
.wholestring .unit{font-weight:400;opacity:.75}
.wholestring .wrap{min-width:14em}
</style>"""


@dataclass(frozen=True)
class Column:
    """A column as it is shown.

    Attributes
    ----------
    title, unit
        What stands over it.
    cells
        What stands in it.
    numbers
        Whether these are numbers, which stand to the right.
    hint
        What is told where the pointer rests on its title.
    """

    title: str
    cells: Sequence[str]
    unit: str = ""
    numbers: bool = True
    hint: str = field(default="")


def table(columns: Sequence[Column], *, caption: str = "", note: str = "") -> str:
    """Give a table as HTML."""
    heads = "".join(_head(of) for of in columns)
    count = len(columns[0].cells) if columns else 0
    rows = "".join(
        "<tr>" + "".join(_cell(of, of.cells[row]) for of in columns) + "</tr>"
        for row in range(count)
    )
    head = f"<caption>{escape(caption)}</caption>" if caption else ""
    foot = f"<p>{escape(note)}</p>" if note else ""
    return (
        f'<div>{STYLE}<table class="wholestring">{head}<thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table>{foot}</div>"
    )


def facts(rows: Sequence[tuple[str, str]], *, caption: str) -> str:
    """Give names and what is said of each as HTML."""
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td>{escape(value)}</td></tr>'
        for name, value in rows
    )
    return (
        f'<div>{STYLE}<table class="wholestring"><caption>{escape(caption)}</caption>'
        f"<tbody>{cells}</tbody></table></div>"
    )


def number(value: float) -> str:
    """Give a number in six digits; nothing of what is none.

    >>> number(1234567.0), number(0.25), number(float("nan"))
    ('1.23457e+06', '0.25', '')
    """
    return "" if np.isnan(value) else f"{value:.6g}"


def _head(of: Column) -> str:
    kind = ' class="number"' if of.numbers else ""
    hint = f' title="{escape(of.hint, quote=True)}"' if of.hint else ""
    unit = f'<br><span class="unit">{escape(of.unit)}</span>' if of.unit else ""
    return f"<th{kind}{hint}>{escape(of.title)}{unit}</th>"


def _cell(of: Column, text: str) -> str:
    kind = "number" if of.numbers else "wrap" if len(text) > 30 else ""
    return f'<td class="{kind}">{escape(text)}</td>' if kind else f"<td>{escape(text)}</td>"
