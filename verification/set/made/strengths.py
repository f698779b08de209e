"""What pipe bears: yield of its body, margin of overpull, stresses, wear of its casing."""

from __future__ import annotations

from collections.abc import Iterator

from .problem import (
    INCH_M,
    POUND_FORCE_N,
    FOOT_POUND_N_m,
    Json,
    PSI_Pa,
    named,
    problem,
    read,
    relative,
)

YIELD = "Tension at yield is the cross-section times the minimum yield strength."
SHEAR = "In torsion the outer surface yields at 0.577 of the yield strength (API RP 7G)."
UNDER = "Under tension P it yields in torsion at J/R 0.577 sqrt(Y^2 - (P/A)^2)."
CONSTANT = "0.577 against 1/sqrt(3) is 0.06 %"
FORMULA = "formula; six digits are what programs print"


def problems() -> Iterator[Json]:
    """Bodies, tension with torsion, overpull, stresses, casing wear."""
    yield from bodies()
    yield from tension_and_torsion()
    yield from overpull()
    yield from stresses()
    yield from wear()


def body(outside_in: float, inside_in: float, yield_psi: float) -> Json:
    return {
        "outside_diameter_m": outside_in * INCH_M,
        "inside_diameter_m": inside_in * INCH_M,
        "yield_strength_Pa": yield_psi * PSI_Pa,
    }


def bodies() -> Iterator[Json]:
    file = "A05_drill_pipe_strength.json"
    grades_psi = {"E75": 75e3, "X95": 95e3, "G105": 105e3, "S135": 135e3}
    for row in read(file)["rows"]:
        inside_in = row["OD_in"] - 2 * row["wall_in"]
        size = row["pipe"].removesuffix(" ppf")
        name = f"{size}-{row['grade']}".replace(" in ", "-").replace("/", "-")
        tension_N = row["tensile_yield_lbf"] * POUND_FORCE_N
        torque_N_m = row["torsional_yield_ftlbf"] * FOOT_POUND_N_m
        yield problem(
            name="pipe-strength-" + name.replace(".", "-").lower(),
            title=f"Drill pipe {size} lb/ft {row['grade']}: yield in tension and in torsion",
            kind="pipe_strength",
            file=file,
            source="formulas of API RP 7G, evaluated by ourselves",
            assumptions=["New pipe, nominal dimensions, body without upsets.", YIELD, SHEAR],
            inputs=body(row["OD_in"], inside_in, grades_psi[row["grade"]]),
            expected={
                "tensile_yield_N": relative(tension_N, 1e-6, FORMULA),
                "torsional_yield_N_m": relative(torque_N_m, 1e-3, CONSTANT),
            },
        )


def tension_and_torsion() -> Iterator[Json]:
    file = "S3b_torque_under_tension_overpull.json"
    cases = read(file)["cases"]
    for pipe in dict.fromkeys(case["inputs"]["pipe"] for case in cases):
        rows = [case for case in cases if case["inputs"]["pipe"] == pipe]
        of, found = rows[0]["inputs"], rows[0]["expected"]
        torques = [row["expected"]["torque_under_tension_Nm"] for row in rows]
        state = pipe.rsplit("_", 1)[1]
        yield problem(
            name=f"pipe-strength-under-tension-{state}",
            title=f"Drill pipe 5 in 19.50 lb/ft S135, {state}: yield in torsion under tension",
            kind="pipe_strength",
            file=file,
            source="formulas of API RP 7G, evaluated by ourselves",
            assumptions=[
                "The dimensions are those of the pipe as it is; premium pipe is worn outside.",
                YIELD,
                SHEAR,
                UNDER,
            ],
            inputs={
                **body(of["od_in"], of["id_in"], of["yield_psi"]),
                "tensions_N": [row["inputs"]["tension_lbf"] * POUND_FORCE_N for row in rows],
            },
            expected={
                "tensile_yield_N": relative(found["tensile_yield_N"], 1e-6, FORMULA),
                "torsional_yield_N_m": relative(
                    found["torsional_yield_ftlbf"] * FOOT_POUND_N_m, 1e-3, CONSTANT
                ),
                "torsional_yield_under_tension_N_m": relative(torques, 1e-3, CONSTANT),
            },
        )


