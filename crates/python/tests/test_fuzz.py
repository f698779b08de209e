"""Odd arguments to everything that is public: a value or an exception of a known class, no crash.

The calls are seeded and made in a process of their own, so that one that ended the process would
fail this test and say which call it was. A panic of the engine that became an exception fails it
too.
"""

import inspect
import os
import random
import subprocess
import sys
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import wholestring as ws
from wholestring import _core, _values

PACKAGE = Path(__file__).parents[1]
sys.path.insert(0, str(PACKAGE))

import reference  # noqa: E402

CALLS = 100_000
SEED = 19


class Quantity:
    """What passes for a quantity of pint, and may lie."""

    def __init__(self, magnitude: object) -> None:
        self.magnitude = magnitude

    def to(self, unit: str) -> "Quantity":
        return self


class Liar:
    """Raises whatever is asked of it."""

    def __getattr__(self, name: str) -> object:
        raise RuntimeError(name)

    def __float__(self) -> float:
        raise OverflowError("no float")

    def __str__(self) -> str:
        raise RuntimeError("no text")

    __repr__ = __str__


def odd(of: random.Random, depth: int = 0) -> Any:
    """Give an odd argument."""
    numbers: list[object] = [
        0,
        -1,
        1,
        2**63,
        -(2**70),
        10**400,
        0.0,
        -0.0,
        0.3,
        1e-320,
        1e300,
        -1e9,
    ]
    numbers += [float("nan"), float("inf"), float("-inf"), True, False, 1 + 2j]
    texts = ["", " ", "10 s", "0.1 s", "90 rpm", "3 m", "1 kHz", "-5 kN", "1e999 s", "nan", "\0"]
    texts += ["drill", "trip_out", "md_m", "hook_load_N", "torque_N_m", "nodes", "time", "rpm"]
    texts += ["well.hole.0.friction", "a.b.c", "...", "[]", '"', "\\", "\ud800", "é" * 300, "'''"]
    texts += ["operation.bit_depth", "string.3.od", "\n", "=", "# x", "length", "rotary speed"]
    picked = of.random()
    if picked < 0.35:
        return of.choice(numbers)
    if picked < 0.7:
        return of.choice(texts)
    if picked < 0.85 and depth < 3:
        items = [odd(of, depth + 1) for _ in range(of.randrange(4))]
        if of.random() < 0.4:
            return {str(of.choice(texts)): item for item in items}
        return tuple(items) if of.random() < 0.5 else items
    others: list[Callable[[], Any]] = [
        lambda: None,
        object,
        Liar,
        lambda: Quantity(of.choice(numbers)),
        lambda: Quantity(Liar()),
        lambda: b"\x00\xff",
        lambda: bytearray(8),
        lambda: len,
        lambda: range(3),
        lambda: {1, 2},
        lambda: Path("nowhere"),
        lambda: iter(()),
    ]
    return of.choice(others)()


Call = Callable[[random.Random], object]


class Targets:
    """What is called: how often, and by which name; few of what takes a tenth of a second."""

    def __init__(self) -> None:
        self.weights: list[int] = []
        self.calls: list[tuple[str, Call]] = []

    def add(self, weight: int, name: str, call: Call) -> None:
        """Add a call that finds its odd arguments itself."""
        self.weights.append(weight)
        self.calls.append((name, call))

    def plain(self, weight: int, count: int, name: str, function: Callable[..., object]) -> None:
        """Add a function of so many arguments, all of them odd, and now and then of others."""

        def call(of: random.Random) -> object:
            given = count if of.random() < 0.95 else of.randrange(4)
            return function(*[odd(of) for _ in range(given)])

        self.add(weight, name, call)

    def keywords(
        self, often: int, label: str, function: Callable[..., object], /, **sound: object
    ) -> None:
        """Add a function with a sound call, of which one or two arguments become odd."""
        kinds = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
        parameters = inspect.signature(function).parameters.values()
        names = [one.name for one in parameters if one.kind in kinds]

        def call(of: random.Random) -> object:
            chosen = of.sample(names, min(len(names), of.choice((1, 1, 2))))
            return function(**{**sound, **{one: odd(of) for one in chosen}})

        self.add(often, label, call)


