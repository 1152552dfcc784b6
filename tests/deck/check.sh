#!/bin/sh
# Loads and validates every deck of the tree without running it, and names those in which it finds an error.
# Arguments: the program, the folder of the sources.
program=$1 root=$2
count=0 wrong=0
for deck in $(cd "$root" && find scripts tests/archive -name '*.lua' ! -name card.lua ! -path scripts/thesis/all.lua | sort); do
  count=$((count + 1))
  "$program" --quiet --check "$root/$deck" >said 2>&1 && continue
  wrong=$((wrong + 1))
  echo "$deck:"
  cat said
done
echo "$count decks, $wrong with errors"
[ "$count" -ge 100 ] && [ "$wrong" -eq 0 ]
