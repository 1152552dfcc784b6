#!/bin/bash
# The Debian packages: made by cpack, unpacked into an empty root, where the program runs from. With --clean-root: in
# a new Debian made for it, by its own package manager, and a deck run there (needs root, mmdebstrap and a mirror).
# Usage: test_deb.sh <cpack> <build folder> [--clean-root]
set -eu
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if ! command -v dpkg-shlibdeps >/dev/null; then
  echo "SKIPPED: dpkg-dev is not installed"
  exit 77
fi
export SOURCE_DATE_EPOCH=1700000000
(umask 022 && cd "$build" && "$1" -G DEB -B "$work/made" >"$work/log" 2>&1) || { cat "$work/log"; exit 1; }
ls "$work"/made/*.deb
program=$(ls "$work"/made/fabricsh_*.deb)
# Made again, at another time and in another folder: the same bits. The long form alone takes the time.
if [ "${3:-}" = --clean-root ]; then
  (umask 022 && cd "$build" && "$1" -G DEB -D CPACK_COMPONENTS_ALL=program -B "$work/another" >"$work/log" 2>&1) || { cat "$work/log"; exit 1; }
  cmp "$program" "$work"/another/*.deb
  rm -r "$work/another"
fi
for word in libumfpack libvtk libedit liblua5.4 libgomp; do
  dpkg-deb -f "$program" Depends | grep -q "$word" || { echo "Depends names no $word"; exit 1; }
done

deck='local t = require("fabric").lab.uniaxial{ card=require("fabric").card "denim", direction="warp", displacement=5e-3, steps=4 }
assert(t.peak.force > 1); print("runs")'
if [ "${3:-}" = --clean-root ]; then
  if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null; then
    echo "SKIPPED: needs root and mmdebstrap"
    exit 77
  fi
  chmod 755 "$work"
  # the mirrors that this machine uses
  sources=$(find /etc/apt/sources.list.d -name '*.sources' | head -n 1)
  mmdebstrap --variant=minbase --customize-hook="copy-in $program /tmp" \
    --customize-hook='chroot "$1" sh -c "apt-get update && apt-get install -y --no-install-recommends /tmp/fabricsh_*.deb"' \
    "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$work/root" "${sources:-/etc/apt/sources.list}" >"$work/log" 2>&1 ||
    { tail -30 "$work/log"; exit 1; }
  printf '%s\n' "$deck" >"$work/root/tmp/deck.lua"
  [ "$(chroot "$work/root" fabricsh --quiet /tmp/deck.lua | tail -1)" = runs ]
  chroot "$work/root" fabricsh --version
  exit
fi
for deb in "$work"/made/*.deb; do dpkg-deb -x "$deb" "$work/root"; done
unset FABRICSH_HOME
cd "$work"
[ "$(root/usr/bin/fabricsh --quiet -e "$deck" 2>/dev/null | tail -1)" = runs ]
if /usr/bin/python3 -c "import numpy" 2>/dev/null; then
  PYTHONPATH=root/usr/lib/python3/dist-packages FABRICSH=root/usr/bin/fabricsh /usr/bin/python3 -c "import fabricsh; assert fabricsh.run_text('print(arg[1])', 7).stdout == '7\n'"
fi
for file in lib/python3/dist-packages/fabricsh.py include/fabricsh/run/static.hpp share/man/man1/fabricsh.1 share/bash-completion/completions/fabricsh; do
  [ -e "root/usr/$file" ] || { echo "no /usr/$file"; exit 1; }
done