def one(function: Callable[[Any], object]) -> Callable[..., object]:
    """Give a function of one argument."""
    return function


def two(function: Callable[[Any, Any], object]) -> Callable[..., object]:
    """Give a function of two arguments."""
    return function


def targets() -> Targets:
    """Give all targets."""
    found = Targets()
    small: dict[str, ws.Value] = {
        "mesh.element_length": 30.0,
        "operation.kind": "drill",
        "dynamics.duration": 0.1,
        "dynamics.settle": 0.1,
        "modes.count": 1,
        "plan.depths": 2,
        "rig.block_weight": "200 kN",
    }
    case = ws.Case.example().with_(small)
    helpers(found)
    of_cases(found, case)
    of_results(found, case)
    of_tables(found, case.soft().nodes)
    of_simulations(found, case)
    of_commands(found, case)
    of_figures(found, case)
    return found


def helpers(found: Targets) -> None:
    """Add what all arguments go through."""
    found.plain(1400, 2, "quantity", _core.quantity)
    found.plain(1400, 1, "time", one(lambda of: _core.quantity(of, "time")))
    found.plain(700, 1, "si_unit", _core.si_unit)
    found.plain(700, 1, "unit_of", _core.unit_of)
    found.plain(300, 3, "values", _core.values)
    found.plain(1400, 2, "si", _values.si)
    found.plain(1400, 1, "toml", one(lambda value: _values.toml(value, "mud.density")))
    found.plain(700, 1, "document", _values.document)
    found.plain(700, 2, "changes", two(lambda one, two: list(_values.changes(one, two))))


def of_cases(found: Targets, case: ws.Case) -> None:
    """Add how cases are made and solved: the settings of a whole string take time to read."""
    Path("survey.csv").write_text("MD (m),Inc,Azi\n0,0,0\n300,0,0\n330,3,45\n")
    imported = ws.import_files("survey.csv")
    found.plain(60, 1, "Case.load", ws.Case.load)
    found.plain(120, 1, "Case", ws.Case)
    found.plain(60, 1, "Case.from_dict", ws.Case.from_dict)
    found.keywords(30, "Case.from_dict", ws.Case.from_dict, table={"well": {}})
    found.plain(30, 2, "Case", two(lambda text, files: ws.Case(text, files=files)))
    found.plain(30, 1, "Case.with_", case.with_)
    found.plain(10, 0, "Case.example", ws.Case.example)
    found.plain(10, 0, "Case.to_toml", case.to_toml)
    found.plain(10, 0, "Case.well_path", case.well_path)
    found.keywords(20, "Case.check", case.check)
    found.keywords(20, "Case.soft", case.soft)
    found.keywords(20, "Case.stiff", case.stiff)
    found.plain(10, 1, "Case.soft_many", case.soft_many)
    found.keywords(10, "Case.dynamic", case.dynamic)
    found.keywords(5, "Case.run", case.with_(model="soft").run)
    found.plain(60, 2, "contents", ws.contents)
    found.plain(60, 1, "import_files", ws.import_files)
    makes: dict[str, Callable[..., object]] = {
        "import_files": ws.import_files,
        "Case.from_files": ws.Case.from_files,
    }
    for name, make in makes.items():
        for part in sorted(arguments(make) - {"files"}):
            found.plain(10, 1, name, of_part(make, part))
    found.plain(20, 1, "Imported.case", imported.case)
    found.plain(10, 1, "Imported.save", imported.save)


def of_part(make: Callable[..., object], part: str) -> Callable[..., object]:
    """Give how a case is made of a survey, with one thing that is said of it."""
    return one(lambda given: make("survey.csv", **{part: given}))


