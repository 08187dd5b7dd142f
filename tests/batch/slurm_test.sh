#!/bin/sh
# A batch and a picture as Slurm job arrays, on a cluster of this machine alone: real slurmctld and
# slurmd, with a task that is killed and requeued. usage: slurm_test.sh GLIMT SOURCE_FOLDER
# Skips (77) where Slurm is not installed, or may not be started.
set -eu

GLIMT=$1
source=$2
export GLIMT
for program in slurmctld slurmd sbatch scontrol squeue scancel; do
  command -v "$program" >/dev/null || {
    echo "skipped: there is no $program; install Debian's slurmctld, slurmd and slurm-client"
    exit 77
  }
done
[ "$(id -u)" = 0 ] || {
  echo "skipped: slurmd is started as root alone"
  exit 77
}

. "$(dirname -- "$0")/../command_test.sh"
mkdir "$folder/state" "$folder/spool"
SLURM_CONF=$folder/slurm.conf
export SLURM_CONF
host=$(hostname -s)

end() {
  scancel --state=RUNNING,PENDING --name=glimt-batch,glimt-picture 2>/dev/null || true
  for daemon in slurmd slurmctld; do
    [ ! -s "$folder/$daemon.pid" ] || kill "$(cat "$folder/$daemon.pid")" 2>/dev/null || true
  done
  sleep 1
  rm -rf "$folder"
}
trap end EXIT

fail() {
  echo "FAILED: $*"
  tail -n 15 "$folder"/*.log "$folder"/*.out 2>/dev/null || true
  exit 1
}

# A requeued task starts once its credential has expired.
cat >"$SLURM_CONF" <<END
ClusterName=glimt
SlurmctldHost=$host
SlurmUser=root
SlurmdUser=root
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
AuthType=auth/none
AuthInfo=cred_expire=5
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=2
NodeName=$host CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
slurmctld && slurmd || fail "Slurm does not start"

# until_true SECONDS COMMAND...: waits for it.
until_true() {
  left=$1
  shift
  until "$@"; do
    left=$((left - 1))
    [ "$left" -gt 0 ] || return 1
    sleep 1
  done
}
idle() { [ "$(sinfo --noheader --format=%t 2>/dev/null)" = idle ]; }
until_true 30 idle || fail "the node does not become idle"
ended() { [ -z "$(squeue --noheader --job "$1" 2>/dev/null)" ]; }

write_room
echo '{"scene": "room.obj", "turntable": {"angles": 9}, "sizes": [[32, 32]], "spp": 300,
       "formats": ["pfm"]}' >"$folder/job.json"

# The batch, one task of three killed after its first picture.
"$GLIMT" batch "$folder/job.json" -o "$folder/alone" --quiet
cd "$folder"
array=$(sbatch --parsable --array=1-3 "$source/app/slurm/glimt-batch.sh" job.json -o array)
first_picture() { [ -s "$folder/array/manifest-part-2-of-3.json" ]; }
until_true 120 first_picture || fail "task 2 makes no picture"
before=$(sha256sum "$folder/array/"*.pfm | wc -l)
scontrol requeue "${array}_2" || fail "task 2 had ended before it could be killed"
until_true 240 ended "$array" || fail "the array does not end"
grep -q 'interrupted' "$folder"/slurm-*.out || fail "task 2 was not killed in the middle"
"$GLIMT" batch job.json -o array 2>"$folder/errors" || fail "$(cat "$folder/errors")"
grep -q "0 pictures made, 9 up to date" "$folder/errors" || fail "$(cat "$folder/errors")"
for file in "$folder/alone/"*.pfm; do
  cmp "$file" "$folder/array/${file##*/}" || fail "the array's picture is another one"
done
echo "batch: killed when $before of 9 pictures were there; all are those of one process"

# One picture in four shares, one of them killed.
"$GLIMT" render room.obj --size 32x32 --spp 512 --quiet -o whole.pfm
mkdir shares
array=$(sbatch --parsable --array=0-3 "$source/app/slurm/glimt-picture.sh" 128 shares room.obj \
  --size 32x32 --quiet)
running() { squeue --noheader --states=RUNNING --format=%K --job "$array" | grep -q '^1$'; }
until_true 60 running || fail "task 1 does not start"
scontrol requeue "${array}_1" || fail "task 1 had ended before it could be killed"
until_true 240 ended "$array" || fail "the array does not end"
[ "$(find shares -name 'share-*.exr' | wc -l)" = 4 ] || fail "there are not four shares"
"$GLIMT" merge shares/share-*.exr -o merged.pfm 2>"$folder/errors" || fail "$(cat "$folder/errors")"
# Rounding alone is between them: docs/picture-files.md.
"$GLIMT" compare merged.pfm whole.pfm --metric relmse --threshold 1e-10 >/dev/null ||
  fail "the shares are not the whole"
echo "picture: four shares, one of them killed, are the whole"
echo "all passed"
