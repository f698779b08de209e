"""Free rods: natural frequencies, stretch, cantilevers that bend far; and how far a well can go."""

from __future__ import annotations

import math
from collections.abc import Iterator

from .problem import INCH_M, POUND_FORCE_N, Json, absolute, named, problem, read, relative, survey

FREQUENCIES = "Frequencies are those of small motions about the rod at rest, without damping."
TENTH = "0.1 %: what elements leave, and what the theory of thin beams leaves out"


def problems() -> Iterator[Json]:
    """Frequencies, stretch, cantilevers, reach."""
    yield from lateral()
    yield from along()
    yield from stretch()
    yield from end_moment()
    yield from tip_force()
    yield from reach()


def lateral() -> Iterator[Json]:
    file = "D09_linear_frequencies.json"
    data = read(file)
    of = data["pinned_pinned_DP"]["inputs"]
    rod = {
        "outside_diameter_m": of["OD"],
        "inside_diameter_m": of["ID"],
        "youngs_modulus_Pa": of["E"],
        "density_kg_per_m3": of["rho"],
    }
    for case in data["pinned_pinned_DP"]["cases"]:
        tension_N = case["axial_N"]
        yield problem(
            name=f"lateral-frequency-pinned-{named(round(tension_N / 1e3))}-kn",
            title=f"A pipe pinned at both ends under {tension_N / 1e3:.1f} kN",
            kind="lateral_frequency",
            file=file,
            source="closed form of Euler and Bernoulli's beam",
            assumptions=[
                FREQUENCIES,
                "No weight, no mud, no wall.",
                "No shear, no rotary inertia.",
            ],
            inputs={
                **rod,
                "length_m": of["L"],
                "upper_end": "pinned",
                "lower_end": "pinned",
                "tension_at_lower_end_N": tension_N,
                "gravity_m_per_s2": 0.0,
            },
            expected={"frequencies_Hz": relative(case["freq_Hz"], 1e-3, TENTH)},
        )
    hanging = data["hanging_chain_1000m_Hz"]
    found = hanging["with_EI_5in_DP_pinned_top_free_bottom_vacuum_Hz"]
    yield problem(
        name="lateral-frequency-hanging",
        title="A kilometre of pipe that hangs from a pin, its lower end free",
        kind="lateral_frequency",
        file=file,
        source="closed form of the hanging chain, with the bending stiffness counted",
        assumptions=[FREQUENCIES, "In vacuum, no wall."],
        inputs={
            **rod,
            "length_m": 1000.0,
            "upper_end": "pinned",
            "lower_end": "free",
            "tension_at_lower_end_N": 0.0,
            "gravity_m_per_s2": 9.80665,
        },
        expected={"frequencies_Hz": relative(found, 1e-3, TENTH)},
    )


def along() -> Iterator[Json]:
    file = "D09_linear_frequencies.json"
    data = read(file)
    of, pipe = data["fixed_free_1000m"], data["pinned_pinned_DP"]["inputs"]
    yield problem(
        name="axial-torsional-frequency-1000-m",
        title="A kilometre of pipe held at its top, its lower end free: along and around",
        kind="axial_torsional_frequency",
        file=file,
        source="closed form: odd quarters of the wave speed over the length",
        assumptions=[FREQUENCIES, "The top is held along and around; no mud, no wall."],
        inputs={
            "length_m": 1000.0,
            "outside_diameter_m": pipe["OD"],
            "inside_diameter_m": pipe["ID"],
            "youngs_modulus_Pa": of["inputs"]["E"],
            "shear_modulus_Pa": of["inputs"]["G"],
            "density_kg_per_m3": of["inputs"]["rho"],
        },
        expected={
            "axial_frequencies_Hz": relative(of["axial_Hz"], 1e-3, TENTH),
            "torsional_frequencies_Hz": relative(of["torsional_Hz"], 1e-3, TENTH),
        },
    )


def stretch() -> Iterator[Json]:
    file = "D09_linear_frequencies.json"
    data = read(file)
    hangs, pipe = data["hanging_stretch"], data["pinned_pinned_DP"]["inputs"]
    of = hangs["inputs"]
    for name, mud, stretch_m in (
        ("air", 0.0, hangs["vacuum_m"]),
        ("mud", of["rho_m"], hangs["in_mud_open_ended_m"]),
    ):
        yield problem(
            name=f"stretch-in-{name}",
            title=f"Stretch of a pipe of 3000 m that hangs in {name}",
            kind="stretch",
            file=file,
            source=f"closed form: {hangs['formula']}",
            assumptions=[
                "Open ends: the mud stands inside and outside, and its pressure acts on all.",
                "The pressure shortens and lengthens by Poisson's ratio.",
            ],
            inputs={
                "length_m": of["L"],
                "outside_diameter_m": pipe["OD"],
                "inside_diameter_m": pipe["ID"],
                "youngs_modulus_Pa": of["E"],
                "poisson_ratio": of["nu"],
                "density_kg_per_m3": of["rho_s"],
                "mud_density_kg_per_m3": mud,
                "gravity_m_per_s2": 9.80665,
            },
            expected={"stretch_m": relative(stretch_m, 1e-6, "closed form")},
        )


