"""The examples next to the package."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"


def example(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def test_a_controller_stops_stick_slip() -> None:
    """At a constant speed the bit stops in each cycle; with the controller, its speed varies by a
    tenth at most after 20 s."""
    controller = example("controller")
    sim = controller.sticking_string()
    start_s = sim.time_s
    sim.advance(5.0)
    assert sim.since(start_s)["bit_rotary_speed_rad_per_s"].min() < 0.1
    assert controller.severity(sim, start_s) > 0.9
    controller.soften(sim, 20.0)
    assert controller.severity(sim, sim.time_s - 5.0) < 0.1
    controller.main()


def test_an_environment_to_learn_in() -> None:
    pytest.importorskip("gymnasium")
    from gymnasium.utils.env_checker import check_env

    environment = example("gymnasium_env")
    check_env(environment.StickSlip(), skip_render_check=True)

    def played(seed: int, change: float) -> tuple[float, list[float]]:
        env = environment.StickSlip()
        observation, _ = env.reset(seed=seed)
        seen, total, is_over = [observation], 0.0, False
        while not is_over:
            observation, reward, is_done, is_over, _ = env.step(np.array([change]))
            assert env.observation_space.contains(observation)
            assert not is_done
            seen.append(observation)
            total += reward
        assert len(seen) == 61
        return total, np.concatenate(seen).tolist()

    still, faster = played(7, 0.0), played(7, 1.0)
    assert played(7, 1.0) == faster
    assert played(8, 1.0) != faster
    # A higher rotary speed ends stick-slip, and drills faster.
    assert faster[0] > still[0] + 10.0
    environment.main()
