"""A learning environment: prevent stick-slip of a string by its rotary speed.

The interface is Gymnasium's. The string is that of ``controller.py``: the example well, and a bit
whose torque falls with its speed.

Observation (four numbers, SI)
    surface torque (N·m), its swing (N·m, largest less smallest), rotary speed that is set (rad/s),
    weight on bit (N): the quantities that a driller sees, none from the bit. Mean and swing are
    over the last 2.5 s, a period of stick-slip.
Action (one number from -1 to 1)
    change of the set rotary speed over the next step: 1 is an increase of 10 rev/min.
Reward (no unit)
    rate of penetration in parts of 10 m/h, less the swing of the bit speed over twice its mean,
    which is 1 at the onset of sticking. Both are over the last 2.5 s.
Episode
    30 s in steps of 0.5 s, from a string in stick-slip after a stop of the top drive.

Run it: ``python gymnasium_env.py``.
"""

from __future__ import annotations

import math
from typing import Any

import gymnasium
import numpy as np
import wholestring as ws
from numpy.typing import NDArray

RPM = math.tau / 60.0
STEP_S = 0.5
SEEN_S = 2.5
EPISODE_S = 30.0
SLOWEST, FASTEST = 40.0 * RPM, 180.0 * RPM
LARGEST_CHANGE = 10.0 * RPM
NOMINAL_RATE_M_PER_S = 10.0 / 3600.0

LEAST = np.array([-60e3, 0.0, SLOWEST, 0.0])
MOST = np.array([60e3, 120e3, FASTEST, 500e3])

Observation = NDArray[np.float64]
Action = NDArray[np.float64]


def falling_torque(bit: ws.BitReading) -> tuple[float, float]:
    """Return depth of cut per revolution, m, and torque, N·m, which falls with the bit speed."""
    rise = 0.6 / (1.0 + abs(bit.rotary_speed_rad_per_s) / 4.0)
    return 2e-8 * bit.weight_on_bit_N, 0.05 * bit.weight_on_bit_N * (1.0 + rise)


class StickSlip(gymnasium.Env[Observation, Action]):
    """A string in stick-slip, controlled by the rotary speed of its top."""

    def __init__(self) -> None:
        self.observation_space = gymnasium.spaces.Box(LEAST, MOST, dtype=np.float64)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (1,), np.float64)
        self._case = ws.Case.example().with_(
            friction=0.1,
            mesh__element_length="10 m",
            dynamics__damping__mass=0.4,
            dynamics__damping__stiffness=1e-4,
        )
        self._begun: dict[float, bytes] = {}
        self._sim: ws.Simulation | None = None
        self._set = 0.0
        self._end_s = 0.0

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Restart, at a rotary speed of 60 to 90 rev/min from the seed."""
        super().reset(seed=seed)
        rpm = 10.0 * float(self.np_random.integers(6, 10))
        if rpm not in self._begun:
            sim = self._simulation(rpm, None)
            sim.set(rpm=0.0, ramp="1 s")
            sim.advance("4 s")
            sim.set(rpm=rpm, ramp="0.5 s")
            sim.advance("16 s")
            self._begun[rpm] = sim.checkpoint()
        self._sim = self._simulation(rpm, self._begun[rpm])
        self._set = rpm * RPM
        self._end_s = self._sim.time_s + EPISODE_S
        return self._observe(self._sim)[0], {}

    def step(self, action: Action) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Set the rotary speed, and advance by half a second."""
        sim = self._sim
        if sim is None:
            raise RuntimeError("call reset before the first step")
        change = float(np.clip(action[0], -1.0, 1.0)) * LARGEST_CHANGE
        self._set = min(max(self._set + change, SLOWEST), FASTEST)
        sim.set(rotary_speed=self._set, ramp=STEP_S)
        sim.advance(STEP_S)
        observation, rate, severity = self._observe(sim)
        reward = rate / NOMINAL_RATE_M_PER_S - severity
        is_over = sim.time_s > self._end_s - 0.5 * STEP_S
        return observation, reward, False, is_over, {"severity": severity}

    def _simulation(self, rpm: float, checkpoint: bytes | None) -> ws.Simulation:
        case = self._case.with_(rpm=f"{rpm} rpm")
        return case.simulation("drill", bit_law=falling_torque, checkpoint=checkpoint)

    def _observe(self, sim: ws.Simulation) -> tuple[Observation, float, float]:
        """Return the observation, the rate of penetration and the severity of the last seconds."""
        last = sim.since(sim.time_s - SEEN_S)
        torque = last["surface_torque_N_m"]
        speed = last["bit_rotary_speed_rad_per_s"]
        weight = float(last["weight_on_bit_N"].mean())
        seen = np.array([torque.mean(), np.ptp(torque), self._set, weight])
        seen = np.clip(seen, LEAST, MOST)
        severity = float(np.ptp(speed) / (2.0 * max(abs(speed.mean()), 0.1)))
        return seen, float(last["rate_of_penetration_m_per_s"].mean()), severity


def main() -> None:
    """Raise the rotary speed while the torque swings."""
    env = StickSlip()
    observation, _ = env.reset(seed=1)
    total, is_over = 0.0, False
    while not is_over:
        swings = observation[1] > 1000.0
        action = np.array([1.0 if swings else 0.0])
        observation, reward, _, is_over, info = env.step(action)
        total += reward
        print(f"{observation[2] / RPM:5.0f} rev/min, severity {info['severity']:.2f}")
    print(f"reward {total:.1f}")


if __name__ == "__main__":
    main()
