#!/bin/sh
# Fuzzes one target on a copy of its corpus. Usage: run.sh <program> <tests/fuzz> <target> <seconds>
# Its findings stay in the folder fuzz-<target> below the current one.
set -eu
program=$1 data=$2 target=$3 seconds=$4
mkdir -p "fuzz-$target/corpus"
cd "fuzz-$target"
cp "$data/corpus/$target"/* corpus/
cp "$data/found/$target"/* corpus/ 2>/dev/null || true
words=
if [ "$target" = card ]; then
  cp "$data/../../share/cards"/*.lua corpus/
  words=-dict=$data/card.dict
  export FABRICSH_HOME="$data/../.."
fi
# The libraries below keep what they made until the end; only what a single input leaks counts.
exec "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 -max_len=65536 -print_final_stats=1 $words corpus