def overpull() -> Iterator[Json]:
    file = "S3b_torque_under_tension_overpull.json"
    data = read(file)
    pipes = {case["inputs"]["pipe"]: case["inputs"] for case in data["cases"]}
    for case in data["overpull"]:
        of = case["inputs"]
        pipe, load_lbf = pipes[of["pipe"]], of["static_hook_load_at_top_of_pipe_lbf"]
        part, state = of["design_factor_on_yield"], of["pipe"].rsplit("_", 1)[1]
        yield problem(
            name=f"overpull-{state}-{load_lbf / 1e3:.0f}-klbf-{named(part)}",
            title=f"Margin of overpull of {state} drill pipe that carries {load_lbf:.0f} lbf",
            kind="overpull",
            file=file,
            source="formulas of API RP 7G, evaluated by ourselves",
            assumptions=[
                YIELD,
                "The margin is the part of the yield that is allowed less the load.",
            ],
            inputs={
                **body(pipe["od_in"], pipe["id_in"], pipe["yield_psi"]),
                "hook_load_N": load_lbf * POUND_FORCE_N,
                "allowed_part_of_yield": part,
            },
            expected={
                "margin_of_overpull_N": relative(
                    case["expected"]["margin_of_overpull_N"], 1e-6, FORMULA
                )
            },
        )


def stresses() -> Iterator[Json]:
    file = "S3a_von_mises_points.json"
    for case in read(file)["cases"]:
        of, found = case["inputs"], case["expected"]
        yield problem(
            name="pipe-stress-" + case["id"].lower().replace("_", "-"),
            title="Stresses of a pipe under tension, bending, torque and pressures: "
            + case["id"].replace("_", " "),
            kind="pipe_stress",
            file=file,
            source="closed forms of Lame, evaluated by ourselves",
            assumptions=[
                "Tension is effective tension; the force in the metal adds p_i A_i - p_o A_o.",
                "Thick wall by Lame, bending M r / I, torsion T r / J, all at the same place.",
            ],
            inputs={
                "outside_diameter_m": of["od_m"],
                "inside_diameter_m": of["id_m"],
                "effective_tension_N": of["effective_tension_N"],
                "bending_moment_N_m": of["bending_moment_Nm"],
                "torque_N_m": of["torque_Nm"],
                "pressure_inside_Pa": of["p_inside_Pa"],
                "pressure_outside_Pa": of["p_outside_Pa"],
                "yield_strength_Pa": of["yield_Pa"],
            },
            expected={
                "force_in_metal_N": relative(found["true_axial_force_N"], 1e-6, FORMULA),
                "largest_von_mises_stress_Pa": relative(found["max_von_mises_Pa"], 1e-6, FORMULA),
                "safety_factor": relative(found["safety_factor"], 1e-6, FORMULA),
            },
        )


def wear() -> Iterator[Json]:
    file = "S6_casing_wear.json"
    for number, case in enumerate(read(file)["cases"], 1):
        of, found = case["inputs"], case["expected"]
        names = {
            "volume_m3_per_m": "volume_m3_per_m",
            "groove_depth_m": "groove_depth_m",
        }
        yield problem(
            name=f"casing-wear-{number}",
            title=f"Groove that tool joints wear into casing {of['casing'].replace('_', ' ')} "
            f"in {of['hours']} h",
            kind="casing_wear",
            file=file,
            source="the wear-factor model and a crescent between two circles, closed forms",
            assumptions=[
                "Volume per metre of casing: wear factor times side force per metre of string "
                "times the way of the tool joint's surface.",
                "The groove is the crescent that a circle of the tool joint's size cuts.",
                "The tool joints pass all of the casing; the factor does not change with depth.",
            ],
            inputs={
                "casing_outside_diameter_m": of["casing_od_m"],
                "casing_inside_diameter_m": of["casing_id_m"],
                "tool_joint_diameter_m": of["tool_joint_od_m"],
                "wear_factor_per_Pa": of["wear_factor_1_per_Pa"],
                "side_force_N_per_m": of["side_force_N_per_m_of_pipe"],
                "rotary_speed_rev_per_min": of["rpm"],
                "time_s": of["hours"] * 3600,
            },
            expected={new: relative(found[old], 1e-6, FORMULA) for new, old in names.items()},
        )
