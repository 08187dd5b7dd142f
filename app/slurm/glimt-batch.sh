#!/bin/sh
# The pictures of a job file, shared out among the tasks of a Slurm job array:
#   sbatch --array=1-16 glimt-batch.sh JOB.json [-o DIR]
# and once all are done, the manifest and the contact sheet of all, also where one has failed:
#   sbatch --dependency=afterany:ARRAY_JOB_ID --wrap 'glimt batch JOB.json'
# The folder of the pictures has to be one that all nodes see. A task that is requeued goes on where it
# was: its part of the manifest says what is there.
#SBATCH --job-name=glimt-batch
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu

: "${SLURM_ARRAY_TASK_ID:?submit it as an array, with sbatch --array=1-N}"
exec "${GLIMT:-glimt}" batch "$@" --job-part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
