"""Beams in their hole: assemblies on stabilisers, pipe on its tool joints."""

from __future__ import annotations

import math
from collections.abc import Iterator

from .problem import Json, absolute, named, problem, read, relative

RIGID = "The wall is rigid and has no friction."
SHEAR = "1 % of the largest force: a beam with shear differs from one without by up to that"
HIGH = "Forces are those of the string on the wall, positive towards the high side."


def problems() -> Iterator[Json]:
    """Assemblies, pendulums, joints in builds."""
    yield from assemblies()
    yield from pendulums()
    yield from joints()
    yield from weightless_joints()


def assemblies() -> Iterator[Json]:
    file = "S1b_bha_stabilisers_straight_hole.json"
    data = read(file)
    of = data["inputs"]
    collar = of["collar"]
    for case in data["cases"]:
        found = case["expected"]
        bit_N = found["bit_side_force_on_rock_N_pos_high"]
        blades_N = found["stabiliser_force_on_wall_N_pos_high"]
        most_N = 0.01 * max(map(abs, [bit_N, *blades_N]))
        tilt_deg = -math.degrees(found["bit_axis_slope_dy_dx_up_from_bit"])
        expected = {
            "bit_side_force_N": absolute(bit_N, most_N, SHEAR),
            "bit_tilt_deg": absolute(tilt_deg, math.degrees(2e-5), "what shear changes; 2e-5 rad"),
            "tangency_from_bit_m": absolute(
                found["tangency_from_bit_m"], 0.15, "what shear changes"
            ),
            "largest_bending_moment_N_m": relative(found["max_abs_moment_Nm"], 0.01, SHEAR),
        }
        if blades_N:
            expected["stabiliser_side_forces_N"] = absolute(blades_N, most_N, SHEAR)
        yield problem(
            name="assembly-" + case["id"].lower().replace("_", "-").replace(".", "-"),
            title="Collars and stabilisers in a straight hole: " + case["id"].replace("_", " "),
            kind="assembly",
            file=file,
            source="our own collocation with free boundaries, to 1e-9",
            assumptions=[
                RIGID,
                HIGH,
                "The bit is hinged on the hole's axis; its tilt is that of the string there, "
                "positive where it points to the high side.",
                "A stabiliser is a point of its diameter without stiffness or weight of its own.",
                "Tension is -weight on bit at the bit and grows by w cos(inc) upwards.",
                "Collars go on upwards; they lie down on the low side at the tangency.",
            ],
            inputs={
                "hole_diameter_m": of["hole_diameter_m"],
                "inclination_deg": case["inputs"]["inc_deg"],
                "weight_on_bit_N": case["inputs"]["WOB_N"],
                "outside_diameter_m": collar["od"],
                "inside_diameter_m": collar["id"],
                "youngs_modulus_Pa": collar["E"],
                "shear_modulus_Pa": collar["G"],
                "weight_in_mud_N_per_m": collar["w"],
                "stabiliser_diameter_m": of["stabiliser_od_m"],
                "stabilisers_from_bit_m": case["inputs"]["stabilisers_from_bit_m"],
            },
            expected=expected,
        )


def pendulums() -> Iterator[Json]:
    file = "C05_stiff_string_contact.json"
    sizes = {"8in": (0.2032, 0.0714375, 0.31115), "6.5in": (0.1651, 0.0714375, 0.2159)}
    reason = "2 %: the closed form leaves out tension and shear"
    for row in read(file)["pendulum"]["rows"]:
        of, found = row["inputs"], row["expected"]
        outside_m, inside_m, hole_m = sizes[row["id"].split()[1]]
        inertia_m4 = math.pi / 64 * (outside_m**4 - inside_m**4)
        bit_N = -found["bit_side_force_N"]
        inclination = math.radians(of["inc_deg"])
        yield problem(
            name="assembly-slick-" + row["id"].split()[1].replace(".", "-"),
            title="A slick assembly that hangs above its bit: " + row["id"],
            kind="assembly",
            file=file,
            source="closed form of Lubinski: L^4 = 24 EI c / q, force q L / 2",
            assumptions=[RIGID, HIGH, "The bit is hinged on the hole's axis.", "No tension."],
            inputs={
                "hole_diameter_m": hole_m,
                "inclination_deg": of["inc_deg"],
                "weight_on_bit_N": of["WOB"],
                "outside_diameter_m": outside_m,
                "inside_diameter_m": inside_m,
                "youngs_modulus_Pa": of["EI"] / inertia_m4,
                "shear_modulus_Pa": of["EI"] / inertia_m4 / 2.6,
                "weight_in_mud_N_per_m": of["q_lateral"] / math.sin(inclination),
                "stabiliser_diameter_m": hole_m,
                "stabilisers_from_bit_m": [],
            },
            expected={
                "bit_side_force_N": relative(bit_N, 0.02, reason),
                "tangency_from_bit_m": relative(found["tangency_length_m"], 0.02, reason),
                "largest_bending_moment_N_m": relative(found["max_moment_Nm"], 0.02, reason),
            },
        )


