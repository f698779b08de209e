"""Errors of the accuracies of the automatic mesh: runs of cases compared with converged ones.

    python scripts/accuracy.py [WORD...]  # run all cases, or those whose titles contain a word
    python scripts/accuracy.py --write    # write the table into the book
    python scripts/accuracy.py --check    # compare its rows and columns with the cases

`benchmarks/accuracy` describes the method, its `cases.toml` lists cases, meshes and numbers.
"""

import argparse
import concurrent.futures
import functools
import json
import os
import pathlib
import subprocess

import page
import tomllib

PAGE = "docs/src/theory/mesh.md"
COMMAND = "scripts/accuracy.py --write"
TARGET = page.ROOT / os.environ.get("CARGO_TARGET_DIR", "target")
LISTED = tomllib.loads((page.ROOT / "benchmarks/accuracy/cases.toml").read_text(encoding="utf-8"))
CASES, MESHES, QUANTITIES = LISTED["case"], LISTED["mesh"], LISTED["quantity"]

# Motions of a string, and the names of their frequencies in the results.
MOTIONS = {
    "along the string": "axial_Hz",
    "about its axis": "torsional_Hz",
    "across, three joints pinned": "lateral_Hz",
}
MODES = 3


def head() -> str:
    """Return the titles of the columns."""
    converged, *others = [mesh["name"] for mesh in MESHES]
    return (
        f"| case | | {converged} | "
        + " | ".join(others)
        + " |\n"
        + "|---" * (2 + len(MESHES))
        + "|\n"
    )


def case_labels(case: dict) -> list[tuple[str, str]]:
    """Return the first two cells of each row of a case."""
    labels = [(case["title"], QUANTITIES["elements"]["label"])]
    return labels + [("", QUANTITIES[name]["label"]) for name in case["quantities"]]


def frequency_labels() -> list[tuple[str, str]]:
    """Return the first two cells of each row of natural frequencies."""
    labels = [f"{words}, {mode + 1}, Hz" for words in MOTIONS for mode in range(MODES)]
    title = CASES[0]["title"].split(",")[0] + ", natural frequencies"
    return [(title if row == 0 else "", label) for row, label in enumerate(labels)]


def cells(quantity: dict, values: list[float]) -> list[str]:
    """Return the converged value, and the errors of the others."""
    digits, error_digits = quantity["decimals"]
    scale, converged = quantity["scale"], values[0]
    if quantity.get("difference"):
        errors = [f"{scale * (value - converged):+.{error_digits}f}" for value in values[1:]]
    else:
        errors = [
            f"{100 * (value - converged) / abs(converged):+.{error_digits}f} %"
            for value in values[1:]
        ]
    return [f"{scale * converged:.{digits}f}", *errors]


def row(label: tuple[str, str], values: list[str]) -> str:
    """Return a row of the table."""
    return f"| {' | '.join([*label, *values])} |\n"


def solve(case: dict, mesh: dict, seed: int, folder: pathlib.Path) -> dict:
    """Run a case, and return the operation's part of its summary."""
    command = [
        TARGET / "release/wholestring",
        "run",
        case["file"],
        "--quiet",
        "--overwrite",
        "-o",
        folder,
    ]
    for setting in [*case.get("settings", []), *mesh["settings"], f"dynamics.seed={seed}"]:
        command += ["--set", setting]
    subprocess.run(command, cwd=page.ROOT, check=True, stdout=subprocess.DEVNULL)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return next(one for one in summary["operations"] if one["model"] == "dynamic")


def number(result: dict, path: str) -> float:
    """Return the number at a path of a result."""
    return functools.reduce(lambda part, name: part[name], path.split("."), result)


def case_rows(case: dict, pool: concurrent.futures.Executor) -> str:
    """Run a case on each mesh with each seed, and return its rows."""
    seeds = range(1, case.get("seeds", 1) + 1)
    place = TARGET / "accuracy" / str(CASES.index(case))
    jobs = [
        [pool.submit(solve, case, mesh, seed, place / f"{mesh['name']}-{seed}") for seed in seeds]
        for mesh in MESHES
    ]
    runs = [[job.result() for job in of_mesh] for of_mesh in jobs]

    def means(name: str) -> list[float]:
        path = QUANTITIES[name]["path"]
        return [sum(number(run, path) for run in of_mesh) / len(of_mesh) for of_mesh in runs]

    table = [[f"{mean:.10g}" for mean in means("elements")]]
    table += [cells(QUANTITIES[name], means(name)) for name in case["quantities"]]
    return "".join(map(row, case_labels(case), table))


def frequency_rows() -> str:
    """Return the rows of natural frequencies of the first case."""
    case, answers = CASES[0], []
    for mesh in MESHES:
        program = TARGET / "release/examples/natural_frequencies"
        command = [program, case["file"], *case.get("settings", []), *mesh["settings"]]
        answers.append(json.loads(subprocess.check_output(command, cwd=page.ROOT)))
    quantity = {"scale": 1, "decimals": [4, 3]}
    table = [
        cells(quantity, [answer[motion][mode] for answer in answers])
        for motion in MOTIONS.values()
        for mode in range(MODES)
    ]
    return "".join(map(row, frequency_labels(), table))


def check() -> None:
    """Check rows and columns of the book's table; its numbers depend on the machine."""
    for case in CASES:
        if not (page.ROOT / case["file"]).is_file():
            raise SystemExit(f"{case['file']} is not there")
    written = page.parts(PAGE, COMMAND)[1].strip()
    expected = [label for case in CASES for label in case_labels(case)] + frequency_labels()
    rows = written.removeprefix(head()).splitlines()
    labels = [tuple(cell.strip() for cell in line.split("|")[1:3]) for line in rows]
    if not written.startswith(head()) or labels != expected:
        raise SystemExit(f"{PAGE}: the table has other rows or columns; run `python {COMMAND}`")


def measure(words: list[str], write: bool) -> None:
    """Run the cases, and print the table."""
    chosen = [case for case in CASES if not words or any(word in case["title"] for word in words)]
    build = ["cargo", "build", "--release", "--quiet", "--package", "wholestring-cli"]
    build += ["--bin", "wholestring", "--example", "natural_frequencies"]
    subprocess.run(build, cwd=page.ROOT, check=True)
    text = head()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for case in chosen:
            print(case["title"], flush=True)
            text += case_rows(case, pool)
    if not words:
        text += frequency_rows()
    print(f"\n{text}")
    if write:
        page.write(PAGE, COMMAND, text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("words", nargs="*")
    arguments = parser.parse_args()
    if arguments.write and arguments.words:
        parser.error("the book has the table of all cases")
    if arguments.check:
        check()
    else:
        measure(arguments.words, arguments.write)
