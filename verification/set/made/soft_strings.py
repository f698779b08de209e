"""The soft string: hook load, torque and side force of strings without bending stiffness."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from .problem import Json, absolute, area_m2, named, problem, read, relative, survey

SOFT = "Soft string: no bending stiffness, the string touches the wall all along."
WEIGHT = "The weight in mud is given; nothing else of the mud acts."
RADIUS = "Friction acts at the contact radius that is given; bit and joints have no other."
PATH = "Between stations the hole is an arc of a circle (minimum curvature)."
HOOK = "Hook load is the effective tension at the top of the string, without block or top drive."
PUSH = "Compression does not buckle the string: no helix presses on the wall."
TURNS = "While the string only turns, all friction acts around the hole and none along it."
ALL = [SOFT, WEIGHT, RADIUS, PATH, HOOK, PUSH, TURNS]

STRAIGHT = "closed form; in a straight hole the length of the elements does not matter"
LUMPED = "what elements of 30 m may leave; a fine integration comes within 1e-6"
HOLE_m = 0.22


def problems() -> Iterator[Json]:
    """Closed forms, then whole wells."""
    yield from closed_forms()
    yield from whole_wells()


def inputs(stations: Any, friction: float, string: list[Json], **more: float) -> Json:
    return {
        "survey": survey(stations),
        "hole_diameter_m": HOLE_m,
        "friction_factor": friction,
        "string": string,
        **more,
    }


def pipe(length_m: float, weight_N_per_m: float, radius_m: float = 0.07) -> list[Json]:
    """A pipe of one piece. Diameters follow from the radius; a soft string has no use for them."""
    return [
        {
            "name": "pipe",
            "length_m": length_m,
            "outside_diameter_m": 2 * radius_m,
            "inside_diameter_m": 1.5 * radius_m,
            "weight_in_mud_N_per_m": weight_N_per_m,
            "contact_radius_m": radius_m,
        }
    ]


def closed_forms() -> Iterator[Json]:
    file = "A01_soft_string_closed_forms.json"
    for case in read(file)["cases"]:
        made = closed_form(case["id"], case["inputs"], case["expected"])
        title, given, expected = made
        yield problem(
            name="soft-string-" + case["id"].lower().replace("_", "-").replace(".", "-"),
            title=title,
            kind="soft_string",
            file=file,
            source="closed form: " + case.get("formula", "the push and the friction of the weight"),
            assumptions=ALL,
            inputs=given,
            expected=expected,
        )


def closed_form(name: str, of: Json, expected: Json) -> tuple[str, Json, Json]:
    """Title, inputs and expected numbers of a closed form."""
    if name == "vertical_hang":
        length_m = of["L_m"]
        given = inputs(
            [(0, 0, 0), (length_m, 0, 0)],
            0.3,
            pipe(length_m, of["w_N_per_m"]),
            weight_on_bit_N=of["WOB_N"],
            bit_torque_N_m=0.0,
        )
        return (
            "A pipe that stands on its bit in a vertical hole",
            given,
            {
                "drilling_hook_load_N": relative(expected["hookload_N"], 1e-6, STRAIGHT),
                "drilling_torque_N_m": absolute(expected["torque_Nm"], 1.0, STRAIGHT),
            },
        )
    if name.startswith("slant"):
        stations = [(0, of["inc_deg"], 0), (of["L_m"], of["inc_deg"], 0)]
        string = pipe(of["L_m"], of["w_N_per_m"], of["r_m"])
        names = {
            "pick_up_hook_load_N": "pickup_N",
            "slack_off_hook_load_N": "slackoff_N",
            "rotating_hook_load_N": "rotating_N",
            "rotating_torque_N_m": "torque_Nm",
        }
        return (
            f"A straight hole of {of['inc_deg']} deg, friction {of['mu']}",
            inputs(stations, of["mu"], string),
            {new: relative(expected[old], 1e-6, STRAIGHT) for new, old in names.items()},
        )
    if name == "critical_angle_no_self_slide":
        inc, length_m, weight = expected["inc_deg"], 2000.0, 300.0
        return (
            "A string in a straight hole at the inclination at which it just slides down",
            inputs([(0, inc, 0), (length_m, inc, 0)], of["mu"], pipe(length_m, weight)),
            {"slack_off_hook_load_N": absolute(0.0, 1e-6 * weight * length_m, STRAIGHT)},
        )
    if name == "horizontal_push_unbuckled":
        given = inputs(
            [(0, 90, 0), (of["L_m"], 90, 0)],
            of["mu"],
            pipe(of["L_m"], of["w_N_per_m"]),
            weight_on_bit_N=of["WOB_N"],
            bit_torque_N_m=0.0,
        )
        return (
            "A string that is pushed along a level hole onto its bit",
            given,
            {"sliding_hook_load_N": relative(expected["axial_at_heel_N"], 1e-6, STRAIGHT)},
        )
    if name == "capstan_weightless":
        length_m = 600.0
        given = inputs(
            [(0, 0, 0), (length_m, of["dogleg_deg"], 0)],
            of["mu"],
            pipe(length_m, 0.0, of["r_m"]),
            tension_at_bit_N=of["F_bottom_N"],
        )
        reason = "closed form; what elements of 30 m may leave"
        return (
            "A weightless string under tension in an arc: Euler's capstan",
            given,
            {
                "pick_up_hook_load_N": relative(expected["pull_top_N"], 5e-3, reason),
                "slack_off_hook_load_N": relative(expected["lower_top_N"], 5e-3, reason),
                "rotating_torque_N_m": relative(expected["rot_torque_Nm"], 5e-3, reason),
            },
        )
    if name.startswith("build_arc"):
        return build_arc(name, of, expected)
    if name.startswith("combined_motion"):
        length_m, speed = 1000.0, of["rpm"] * 2 * math.pi / 60
        given = inputs(
            [(0, 90, 0), (length_m, 90, 0)],
            of["mu"],
            pipe(length_m, of["N_N"] / length_m, of["r_m"]),
            rotary_speed_rad_per_s=speed,
            axial_speed_m_per_s=of["rop_m_per_h"] / 3600,
        )
        reason = "closed form: friction opposes the resultant of sliding and turning"
        return (
            f"A string that turns at {of['rpm']} rev/min and goes down {of['rop_m_per_h']} m/h",
            given,
            {
                "reaming_hook_load_N": relative(-expected["axial_drag_N"], 1e-6, reason),
                "reaming_torque_N_m": relative(expected["torque_Nm"], 1e-6, reason),
            },
        )
    raise ValueError(f"{name} has no problem")


def build_arc(name: str, of: Json, expected: Json) -> tuple[str, Json, Json]:
    """An arc with weight, pulled at its lower end."""
    angle = of["inc_bottom_deg"] - of["inc_top_deg"]
    length_m = of["R_m"] * math.radians(angle)
    given = inputs(
        [(0, of["inc_top_deg"], 0), (length_m, of["inc_bottom_deg"], 0)],
        of["mu"],
        pipe(length_m, of["w_N_per_m"]),
        tension_at_bit_N=of["F_bottom_N"],
    )
    operation = "pick_up" if "pull" in name else "slack_off"
    numbers = {f"{operation}_hook_load_N": relative(expected["F_top_N"], 5e-3, LUMPED)}
    if "switch_inclination_deg" in expected:
        numbers[f"{operation}_side_change_inclination_deg"] = absolute(
            expected["switch_inclination_deg"], 0.5, "elements of 3 m are so much of the arc"
        )
    motion = "pulled" if operation == "pick_up" else "lowered"
    pull_kN = of["F_bottom_N"] / 1e3
    return f"A string {motion} in a build under {pull_kN:g} kN, friction {of['mu']}", given, numbers


def whole_wells() -> Iterator[Json]:
    file = "A02_np13_like_synthetic_well.json"
    well = read(file)
    string = [
        {
            "name": part["name"],
            "length_m": part["len"],
            "outside_diameter_m": part["OD"],
            "inside_diameter_m": part["ID"],
            "weight_in_mud_N_per_m": part["w"],
            "contact_radius_m": part["r"],
        }
        for part in well["string_from_bit_up"]
    ]
    operations = {
        "pick_up": "pickup_off_bottom",
        "slack_off": "slackoff_off_bottom",
        "rotating": "rotating_off_bottom",
        "drilling": "rotary_drilling_6t",
        "sliding": "sliding_6t",
    }
    for result in well["results"]:
        found, numbers = result["expected"], {}
        hangs_N = found["rotating_off_bottom"]["hookload_N"]
        for name, old in operations.items():
            load = absolute(found[old]["hookload_N"], 5e-3 * hangs_N, LUMPED + ", of what hangs")
            numbers[f"{name}_hook_load_N"] = load
            side_N = found[old]["sum_normal_N"]
            numbers[f"{name}_side_force_total_N"] = relative(side_N, 5e-3, LUMPED)
            if found[old]["torque_Nm"]:
                numbers[f"{name}_torque_N_m"] = relative(found[old]["torque_Nm"], 5e-3, LUMPED)
        given = inputs(
            well["survey_md_inc_azi"],
            result["mu"],
            string,
            weight_on_bit_N=-found["rotary_drilling_6t"]["min_eff_tension_N"],
            # The file tells it in words.
            bit_torque_N_m=3100.0,
        )
        yield problem(
            name=f"soft-string-assembly-well-mu-{named(result['mu'])}",
            title=f"A well of 4305 m with a bottom-hole assembly, friction {result['mu']}",
            kind="soft_string",
            file=file,
            source="our own integration of the soft string along exact arcs, to 1e-11",
            assumptions=ALL,
            inputs=given,
            expected=numbers,
        )
    yield from common_well()


def common_well() -> Iterator[Json]:
    file = "A06_common_case_soft_string.json"
    data = read(file)
    of = data["inputs"]
    [[_, length_m, outside_m, inside_m]] = of["strings_top_down"]["A"]
    weight = of["steel_kg_m3"] * area_m2(outside_m, inside_m) * of["g"] * of["buoyancy_factor"]
    string = pipe(length_m, weight, outside_m / 2)
    string[0]["inside_diameter_m"] = inside_m
    inc = of["inc_deg"]
    corners = [(0, 0), (of["kop_m"], 0), (of["eob_m"], inc), (of["td_m"], inc)]
    stations = [(md_m, inc, of["azimuth_deg"]) for md_m, inc in corners]
    loads = {
        "pick_up_hook_load_N": "pu_offbottom",
        "slack_off_hook_load_N": "so_offbottom",
        "rotating_hook_load_N": "rot_offbottom",
        "drilling_hook_load_N": "rotary_drilling_WOB60_TOB5_hook",
        "sliding_hook_load_N": "slide_drilling_WOB60_hook",
    }
    torques = {
        "rotating_torque_N_m": "rot_offbottom_torque",
        "drilling_torque_N_m": "rotary_drilling_WOB60_TOB5_torque",
    }
    for name, found in data["results"].items():
        friction, hangs_N = float(name.removeprefix("A_mu")), 1e3 * found["rot_offbottom"]
        numbers = {
            new: absolute(1e3 * found[old], 5e-3 * hangs_N, LUMPED + ", of what hangs")
            for new, old in loads.items()
        }
        for new, old in torques.items():
            numbers[new] = relative(1e3 * found[old], 5e-3, LUMPED)
        yield problem(
            name=f"soft-string-common-well-mu-{named(friction)}",
            title=f"Drill pipe in a well that builds to 65 deg, friction {friction}",
            kind="soft_string",
            file=file,
            source="our own integration of the soft string along exact arcs, to 1e-11",
            assumptions=ALL,
            inputs=inputs(stations, friction, string, weight_on_bit_N=60e3, bit_torque_N_m=5e3),
            expected=numbers,
        )
