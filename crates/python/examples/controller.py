"""A top-drive controller in a few lines: it absorbs torsional waves, as soft torque does.

The string of the example well drills with a bit whose torque falls with its speed, and is in
stick-slip. A top at constant speed reflects every torsional wave. A top that slows by the torque of
the wave over the impedance of the pipe absorbs it, and the bit settles at the speed of the top.

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
    """Return depth of cut per revolution, m, and torque, N·m, which falls with the bit speed."""
    rise = 0.6 / (1.0 + abs(bit.rotary_speed_rad_per_s) / 4.0)
    return 2e-8 * bit.weight_on_bit_N, 0.05 * bit.weight_on_bit_N * (1.0 + rise)


def sticking_string() -> ws.Simulation:
    """Return the string in stick-slip, after a stop of the top drive."""
    case = ws.Case.example().with_(
        rpm=f"{RPM} rpm",
        friction=0.1,
        mesh__element_length="10 m",
        dynamics__damping__mass=0.4,
        # Damps high frequencies, which the delay of a discrete controller would amplify.
        dynamics__damping__stiffness=1e-4,
    )
    sim = case.simulation("drill", bit_law=falling_torque)
    sim.set(rpm=0.0, ramp="1 s")
    sim.advance("4 s")
    sim.set(rpm=f"{RPM} rpm", ramp="0.5 s")
    sim.advance("16 s")
    return sim


def soften(sim: ws.Simulation, seconds: float) -> None:
    """Control the rotary speed of the top for a time."""
    set_rad_per_s, correction_rad_per_s = RPM * math.tau / 60.0, 0.0
    mean_N_m = float(sim.since(sim.time_s - MEAN_S)["surface_torque_N_m"].mean())
    for _ in range(round(seconds / STEP_S)):
        now = sim.now
        mean_N_m += (now["surface_torque_N_m"] - mean_N_m) * STEP_S / MEAN_S
        own_N_m = IMPEDANCE_N_M_S * (now["rotary_speed_rad_per_s"] - set_rad_per_s)
        wave_N_m = now["surface_torque_N_m"] - mean_N_m - own_N_m
        target_rad_per_s = 0.5 * wave_N_m / IMPEDANCE_N_M_S
        correction_rad_per_s += (target_rad_per_s - correction_rad_per_s) * STEP_S / FILTER_S
        sim.set(rotary_speed=set_rad_per_s - correction_rad_per_s, ramp=STEP_S)
        sim.advance(STEP_S)


def severity(sim: ws.Simulation, after_s: float) -> float:
    """Return the range of the bit speed over twice its mean: 1 at the onset of sticking."""
    speed = sim.since(after_s)["bit_rotary_speed_rad_per_s"]
    return float((speed.max() - speed.min()) / (2.0 * speed.mean()))


def main() -> None:
    """Run the string into stick-slip, then apply the controller."""
    sim = sticking_string()
    print(f"constant speed: {severity(sim, sim.time_s - 5.0):.2f}")
    soften(sim, 20.0)
    print(f"softened:       {severity(sim, sim.time_s - 5.0):.2f}")


if __name__ == "__main__":
    main()
