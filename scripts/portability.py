"""The program on other systems and processors, emulated on Linux on x86-64.

    python scripts/portability.py [windows | avx2 | baseline | aarch64]...  # all by default

Compares the numbers of short runs of every kind with those of this machine, bit by bit, and runs
the command-line tests on the system. It takes an hour and a half, most for ARM. Missing packages
are named.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[1]
TARGET = ROOT / os.environ.get("CARGO_TARGET_DIR", "target")
FOLDER = TARGET / "portability"

# Debian's path that avoids a conflict with the 32-bit version.
WINE = "/usr/lib/wine/wine64"

# The target's name in Rust if the program must be built for it; programs and their Debian packages,
# the linker first; the runner; the runs whose numbers may differ in single bits; whether the tests
# are run there, which an emulated processor of the same system does not affect.
SYSTEMS = {
    "windows": {
        "target": "x86_64-pc-windows-gnu",
        "needs": {"x86_64-w64-mingw32-gcc": "gcc-mingw-w64-x86-64", WINE: "wine64"},
        "runner": [WINE],
        "tested": True,
    },
    "avx2": {
        "needs": {"qemu-x86_64": "qemu-user"},
        "runner": ["qemu-x86_64", "-cpu", "Haswell"],
    },
    "baseline": {
        "needs": {"qemu-x86_64": "qemu-user"},
        "runner": ["qemu-x86_64", "-cpu", "Nehalem"],
        # Single-precision operations are fused if the processor supports it.
        "may_differ": ["single"],
    },
    "aarch64": {
        "target": "aarch64-unknown-linux-gnu",
        "needs": {
            "aarch64-linux-gnu-gcc": "gcc-aarch64-linux-gnu libc6-dev-arm64-cross",
            "qemu-aarch64": "qemu-user",
        },
        "runner": ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"],
        "tested": True,
    },
}

NP13 = "run cases/np13-x1042.toml --csv"
SHORT = "--set dynamics.settle=1s --set dynamics.duration=2s --set model=dynamic"
# A tenth of a second on rock so coarse that an emulator runs the bit in on it in minutes. It uses
# one thread, because an emulator makes threads wait for each other.
ON_ROCK = (
    "-j 1 --set model=dynamic --set rock.element_size=24mm "
    "--set dynamics.settle=0.05s --set dynamics.duration=0.05s"
)
RUNS = {
    "soft": f"{NP13} --set model=soft",
    "stiff": f"{NP13} --set model=stiff",
    "dynamic": f'{NP13} {SHORT} --set records.spectra=["surface_torque"]',
    "single": f"{NP13} {SHORT} --set dynamics.precision=single",
    "motor": f"run cases/bent-motor.toml --csv {SHORT}",
    "rock": f"run cases/rock-300.toml --csv {ON_ROCK}",
    "bha": "bha cases/bent-motor.toml",
    "modes": "modes cases/slant.toml",
    "plan": "plan cases/slant.toml",
    "reach": "reach cases/horizontal.toml",
}
# Values of a run that depend on the machine.
OF_THE_MACHINE = re.compile(rb'"(instructions|wall_time_s|real_time_factor)"')

# Library of random numbers that Rust requires and Wine 8 lacks. It forwards the call; for tests.
RANDOM = """#include <windows.h>
#include <ntsecapi.h>
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE data, SIZE_T length) {
    return RtlGenRandom(data, (ULONG)length);
}
"""


def run(command: list[str | pathlib.Path], variables: dict[str, str] | None = None) -> None:
    """Run a command in the root of the repository."""
    subprocess.run(command, cwd=ROOT, check=True, env=os.environ | (variables or {}))


def numbers(
    folder: pathlib.Path, program: list[str], variables: dict[str, str]
) -> dict[str, bytes]:
    """Return the tables and summaries of the runs; pages and pictures are drawn from these."""
    shutil.rmtree(folder, ignore_errors=True)
    for name, words in RUNS.items():
        run([*program, *words.split(), "--quiet", "--output", folder / name], variables)
    files = [path for path in folder.glob("*/*") if path.suffix in {".csv", ".parquet", ".json"}]
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(files)}


def difference(here: bytes | None, there: bytes | None) -> str | None:
    """Return the difference of a file in words; none if it is equal."""
    if here == there:
        return None
    if here is None or there is None:
        return "is not there" if there is None else "is there alone"
    if b"\0" in here + there:
        return "differs"
    split = [
        [
            (place, word.decode())
            for place, line in enumerate(text.splitlines(), 1)
            if not OF_THE_MACHINE.search(line)
            for word in re.split(rb"[][, {}:]", line)
        ]
        for text in (here, there)
    ]
    if len(split[0]) != len(split[1]):
        return "has other words"
    pairs = [(line, a, b) for (line, a), (_, b) in zip(*split, strict=True) if a != b]
    if not pairs:
        return None
    farthest = max(apart(a, b) for _, a, b in pairs)
    line, a, b = pairs[0]
    first = f"first in line {line}: {a} here, {b} there ({apart(a, b):.1e})"
    count = f"{len(pairs)} of {len(split[0])} numbers"
    return f"differs in {count}, {first}; the farthest are {farthest:.1e} apart"


def apart(a: str, b: str) -> float:
    """Return the relative difference of two numbers, infinite for words."""
    try:
        return abs(float(a) - float(b)) / max(abs(float(a)), abs(float(b)))
    except (ValueError, ZeroDivisionError):
        return float("inf")


def compare(here: dict[str, bytes], there: dict[str, bytes], may_differ: list[str]) -> bool:
    """Print the differences; return whether only those of runs that may differ do."""
    found = {name: difference(here.get(name), there.get(name)) for name in here | there}
    found = {name: words for name, words in found.items() if words}
    for name, words in found.items():
        print(f"  {name} {words}")
    print(f"  {len(found)} of {len(here)} files are not the same to the last bit")
    return all(name.split("/")[0] in may_differ for name in found)


def missing(system: dict) -> list[str]:
    """Return the commands that install what a system requires."""
    commands = []
    triple = system.get("target")
    sysroot = subprocess.check_output(["rustc", "--print", "sysroot"], text=True).strip()
    if triple and not pathlib.Path(sysroot, "lib/rustlib", triple).is_dir():
        commands.append(f"rustup target add {triple}")
    packages = [
        package for program, package in system["needs"].items() if not shutil.which(program)
    ]
    return commands + [f"apt-get install {package}" for package in packages]


def wine() -> dict[str, str]:
    """Prepare Wine in its own folders, and return its environment."""
    prefix, temporary = FOLDER / "wine", FOLDER / "temporary"
    for folder in (prefix, temporary):
        folder.mkdir(parents=True, exist_ok=True)
    # Temporary files are on the Linux disk, because the tests use its paths.
    place = "Z:" + str(temporary).replace("/", "\\")
    variables = {
        "WINEPREFIX": str(prefix),
        "WINEDEBUG": "-all",
        "WINEDLLOVERRIDES": "mscoree,mshtml,winemenubuilder.exe=",
        # Tests would call cargo, which is not a Windows program here.
        "INSTA_WORKSPACE_ROOT": str(ROOT),
        "TMP": place,
        "TEMP": place,
    }
    system = prefix / "drive_c/windows/system32"
    if not system.is_dir():
        run([WINE, "wineboot", "--init"], variables)
    library = system / "bcryptprimitives.dll"
    if not library.is_file():
        source = prefix / "random.c"
        source.write_text(RANDOM)
        run(["x86_64-w64-mingw32-gcc", "-shared", "-O1", "-o", library, source, "-ladvapi32"])
    # A server ends three seconds after its last program, and a program that starts at that moment
    # fails. Starting a second server reports the first one.
    server = ["/usr/lib/wine/wineserver64", "--persistent=600"]
    subprocess.run(server, env=os.environ | variables, check=False)
    return variables


def agrees(name: str, here: dict[str, bytes], native: pathlib.Path) -> bool:
    """Build for a system, compare its numbers, and run the command-line tests there."""
    system = SYSTEMS[name]
    triple, runner = system.get("target"), system["runner"]
    building, program = {}, native
    if triple:
        prefix = f"CARGO_TARGET_{triple.upper().replace('-', '_')}"
        building = {
            f"{prefix}_LINKER": next(iter(system["needs"])),
            f"{prefix}_RUNNER": " ".join(runner),
        }
        build = [
            "cargo",
            "build",
            "--quiet",
            "--workspace",
            "--bin",
            "wholestring",
            "--target",
            triple,
        ]
        run(build, building)
        program = (
            TARGET / triple / "debug" / ("wholestring.exe" if name == "windows" else "wholestring")
        )
    running = wine() if name == "windows" else {}
    there = numbers(FOLDER / name, [*runner, str(program)], running)
    if not compare(here, there, system.get("may_differ", [])):
        return False
    if not system.get("tested"):
        return True
    test = ["cargo", "test", "--workspace", "--test", "cli", "--no-fail-fast"]
    if name == "windows":
        # Tests and program both run on the system, for its files, signals and clocks.
        test, running = [*test, "--target", triple], building | running
    else:
        # The tests start this command in place of their program. Benchmarks query this processor.
        running = {"WHOLESTRING_IN_ITS_PLACE": "\n".join([*runner, str(program)])}
        test += ["--", "--skip", "bench::"]
    return subprocess.run(test, cwd=ROOT, env=os.environ | running, check=False).returncode == 0


def main() -> None:
    """Test the systems that are named."""
    names = sys.argv[1:] or list(SYSTEMS)
    if unknown := [name for name in names if name not in SYSTEMS]:
        raise SystemExit(f"`{unknown[0]}` is not one of {', '.join(SYSTEMS)}")
    if lacking := [f"  {name}: {command}" for name in names for command in missing(SYSTEMS[name])]:
        raise SystemExit("\n".join(["these must be installed:", *lacking]))
    run(
        [
            "cargo",
            "build",
            "--quiet",
            "--workspace",
            "--features",
            "wholestring-cli/app",
            "--bin",
            "wholestring",
        ]
    )
    native = TARGET / "debug/wholestring"
    here = numbers(FOLDER / "here", [str(native)], {})
    wrong = []
    for name in names:
        print(name, flush=True)
        try:
            if not agrees(name, here, native):
                wrong.append(name)
        except subprocess.CalledProcessError as error:
            print(f"  {error}")
            wrong.append(name)
    if wrong:
        raise SystemExit(f"not as on this machine: {', '.join(wrong)}")


if __name__ == "__main__":
    main()
