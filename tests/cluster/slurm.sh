#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a batch in parts on a Slurm of two nodes on this machine, and kills one of the nodes meanwhile. `merge` of the
# parts must give the bytes of a batch in one run. Needs no systemd and leaves nothing behind.
#   bash tests/cluster/slurm.sh                                       a minute or two
#   bash tests/cluster/slurm.sh --puzzles 1000000 --parts 64 --patient
#   --input      a file of puzzles instead of puzzles from puzzles.sh
#   --whole      the answers of a batch in one run, if they exist already
#   --patient    waits until Slurm itself restarts the lost part, two minutes later; otherwise the script tells it to
#   --frozen     the node's processes are stopped instead of killed: the other node refuses the part, because it is
#                still being written, and then the node comes back
# BANKSHOT=PATH names another program than build/release/bankshot.
set -euo pipefail
cd "$(dirname "$0")/../.."
. cmake/packages.sh
puzzles=30000 parts=8 input="" whole="" patient="" frozen=""
while [ $# -gt 0 ]; do
  case $1 in
    --puzzles) puzzles=$2 && shift ;;
    --input) input=$(readlink -f "$2") && shift ;;
    --whole) whole=$(readlink -f "$2") && shift ;;
    --parts) parts=$2 && shift ;;
    --patient) patient=yes ;;
    --frozen) frozen=yes ;;
    *) sed -n '3,13s/^# //p' "$0" >&2 && exit 2 ;;
  esac
  shift
done
need slurm-wlm munge
export PATH=$PATH:/usr/sbin
root=$PWD
folder=$(mktemp -d)
chmod 755 "$folder"  # munge needs a socket that everybody can reach
cp "${BANKSHOT:-build/release/bankshot}" "$folder/bankshot"  # a copy, because the program may be rebuilt meanwhile
BANKSHOT=$folder/bankshot
cd "$folder"
export SLURM_CONF=$folder/slurm.conf

say() { echo "$(date +%T) $*"; }
give_up() { say "$*" >&2; exit 1; }

# Lists the processes of a node's jobs. Each job is in a session of its own, led by the daemon that watches over it.
jobs_of() {  # NODE
  local pid
  for pid in $(grep -lzxs "SLURMD_NODENAME=$1" /proc/[0-9]*/environ | cut -d/ -f3); do
    if tr '\0' '\n' 2>/dev/null <"/proc/$pid/environ" | grep -qx "SLURM_CONF=$SLURM_CONF"; then echo "$pid"; fi
  done
}
signal_jobs() {  # SIGNAL NODE
  local pid session
  for session in $(for pid in $(jobs_of "$2"); do ps -o sid= -p "$pid"; done | sort -u); do
    kill "-$1" $(ps -o pid= -s "$session") 2>/dev/null || true
  done
}