def arguments(of: Callable[..., object]) -> set[str]:
    """Give the names of the arguments of a function."""
    return set(inspect.signature(of).parameters)


def of_results(found: Targets, case: ws.Case) -> None:
    """Add what is asked of results."""
    solved = case.soft()
    folder = solved.save("solved")
    loaded = ws.Results.load(folder)
    swept = ws.sweep(case.with_(model="soft"), {"friction": [0.2, 0.3]}, folder="swept")
    modes = case.modes("modes")
    calibration = case.calibrate(readings(case), "calibrated", one_factor=True)
    found.plain(900, 1, "Results[]", solved.__getitem__)
    found.plain(900, 1, "BaseResults.table", solved.table)
    found.plain(60, 1, "BaseResults.table", loaded.table)
    found.plain(60, 1, "BaseResults.load", ws.Results.load)
    found.plain(60, 1, "load", ws.load)
    found.plain(60, 1, "Sweep.load", ws.Sweep.load)
    found.plain(60, 1, "Sweep[]", swept.__getitem__)
    for name in ("to_polars", "to_pandas"):
        found.plain(10, 0, f"Sweep.{name}", getattr(swept, name))
        found.plain(10, 0, f"Results.{name}", getattr(solved, name))
    found.plain(60, 1, "Sweep", ws.Sweep)
    found.plain(60, 1, "Modes.frequencies_Hz", modes.frequencies_Hz)
    found.plain(20, 1, "Calibration[]", calibration.__getitem__)
    found.plain(20, 1, "Calibration.applied_to", calibration.applied_to)
    found.keywords(4, "BaseResults.save", solved.save)
    found.keywords(4, "BaseResults.save", loaded.save)


def readings(case: ws.Case) -> dict[str, object]:
    """Give what is calibrated with."""
    depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    table = case.broomstick(frictions=0.25, bit_depths=depths, operations="trip_out", model="soft")
    return {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}


def of_tables(found: Targets, nodes: ws.Table) -> None:
    """Add what is asked of a table."""
    found.plain(900, 1, "Table[]", nodes.__getitem__)
    found.plain(900, 1, "Table.unit", nodes.unit)
    found.plain(900, 1, "Table.meaning", nodes.meaning)
    found.plain(300, 1, "in Table", nodes.__contains__)
    found.plain(300, 0, "schema", nodes.__arrow_c_schema__)
    found.plain(300, 1, "stream", nodes.__arrow_c_stream__)
    found.plain(100, 1, "restored", _core.Table.restore)
    found.plain(100, 3, "restored", _core.Answers.restore)
    for name in ("to_numpy", "to_polars", "to_pandas"):
        found.plain(20, 0, f"Table.{name}", getattr(nodes, name))


