"""A sweep on a Slurm cluster with Dask: the number of workers follows the queue.

    pip install './crates/python[dask]'
    python dask_slurm.py my-well.toml out/friction-sweep

This program runs on the node where jobs are submitted, until the sweep is finished. If it is
killed, the same command continues the sweep.
"""

import sys
from typing import Any

import wholestring as ws
from dask.distributed import Client, Security
from dask_jobqueue import SLURMCluster  # pyright: ignore[reportPrivateImportUsage]


def slurm_cluster(**more: Any) -> Any:
    """Return a cluster whose jobs have eight workers of one thread each: a case uses one thread."""
    settings: dict[str, Any] = {
        "cores": 8,
        "processes": 8,
        "memory": "8 GB",
        "walltime": "04:00:00",
        "job_name": "wholestring",
        # A worker ends a little before its job, so that Dask moves its cases to others.
        "worker_extra_args": ["--lifetime", "235m", "--lifetime-stagger", "4m"],
        # The network is shared. The keys are in a folder that all nodes see and only you can read.
        "protocol": "tls",
        "security": Security.temporary(),  # pyright: ignore[reportUnknownMemberType]
        "shared_temp_directory": ".",
    }
    return SLURMCluster(**(settings | more))


def main(case_file: str, folder: str) -> None:
    """Sweep a case, and print the cases that failed."""
    case = ws.Case.load(case_file)
    vary: dict[str, list[float] | str] = {
        "friction": [0.1, 0.2, 0.3, 0.4],
        "bit_depth": "300m..4305m/300m",
    }
    with slurm_cluster() as cluster, Client(cluster) as client:
        cluster.adapt(minimum_jobs=1, maximum_jobs=16)
        swept = ws.sweep(case, vary, folder=folder, executor=client, progress=True)
    print(swept)
    for name, reason in swept.failed.items():
        print(f"{name}: {reason}")


if __name__ == "__main__":
    main(*sys.argv[1:])
