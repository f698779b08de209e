"""Odd arguments to all public functions: a value or an exception of a known class, no crash.

The calls are seeded and made in a process of their own, so that one that ended the process would
fail this test with the name of the call. A panic of the engine that became an exception also fails
it.
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
    """An imitation of a quantity of pint, whose value may be invalid."""

    def __init__(self, magnitude: object) -> None:
        self.magnitude = magnitude

    def to(self, unit: str) -> "Quantity":
        return self


class Liar:
    """An object that raises an error in every method."""

    def __getattr__(self, name: str) -> object:
        raise RuntimeError(name)

    def __float__(self) -> float:
        raise OverflowError("no float")

    def __str__(self) -> str:
        raise RuntimeError("no text")

    __repr__ = __str__


def odd(rng: random.Random, depth: int = 0) -> Any:
    """Return an odd argument."""
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
    picked = rng.random()
    if picked < 0.35:
        return rng.choice(numbers)
    if picked < 0.7:
        return rng.choice(texts)
    if picked < 0.85 and depth < 3:
        items = [odd(rng, depth + 1) for _ in range(rng.randrange(4))]
        if rng.random() < 0.4:
            return {str(rng.choice(texts)): item for item in items}
        return tuple(items) if rng.random() < 0.5 else items
    others: list[Callable[[], Any]] = [
        lambda: None,
        object,
        Liar,
        lambda: Quantity(rng.choice(numbers)),
        lambda: Quantity(Liar()),
        lambda: b"\x00\xff",
        lambda: bytearray(8),
        lambda: len,
        lambda: range(3),
        lambda: {1, 2},
        lambda: Path("nowhere"),
        lambda: iter(()),
    ]
    return rng.choice(others)()


Call = Callable[[random.Random], object]


class Targets:
    """Calls with their weights and names; a call of a tenth of a second has a low weight."""

    def __init__(self) -> None:
        self.weights: list[int] = []
        self.calls: list[tuple[str, Call]] = []

    def add(self, weight: int, name: str, call: Call) -> None:
        """Add a call that draws its own odd arguments."""
        self.weights.append(weight)
        self.calls.append((name, call))

    def plain(self, weight: int, count: int, name: str, function: Callable[..., object]) -> None:
        """Add a function of ``count`` arguments, all odd, sometimes with another number of them."""

        def call(rng: random.Random) -> object:
            arity = count if rng.random() < 0.95 else rng.randrange(4)
            return function(*[odd(rng) for _ in range(arity)])

        self.add(weight, name, call)

    def keywords(
        self, often: int, label: str, function: Callable[..., object], /, **sound: object
    ) -> None:
        """Add a function with a valid call, of which one or two arguments become odd."""
        kinds = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
        parameters = inspect.signature(function).parameters.values()
        names = [one.name for one in parameters if one.kind in kinds]

        def call(rng: random.Random) -> object:
            chosen = rng.sample(names, min(len(names), rng.choice((1, 1, 2))))
            return function(**{**sound, **{one: odd(rng) for one in chosen}})

        self.add(often, label, call)


def one(function: Callable[[Any], object]) -> Callable[..., object]:
    """Return a function of one argument."""
    return function


def two(function: Callable[[Any, Any], object]) -> Callable[..., object]:
    """Return a function of two arguments."""
    return function


def targets() -> Targets:
    """Return all targets."""
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
    """Add the conversions of all arguments."""
    found.plain(1400, 2, "quantity", _core.quantity)
    found.plain(1400, 1, "time", one(lambda text: _core.quantity(text, "time")))
    found.plain(700, 1, "si_unit", _core.si_unit)
    found.plain(700, 1, "unit_of", _core.unit_of)
    found.plain(300, 3, "values", _core.values)
    found.plain(1400, 2, "si", _values.si)
    found.plain(1400, 1, "toml", one(lambda value: _values.toml(value, "mud.density")))
    found.plain(700, 1, "document", _values.document)
    found.plain(700, 2, "changes", two(lambda one, two: list(_values.changes(one, two))))


def of_cases(found: Targets, case: ws.Case) -> None:
    """Add the making and solving of cases: the settings of a whole string take time to read."""
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
    """Return a function that makes a case from a survey with one more argument."""
    return one(lambda value: make("survey.csv", **{part: value}))


def arguments(function: Callable[..., object]) -> set[str]:
    """Return the names of the arguments of a function."""
    return set(inspect.signature(function).parameters)


def of_results(found: Targets, case: ws.Case) -> None:
    """Add the methods of results."""
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
    """Return readings for a calibration."""
    depths = [500.0, 700.0, 900.0, 1050.0, 1200.0]
    table = case.broomstick(frictions=0.25, bit_depths=depths, operations="trip_out", model="soft")
    return {"bit_depth_m": depths, "pick_up_N": table["hook_load_with_block_N"]}


def of_tables(found: Targets, nodes: ws.Table) -> None:
    """Add the methods of a table."""
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
    """Add simulations that the caller advances."""
    sim = case.simulation()
    sim.advance(0.02)
    checkpoint = sim.checkpoint()
    sims = [sim, case.simulation(checkpoint=checkpoint)]

    def damaged(rng: random.Random) -> object:
        data = bytearray(checkpoint)
        for _ in range(rng.randrange(1, 4)):
            data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
        cut = bytes(data[: rng.randrange(len(data))] if rng.random() < 0.3 else data)
        return case.simulation(checkpoint=cut)

    def changed(rng: random.Random) -> object:
        """Change an existing set point."""
        name = rng.choice(
            ["rpm", "block_velocity", "weight_on_bit", "flow_rate", "friction", "ramp", "odd"]
        )
        setter: Callable[..., object] = rng.choice(sims).set
        return setter(**{name: odd(rng)})

    def advanced(rng: random.Random) -> None:
        time = odd(rng)
        # Long valid times are shortened.
        small: dict[Any, Any] = {"10 s": "0.1 s", 10**400: 1e-3}
        small |= dict.fromkeys((1e300, 2**63, 1, 0.3), 1e-3)
        try:
            time = small.get(time, time)
        except TypeError:
            pass
        if isinstance(time, Quantity | bool):
            time = 1e-3
        which = rng.randrange(len(sims))
        try:
            sims[which].advance(time)
        except ws.NoAnswerError:
            # A diverged simulation remains so; replace it from the checkpoint.
            sims[which] = case.simulation(checkpoint=checkpoint)
            raise

    def reading(rng: random.Random) -> object:
        one = rng.choice(sims)
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
        return rng.choice(asks)()

    def lazily(read: Callable[[ws.Simulation], object]) -> Call:
        return lambda rng: read(rng.choice(sims))

    def law(answer: Any) -> Callable[[Any], Any]:
        return lambda reading: answer

    made = "Case.simulation"
    found.plain(10, 1, made, case.simulation)
    found.plain(30, 1, made, one(lambda value: case.simulation(checkpoint=value)))
    found.add(20, made, damaged)
    found.plain(15, 1, made, one(lambda rate: case.simulation(bit_law=law((1e-3, 1e3)), rate=rate)))
    found.plain(10, 1, made, one(lambda value: case.simulation(bit_law=law(value))))
    found.plain(10, 1, made, one(lambda value: case.simulation(excitation=law(value))))
    found.plain(10, 1, made, one(lambda value: case.simulation(bit_law=value)))
    found.plain(10, 1, made, one(lambda value: case.simulation(jobs=value)))
    found.add(900, "Simulation.set", changed)
    found.add(300, "Simulation.advance", advanced)
    found.add(2000, "reading", reading)
    found.add(300, "Simulation.since", lambda rng: rng.choice(sims).since(odd(rng)))
    found.add(20, "Simulation.forget", lambda rng: rng.choice(sims).forget(odd(rng)))
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
    """Add the methods with a long solution time, a few calls of each."""
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
    """Add every figure, with results that it can draw and with others."""
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
    for name in (name for name in ws.plot.__all__ if name != "Units"):
        function = getattr(ws.plot, name)

        def call(rng: random.Random, function: Any = function, name: str = name) -> object:
            every = inspect.signature(function).parameters.values()
            others = [one.name for one in every if one.kind is one.KEYWORD_ONLY]
            names = rng.sample(others, min(len(others), rng.randrange(3)))
            options = {one: odd(rng) for one in names}
            subject = odd(rng) if rng.random() < 0.3 else drawn[name]
            is_pair = name == "compare" and subject is drawn[name]
            try:
                return function(*pair, **options) if is_pair else function(subject, **options)
            finally:
                pyplot.close("all")

        found.add(6, f"plot.{name}", call)


# Exceptions that a caller may expect from odd arguments.
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
    """Make ``calls`` calls, and yield the name of each before it is made."""
    warnings.simplefilter("ignore")
    rng = random.Random(seed)
    chosen = targets()
    for call, (name, function) in enumerate(rng.choices(chosen.calls, chosen.weights, k=calls)):
        yield f"call {call}, {name}"
        try:
            function(rng)
        except ws.Error as error:
            # An error of the base class itself means that the engine panicked.
            if type(error) is ws.Error:
                raise
        except KNOWN:
            pass
        except RuntimeError as error:
            # Errors of `Liar` itself.
            if type(error) is not RuntimeError:
                raise


def main(calls: int, seed: int, trace: bool) -> None:
    """Make ``calls`` calls in this folder."""
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
    for name, item in reference.public():
        short = name.removeprefix("wholestring.")
        if not inspect.isclass(item):
            public.add(short)
            continue
        for member, one in reference.members(item):
            if inspect.isfunction(one):
                public.add(f"{short}.{member}")
    # A method of a protocol, implemented elsewhere.
    assert public - called == {"Quantity.to"}


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:] == ["trace"])