def of_simulations(found: Targets, case: ws.Case) -> None:
    """Add simulations in hand."""
    sim = case.simulation()
    sim.advance(0.02)
    kept = sim.checkpoint()
    sims = [sim, case.simulation(checkpoint=kept)]

    def damaged(of: random.Random) -> object:
        data = bytearray(kept)
        for _ in range(of.randrange(1, 4)):
            data[of.randrange(len(data))] ^= 1 << of.randrange(8)
        cut = bytes(data[: of.randrange(len(data))] if of.random() < 0.3 else data)
        return case.simulation(checkpoint=cut)

    def changed(of: random.Random) -> object:
        """Give it a set point that there is, or time that it takes a moment to pass."""
        name = of.choice(
            ["rpm", "block_velocity", "weight_on_bit", "flow_rate", "friction", "ramp", "odd"]
        )
        asked: Callable[..., object] = of.choice(sims).set
        return asked(**{name: odd(of)})

    def advanced(of: random.Random) -> None:
        time = odd(of)
        # What is a time at all would be waited for.
        small: dict[Any, Any] = {"10 s": "0.1 s", 10**400: 1e-3}
        small |= dict.fromkeys((1e300, 2**63, 1, 0.3), 1e-3)
        try:
            time = small.get(time, time)
        except TypeError:
            pass
        if isinstance(time, Quantity | bool):
            time = 1e-3
        which = of.randrange(len(sims))
        try:
            sims[which].advance(time)
        except ws.NoAnswerError:
            # One that diverged stays so: another, from where all was well.
            sims[which] = case.simulation(checkpoint=kept)
            raise

    def reading(of: random.Random) -> object:
        one = of.choice(sims)
        asks: list[Callable[[], object]] = [
            lambda: one.now,
            lambda: one.time_s,
            lambda: one.friction,
            lambda: one.is_settling,
            lambda: repr(one),
            lambda: one.end_time_s,
            lambda: one.operation,
            lambda: one.sample_interval_s,
        ]
        return of.choice(asks)()

    def lazily(ask: Callable[[ws.Simulation], object]) -> Call:
        return lambda of: ask(of.choice(sims))

    def law(answer: Any) -> Callable[[Any], Any]:
        return lambda reading: answer

    made = "Case.simulation"
    found.plain(10, 1, made, case.simulation)
    found.plain(30, 1, made, one(lambda of: case.simulation(checkpoint=of)))
    found.add(20, made, damaged)
    found.plain(15, 1, made, one(lambda of: case.simulation(bit_law=law((1e-3, 1e3)), rate=of)))
    found.plain(10, 1, made, one(lambda of: case.simulation(bit_law=law(of))))
    found.plain(10, 1, made, one(lambda of: case.simulation(excitation=law(of))))
    found.plain(10, 1, made, one(lambda of: case.simulation(bit_law=of)))
    found.plain(10, 1, made, one(lambda of: case.simulation(jobs=of)))
    found.add(900, "Simulation.set", changed)
    found.add(300, "Simulation.advance", advanced)
    found.add(2000, "reading", reading)
    found.add(300, "Simulation.since", lambda of: of.choice(sims).since(odd(of)))
    found.add(20, "Simulation.forget", lambda of: of.choice(sims).forget(odd(of)))
    found.add(20, "Simulation.state", lazily(lambda one: one.state()))
    found.add(10, "Simulation.results", lazily(lambda one: one.results()))
    found.add(10, "Simulation.history", lazily(lambda one: one.history))
    found.add(10, "Simulation.checkpoint", lazily(lambda one: one.checkpoint()))


STUDY = """
name = "Friction"
[[sweep]]
name = "statics"
case = "slant.toml"
set = { model = "soft" }
vary = { friction = [0.2, 0.3] }
"""

ROCK: dict[str, ws.Value] = {
    "string.0.od": "120 mm",
    "bit.face.cutter_diameter": "19 mm",
    "rock.strength": "10 MPa",
    "rock.element_size": "15 mm",
    "rock.density_factor": 60,
    "bit_test.wob": ["10 kN"],
    "bit_test.rpm": ["240 rpm"],
    "bit_test.settle_revolutions": 0.25,
    "bit_test.revolutions": 0.5,
}


def of_commands(found: Targets, case: ws.Case) -> None:
    """Add the verbs that solve more than a moment takes: a few of each."""
    Path("slant.toml").write_text(ws.Case.example().to_toml())
    Path("study.toml").write_text(STUDY)
    soft = case.with_(model="soft")
    data = readings(case)
    found.keywords(8, "Case.broomstick", case.broomstick, model="soft", bit_depths=[900.0])
    found.keywords(4, "Case.plan", case.plan)
    found.keywords(4, "Case.reach", case.reach, to="2 km")
    found.keywords(4, "Case.bha", case.bha, weight=[1e4], inclination=[0.5])
    found.keywords(4, "Case.modes", case.modes, operation="drill")
    found.keywords(4, "Case.calibrate", case.calibrate, data=data, one_factor=True)
    found.keywords(4, "Case.bit_test", ws.Case.example().with_(ROCK).bit_test)
    found.keywords(4, "study", ws.study, path="study.toml")
    found.keywords(8, "sweep", ws.sweep, case=soft, vary={"friction": [0.2]})
    found.plain(60, 1, "sweep", one(lambda vary: ws.sweep(soft, vary)))


