#!/bin/sh
# A study as an array job, with a task missing and with its tasks at once; broken off and taken up again.
# Usage: run.sh <fabricsh> <source folder>
set -u
program=$1 deck=$2/scripts/study/thickness.lua
root=$(mktemp -d) && cd "$root" || exit 1
trap 'rm -rf "$root"' EXIT
fail() { echo "FAILED: $*" && exit 1; }

"$program" --quiet "$deck" whole >/dev/null 2>&1 || fail "the study by itself"
task() {
  SLURM_ARRAY_TASK_ID=$1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_MAX=3 "$program" --quiet --threads 1 "$deck" "$2"
}

# One after the other: each its share, the table at the end.
task 1 turns >said 2>/dev/null || fail "task 1"
grep -q '4 of 6 cases are still missing' said || fail "task 1 says $(cat said)"
task 3 turns >said 2>/dev/null || fail "task 3"
[ ! -e turns/study.csv ] || fail "a table before all cases are there"
[ "$(find turns -name 'case-*' | wc -l)" -eq 4 ] || fail "two cases each"
task 2 turns >said 2>/dev/null || fail "task 2"
cmp turns/study.csv whole/study.csv || fail "the array's table is another one"

# All at once.
for i in 1 2 3; do task $i once >/dev/null 2>&1 & done
wait
task 1 once >/dev/null 2>&1
cmp once/study.csv whole/study.csv || fail "the table of tasks side by side is another one"

# Numbers of tasks that are no plain range.
SLURM_ARRAY_TASK_ID=9 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=1 "$program" --quiet "$deck" no >said 2>&1 && fail "task 9 of 3"
grep -q 'task 9 is outside the array of 3 tasks that begins at 1' said || fail "task 9 says $(cat said)"

SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_STEP=0 "$program" --quiet "$deck" no >said 2>&1 && fail "steps of 0"
grep -q 'SLURM_ARRAY_TASK_STEP: expected a whole number of at least 1 ' said || fail "steps of 0: $(cat said)"
# All values in one variable, two in the others.
for name in ID COUNT MIN STEP; do
  values='-1 1.5'
  [ $name != ID ] || values='4e12 4294967294 9223372036854775807 -1 1.5 1e400 nan'
  for value in $values; do
    env SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=1 "SLURM_ARRAY_TASK_$name=$value" "$program" --quiet "$deck" no >said 2>&1 && fail "$name=$value"
    grep -q "the variable SLURM_ARRAY_TASK_$name: expected a whole number of at least [01] and at most 1000000000, got '$value'" said || fail "$name=$value: $(cat said)"
  done
done

# Broken off by each signal; no worker stays behind, what is done is kept, the rest is done on the second run. The
# cases from the fourth on wait, so that the signal finds some of them under way however busy the machine is.
cat >slow.lua <<'EOF'
local s = require "fabric".study { parameters = { n = { 1, 2, 3, 4, 5, 6, 7, 8 } }, folder = arg[1], workers = 2, run = function(p)
  io.open(arg[1] .. "-log", "a"):write(p.n, "\n")
  while p.n > 3 and not io.open(arg[1] .. "-go") do end
  return { square = p.n ^ 2 }
end }
assert(s.complete and s[8].values.square == 64)
EOF
for signal in INT TERM KILL; do
  "$program" --quiet slow.lua "slow-$signal" "$root" >said 2>&1 &
  process=$!
  for _ in $(seq 1200); do
    [ "$(find . -path "./slow-$signal/case-*" | wc -l)" -ge 3 ] && break
    sleep 0.05
  done
  kill -$signal $process
  wait $process && fail "$signal did not end it"
  [ $signal != INT ] || grep -q "study: interrupted; 3 of 8 cases are kept in 'slow-INT', run the same deck again to continue" said ||
    fail "INT says $(cat said)"
  for _ in $(seq 1200); do
    workers=$(pgrep -f "slow.lua slow-$signal $root" | wc -l)
    [ "$workers" -eq 0 ] && break
    sleep 0.05
  done
  [ "$workers" -eq 0 ] || fail "$signal left $workers workers"
  kept=$(find slow-$signal -name 'case-*' | wc -l)
  [ "$kept" -eq 3 ] || fail "$signal: $kept cases kept"
  touch "slow-$signal-go"
  before=$(wc -l <slow-$signal-log)
  "$program" --quiet slow.lua "slow-$signal" || fail "$signal: the second run"
  [ $(($(wc -l <slow-$signal-log) - before)) -eq $((8 - kept)) ] || fail "$signal: finished cases ran again"
