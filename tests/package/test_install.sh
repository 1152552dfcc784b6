#!/bin/sh
# The tree that `cmake --install` writes works where it stands: the program finds its Lua modules and cards, a C++ project
# finds the core and gets the closed form. Usage: test_install.sh <cmake> <build folder> <source folder>
set -eu
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
"$1" --install "$2" --prefix "$prefix" >/dev/null
cd "$prefix"
unset FABRICSH_HOME FABRICSH
bin/fabricsh -e 'local fabric = require "fabric"; assert(fabric.card("denim").thickness > 0)'
bin/fabricsh --quiet share/fabricsh/scripts/thesis/uniaxial.lua blend warp free 20 "$prefix/out" >/dev/null
# Photographs are a part: without its module a call names the package, and all else is as it was.
photograph='local fabric = require "fabric"
local ok, why = pcall(fabric.lab.photograph, { file="out/dots.png", rows=2, columns=2, pitch=20, radius=4, width=60, height=60 })
if not ok then print((tostring(why):match "photograph: .*")) end'
module=$(find . -name photographs.so)
if [ -n "$module" ]; then
  [ -z "$(bin/fabricsh --quiet --safe -e "$photograph")" ] && [ -s out/dots.png ]
  echo broken >"$module"
  bin/fabricsh --quiet -e "$photograph" | grep -q 'photograph: photographs: cannot load the part: .*photographs.so'
  rm "$module"
fi
bin/fabricsh --quiet -e "$photograph" |
  grep -q 'photograph: photographs are a part that is not installed (Debian package fabricsh-photographs, or'
if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=share/fabricsh/share/python \
    /usr/bin/python3 -c 'import fabricsh, os; assert fabricsh.read_card("denim")["name"] == "denim" and fabricsh.find_program() == os.path.realpath("bin/fabricsh")'
fi

"$1" -S "$3/tests/package/consumer" -B consumer -DCMAKE_PREFIX_PATH="$prefix" >log 2>&1 &&
  "$1" --build consumer >>log 2>&1 || { cat log; exit 1; }
consumer/consumer
# A drape with its table, series and checkpoint, cut at half time and gone on with by a second process: the same table.
consumer/drape whole >/dev/null
consumer/drape half stop >/dev/null
consumer/drape half go-on
cmp whole/drape.csv half/drape.csv
grep -q drape_00004.vtu half/drape.pvd
grep -q '"status": "done"' half/run.json
if grep -rl -e "$3" -e "$2" lib share >found; then
  echo "installed files name the source or build folder:"
  cat found
  exit 1
fi
