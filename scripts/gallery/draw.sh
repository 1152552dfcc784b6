#!/bin/sh
# Draws the pictures of the gallery anew, into share/doc/figures/gallery. Usage: draw.sh <fabricsh>
set -eu
export OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1  # beside other work idle threads would take the time of busy ones
cd "$(dirname "$0")/../.."
program=$1
out=share/doc/figures/gallery
for deck in scripts/gallery/*.lua; do
  case $deck in
    */table.lua) "$program" --quiet "$deck" "$out" 56 ;;
    */drape.lua) "$program" --quiet "$deck" "$out" 20 ;;
    *) "$program" --quiet "$deck" "$out" ;;
  esac
done
characterised=$(mktemp -d)
"$program" --quiet scripts/lab/characterise.lua share/data/synthetic-blend "$characterised"
cp "$characterised/weft.svg" $out/characterise.svg
rm -r "$characterised"
