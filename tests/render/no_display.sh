#!/bin/sh
# Where there is no display and no Xvfb, fabric.render says so and what to do. Usage: no_display.sh <fabricsh>
set -eu
program=$1
cat >sheet.lua <<'DECK'
local fabric = require "fabric"
fabric.mesh.rectangle{ width = 0.1, height = 0.1, nx = 2, ny = 2 }:write "sheet.vtu"
local ok, message = pcall(fabric.render, { file = "sheet.png", vtu = "sheet.vtu" })
assert(not ok and tostring(message):find("no display to draw on: install Xvfb", 1, true), tostring(message))
assert(not io.open "sheet.png")
DECK
env -u DISPLAY PATH=/nonexistent "$program" --quiet sheet.lua
