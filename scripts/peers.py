# ruff: noqa: RUF001
"""The same work in wholestring and in alternative programs, one after the other on one core.

    python scripts/peers.py          # measure, and print two tables
    python scripts/peers.py --write  # write them into the book

`benchmarks/peers` has the work and the scripts of the programs. Needs Python 3.11 or newer, for
which all pinned packages are available; they are installed in `target/peers`.
"""

import json
import os
import pathlib
import platform
import subprocess
import sys
import venv

import page

PAGE = "docs/src/speed.md"
COMMAND = "scripts/peers.py --write"
FOLDER = page.ROOT / "benchmarks/peers"
TARGET = page.ROOT / os.environ.get("CARGO_TARGET_DIR", "target")
WHOLESTRING = TARGET / "release/wholestring"
# Runs of each program, in turn; the shortest time counts, because disturbances only add time.
REPEATS = 3
# Scripts of the dynamics; the others are compared with the first.
DYNAMICS = [
    ["wholestring_run.py", str(WHOLESTRING)],
    ["pyelastica_rod.py", "--inertia", "raised"],
    ["pyelastica_rod.py"],
    ["exudyn_beams.py"],
]
# One thread regardless of the libraries' defaults, and compiled caches in the build folder.
ENVIRONMENT = os.environ | {
    "NUMBA_CACHE_DIR": str(TARGET / "peers/numba"),
    "PYTHONDONTWRITEBYTECODE": "1",
    "OMP_NUM_THREADS": "1",
    "NUMBA_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
}
WELLS = {"deviated": "NP13-X1042's shape", "build": "build", "drop": "drop"}
ANSWERS = {
    "pick_up_N": "pick-up, kN",
    "slack_off_N": "slack-off, kN",
    "rotating_N": "rotating, kN",
    "torque_N_m": "torque, kN·m",
}
TIMES = {"coarse_s": "all, pieces of 30 m, ms", "fine_s": "all, pieces of 1 m, ms"}


def answer(command: list[str | pathlib.Path]) -> dict:
    """Return the last line that a program prints in JSON."""
    text = subprocess.check_output(command, cwd=page.ROOT, env=ENVIRONMENT, text=True)
    return json.loads([line for line in text.splitlines() if line.startswith("{")][-1])


def digits(value: float) -> str:
    """Return two digits of small values, whole numbers for large ones."""
    return f"{float(f'{value:.1e}'):.15g}" if value < 100 else f"{value:.0f}"


def row(*cells: object) -> str:
    """Return a row of a table."""
    return "| " + " | ".join(map(str, cells)) + " |\n"


def dynamics(measured: list[dict]) -> str:
    """Return the table of each program's time, and whether its results agree, and its notes."""
    ours = measured[0]["cpu_s"] / measured[0]["simulated_s"]
    text = row(
        "program", "elements", "step, µs", "simulated, s", "CPU s per simulated s", "× real time",
        "CPU, wholestring's = 1", "hook load, kN", "torque, kN·m",
    ) + "|---" * 9 + "|\n"  # fmt: skip
    notes = "\n| program | its step | left out |\n|---|---|---|\n"
    for run in measured:
        name = ", ".join(filter(None, [f"{run['program']} {run['version']}", run["variant"]]))
        cpu = run["cpu_s"] / run["simulated_s"]
        text += row(
            name, run["elements"], f"{run['step_s'] * 1e6:.0f}", f"{run['simulated_s']:.0f}",
            digits(cpu), digits(1 / cpu), digits(cpu / ours), f"{run['hook_load_N'] / 1e3:.1f}",
            f"{run['torque_N_m'] / 1e3:.2f}",
        )  # fmt: skip
        notes += row(name, run["tuned"], run["leaves_out"])
    return text + notes


def statics(ours: dict, theirs: dict) -> str:
    """Return the table of the soft string's results and times, ours and welleng's."""
    text = row(
        "well", "answer", "closed form", "wholestring", f"welleng {theirs['version']}", "apart",
        "closed form, sign turned",
    ) + "|---" * 7 + "|\n"  # fmt: skip
    for well, title in WELLS.items():
        for key, name in ANSWERS.items():
            # The arcs are present for the side force, the sum of which is the torque.
            if well != "deviated" and key != "torque_N_m":
                continue
            known = [
                theirs.get(f"{form}_{key}", {}).get(well) for form in ("closed_form", "turned_sign")
            ]
            exact, turned = ["–" if value is None else f"{value / 1e3:.2f}" for value in known]
            our, their = ours[well][key], theirs[well][key]
            apart = f"{(their / our - 1) * 100:+.1f} %"
            text += row(title, name, exact, f"{our / 1e3:.2f}", f"{their / 1e3:.2f}", apart, turned)
        for key, name in TIMES.items():
            our, their = ours[well][key], theirs[well][key]
            times = [digits(our * 1e3), digits(their * 1e3), f"{digits(their / our)} times"]
            text += row(title, name, "–", *times, "–")
    return text


def processor() -> str:
    """Return the system's name of the processor."""
    listed = pathlib.Path("/proc/cpuinfo")
    text = listed.read_text() if listed.exists() else ""
    names = [
        line.split(":")[1].strip() for line in text.splitlines() if line.startswith("model name")
    ]
    wide = ", with AVX-512" if "avx512f" in text else ""
    return (names[0] if names else platform.machine()) + wide


def main() -> None:
    """Measure, and print or write the tables."""
    folder = TARGET / "peers"
    python = folder / "bin/python"
    if not python.exists():
        venv.create(folder, with_pip=True)
    pip = [python, "-m", "pip", "install", "--quiet", "-r", FOLDER / "requirements.txt"]
    subprocess.run(pip, check=True)
    cargo = ["cargo", "build", "--release", "--quiet", "--package", "wholestring-cli"]
    subprocess.run(cargo, cwd=page.ROOT, check=True)
    quickest: list[dict] = [{} for _ in DYNAMICS]
    for turn in range(REPEATS):
        for place, (script, *words) in enumerate(DYNAMICS):
            print(f"[{turn + 1}/{REPEATS}] {script}", flush=True)
            run = answer([python, FOLDER / script, *words])
            if not quickest[place] or run["cpu_s"] < quickest[place]["cpu_s"]:
                quickest[place] = run
    bench = ["cargo", "bench", "--quiet", "--package", "wholestring", "--bench", "soft_string"]
    table = statics(answer([*bench]), answer([python, FOLDER / "welleng_soft_string.py"]))
    text = f"On one core of {processor()}.\n\n{dynamics(quickest)}\n{table}"
    print(f"\n{text}")
    if "--write" in sys.argv:
        page.write(PAGE, COMMAND, text)


if __name__ == "__main__":
    main()
