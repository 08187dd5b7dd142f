#!/bin/sh
# One picture, its samples shared out among the tasks of a Slurm job array, COUNT each:
#   sbatch --array=0-15 glimt-picture.sh COUNT FOLDER SCENE [OPTION]...
# and once all are done:
#   sbatch --dependency=afterok:ARRAY_JOB_ID --wrap 'glimt merge FOLDER/share-*.exr -o picture.png'
# Options are those of glimt render but for what ends it. The folder has to be one that all nodes see. A
# share gets its name when it is whole, so a task that is requeued finds either that or nothing.
#SBATCH --job-name=glimt-picture
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu

: "${SLURM_ARRAY_TASK_ID:?submit it as an array, with sbatch --array=0-N}"
count=$1
folder=$2
scene=$3
shift 3

number=$(printf %05d "$SLURM_ARRAY_TASK_ID")
share=$folder/share-$number.exr
under_way=$folder/under-way-$number.exr
[ ! -e "$share" ] || exit 0

# glimt answers SIGTERM with what it has, which is less than the share.
stopped=''
trap 'stopped=1' INT TERM
"${GLIMT:-glimt}" render "$scene" --samples $((SLURM_ARRAY_TASK_ID * count)):"$count" \
  -o "$under_way" "$@"
if [ -n "$stopped" ]; then
  rm -f "$under_way"
  exit 1
fi
mv "$under_way" "$share"
