"""The parts of the runner."""
