#!/bin/sh
# Loads and validates decks without running them, and names those in which it finds an error: all that the suite
# does not run (scripts/long and those named), those of earlier releases, and every fifth of the others.
# Arguments: the program, the folder of the sources, decks in scripts that only the long suite runs.
program=$1 root=$2
shift 2
nightly=" $* "
count=0 wrong=0 place=0
for deck in $(cd "$root" && find scripts tests/archive -name '*.lua' ! -name card.lua ! -path scripts/thesis/all.lua | sort); do
  place=$((place + 1))
  case $deck in
    scripts/long/* | tests/archive/*) ;;
    *)
      case $nightly in *" ${deck#scripts/} "*) ;; *) [ $((place % 5)) -eq 0 ] || continue ;; esac
      ;;
  esac
  count=$((count + 1))
  "$program" --quiet --check "$root/$deck" >said 2>&1 && continue
  wrong=$((wrong + 1))
  echo "$deck:"
  cat said
done
echo "$count decks, $wrong with errors"
[ "$count" -ge 50 ] && [ "$wrong" -eq 0 ]
