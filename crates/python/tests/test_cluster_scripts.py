"""Scripts for clusters, rendered and checked but not run on one."""

from __future__ import annotations

import os
import runpy
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples" / "cluster"


# On Windows, a program of this name starts a Linux subsystem, if one is installed.
needs_bash = pytest.mark.skipif(
    os.name != "posix" or shutil.which("bash") is None, reason="this system has no bash"
)


@needs_bash
def test_the_array_of_slurm_hands_its_shares_to_the_command_line(tmp_path: Path) -> None:
    script = EXAMPLES / "slurm-array.sh"
    subprocess.run(["bash", "-n", str(script)], check=True)
    program = tmp_path / "wholestring"
    program.write_text('#!/bin/bash\nprintf "%s\\n" "$@"\n')
    program.chmod(0o755)

    def arguments(task: int) -> list[str]:
        path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
        given = {"PATH": path, "SLURM_ARRAY_TASK_ID": str(task), "SLURM_CPUS_PER_TASK": "8"}
        ran = subprocess.run(
            ["bash", str(script)], env=given, check=True, capture_output=True, text=True
        )
        return ran.stdout.splitlines()

    last = arguments(0)
    assert "--shard" not in last
    assert "--resume" in last and last[last.index("-j") + 1] == "8"
    assert last[last.index("-o") + 1] == "out/friction-sweep"
    lines = script.read_text().splitlines()
    array = next(line.split("1-")[1] for line in lines if line.startswith("#SBATCH --array="))
    for task in (1, int(array)):
        assert arguments(task) == [*last, "--shard", f"{task}/{array}"]


@needs_bash
def test_dask_jobqueue_renders_the_job(tmp_path: Path) -> None:
    jobqueue = pytest.importorskip("dask_jobqueue")
    example = runpy.run_path(str(EXAMPLES / "dask_slurm.py"))
    here: dict[str, Any] = {
        "scheduler_options": {"host": "127.0.0.1", "dashboard_address": "127.0.0.1:0"},
        "shared_temp_directory": str(tmp_path),
    }
    with example["slurm_cluster"](**here) as cluster:
        assert isinstance(cluster, jobqueue.SLURMCluster)
        script = cluster.job_script()
    subprocess.run(["bash", "-n"], input=script, text=True, check=True)
    for line in (
        "#SBATCH -J wholestring",
        "#SBATCH --cpus-per-task=8",
        "#SBATCH -t 04:00:00",
        "--nthreads 1 ",
        "--nworkers 8",
        "--lifetime 235m",
        "tls://127.0.0.1:",
        "--tls-key",
    ):
        assert line in script, script
