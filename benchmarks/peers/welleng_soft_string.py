"""The soft string in welleng, at the stations that wholestring's is given."""

from __future__ import annotations

import json
import math
import time
import warnings
from importlib.metadata import version

import numpy as np
from welleng.architecture import BHA, WellBore
from welleng.survey import Survey
from welleng.torque_drag import TorqueDrag

from problem import Array, Problem

REPEATS = 51
Stations = list[list[float]]


def surveyed(stations: Stations, spacing_m: float) -> tuple[Array, Array]:
    """Measured depths in m at equal distances between the stations, and their inclinations, rad.

    In one vertical plane minimum curvature is a constant build.
    """
    corners = np.array(stations)
    depth = np.arange(0, corners[-1, 0] + 1e-6, spacing_m)
    depth = np.unique(np.concatenate([depth, corners[:, 0]]))
    return depth, np.radians(np.interp(depth, corners[:, 0], corners[:, 1]))


def solve(problem: Problem, stations: Stations) -> dict[str, float]:
    """Hook loads in N, torque in N.m; least times in s, also at stations every metre.

    One call solves all three operations.
    """
    answer, coarse_s = timed(problem, stations, problem.station_spacing_m)
    return {
        "pick_up_N": float(answer.tension["pickup"][0]),
        "slack_off_N": float(answer.tension["slackoff"][0]),
        "rotating_N": float(answer.tension["rotating"][0]),
        "torque_N_m": float(answer.torque["rotating"][0]),
        "coarse_s": coarse_s,
        "fine_s": timed(problem, stations, 1.0)[1],
    }


def timed(problem: Problem, stations: Stations, spacing_m: float) -> tuple[TorqueDrag, float]:
    """The answer at stations so far apart, and the least time that it takes, s."""
    p = problem
    depth, inclination = surveyed(stations, spacing_m)
    bottom = float(depth[-1])
    survey = Survey(md=depth, inc=inclination, azi=np.zeros_like(depth), deg=False)
    hole = WellBore("hole", 0.0, bottom, method="top_down")
    hole.add_section(id=p.hole_diameter_m, coeff_friction_sliding=p.friction, bottom=bottom)
    string = BHA("string", 0.0, bottom, method="top_down")
    string.add_section(
        od=p.outside_diameter_m,
        id=p.inside_diameter_m,
        unit_weight=p.weight_N_per_m,
        bottom=bottom,
    )
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        answer = TorqueDrag(survey, hole, string, fluid_density=0.0)
        times.append(time.perf_counter() - begin)
    return answer, min(times)


def arc_torque(problem: Problem, stations: Stations, turned: bool) -> float:
    """Torque in N.m of the closed form: an arc between two directions and a straight piece below.

    In a build from the vertical the tension F + w R (sin I1 - sin I) pulls the string to the high
    side while its weight presses it to the low side: q = 2 w sin I - w sin I1 - F/R, F the tension
    below. In a drop to the vertical both press on the low side: q = 2 w sin I + F/R. R is the
    radius of the arc; q must not change its sign. `turned`: what comes out where the sign of the
    tension's part is the wrong one, w sin I1 + F/R and -F/R.
    """
    (top, first, _), (arc, second, _), (bottom, _, _) = stations
    w, radius = problem.weight_N_per_m, (arc - top) / math.radians(abs(second - first))
    inc = math.radians(max(first, second))
    below = w * (bottom - arc)
    twice_weight = 0.0 if turned else 2 * w * radius * (1 - math.cos(inc))
    if second > first:
        pulled = (below * math.cos(inc) + w * radius * math.sin(inc)) * inc
        pressed = pulled - twice_weight + below * math.sin(inc)
    else:
        pressed = twice_weight + below * inc
    return problem.friction * problem.radius_m * pressed


if __name__ == "__main__":
    # Of azimuths that are all zero.
    warnings.filterwarnings("ignore")
    work = Problem.read()
    wells = {
        "deviated": work.stations_md_m_inc_deg_azi_deg,
        "build": work.build_md_m_inc_deg_azi_deg,
        "drop": work.drop_md_m_inc_deg_azi_deg,
    }
    answers: dict[str, object] = {name: solve(work, well) for name, well in wells.items()}
    for key, turned in (("closed_form", False), ("turned_sign", True)):
        torques = {name: arc_torque(work, wells[name], turned) for name in ("build", "drop")}
        answers[f"{key}_torque_N_m"] = torques
    answers["version"] = version("welleng")
    print(json.dumps(answers))
