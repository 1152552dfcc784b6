#!/bin/sh
# The installed program finds its Lua modules and cards: installs into a folder far from the build tree and runs
# it there. Usage: test_install.sh <cmake> <build folder>
set -eu
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
"$1" --install "$2" --prefix "$prefix" >/dev/null
cd "$prefix"
unset FABRICSH_HOME
bin/fabricsh -e 'local fabric = require "fabric"; assert(fabric.card("denim").thickness > 0)'
