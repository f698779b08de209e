"""The verification problems for other programs: valid, up to date with their sources, solved."""

import importlib
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

SET = Path(__file__).parents[3] / "verification/set"
PROBLEMS = sorted((SET / "problems").glob("*.json"))
SLANT = "soft-string-slant-30-mu0-2"


def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *map(str, words)], cwd=SET, capture_output=True, text=True, check=False
    )


def test_the_problems_are_what_the_schema_says() -> None:
    schema = json.loads((SET / "schema.json").read_text(encoding="utf-8"))
    # The package has no types.
    validators: Any = importlib.import_module("jsonschema.validators")
    validators.Draft202012Validator.check_schema(schema)
    validator = validators.Draft202012Validator(schema)
    assert PROBLEMS
    for file in PROBLEMS:
        problem = json.loads(file.read_text(encoding="utf-8"))
        faults = [f"{fault.json_path}: {fault.message}" for fault in validator.iter_errors(problem)]
        assert not faults, file.name
        assert problem["id"] == file.stem
        assert (SET.parents[1] / problem["source"]["file"]).is_file(), file.name


def test_the_problems_are_what_their_sources_say() -> None:
    checked = run("make.py", "--check")
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_this_program_holds_all_that_it_answers(tmp_path: Path) -> None:
    ran = run("run.py", "adapters/wholestring", "--json", tmp_path / "found.json")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    found = json.loads((tmp_path / "found.json").read_text(encoding="utf-8"))["problems"]
    assert len(found) == len(PROBLEMS)
    assert {row["kind"] for row in found if row["out_of_scope"]} == {"cantilever"}
    silent = {row["kind"] for row in found if row["not_answered"]}
    assert silent == {"buckling_load", "casing_wear", "pipe_stress"}


@pytest.mark.parametrize(
    ("answer", "status", "output"),
    [
        ("{'pick_up_hook_load_N': 579615.3}", 0, "4 1 1"),
        ("{'pick_up_hook_load_N': 580000.0}", 1, "580000 for 579615, +0.066 %"),
        ("{'pick_up_hook_load_N': float('nan')}", 1, "nan for 579615"),
        ("{'pick_up_hook_load_N': '579615'}", 2, "pick_up_hook_load_N is a number, not '579615'"),
        ("{'pick_up_hook_load_N': [1.0]}", 2, "is a number, not [1.0]"),
        ("{'hook_load_N': 1.0}", 2, "'hook_load_N' is not asked for; known are pick_up_hook"),
        ("[1.0]", 2, "answers are a mapping"),
        ("1 / 0", 1, "ZeroDivisionError: division by zero"),
        ("{}", 0, "4 0 0"),
    ],
)
def test_an_answer_is_judged(tmp_path: Path, answer: str, status: int, output: str) -> None:
    adapter = tmp_path / "adapter.py"
    adapter.write_text(f"def answers(problem):\n    return {answer}\n", encoding="utf-8")
    ran = run("run.py", adapter, "--only", SLANT)
    assert ran.returncode == status, ran.stdout + ran.stderr
    assert output in " ".join((ran.stdout + ran.stderr).split())


def test_a_command_answers(tmp_path: Path) -> None:
    program = tmp_path / "program.py"
    program.write_text(
        "import json, sys\n"
        "problem = json.load(sys.stdin)\n"
        "expected = {name: of['value'] for name, of in problem['expected'].items()}\n"
        "json.dump(expected if problem['kind'] == 'stretch' else None, sys.stdout)\n",
        encoding="utf-8",
    )
    command = f'"{Path(sys.executable).as_posix()}" "{program.as_posix()}"'
    ran = run("run.py", command, "--only", "stretch", "--only", SLANT)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    rows = [line.split() for line in ran.stdout.splitlines()]
    assert ["soft_string", "1", "0", "0", "0", "1", "4", "0", "0"] in rows
    assert ["stretch", "2", "2", "0", "0", "0", "2", "2", "2", "0"] in rows


def test_a_list_has_its_length(tmp_path: Path) -> None:
    adapter = tmp_path / "adapter.py"
    adapter.write_text("def answers(problem):\n    return {'north_m': [0.0]}\n", encoding="utf-8")
    ran = run("run.py", adapter, "--only", "well-path-one-arc")
    assert ran.returncode == 2
    assert "north_m has 4 numbers, answered 1" in ran.stderr


def test_the_results_that_are_shown_are_those() -> None:
    """Compare counts, not deviations, which are the rounding of the machine of the run."""
    text = (SET / "README.md").read_text(encoding="utf-8")
    of_all = [line for line in text.splitlines() if line.startswith("| all |")]
    assert all(f"| all | {len(PROBLEMS)} |" in line for line in of_all)
    assert len(of_all) == 2
