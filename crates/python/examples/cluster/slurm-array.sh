#!/bin/bash
# A sweep as an array of Slurm jobs, each of which solves one share. No Python is required, and the
# shares are independent of each other. Start it with
#
#     sbatch slurm-array.sh
#
# A killed share is restarted with the same command, which skips the finished cases.
# The last share to end writes the table and the page of the whole sweep. If shares were killed, a
# job that waits for all others solves the remaining cases:
#
#     sbatch --dependency=afterany:JOB --array=0 slurm-array.sh
#
#SBATCH --job-name=friction-sweep
#SBATCH --array=1-16
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=8
#SBATCH --mem=8G
#SBATCH --time=04:00:00
#SBATCH --output=sweep-%A-%a.log

set -euo pipefail

# The sweep. All jobs have the same values, and the same folder on a disk that all nodes see.
case_file=${CASE_FILE:-my-well.toml}
folder=${FOLDER:-out/friction-sweep}
vary=(--vary "friction=0.1,0.2,0.3,0.4" --vary "bit_depth=300m..4305m/300m")

# The jobs of the array above, counted from 1; the last job is number 0 of an array of its own.
shares=16

share=()
if [ "$SLURM_ARRAY_TASK_ID" != 0 ]; then
    share=(--shard "$SLURM_ARRAY_TASK_ID/$shares")
fi

exec wholestring sweep "$case_file" "${vary[@]}" --resume -o "$folder" \
    -j "$SLURM_CPUS_PER_TASK" --quiet "${share[@]}"
