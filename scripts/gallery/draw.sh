#!/bin/sh
# Draws every picture of share/doc anew: those of the gallery, of the law, of the thesis, of contact and of the pages, each by the deck or
# page that shows it. Minutes; on one processor half an hour. (drape_disc.png and drape_outlines.svg
# are drawn by scripts/long/drape_table.lua.) Usage: draw.sh <fabricsh> [gallery|garment|law|thesis|contact|pages ...]
set -eu
export OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1  # beside other work idle threads would take the time of busy ones
cd "$(dirname "$0")/../.."
root=$PWD
program=$(realpath "$1")
shift
out=$root/share/doc/figures
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

gallery() {
  for deck in scripts/gallery/*.lua; do
    case $deck in
      */table.lua) "$program" --quiet "$deck" "$out/gallery" 96 ;;
      */drape.lua|*/sleeve.lua) "$program" --quiet "$deck" "$out/gallery" 32 ;;
      */fall.lua)
        "$program" --quiet "$deck" "$work" 28 36
        python3 scripts/gallery/movie.py "$out/gallery/fall.png" 70 "$work"/fall_0*.png
        ;;
      */dome.lua) "$program" --quiet "$deck" "$out/gallery" 20 ;;
      */balloon.lua) "$program" --quiet "$deck" "$out/gallery" 16 ;;
      *) "$program" --quiet "$deck" "$out/gallery" ;;
    esac
  done
  "$program" --quiet scripts/lab/characterise.lua share/data/synthetic-blend "$work/mine"
  cp "$work/mine/weft.svg" "$out/gallery/characterise.svg"
}

# worn <deck of scripts/garment> <file that it draws> <name in share/doc> <arguments> ...
worn() {
  deck=$1 drawn=$2 name=$3
  shift 3
  "$program" --quiet "scripts/garment/$deck.lua" "$@"
  cp "$work/$drawn" "$out/gallery/$name"
}

garment() {
  worn cushion cushion.png cushion.png "$work"
  worn glove glove/glove.png glove.png muslin 4 15 0.01 "$work/glove"
  worn sleeve sleeve/sleeve.png worn_sleeve.png blend 12 30 0.02 "$work/sleeve" 3
  worn skirt skirt/skirt.png skirt.png blend 40 1 0.4 "$work/skirt" 32
}

law() {
  for name in biaxial loops reload shear; do "$program" --quiet "scripts/law/$name.lua" "$out"; done
  "$program" --quiet scripts/lab/loops.lua "$work/loops"
  cp "$work/loops/lab_loops.svg" "$out"
}

# thesis_figure <name in share/doc> <deck> <file below out/thesis>
thesis_figure() {
  [ -e "$work/out/thesis/$3" ] || (cd "$work" && "$program" --quiet "$root/scripts/thesis/$2.lua")
  cp "$work/out/thesis/$3" "$out/$1"
}

thesis() {
  thesis_figure thesis_buckling.png fig_7_09_buckling fig_7_09/snapshots.png
  thesis_figure thesis_zones.png fig_7_20_bias_blend fig_7_20/zones.png
  thesis_figure thesis_fields.png fig_7_26_fields fig_7_26/S11.png
  thesis_figure thesis_ratios.svg table_7_4_ratios table_7_4/muslin_warp.svg
  thesis_figure thesis_drape.png drape drape/frames.png
  thesis_figure thesis_poke.png poke poke/frames.png
}

# page_figures <page> <file that it writes> <name in share/doc> ...
page_figures() {
  page=$1
  shift
  mkdir -p "$work/$page"
  (cd "$work/$page" && "$program" "$root/tests/doc/page.lua" "$root" "$root/share/doc/$page.md")
  while [ $# -gt 0 ]; do
    cp "$work/$page/page/$1" "$out/$2"
    shift 2
  done
}

# fine_figure <page> <deck on it> <file that it writes> <name in share/doc> ...: the deck with the argument "fine"
fine_figure() {
  mkdir -p "$work/fine"
  (cd "$work/fine" && awk -v deck="$2" '$0 == "```lua " deck { on = 1; next } /^```/ { on = 0 } on' "$root/share/doc/$1.md" >"$2" &&
    "$program" --quiet "$2" fine)
  shift 2
  while [ $# -gt 0 ]; do
    cp "$work/fine/$1" "$out/$2"
    shift 2
  done
}

contact() { "$program" --quiet scripts/contact/pictures.lua "$work/contact" 16 && cp "$work"/contact/contact_*.png "$out"; }

pages() {
  page_figures tutorial out/pull/strip.png tutorial_strip.png
  page_figures howto/contact out/ball.png contact_tutorial_ball.png out/curves.svg contact_tutorial_curves.svg
  page_figures howto/own-mesh out/disc.png howto_ring.png
  page_figures howto/garment out/tunic.png howto_garment.png
  page_figures howto/bias-angle out/angle.png howto_angle.png
  page_figures howto/own-csv out/mine/weft.svg howto_own_csv.svg out/mine/compare.svg tutorial_compare.svg
  page_figures howto/ball-drop out/drop.png howto_ball.png out/drop.svg howto_ball.svg
  fine_figure howto/drape drape.lua out/disc.png howto_drape_coefficient.png out/outlines.svg howto_drape_outlines.svg
  fine_figure howto/sleeve sleeve.lua out/sleeve.png howto_sleeve.png
  page_figures howto/plot out/weft.svg howto_weft.svg out/spread.svg howto_spread.svg out/panels.svg howto_plots.svg out/bias.png \
    howto_panels.png out/views.png howto_views.png
}

[ $# -gt 0 ] || set -- gallery garment law thesis contact pages
for part; do "$part"; done
find "$out" -type f ! -name fall.png -size +250k | while read -r large; do echo "$large is larger than 250 kB" && false; done
