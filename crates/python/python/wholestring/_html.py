"""Tables as HTML for notebooks, in light and dark themes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape

import numpy as np

# Colours follow the notebook: text inherits its colour and lines mix it with transparency, so that
# both have contrast on a light and on a dark page.
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
    """A column of a table in HTML.

    Attributes
    ----------
    title, unit
        Heading, and unit below it.
    cells
        Texts of the cells.
    numbers
        Whether the cells are numbers, which are aligned to the right.
    hint
        Tooltip of the heading.
    """

    title: str
    cells: Sequence[str]
    unit: str = ""
    numbers: bool = True
    hint: str = field(default="")


def table(columns: Sequence[Column], *, caption: str = "", note: str = "") -> str:
    """Return a table as HTML."""
    heads = "".join(_head(column) for column in columns)
    count = len(columns[0].cells) if columns else 0
    rows = "".join(
        "<tr>" + "".join(_cell(column, column.cells[row]) for column in columns) + "</tr>"
        for row in range(count)
    )
    head = f"<caption>{escape(caption)}</caption>" if caption else ""
    foot = f"<p>{escape(note)}</p>" if note else ""
    return (
        f'<div>{STYLE}<table class="wholestring">{head}<thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table>{foot}</div>"
    )


def facts(rows: Sequence[tuple[str, str]], *, caption: str) -> str:
    """Return a table of names and values as HTML."""
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td>{escape(value)}</td></tr>'
        for name, value in rows
    )
    return (
        f'<div>{STYLE}<table class="wholestring"><caption>{escape(caption)}</caption>'
        f"<tbody>{cells}</tbody></table></div>"
    )


def number(value: float) -> str:
    """Return a number in six digits; an empty text for NaN.

    >>> number(1234567.0), number(0.25), number(float("nan"))
    ('1.23457e+06', '0.25', '')
    """
    return "" if np.isnan(value) else f"{value:.6g}"


def _head(column: Column) -> str:
    kind = ' class="number"' if column.numbers else ""
    hint = f' title="{escape(column.hint, quote=True)}"' if column.hint else ""
    unit = f'<br><span class="unit">{escape(column.unit)}</span>' if column.unit else ""
    return f"<th{kind}{hint}>{escape(column.title)}{unit}</th>"


def _cell(column: Column, text: str) -> str:
    kind = "number" if column.numbers else "wrap" if len(text) > 30 else ""
    return f'<td class="{kind}">{escape(text)}</td>' if kind else f"<td>{escape(text)}</td>"