def end_moment() -> Iterator[Json]:
    file = "D01_cantilever_end_moment.json"
    data = read(file)
    of = data["inputs"]
    length_m = of["L_in"] * INCH_M
    stiffness = of["EI_lbf_in2"] * POUND_FORCE_N * INCH_M**2
    reason = "1e-4 of the length: elements of a sixteenth"
    for case in data["expected"]:
        yield problem(
            name=f"cantilever-moment-{named(case['lam'])}",
            title=f"A cantilever bent by an end moment of {case['lam']} pi EI/L",
            kind="cantilever",
            file=file,
            source="closed form, an arc; inputs of the example `tipmoment` of GXBeam.jl",
            assumptions=["Rotations are as large as they are; the arc keeps its length."],
            inputs={
                "length_m": length_m,
                "bending_stiffness_N_m2": stiffness,
                "end_moment_N_m": case["M"] * POUND_FORCE_N * INCH_M,
                "end_force_across_N": 0.0,
            },
            expected={
                "tip_along_m": absolute(case["tip_x"] * INCH_M, 1e-4 * length_m, reason),
                "tip_across_m": absolute(case["tip_y"] * INCH_M, 1e-4 * length_m, reason),
                "tip_angle_deg": absolute(math.degrees(case["tip_angle_rad"]), 0.01, reason),
            },
        )


def tip_force() -> Iterator[Json]:
    file = "D05_elastica_tip_force.json"
    reason = "1e-4 of the length: elements of a sixteenth"
    for row in read(file)["table"]:
        load = row["PL2_over_EI"]
        yield problem(
            name=f"cantilever-force-{named(load)}",
            title=f"A cantilever under a dead force at its tip of {load} EI/L^2",
            kind="cantilever",
            file=file,
            source="Bisshopp and Drucker (1945), elliptic integrals evaluated by ourselves",
            assumptions=["Rotations are as large as they are; the force keeps its direction."],
            inputs={
                "length_m": 1.0,
                "bending_stiffness_N_m2": 1000.0,
                "end_moment_N_m": 0.0,
                "end_force_across_N": 1000.0 * load,
            },
            expected={
                "tip_along_m": absolute(row["x_over_L"], 1e-4, reason),
                "tip_across_m": absolute(row["delta_over_L"], 1e-4, reason),
                "tip_angle_deg": absolute(row["tip_angle_deg"], 0.01, reason),
            },
        )


def reach() -> Iterator[Json]:
    file = "S5_reach.json"
    data = read(file)
    of, pipe = data["inputs"], data["inputs"]["pipe"]
    names = {
        "drilling_torque_limit_depth_m": "torque_limit_rotary_drilling_md_m",
        "rotating_torque_limit_depth_m": "torque_limit_off_bottom_md_m",
        "slack_off_zero_hook_load_depth_m": "zero_slackoff_hook_load_md_m",
        "sliding_zero_hook_load_depth_m": "zero_sliding_hook_load_with_WOB_md_m",
    }
    for case in data["cases"]:
        inc, friction = case["inputs"]["inc_deg"], case["inputs"]["mu"]
        end_m = case["inputs"]["eob_m"]
        stations = [(0, 0, 0), (of["kop_m"], 0, 0), (end_m, inc, 0)]
        yield problem(
            name=f"reach-inc-{named(inc)}-mu-{named(friction)}",
            title=f"How far a tangent of {inc:g} deg goes at friction {friction}",
            kind="reach",
            file=file,
            source="closed forms of the soft string, roots in depth",
            assumptions=[
                "Soft string in minimum curvature; the tangent goes on from the last station.",
                "The string is the same pipe to the surface; friction acts at the contact radius.",
                "Compression does not buckle the string: no helix presses on the wall.",
                "Hook load is without the block; the depth is the first at which the limit is met.",
            ],
            inputs={
                "survey": survey(stations),
                "hole_diameter_m": of["hole_m"],
                "friction_factor": friction,
                "outside_diameter_m": pipe["od"],
                "inside_diameter_m": pipe["id"],
                "weight_in_mud_N_per_m": pipe["w"],
                "contact_radius_m": of["contact_radius_m"],
                "weight_on_bit_N": of["WOB_N"],
                "bit_torque_N_m": of["bit_torque_Nm"],
                "torque_limit_N_m": of["top_drive_limit_Nm"],
            },
            expected={
                new: relative(case["expected"][old], 3e-3, "0.3 %: elements of 30 m")
                for new, old in names.items()
            },
        )