def span(pipe: Json, weight: float, half_m: float, rate: float, inc: float, tension: float) -> Json:
    """A pipe between its tool joints."""
    return {
        "outside_diameter_m": pipe["od"],
        "inside_diameter_m": pipe["id"],
        "youngs_modulus_Pa": pipe["E"],
        "weight_in_mud_N_per_m": weight,
        "tool_joint_diameter_m": pipe["joint"],
        "tool_joint_spacing_m": 2 * half_m,
        "hole_diameter_m": pipe["hole"],
        "build_rate_deg_per_30m": rate,
        "inclination_deg": inc,
        "tension_N": tension,
    }


JOINTS = [
    RIGID,
    "Tool joints are points at equal distances, without stiffness or weight of their own.",
    "All spans are alike: at a joint the string has the direction of the hole.",
    "The tension is that at the place and the same all along the span.",
]


def joints() -> Iterator[Json]:
    file = "S1a_tool_joints_in_build.json"
    data = read(file)
    pipe = {**data["inputs"]["pipe"], "joint": data["inputs"]["tool_joint_od_m"]}
    pipe["hole"] = data["inputs"]["hole_m"]
    reason = "1 %: shear, elements of 1 to 2 m"
    for row in data["periodic"]:
        of, found = row["inputs"], row["expected"]
        force_N = found["TJ_force_on_wall_N_pos_high"]
        bending = pipe["EI"] * found["curvature_at_TJ"]
        middle = pipe["EI"] * found["curvature_mid"]
        given = (of["dls_deg_30m"], of["inc_deg"], of["T_N"])
        expected = {
            "moment_at_joint_N_m": relative(bending, 0.01, reason),
            "moment_between_joints_N_m": absolute(middle, 0.01 * bending, reason),
        }
        if found["regime"] == "none":
            expected["joint_side_force_N"] = relative(force_N, 0.01, reason)
        yield problem(
            name=f"joints-{of['T_N'] / 1e3:.0f}-kn-{named(given[0])}-deg-inc-{named(given[1])}",
            title=f"Pipe between its tool joints under {of['T_N'] / 1e3:.0f} kN in a build of "
            f"{given[0]} deg/30 m at {given[1]} deg: {found['regime']} contact of the body",
            kind="joint_bending",
            file=file,
            source="closed form; where the body touches, our own boundary value problem",
            assumptions=[*JOINTS, "The body touches the wall where it sags as far."],
            inputs=span(pipe, pipe["w"], of["half_spacing_m"], *given),
            expected=expected,
        )


def weightless_joints() -> Iterator[Json]:
    file = "C05_stiff_string_contact.json"
    case = read("C01_straight_hole_critical_loads.json")["cases"][0]["inputs"]
    pipe = {"od": case["OD_m"], "id": case["ID_m"], "E": case["E_Pa"]}
    reason = "1 %: shear, elements of 1 to 2 m"
    for row in read(file)["tool_joint_curved_hole"]["rows"]:
        of, found = row["inputs"], row["expected"]
        bending = of["EI"] * found["curvature_TJ_rad_m"]
        middle = of["EI"] * found["mid_curvature_rad_m"]
        # So thick that the body stays off the wall, as the closed form has it.
        wide = {**pipe, "joint": 0.3, "hole": 0.35}
        given = (of["dls_deg_30m"], 90, of["T_N"])
        yield problem(
            name=f"joints-weightless-{of['T_N'] / 1e3:.0f}-kn-{named(given[0])}-deg",
            title=f"Weightless pipe between its tool joints under {of['T_N'] / 1e3:.0f} kN in "
            f"a build of {given[0]} deg/30 m",
            kind="joint_bending",
            file=file,
            source="closed form of Lubinski (1961) and Paslay and Cernocky (1991)",
            assumptions=[*JOINTS, "The body does not touch the wall."],
            inputs=span(wide, 0.0, of["half_joint_m"], *given),
            expected={
                "moment_at_joint_N_m": relative(bending, 0.01, reason),
                "moment_between_joints_N_m": absolute(middle, 0.01 * bending, reason),
                "joint_side_force_N": relative(found["TJ_side_force_N"], 0.01, reason),
            },
        )