daemons=""
finish() {
  local code=$?
  trap - EXIT
  signal_jobs KILL n1
  signal_jobs KILL n2
  # shellcheck disable=SC2086  # a process each
  kill -KILL $daemons 2>/dev/null || true
  wait 2>/dev/null
  if [ $code != 0 ]; then tail -n 20 "$folder"/*.log "$folder"/slurm-*.out >&2 2>/dev/null || true; fi
  cd / && rm -rf "$folder"
  exit $code
}
trap finish EXIT
trap 'exit 130' INT TERM

start() {  # COMMAND... : runs in the background and ends with this script
  "$@" >>"$folder/$(basename "$1").log" 2>&1 &
  daemons="$daemons $!"
}

configure_slurm() {
  local host port=$((20000 + RANDOM % 4000 * 3)) user
  host=$(hostname -s) user=$(id -un)
  mkdir state spool-n1 spool-n2
  cat >slurm.conf <<END
ClusterName=bankshot
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmdParameters=config_overrides
SwitchType=switch/none
MpiDefault=none
SelectType=select/linear
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SlurmdTimeout=15
ReturnToService=2
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
}

until_true() {  # SECONDS WHAT COMMAND...
  local until=$((SECONDS + $1)) what=$2
  shift 2
  until "$@"; do
    [ $SECONDS -lt $until ] || give_up "waited in vain: $what"
    sleep 0.05
  done
}

both_are_up() { [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | wc -l)" = 2 ]; }

# Writes the script that the jobs run in place of the program. After a third of the parts, the first part on n2 stops in
# the middle, with some but not all of its answers written, and names itself. So the node is always lost at that moment.
write_shim() {
  cat >shim <<END
#!/bin/bash
part=\$SLURM_ARRAY_TASK_ID
if [ "\$SLURMD_NODENAME" != n2 ] || [ -e middle ] || [ "\$part" -lt $((parts / 3)) ]; then exec ./bankshot "\$@"; fi
./bankshot "\$@" &
lines=()
while kill -0 \$! && [ \${#lines[@]} -le 6 ]; do mapfile -t lines <"shots-\$part.jsonl.partial.progress"; done 2>/dev/null
kill -STOP \$!
if [ -e "shots-\$part.jsonl.partial.progress" ] && [ ! -e "shots-\$part.jsonl" ]; then
  echo "\$part" >middle.new && mv middle.new middle
else
  kill -CONT \$!
fi
wait \$!
END
  chmod 755 shim
}

# Only the jobs that ran on n2 wait for a start time in the future.
all_are_done() {
  local waiting
  [ -n "$patient" ] || for waiting in $(squeue -h -r -t PENDING -o '%i %r' | awk '$2 == "BeginTime" { print $1 }'); do
    scontrol update "JobId=$waiting" StartTime=now
  done
  sleep 0.5
  [ -z "$(squeue -h)" ]
}

was_refused() {
  all_are_done || true
  grep -qs "another bankshot is writing this file" slurm-*_"$lost".out
}

configure_slurm
head -c 1024 /dev/urandom >munge.key
chmod 400 munge.key
start munged --foreground --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munge.seed"
until_true 20 "munge's socket" test -S munge.socket
start slurmctld -D -f "$SLURM_CONF"
start slurmd -D -N n1 -f "$SLURM_CONF"
start slurmd -D -N n2 -f "$SLURM_CONF"
n2=$!
if [ -n "$input" ]; then
  ln -s "$input" puzzles.jsonl
else
  bash "$root/tests/cluster/puzzles.sh" "$puzzles" "$BANKSHOT" >puzzles.jsonl
fi
until_true 60 "two nodes that are up" both_are_up
say "$(wc -l <puzzles.jsonl) puzzles in $parts parts on two nodes"

write_shim
BANKSHOT=./shim sbatch --parsable --array=0-$((parts - 1)) --export="ALL,PARTS=$parts,PUZZLES=puzzles.jsonl" \
  "$root/examples/cluster/batch.slurm" >/dev/null
until_true 7200 "a part in the middle of its lines" test -e middle
lost=$(cat middle)
disown "$n2"  # otherwise the shell reports that it was killed
kill -KILL "$n2"
[ -n "$frozen" ] || signal_jobs KILL n2
say "node n2 is gone; part $lost has $(wc -l <"shots-$lost.jsonl.partial") answers"
if [ -n "$frozen" ]; then
  until_true 600 "a refusal" was_refused
  say "$(grep -h "another bankshot" slurm-*_"$lost".out)"
  signal_jobs CONT n2
  until_true 600 "the part of the frozen node" test -e "shots-$lost.jsonl"
fi
until_true 7200 "an empty queue" all_are_done
say "the queue is empty"
[ -n "$frozen" ] || [ "$(scontrol show job -o | grep -c 'Restarts=1 ')" = 1 ] || give_up "no part was started again"

"$BANKSHOT" merge shots-*.jsonl -o shots.jsonl
if [ -z "$whole" ]; then
  whole=$folder/whole.jsonl
  "$BANKSHOT" batch puzzles.jsonl -o "$whole" --no-timing --quiet
fi
cmp shots.jsonl "$whole"
[ "$(wc -l <shots.jsonl)" = "$(wc -l <puzzles.jsonl)" ] || give_up "an answer is missing"
say "byte for byte a batch in one go: $(sha256sum <shots.jsonl | cut -c-16)"
