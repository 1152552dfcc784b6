#!/bin/sh
# The lint can fail: each bad tree must be refused with its own words, and the good one must pass.
set -u
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# A tree with three rooms, in order, without a fault.
good_tree() {
  rm -rf "$work/tree"
  mkdir -p "$work/tree/src/base" "$work/tree/src/linear" "$work/tree/src/app" "$work/tree/scripts"
  cd "$work/tree" || exit 1
  printf '# rooms\nbase:\nlinear: base\nformat: base\napp: base linear\n' >src/LAYERS
  printf '#pragma once\n#include <vector>\n// printf("x") is only words\n' >src/base/a.hpp
  printf '#include "base/a.hpp"\n#include "fabricsh_config.hpp"\n' >src/base/a.cpp
  printf '#include <umfpack.h>\n#include "base/a.hpp"\n' >src/linear/s.cpp
  printf '#include "base/a.hpp"\n#include "linear/s.hpp"\nint main() { std::cout << 1; std::exit(0); }\n' >src/app/main.cpp
  mkdir -p "$work/tree/src/format"
  printf '#include "base/a.hpp"\n' >src/format/f.cpp
  printf 'fabric.expect{ {"x", 1, 1} }\n' >scripts/deck.lua
  mkdir -p lua/fabric/low lua/fabric/high
  printf '# rooms\n.:\nlow:\nlow/apart:\nhigh: . low/apart\nlibrary: high\n' >lua/LAYERS
  printf 'local define, b = require "fabric.define", require "fabric.low.b"\n' >lua/fabric/low/a.lua
  printf 'require "fabric.sorted"\nlocal n = require("fabric.low.apart")(2)\n' >lua/fabric/high/init.lua
  printf 'require "fabric.high"\n' >lua/fabric/library.lua
  : >lua/fabric/sorted.lua
}

# refuses <words>: the tree as it stands must fail, and say the words.
refuses() {
  if output=$(sh "$here/lint.sh" "$work/tree" 2>&1); then
    echo "passed a tree that it should refuse with: $1"
    failures=$((failures + 1))
  elif ! printf '%s\n' "$output" | grep -qF -- "$1"; then
    printf 'expected the words: %s\ngot: %s\n' "$1" "$output"
    failures=$((failures + 1))
  fi
}

# bad <file> <line> <words>: one more line makes the good tree bad.
bad() {
  good_tree
  mkdir -p "$(dirname "$1")"
  printf '%s\n' "$2" >>"$1"
  refuses "$3"
}

good_tree
if ! sh "$here/lint.sh" "$work/tree"; then
  echo "refused the good tree"
  failures=$((failures + 1))
fi

bad src/base/a.hpp '#include "linear/s.hpp"' "of a room below it"
bad src/linear/s.cpp '  #  include "app/x.hpp"' "of a room below it"
bad src/LAYERS 'output: format linear assembly' "needs 'assembly', which does not stand above it"
bad src/LAYERS 'base: base' "stands there twice"
bad_folder() {
  good_tree
  printf 'app/: low high\n' >>src/LAYERS
  mkdir -p src/app/low src/app/high src/app/other
  printf '#include "%s"\n' "$2" >"src/app/$1"
  refuses "$3"
}
bad_folder low/a.cpp app/high/b.hpp "folder 'low' of room 'app' includes 'app/high/b.hpp' of a later folder"
bad_folder other/a.cpp app/low/b.hpp "'other' is no folder of room 'app'"
bad src/LAYERS 'Base = x' "expected 'room: rooms it needs'"
bad src/app/main.cpp '#include "format/csv.hpp"' "src/LAYERS does not name 'format' for it"
bad src/LAYERS 'run: linear' "room 'run' includes nothing of room 'linear'"
bad src/app/main.cpp '#include "plugin/x.hpp"' "is no room of src/LAYERS"
bad src/app/main.cpp '#include "x.hpp"' "without its room"
bad src/linear/s.cpp '#include "fabricsh_config.hpp"' "without its room"
bad src/base/a.cpp '#include "../linear/s.hpp"' "is no room of src/LAYERS"
bad src/extra/x.cpp 'int x;' "room 'extra' is not in src/LAYERS"
bad src/app/main.cpp '#include <umfpack.h>' "<umfpack.h>, which belongs to: linear"
bad src/app/main.cpp '#include <suitesparse/cholmod.h>' "which belongs to: linear"
bad src/linear/s.cpp '#include <vtkNew.h>' "which belongs to: format"
bad src/linear/s.cpp '#include <lauxlib.h>' "which belongs to: script repl"
bad src/linear/s.cpp '#include <lua.hpp>' "which belongs to: script repl"
bad src/app/main.cpp '#include <histedit.h>' "which belongs to: repl"
bad src/base/a.hpp '#include "base/a.hpp"' "in a circle"
bad src/linear/s.cpp '  std::cerr << 1;' "prints; only app and repl do"
bad src/linear/s.cpp '  printf("x");' "prints; only app and repl do"
bad src/linear/s.cpp '  std::fputs(text, stderr);' "prints; only app and repl do"
bad src/linear/s.cpp '  std::exit(1);' "ends the program"
bad src/linear/s.cpp '  std::ifstream file(path);' "past the gate"
bad src/linear/s.cpp '  const int n = ::open(path, O_RDONLY);' "past the gate"
bad src/linear/s.cpp '  if (std::filesystem::exists(path, trouble)) return;' "asks for a file past the gate"
bad src/linear/s.cpp '  if (fs::is_regular_file(path)) return;' "asks for a file past the gate"
bad src/linear/s.cpp '  if (::stat(path, &about) == 0) return;' "asks for a file past the gate"
bad lua/fabric/low/a.lua 'local c = require "fabric.high.c"' "room 'low' requires 'high/c', and lua/LAYERS does not name 'high' for it"
bad lua/fabric/high/c.lua 'local a, b = require "fabric.low.apart", require "fabric.low.a"' "does not name 'low' for it"
bad lua/fabric/sorted.lua 'require "fabric.library"' "does not name 'library' for it"
bad lua/fabric/more/a.lua '' "room 'more' is not in lua/LAYERS"
bad lua/fabric/low/a.lua 'require "fabric.more.a"' "which is in no room of lua/LAYERS"
bad lua/LAYERS 'top: low more' "needs 'more', which does not stand above it"
bad lua/LAYERS 'top: low' "room 'top' requires nothing of room 'low'"
bad lua/LAYERS 'low:' "stands there twice"
bad lua/LAYERS 'low = high' "expected 'room: rooms it needs'"
bad src/base/long.hpp "$(yes '//' | head -n 801)" "is 801 lines long"
bad scripts/other.lua 'print(1)' "scripts/other.lua: has no expect{...} block"

good_tree
printf '#include "base/c.hpp"\n' >src/base/b.hpp
printf '#include "base/b.hpp"\n' >src/base/c.hpp
refuses "in a circle"

good_tree
: >src/LAYERS
refuses "names no room"

# Without its formatter the check of the form fails; it is not left out in silence.
if said=$(PATH=/nonexistent /bin/sh "$here/format.sh" . 2>&1) || [ "${said#*clang-format 14 is not installed}" = "$said" ]; then
  echo "FAILED: without clang-format the check of the form says: $said"
  failures=$((failures + 1))
fi

[ "$failures" -eq 0 ] || exit 1
echo "the lint refuses what it should"
