#!/bin/sh
# Faults that luacheck finds in the Lua of the tree: names that nobody defined, values that nobody reads. Usage: lua.sh <root of the tree>
set -eu
if ! command -v luacheck >/dev/null; then
  echo "SKIPPED: no luacheck (Debian's lua-check)"
  exit 77
fi
cd "$1"
exec luacheck --config scripts/luacheckrc --no-color --codes --quiet lua scripts share/cards tests
