"""Buckling: loads at which a pipe leaves its straight course in its hole, and lock-up."""

from __future__ import annotations

from collections.abc import Iterator

from .problem import Json, named, problem, read, relative

SINUSOID = "Sinusoid of Dawson and Paslay: F^2 = 4 EI q / r, q the side force per length."
HELIX = "Helix of Chen, Lin and Cheatham: F^2 = 8 EI q / r."
FULL = "Finished helix of Wu and Juvkam-Wold: 2 (2 sqrt 2 - 1) sqrt(EI w sin(inc) / r)."
SIDE = (
    "In a curved hole q is that of weight and compression together, "
    "sqrt((w sin(inc) + F build)^2 + (F sin(inc) turn)^2) (He and Kyllingstad); "
    "the load is the smallest compression that fulfils it."
)
LOADS = "Loads are compressions, positive; no friction, no torque, no tool joints."
REASON = "closed form, or the root of one equation; six digits are what programs print"


def problems() -> Iterator[Json]:
    """Straight holes, curved holes, places along a well, lock-up."""
    yield from straight()
    yield from curved()
    yield from along_a_well()
    yield from lock_up()


def place(pipe: Json, weight: float, hole_m: float, inc: float, build: float, turn: float) -> Json:
    """A pipe at a place of its hole."""
    return {
        "outside_diameter_m": pipe["outside_m"],
        "inside_diameter_m": pipe["inside_m"],
        "youngs_modulus_Pa": pipe["youngs_modulus_Pa"],
        "weight_in_mud_N_per_m": weight,
        "hole_diameter_m": hole_m,
        "inclination_deg": inc,
        "build_rate_deg_per_30m": build,
        "turn_rate_deg_per_30m": turn,
    }


def straight() -> Iterator[Json]:
    file = "C01_straight_hole_critical_loads.json"
    names = {
        "sinusoidal_load_N": "F_sin_DawsonPaslay_N",
        "helical_load_N": "F_hel_sqrt2_ChenLinCheatham_N",
        "full_helix_load_N": "F_hel_2sqrt2minus1_Wu_N",
        "sinusoidal_wavelength_m": "sin_wavelength_m",
    }
    for number, case in enumerate(read(file)["cases"], 1):
        of = case["inputs"]
        pipe = {
            "outside_m": of["OD_m"],
            "inside_m": of["ID_m"],
            "youngs_modulus_Pa": of["E_Pa"],
        }
        yield problem(
            name=f"buckling-straight-{number}",
            title=f"Critical loads in a straight hole: {case['id']}",
            kind="buckling_load",
            file=file,
            source="formulas of Dawson and Paslay (1984), Chen, Lin and Cheatham (1990), "
            "Wu and Juvkam-Wold (1993)",
            assumptions=[SINUSOID, HELIX, FULL, LOADS],
            inputs=place(pipe, of["buoyed_w_N_m"], of["hole_m"], of["inc_deg"], 0, 0),
            expected={
                new: relative(case["expected"][old], 1e-6, REASON) for new, old in names.items()
            },
        )


def curved() -> Iterator[Json]:
    file = "C03_curved_hole_he_kyllingstad.json"
    # The file has the bending stiffness and the clearance of this pipe in this hole.
    of = read("C01_straight_hole_critical_loads.json")["cases"][0]["inputs"]
    pipe = {"outside_m": of["OD_m"], "inside_m": of["ID_m"], "youngs_modulus_Pa": of["E_Pa"]}
    places: dict[tuple[float, float, float], Json] = {}
    for case in read(file)["cases"]:
        row = case["inputs"]
        if abs(row["EI"] / (of["E_Pa"] * of["I_m4"]) - 1) > 1e-9 or row["r_c"] != of["clearance_m"]:
            raise ValueError(f"{file} has another pipe")
        key = (row["inc_deg"], row["build_deg_per_30m"], row["turn_deg_per_30m"])
        name = {"sin": "sinusoidal_load_N", "hel": "helical_load_N"}[row["mode"]]
        load_N = case["expected"]["F_crit_N"]
        made = places.setdefault(key, {"weight": row["w"], "expected": {}})
        made["expected"][name] = relative(load_N, 1e-6, REASON)
    for (inc, build, turn), made in places.items():
        yield problem(
            name=f"buckling-curved-inc-{named(inc)}-build-{named(build)}-turn-{named(turn)}",
            title=f"Critical loads at {inc} deg where the hole builds {build} and turns {turn} "
            "deg/30 m",
            kind="buckling_load",
            file=file,
            source="criterion of He and Kyllingstad (1995), evaluated by ourselves",
            assumptions=[SINUSOID, HELIX, SIDE, LOADS],
            inputs=place(pipe, made["weight"], of["hole_m"], inc, build, turn),
            expected=made["expected"],
        )