done

# A case whose process ends without a word is missing, not done.
cat >dies.lua <<'EOF'
local s = require "fabric".study { parameters = { n = { 1, 2, 3 } }, folder = arg[1], workers = 1, run = function(p)
  if p.n == 2 then os.exit(0) end
  if p.n == 3 then error "no" end
  return { square = p.n ^ 2 }
end }
assert(not s.complete and s.missing == 1 and s.failed == 1)
EOF
"$program" dies.lua dies >said 2>&1 || fail "a case that leaves: $(cat said)"
grep -q 'study: 2 of 3 done, 1 failed, 1 without an answer' said || fail "a case that leaves says $(cat said)"

# Safe as well, the variables of an array job being the only ones that such a deck sees.
mkdir deck && cp "$deck" deck/
SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=1 "$program" --quiet --safe deck/thickness.lua >said 2>/dev/null || fail "--safe"
grep -q '4 of 6 cases are still missing' said || fail "--safe says $(cat said)"

# Each case is a process of its own; a warning that all of them have is said once, and not again by what follows.
cat >warns.lua <<'EOF'
local fabric = require "fabric"
local function same() fabric.warn "the same in all cases" end
fabric.study { parameters = { n = { 1, 2, 3, 4, 5, 6 } }, folder = "warns", workers = 3, run = function(p)
  same()
  fabric.warn("of case " .. p.n)
  return { n = p.n }
end }
same()
fabric.warn "of the deck"
EOF
"$program" --quiet warns.lua >said 2>&1 || fail "a study with warnings"
[ "$(grep -c 'the same in all cases' said)" -eq 1 ] || fail "the warning of all cases: $(cat said)"
[ "$(grep -c 'of case' said)" -eq 6 ] && [ "$(grep -c 'of the deck' said)" -eq 1 ] || fail "warnings that differ: $(cat said)"
# Cases one by one, in any order; listing computes nothing; what stands behind run() may change.
cat >cases.lua <<'EOF'
local s = require "fabric".study { sample = require "fabric".sobol { x = { 0, 1 }, n = 3 }, folder = "cases", run = function(p)
  return { double = 2 * p.x }
end }
print(s.complete)
EOF
"$program" --quiet --cases cases.lua >said 2>&1 || fail "--cases: $(cat said)"
[ "$(grep -c '^[123].x = 0[.]' said)" -eq 3 ] && [ ! -e cases ] || fail "--cases says $(cat said)"
for k in 3 1 2; do "$program" --quiet --case $k cases.lua >said 2>&1 || fail "--case $k: $(cat said)"; done
grep -q true said && [ -e cases/study.csv ] || fail "three cases one by one: $(cat said)"
"$program" --quiet --case 4 cases.lua >said 2>&1 && fail "--case 4 of 3"
grep -q -- '--case 4: the study has 3 cases' said || fail "--case 4 says $(cat said)"
"$program" --quiet --case 0 cases.lua >said 2>&1 && fail "--case 0"
grep -q -- '--case: expected the number of a case, from 1 on' said || fail "--case 0 says $(cat said)"
echo 'print "a plot"' >>cases.lua
"$program" --quiet cases.lua >said 2>&1 && grep -q 'a plot' said || fail "a line behind run(): $(cat said)"
sed -i 's/2 \* p.x/3 * p.x/' cases.lua
"$program" --quiet cases.lua >said 2>&1 && fail "another run()"
grep -q 'before it was changed' said || fail "another run() says $(cat said)"

# Through joblib, where it is installed.
if python3 -c 'import joblib' 2>/dev/null; then
  rm -r cases
  PROGRAM=$program python3 -c '
import os, subprocess
from joblib import Parallel, delayed
case = lambda k: subprocess.run([os.environ["PROGRAM"], "--quiet", "--threads", "1", "--case", str(k), "cases.lua"], check=True)
Parallel(n_jobs=2)(delayed(case)(k) for k in range(1, 4))' >said 2>&1 || fail "joblib: $(cat said)"
  "$program" --quiet cases.lua >said 2>&1 && grep -q true said || fail "joined: $(cat said)"
else
  echo "joblib is not installed: its example is not run"
fi
echo "all kept"
