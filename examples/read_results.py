"""Reads what a run left: python examples/read_results.py out/<case name>

Needs polars (pip install polars). Columns, units and meaning: docs/src/outputs.md.
"""

import sys
from pathlib import Path

import polars as pl

folder = Path(sys.argv[1])
nodes = pl.read_parquet(folder / "nodes.parquet")
time = pl.read_parquet(folder / "time.parquet")

print("Along the string: where it carries most, and where it rubs hardest")
for (model, operation), string in nodes.group_by("model", "operation", maintain_order=True):
    compression = string.filter(pl.col("tension_N") < 0)
    hardest = string.filter(pl.col("side_force_N_per_m").is_not_null()).sort(
        pl.col("side_force_N_per_m").abs(), descending=True
    )
    print(f"  {operation} ({model})")
    print(f"    tension at surface   {string['tension_N'][0] / 1e3:9.1f} kN")
    print(f"    torque at surface    {string['torque_N_m'][0] / 1e3:9.2f} kN.m")
    if not compression.is_empty():
        print(f"    in compression from  {compression['md_m'].min():9.1f} m MD")
    used = string.filter(pl.col("yield_use").is_not_null()).sort("yield_use", descending=True)
    if not used.is_empty():
        part, depth = used["yield_use"][0], used["md_m"][0]
        print(f"    most of the yield    {100 * part:9.0f} % at {depth:.1f} m MD")
    if not hardest.is_empty():
        force, depth = hardest["side_force_N_per_m"][0], hardest["md_m"][0]
        side = "high" if force > 0 else "low"
        print(f"    largest side force   {abs(force) / 1e3:9.2f} kN/m, {side} side, at {depth:.1f} m MD")

if not time.is_empty():
    print("In time: the second half of each run")
    for (operation,), run in time.group_by("operation", maintain_order=True):
        late = run.filter(pl.col("time_s") > run["time_s"].max() / 2)
        for name, scale, unit in [("hook_load_N", 1e3, "kN"), ("surface_torque_N_m", 1e3, "kN.m")]:
            mean, deviation = late[name].mean() / scale, late[name].std() / scale
            print(f"  {operation:<20} {name:<20} {mean:9.2f} +- {deviation:.2f} {unit}")

# With [records] frames in the case. They can be many: this reads no more of them than it needs.
if (folder / "frames.parquet").exists():
    frames = pl.scan_parquet(folder / "frames.parquet")
    if "contact_force_N" in frames.collect_schema():
        print("In frames: the hardest contact")
        where = pl.col("contact_force_N").abs().arg_max()
        columns = pl.col("time_s", "md_m", "contact_force_N").get(where)
        for row in frames.group_by("operation").agg(columns).collect().iter_rows(named=True):
            print(
                f"  {row['operation']:<20} {abs(row['contact_force_N']) / 1e3:9.2f} kN"
                f" at {row['md_m']:.1f} m MD, {row['time_s']:.2f} s"
            )
