#!/bin/bash
# An array job of Slurm, submitted to a controller and a daemon of this machine that live for this test alone: the tasks share the study, one that is
# cancelled leaves its cases missing, and the same job submitted again computes these. Needs the packages slurmctld, slurmd and slurm-client, and root.
# Usage: slurm.sh <fabricsh> <source folder>
set -u
program=$1 deck=$2/scripts/study/thickness.lua
for needed in slurmctld slurmd sbatch squeue scancel; do
  PATH=$PATH:/usr/sbin command -v $needed >/dev/null || { echo "SKIPPED: $needed is not installed (Debian packages slurmctld, slurmd, slurm-client)" && exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "SKIPPED: slurmd has to be started by root" && exit 77; }
root=$(mktemp -d) && cd "$root" || exit 1
controller= daemon=
end() {
  for process in $daemon $controller; do kill "$process" 2>/dev/null && wait "$process" 2>/dev/null; done
  rm -rf "$root"
}
trap end EXIT
fail() { echo "FAILED: $*"; tail -n 5 controller.log daemon.log job-*.log 2>/dev/null; exit 1; }

port=$((20000 + $$ % 20000))
host=$(hostname -s)
mkdir state spool
cat >slurm.conf <<CONF
ClusterName=study
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$root/state
SlurmdSpoolDir=$root/spool
SlurmctldPidFile=$root/controller.pid
SlurmdPidFile=$root/daemon.pid
SlurmctldLogFile=$root/controller.log
SlurmdLogFile=$root/daemon.log
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=10 State=UP
CONF
export SLURM_CONF=$root/slurm.conf PATH=$PATH:/usr/sbin
slurmctld -D >/dev/null 2>&1 & controller=$!
slurmd -D -N "$host" >/dev/null 2>&1 & daemon=$!
for _ in $(seq 300); do sinfo -h -o %T 2>/dev/null | grep -q idle && break; sleep 0.1; done
sinfo -h -o %T | grep -q idle || fail "no node is idle: $(sinfo 2>&1)"

# The words of sbatch files are those of the shipped one.
cat >job.sbatch <<JOB
#!/bin/bash
#SBATCH --array=1-3
#SBATCH --cpus-per-task=1
#SBATCH --output=job-%A-%a.log
exec "$program" --quiet --threads "\$SLURM_CPUS_PER_TASK" "\$1" "\$2"
JOB
submit() { sbatch --parsable "$@" || fail "sbatch $*"; }
over() {
  for _ in $(seq 1200); do [ -z "$(squeue -h 2>/dev/null)" ] && return; sleep 0.1; done
  fail "jobs are still there: $(squeue 2>&1)"
}

"$program" --quiet "$deck" whole >/dev/null 2>&1 || fail "the study by itself"
submit job.sbatch "$deck" shared >/dev/null
over
[ -e shared/study.csv ] || "$program" --quiet "$deck" shared >/dev/null 2>&1 # the last tasks may have ended at the same moment
cmp shared/study.csv whole/study.csv || fail "the table of the array is another one"

# The second task of three waits until it is cancelled; the same array then computes what is missing.
cat >waits.lua <<'DECK'
local s = require "fabric".study { parameters = { n = { 1, 2, 3, 4, 5, 6 } }, folder = arg[1], run = function(p)
  while p.n == 5 and not io.open(arg[1] .. "-go") do end
  return { square = p.n ^ 2 }
end }
print(s.complete)
DECK
job=$(submit job.sbatch "$root/waits.lua" cut)
for _ in $(seq 1200); do [ "$(find cut -name 'case-*' 2>/dev/null | wc -l)" -eq 5 ] && break; sleep 0.1; done
scancel "${job}_2" || fail "scancel"
over
[ "$(find cut -name 'case-*' | wc -l)" -eq 5 ] && [ ! -e cut/study.csv ] || fail "after the cancelled task: $(ls cut)"
touch cut-go
job=$(submit job.sbatch "$root/waits.lua" cut)
over
grep -q true job-"$job"-2.log && [ "$(grep -c , cut/study.csv)" -eq 7 ] || fail "submitted again"
echo "an array of three tasks gives the table of the study by itself; after scancel the same array computes what is missing"
