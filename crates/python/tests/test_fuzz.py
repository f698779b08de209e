"""Odd arguments to everything that is public: a value or an exception of a known class, no crash.

The calls are seeded and made in a process of their own, so that one that ended the process would
fail this test and say which call it was.
"""

# Whatever is odd has no type that anybody knows.
# pyright: basic

import random
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

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


Target = tuple[int, int, str, Callable[..., Any]]


def targets(ws: Any) -> list[Target]:
    """Give what is called: how often, with how many arguments, by which name; none takes long."""
    from wholestring import _core, _values

    # Settings of the whole string take time to read: the short text is of a case that is wrong.
    case = ws.Case.example().with_({"mesh.element_length": 30.0, "operation.kind": "drill"})
    solved = case.soft()
    nodes = solved.table("nodes")
    sim = case.simulation()
    sim.advance(0.02)
    kept = sim.checkpoint()
    sims = [sim, case.simulation(checkpoint=kept)]

    def damaged(of: random.Random) -> bytes:
        data = bytearray(kept)
        for _ in range(of.randrange(1, 4)):
            data[of.randrange(len(data))] ^= 1 << of.randrange(8)
        return bytes(data[: of.randrange(len(data))] if of.random() < 0.3 else data)

    def changed(of: random.Random, *arguments: Any) -> Any:
        """Give it a set point that there is, or time that it takes a moment to pass."""
        name = of.choice(
            ["rpm", "block_velocity", "weight_on_bit", "flow_rate", "friction", "ramp", "odd"]
        )
        return of.choice(sims).set(**dict.fromkeys([name], arguments[0] if arguments else None))

    def advanced(of: random.Random) -> Any:
        time = odd(of)
        # What is a time at all would be waited for.
        small = {"10 s": "0.1 s", 1e300: 1e-3, 2**63: 1e-3, 10**400: 1e-3, 1: 1e-3, 0.3: 1e-3}
        try:
            time = small.get(time, time)
        except TypeError:
            pass
        if isinstance(time, Quantity | bool):
            time = 1e-3
        which = of.randrange(len(sims))
        try:
            return sims[which].advance(time)
        except ws.NoAnswerError:
            # One that diverged stays so: another, from where all was well.
            sims[which] = case.simulation(checkpoint=kept)
            raise

    def reading(of: random.Random) -> Any:
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

    def plain(call: Callable[..., Any]) -> Callable[..., Any]:
        return lambda of, *arguments: call(*arguments)

    def lazily(ask: Callable[[Any], Any]) -> Callable[..., Any]:
        return lambda of: ask(of.choice(sims))

    def law(answer: Any) -> Callable[[Any], Any]:
        return lambda reading: answer

    return [
        (1400, 2, "quantity", plain(_core.quantity)),
        (1400, 1, "time", plain(lambda of: _core.quantity(of, "time"))),
        (700, 1, "si_unit", plain(_core.si_unit)),
        (700, 1, "unit_of", plain(_core.unit_of)),
        (1400, 2, "si", plain(_values.si)),
        (1400, 1, "toml", plain(lambda value: _values.toml(value, "mud.density"))),
        (700, 1, "document", plain(_values.document)),
        (700, 2, "changes", plain(lambda one, two: list(_values.changes(one, two)))),
        (900, 1, "table[]", plain(nodes.__getitem__)),
        (900, 1, "table.unit", plain(nodes.unit)),
        (900, 1, "table.meaning", plain(nodes.meaning)),
        (300, 1, "in table", plain(nodes.__contains__)),
        (300, 0, "schema", plain(nodes.__arrow_c_schema__)),
        (300, 1, "stream", plain(nodes.__arrow_c_stream__)),
        (900, 1, "results[]", plain(solved.__getitem__)),
        (900, 1, "results.table", plain(solved.table)),
        (60, 1, "Results.load", plain(ws.Results.load)),
        (60, 1, "Case.load", plain(ws.Case.load)),
        (120, 1, "Case", plain(ws.Case)),
        (60, 1, "Case.from_dict", plain(ws.Case.from_dict)),
        (30, 2, "Case(files)", plain(lambda text, files: ws.Case(text, files=files))),
        (30, 1, "case.with_", plain(case.with_)),
        (
            20,
            1,
            "case.soft",
            plain(lambda of: case.soft(of) if isinstance(of, str) else case.soft(3)),
        ),
        (10, 1, "simulation", plain(lambda of: case.simulation(of))),
        (30, 1, "checkpoint", plain(lambda of: case.simulation(checkpoint=of))),
        (20, 0, "damaged", lambda of: case.simulation(checkpoint=damaged(of))),
        (15, 1, "rate", plain(lambda of: case.simulation(bit_law=law((1e-3, 1e3)), rate=of))),
        (10, 1, "bit_law", plain(lambda of: case.simulation(bit_law=law(of)))),
        (10, 1, "excitation", plain(lambda of: case.simulation(excitation=law(of)))),
        (10, 1, "no law", plain(lambda of: case.simulation(bit_law=of))),
        (900, 1, "set", changed),
        (300, 0, "advance", advanced),
        (2000, 0, "reading", reading),
        (300, 1, "since", lambda of, *one: of.choice(sims).since(*one)),
        (20, 0, "state", lazily(lambda one: one.state())),
        (10, 0, "sim.results", lazily(lambda one: one.results())),
        (10, 0, "history", lazily(lambda one: one.history)),
        (10, 0, "sim.checkpoint", lazily(lambda one: one.checkpoint())),
    ]


# What a caller may expect of odd arguments; `RuntimeError` is what a liar raises itself.
KNOWN = (
    TypeError,
    ValueError,
    KeyError,
    AttributeError,
    OverflowError,
    OSError,
    IndexError,
)


def fuzz(calls: int, seed: int) -> None:
    """Make so many calls, and say which would have been the last."""
    import warnings

    import wholestring as ws

    warnings.simplefilter("ignore")
    of = random.Random(seed)
    chosen = targets(ws)
    weights = [weight for weight, *_ in chosen]
    trace = sys.argv[3:] == ["trace"]
    for call, (_, count, name, function) in enumerate(of.choices(chosen, weights, k=calls)):
        given = count if of.random() < 0.95 else of.randrange(4)
        arguments = [odd(of) for _ in range(given)]
        if trace:
            print(call, name, flush=True)
        try:
            function(of, *arguments)
        except (*KNOWN, ws.Error):
            pass
        except RuntimeError as error:
            # The liar's own.
            if type(error) is not RuntimeError:
                raise
        except BaseException as error:
            raise SystemExit(f"call {call}, {name}: {type(error).__name__}: {error}") from error
    print(f"{calls} calls")


def test_odd_arguments_never_end_the_process() -> None:
    command = [sys.executable, __file__, str(CALLS), str(SEED)]
    found = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert found.returncode == 0, found.stderr[-2000:]
    assert found.stdout == f"{CALLS} calls\n", found.stdout + found.stderr[-2000:]


if __name__ == "__main__":
    fuzz(int(sys.argv[1]), int(sys.argv[2]))
