"""Writes the problems of this set from the files of `verification/`.

Every number stands in one place, there. `python make.py` writes `problems/`, and with `--check` it
says whether what is there is what it would write.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from made import beams, buckling, rods, soft_strings, strengths, well_paths

FOLDER = Path(__file__).parent / "problems"
MODULES = (well_paths, soft_strings, buckling, strengths, beams, rods)


def texts() -> dict[str, str]:
    """The text of each file of `problems/`."""
    made: dict[str, str] = {}
    for module in MODULES:
        for problem in module.problems():
            name = f"{problem['id']}.json"
            if name in made:
                raise ValueError(f"two problems are called {problem['id']}")
            made[name] = text(problem) + "\n"
    return made


def text(value: Any, indent: str = "") -> str:
    """JSON with lists of numbers on one line: a survey is read column by column."""
    deeper = indent + "  "
    if isinstance(value, dict) and value:
        rows = [f"{deeper}{json.dumps(key)}: {text(of, deeper)}" for key, of in value.items()]
        return "{\n" + ",\n".join(rows) + f"\n{indent}}}"
    if isinstance(value, list) and any(isinstance(of, dict | str) for of in value):
        rows = [deeper + text(of, deeper) for of in value]
        return "[\n" + ",\n".join(rows) + f"\n{indent}]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing, say what differs")
    check = parser.parse_args().check
    made = texts()
    there = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.json")}
    differing = sorted(name for name in made | there if made.get(name) != there.get(name))
    if check:
        for name in differing:
            print(f"problems/{name} is not what make.py writes")
        return 1 if differing else 0
    FOLDER.mkdir(exist_ok=True)
    for name in differing:
        if name in made:
            (FOLDER / name).write_text(made[name], encoding="utf-8", newline="\n")
        else:
            (FOLDER / name).unlink()
    print(f"{len(made)} problems, {len(differing)} written or removed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