def of_figures(found: Targets, case: ws.Case) -> None:
    """Add every figure, of results that it draws, and of none."""
    from matplotlib import pyplot

    drawn: dict[str, object] = {
        "broomstick": case.broomstick(model="soft"),
        "calibration": ws.load("calibrated"),
        "campbell": ws.load("modes"),
        "compare": "a pair",
        "modes": ws.load("modes"),
        "reach": case.reach(to="2 km"),
        "spectrum": case.with_(records__spectra=["hook_load"]).dynamic(),
        "sweep": ws.load("swept"),
        "time": case.dynamic(),
        "tracks": case.soft(),
        "well": case,
    }
    pair = [case.soft(), case.with_(friction=0.1).soft()]
    for name in (of for of in ws.plot.__all__ if of != "Units"):
        function = getattr(ws.plot, name)

        def call(of: random.Random, function: Any = function, name: str = name) -> object:
            every = inspect.signature(function).parameters.values()
            others = [one.name for one in every if one.kind is one.KEYWORD_ONLY]
            given = {one: odd(of) for one in of.sample(others, min(len(others), of.randrange(3)))}
            shown = odd(of) if of.random() < 0.3 else drawn[name]
            is_pair = name == "compare" and shown is drawn[name]
            try:
                return function(*pair, **given) if is_pair else function(shown, **given)
            finally:
                pyplot.close("all")

        found.add(6, f"plot.{name}", call)


# What a caller may expect of odd arguments.
KNOWN = (
    TypeError,
    ValueError,
    KeyError,
    AttributeError,
    OverflowError,
    OSError,
    IndexError,
)


def fuzz(calls: int, seed: int) -> Iterator[str]:
    """Make so many calls, and say which would have been the last."""
    warnings.simplefilter("ignore")
    of = random.Random(seed)
    chosen = targets()
    for call, (name, function) in enumerate(of.choices(chosen.calls, chosen.weights, k=calls)):
        yield f"call {call}, {name}"
        try:
            function(of)
        except ws.Error as error:
            # Of no class of its own: the engine panicked.
            if type(error) is ws.Error:
                raise
        except KNOWN:
            pass
        except RuntimeError as error:
            # The liar's own.
            if type(error) is not RuntimeError:
                raise


def main(calls: int, seed: int, trace: bool) -> None:
    """Make so many calls in this folder."""
    name = "the targets"
    try:
        for name in fuzz(calls, seed):
            if trace:
                print(name, flush=True)
    except BaseException as error:
        if trace:
            raise
        message = f"{name}: {type(error).__name__}: {error}"
        raise SystemExit(message) from error
    print(f"{calls} calls")


def test_odd_arguments_never_end_the_process(tmp_path: Path) -> None:
    command = [sys.executable, __file__, str(CALLS), str(SEED)]
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    found = subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=900,
        cwd=tmp_path,
        env=environment,
        errors="replace",
    )
    assert found.returncode == 0, found.stderr[-2000:]
    assert found.stdout == f"{CALLS} calls\n", found.stdout + found.stderr[-2000:]
    assert "panicked" not in found.stderr, found.stderr[-2000:]


def test_everything_that_is_public_is_called(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    called = {name for name, _ in targets().calls}
    public: set[str] = set()
    for name, of in reference.public():
        short = name.removeprefix("wholestring.")
        if not inspect.isclass(of):
            public.add(short)
            continue
        for member, one in reference.members(of):
            if inspect.isfunction(one):
                public.add(f"{short}.{member}")
    # A protocol: others have it.
    assert public - called == {"Quantity.to"}


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:] == ["trace"])
