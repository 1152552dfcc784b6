#!/bin/sh
# The state of a run goes to the drawing program through a folder of its own: nothing in the folder of temporary files
# can be prepared for it, and nothing stays there. Usage: private.sh <fabricsh>
set -eu
program=$1
rm -rf temporary && mkdir temporary
echo untouched >victim
cat >run.lua <<'DECK'
local fabric = require "fabric"
local strip = fabric.lab.uniaxial { card = fabric.card "blend", unload = false, steps = 2 }
local ok, message = pcall(fabric.render, { file = "run.png", run = strip.analysis })
if not ok and tostring(message):find("no display", 1, true) then return end
assert(ok, message)
DECK
# A link where another user could guess that the program of this number will write.
TMPDIR=$PWD/temporary sh -c 'ln -s ../victim "temporary/fabricsh-$$-frame.vtu"; exec "$0" --quiet run.lua' "$program"
[ "$(cat victim)" = untouched ] || { echo "FAILED: it wrote through the link" && exit 1; }
[ "$(find temporary -mindepth 1 ! -type l | wc -l)" -eq 0 ] || { echo "FAILED: left behind: $(ls temporary)" && exit 1; }
echo 'local ok, message = pcall(require "fabric".render, { file = "no.png", run = require "fabric".lab.uniaxial {
  card = require "fabric".card "blend", unload = false, steps = 2 }.analysis }) print(message)' >nowhere.lua
TMPDIR=/nonexistent "$program" --quiet nowhere.lua 2>&1 | grep -q 'render: no folder for a temporary file (TMPDIR, or /tmp): '
