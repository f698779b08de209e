"""What a run of a program hands back."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

import numpy as np


@dataclass(frozen=True)
class Measured:
    """One program's run of the dynamics."""

    program: str
    version: str
    variant: str
    """What was done to it; empty where nothing was."""
    elements: int
    step_s: float
    simulated_s: float
    cpu_s: float
    hook_load_N: float
    torque_N_m: float
    """At the top."""
    tuned: str
    """How the step was chosen."""
    leaves_out: str
    """What the program, or what could be set up in it, does not have."""

    def write(self) -> None:
        """One line of JSON on the screen, the last."""
        print(json.dumps(asdict(self)))


class Means:
    """Means of samples that are taken at equal times."""

    def __init__(self) -> None:
        self.samples: list[tuple[float, ...]] = []

    def add(self, *values: float) -> None:
        self.samples.append(tuple(float(value) for value in values))

    def of(self) -> list[float]:
        return [float(mean) for mean in np.mean(np.array(self.samples), axis=0)]
