"""A controller of a top drive in a few lines: it gives way to torsional waves, as soft torque does.

The string of the example well drills with a bit whose torque falls as it turns faster, and sticks
and slips. A top that turns at a constant speed throws every torsional wave back. One that slows by
the wave's torque over the pipe's impedance takes it up, and the bit comes to rest at its speed.

Run it: ``python controller.py``.
"""

import math

import wholestring as ws

RPM = 80.0
STEP_S = 0.01
MEAN_S = 10.0
FILTER_S = 0.05

PIPE_OD_M, PIPE_ID_M = 5.0 * 0.0254, 4.276 * 0.0254
POLAR_M4 = math.pi / 32.0 * (PIPE_OD_M**4 - PIPE_ID_M**4)
IMPEDANCE_N_M_S = POLAR_M4 * math.sqrt(7850.0 * 79.3e9)
"""Torque of a torsional wave in the drill pipe over its rotary speed."""


def falling_torque(bit: ws.BitReading) -> tuple[float, float]:
    """Depth of cut per revolution, m, and torque, N·m: it falls as the bit turns faster."""
    rise = 0.6 / (1.0 + abs(bit.rotary_speed_rad_per_s) / 4.0)
    return 2e-8 * bit.weight_on_bit_N, 0.05 * bit.weight_on_bit_N * (1.0 + rise)


def sticking_string() -> ws.Simulation:
    """Give the string as it sticks and slips, after a stop of the top drive."""
    case = ws.Case.example().with_(
        rpm=f"{RPM} rpm",
        friction=0.1,
        mesh__element_length="10 m",
        dynamics__damping__mass=0.4,
        # High notes die, which the delay of a controller in steps would feed.
        dynamics__damping__stiffness=1e-4,
    )
    sim = case.simulation("drill", bit_law=falling_torque)
    sim.set(rpm=0.0, ramp="1 s")
    sim.advance("4 s")
    sim.set(rpm=f"{RPM} rpm", ramp="0.5 s")
    sim.advance("16 s")
    return sim


def soften(sim: ws.Simulation, seconds: float) -> None:
    """Control the top's speed for a time."""
    set_rad_per_s, gives_way_rad_per_s = RPM * math.tau / 60.0, 0.0
    mean_N_m = float(sim.since(sim.time_s - MEAN_S)["surface_torque_N_m"].mean())
    for _ in range(round(seconds / STEP_S)):
        now = sim.now
        mean_N_m += (now["surface_torque_N_m"] - mean_N_m) * STEP_S / MEAN_S
        own_N_m = IMPEDANCE_N_M_S * (now["rotary_speed_rad_per_s"] - set_rad_per_s)
        comes_up_N_m = now["surface_torque_N_m"] - mean_N_m - own_N_m
        wanted_rad_per_s = 0.5 * comes_up_N_m / IMPEDANCE_N_M_S
        gives_way_rad_per_s += (wanted_rad_per_s - gives_way_rad_per_s) * STEP_S / FILTER_S
        sim.set(rotary_speed=set_rad_per_s - gives_way_rad_per_s, ramp=STEP_S)
        sim.advance(STEP_S)


def severity(sim: ws.Simulation, after_s: float) -> float:
    """Give the swing of the bit's speed over twice its mean: 1 where it just sticks."""
    speed = sim.since(after_s)["bit_rotary_speed_rad_per_s"]
    return float((speed.max() - speed.min()) / (2.0 * speed.mean()))


def main() -> None:
    """Let the string stick and slip, then soften it."""
    sim = sticking_string()
    print(f"constant speed: {severity(sim, sim.time_s - 5.0):.2f}")
    soften(sim, 20.0)
    print(f"softened:       {severity(sim, sim.time_s - 5.0):.2f}")


if __name__ == "__main__":
    main()