def along_a_well() -> Iterator[Json]:
    file = "S2a_buckling_along_string.json"
    data = read(file)
    of = data["inputs"]
    pipe = {
        "outside_m": of["pipe"]["od"],
        "inside_m": of["pipe"]["id"],
        "youngs_modulus_Pa": of["pipe"]["E"],
    }
    weight, hole_m = of["pipe"]["w"], of["hole_m"]
    rates = of["well_segments_from_to_inc0_deg_rate_deg_30m"]
    rows = []
    for row in data["critical"]:
        # Beside the ends of the well's parts the places say nothing new.
        if row["md_m"] % 100 or not row["inc_deg"]:
            continue
        [rate] = [rate for from_m, to_m, _, rate in rates if from_m < row["md_m"] <= to_m]
        loads = (row["F_sin_all_roots_N"], row["F_hel_HeKyllingstad_beta8_all_roots_N"])
        rows.append((f"at-{row['md_m']}-m", row["inc_deg"], rate, *loads))
    for row in data["strong_drop_points"]:
        rate, loads = row["inputs"]["build_deg_30m"], row["expected"]
        name = f"drop-{named(-rate)}"
        roots = (loads["F_sin_all_roots_N"], loads["F_hel_all_roots_N"])
        rows.append((name, row["inputs"]["inc_deg"], rate, *roots))
    for name, inc, rate, sinusoidal_N, helical_N in rows:
        yield problem(
            name=f"buckling-along-a-well-{name}",
            title=f"Critical loads at {inc:.4g} deg where the hole builds {rate} deg/30 m",
            kind="buckling_load",
            file=file,
            source="criterion of He and Kyllingstad (1995), evaluated by ourselves",
            assumptions=[SINUSOID, HELIX, SIDE, LOADS],
            inputs=place(pipe, weight, hole_m, inc, rate, 0),
            expected={
                "sinusoidal_load_N": relative(min(sinusoidal_N), 1e-6, REASON),
                "helical_load_N": relative(min(helical_N), 1e-6, REASON),
            },
        )


def lock_up() -> Iterator[Json]:
    file = "S2b_lockup_horizontal.json"
    data = read(file)
    pipe = data["inputs"]["pipe"]
    for case in data["cases"]:
        of, found = case["inputs"], case["expected"]
        rule = {"ChenLinCheatham": "chen", "WuJuvkamWold": "wu"}[of["F_hel_rule"]]
        reason = "closed form, quadrature and integration agree; elements of 10 m leave less"
        yield problem(
            name=f"lock-up-{rule}-bit-{named(of['F_at_bit_N'] / 1e3)}-kn",
            title=f"Lock-up of a string in a level hole, {of['F_at_bit_N'] / 1e3:g} kN at the bit",
            kind="lock_up",
            file=file,
            source="closed form of the push of a helix; formula in the file",
            assumptions=[
                "Level straight hole; the string slides and does not turn.",
                "Below the load of the helix the wall bears w, beyond it w + r F^2 / (4 EI).",
                {"chen": HELIX, "wu": FULL}[rule] + " It is given as `helical_load_N`.",
                "The string locks up at the length at which the push grows without bound.",
            ],
            inputs={
                "outside_diameter_m": pipe["od"],
                "inside_diameter_m": pipe["id"],
                "youngs_modulus_Pa": pipe["E"],
                "weight_in_mud_N_per_m": pipe["w"],
                "hole_diameter_m": data["inputs"]["hole_m"],
                "friction_factor": of["mu"],
                "compression_at_bit_N": of["F_at_bit_N"],
                "helical_load_N": of["F_hel_N"],
                "helix_criterion": {"chen": "chen-lin-cheatham", "wu": "wu-juvkam-wold"}[rule],
                "length_m": 0.9 * found["lockup_length_m"],
            },
            expected={
                "push_N": relative(found["F_at_0p9_L_N"], 1e-3, reason),
                "lock_up_length_m": relative(found["lockup_length_m"], 1e-3, reason),
            },
        )
