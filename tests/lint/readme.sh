#!/bin/sh
# The deck in README.md runs. Usage: readme.sh <root of the tree> <fabricsh>
set -eu
sed -n '/^```lua$/,/^```$/p' "$1/README.md" | sed '/^```/d' >first.lua
test -s first.lua
"$2" --quiet first.lua
test -s out/first/strip.pvd
