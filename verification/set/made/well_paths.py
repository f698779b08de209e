"""Well paths: positions of surveyed stations by minimum curvature."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from itertools import groupby

from .problem import SOURCES, Json, absolute, problem, read, survey

MINIMUM_CURVATURE = "Between stations the hole is an arc of a circle (minimum curvature)."
COORDINATES = "Azimuths and coordinates are of the same grid; no convergence, no declination."


def problems() -> Iterator[Json]:
    """The standard wells, and the arcs of the wells in which strings are held."""
    yield from standard()
    yield from planar()


def standard() -> Iterator[Json]:
    """The twelve ISCWSA standard wellpaths."""
    file = "B01_iscwsa_standard_wellpaths.csv"
    with (SOURCES / file).open(encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text))
    for well, group in groupby(rows, key=lambda row: row["well"]):
        stations = list(group)
        column = {
            name: [float(of[name]) for of in stations] for name in stations[0] if name != "well"
        }
        reason = "published positions are rounded to 0.005 m"
        yield problem(
            name="well-path-iscwsa-" + well.split()[0].lower(),
            title=f"ISCWSA standard wellpath: {well}",
            kind="well_path",
            file=file,
            source="ISCWSA standard wellpaths as in `reference/` of jonnymaserati/welleng",
            licence="Apache-2.0",
            assumptions=[MINIMUM_CURVATURE, COORDINATES],
            inputs={
                "survey": survey(
                    [*zip(column["md_m"], column["inc_deg"], column["azi_deg"], strict=True)]
                ),
                "first_north_m": column["north_m"][0],
                "first_east_m": column["east_m"][0],
                "first_true_vertical_depth_m": column["tvd_m"][0],
            },
            expected={
                "north_m": absolute(column["north_m"], 0.006, reason),
                "east_m": absolute(column["east_m"], 0.006, reason),
                "true_vertical_depth_m": absolute(column["tvd_m"], 0.006, reason),
            },
        )


def planar() -> Iterator[Json]:
    """A vertical part, an arc and a tangent in one vertical plane, whose depth is a closed form."""
    file = "A06_common_case_soft_string.json"
    of = read(file)["inputs"]
    kick_off_m, end_m, bottom_m = of["kop_m"], of["eob_m"], of["td_m"]
    azimuth, inclination = math.radians(of["azimuth_deg"]), math.radians(of["inc_deg"])
    radius_m, tangent_m = (end_m - kick_off_m) / inclination, bottom_m - end_m
    out_m = [0.0, 0.0, radius_m * (1 - math.cos(inclination))]
    out_m.append(out_m[-1] + tangent_m * math.sin(inclination))
    down_m = [0.0, kick_off_m, kick_off_m + radius_m * math.sin(inclination)]
    down_m.append(read(file)["analytic"]["TVD_m"])
    reason = "closed form; rounding over kilometres"
    stations = [(0.0, 0.0), (kick_off_m, 0.0), (end_m, of["inc_deg"]), (bottom_m, of["inc_deg"])]
    yield problem(
        name="well-path-one-arc",
        title="One arc from the vertical to a tangent",
        kind="well_path",
        file=file,
        source="closed form of an arc and a tangent",
        assumptions=[MINIMUM_CURVATURE, COORDINATES],
        inputs={
            "survey": survey([(md_m, inc, of["azimuth_deg"]) for md_m, inc in stations]),
            "first_north_m": 0.0,
            "first_east_m": 0.0,
            "first_true_vertical_depth_m": 0.0,
        },
        expected={
            "north_m": absolute([x * math.cos(azimuth) for x in out_m], 1e-6, reason),
            "east_m": absolute([x * math.sin(azimuth) for x in out_m], 1e-6, reason),
            "true_vertical_depth_m": absolute(down_m, 1e-6, reason),
        },
    )
    file = "A02_np13_like_synthetic_well.json"
    well = read(file)
    stations = well["survey_md_inc_azi"]
    yield problem(
        name="well-path-build-in-stations",
        title="A build of 26 stations and a tangent: where its end lies",
        kind="well_path",
        file=file,
        source="closed form of an arc and a tangent",
        assumptions=[MINIMUM_CURVATURE, COORDINATES],
        inputs={
            "survey": survey(stations),
            "first_north_m": 0.0,
            "first_east_m": 0.0,
            "first_true_vertical_depth_m": 0.0,
        },
        expected={
            "end_north_m": absolute(well["north_m"], 1e-6, reason),
            "end_true_vertical_depth_m": absolute(well["TVD_m"], 1e-6, reason),
        },
    )
