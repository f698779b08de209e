"""The same work in wholestring: a case written for it, the binary run as a user runs it."""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import tempfile
from pathlib import Path

from measured import Measured
from problem import Problem

CASE = """\
name = "side by side"
model = ["dynamic"]
[well]
stations = {stations}
path = "minimum-curvature"
[[well.hole]]
kind = "open"
to = "{length_m} m"
diameter = "{hole_diameter_m} m"
friction = {friction}
[mud]
density = 0
drag_coefficient = 0
[steel]
density = "{density_kg_per_m3} kg/m3"
youngs_modulus = "{youngs_modulus_Pa} Pa"
shear_modulus = "{shear_modulus_Pa} Pa"
[[string]]
component = "pipe"
od = "{outside_diameter_m} m"
id = "{inside_diameter_m} m"
length = "to surface"
[operation]
kind = "rotate_off_bottom"
bit_depth = "{length_m} m"
rpm = {rotary_speed_rpm}
trip_speed = "{trip_speed_m_per_s} m/s"
[mesh]
element_length = "{element_length_m} m"
[dynamics]
contact_law = "linear"
contact_stiffness = "{contact_stiffness_N_per_m} N/m"
contact_damping_ratio = {contact_damping_ratio}
damping = {{ mass = {damping_mass_per_s}, stiffness = {damping_stiffness_s} }}
duration = "{duration_s} s"
settle = "{settle_s} s"
"""


def case(problem: Problem, settle_s: float, duration_s: float) -> str:
    """A case file in TOML."""
    values = vars(problem) | {
        "stations": json.dumps(problem.stations_md_m_inc_deg_azi_deg),
        "settle_s": settle_s,
        "duration_s": duration_s,
    }
    return CASE.format(**values)


def run(problem: Problem, program: Path, simulated_s: float) -> Measured:
    """Settles for half of the time, takes means over the other half; all of the process counts."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        file.write_text(case(problem, simulated_s / 2, simulated_s / 2), encoding="utf-8")
        words = [str(program), "run", str(file), "--quiet", "--json", "-o", f"{folder}/out"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(words, check=True, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    summary = json.loads(done.stdout)
    operation = summary["operations"][0]
    return Measured(
        program="wholestring",
        version=summary["engine_version"],
        variant="",
        elements=operation["numerics"]["elements"],
        step_s=operation["numerics"]["time_step_s"],
        simulated_s=simulated_s,
        cpu_s=after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
        hook_load_N=operation["hook_load_N"],
        torque_N_m=operation["surface_torque_N_m"],
        tuned="its own choice",
        leaves_out="nothing of this work; statistics, tables, page and picture are in the time",
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("binary", type=Path)
    parser.add_argument("--seconds", type=float, default=60.0, help="simulated")
    given = parser.parse_args()
    run(Problem.read(), given.binary, given.seconds).write()
