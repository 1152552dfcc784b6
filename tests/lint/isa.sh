#!/bin/sh
# Code compiled for a wider instruction set must not leak: a weak function outside its own namespace could be the
# copy that the linker keeps, and stop the program on a machine without that set.
# Usage: isa.sh <avx2|avx512> <object file>...
set -eu
isa=$1
shift
leaks=$(nm -C --defined-only "$@" | awk -v isa="::$isa::" '$2 == "W" && index($0, isa) == 0')
if [ -n "$leaks" ]; then
  echo "weak functions compiled for $isa outside its namespace:"
  echo "$leaks" | sed 's/^[0-9a-f]* *//' | sort -u
  exit 1
fi
