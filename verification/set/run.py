"""Gives the problems of this set to a program and says which of its answers hold.

    python run.py ADAPTER [--only KIND_OR_ID] [--json OUT] [--markdown OUT]

ADAPTER is a Python file, a folder with an `__init__.py`, or a command. Python defines
`answers(problem)`, which returns numbers by name; names left out are not answered, and
`NotImplementedError` says that the problem is outside of the program's scope. A command is run once
for each problem, reads it as JSON from its standard input and writes the same as JSON to its
standard output, `null` where the problem is out of scope.

The exit status is 0 where no answer failed, 1 where one did, 2 where the adapter is at fault.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from running.adapter import AdapterError, load
from running.judge import Outcome, judge
from running.tables import as_json, as_markdown, as_text

PROBLEMS = Path(__file__).parent / "problems"


def chosen(only: Sequence[str]) -> list[dict[str, object]]:
    """The problems of these kinds and names, all of them where none is given."""
    files = sorted(PROBLEMS.glob("*.json"))
    problems = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    names = {of["id"] for of in problems} | {of["kind"] for of in problems}
    for name in only:
        if name not in names:
            kinds = ", ".join(sorted({of["kind"] for of in problems}))
            raise AdapterError(f"there is no kind or problem {name!r}; kinds are {kinds}")
    return [of for of in problems if not only or of["id"] in only or of["kind"] in only]


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("adapter", metavar="ADAPTER")
    parser.add_argument("--only", action="append", default=[], metavar="KIND_OR_ID")
    parser.add_argument("--json", type=Path, metavar="OUT", help="every number, as JSON")
    parser.add_argument("--markdown", type=Path, metavar="OUT", help="the tables, as Markdown")
    given = parser.parse_args()
    try:
        problems = chosen(given.only)
        adapter = load(given.adapter)
        outcomes: list[Outcome] = [judge(problem, adapter.answers) for problem in problems]
    except AdapterError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    if given.json:
        given.json.write_text(as_json(adapter, outcomes), encoding="utf-8", newline="\n")
    if given.markdown:
        given.markdown.write_text(as_markdown(adapter, outcomes), encoding="utf-8", newline="\n")
    print(as_text(adapter, outcomes), end="")
    return 1 if any(outcome.failed for outcome in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
