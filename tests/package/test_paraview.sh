#!/bin/bash
# scripts/demo on a machine that has Debian's ParaView, which libvtk9-dev would remove: in a new Debian made for it, it
# builds, pulls its strip, and leaves ParaView where it was (needs root, mmdebstrap and a mirror; takes long).
# Usage: test_paraview.sh <source folder>
set -eu
source=$1
if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null; then
  echo "SKIPPED: needs root and mmdebstrap"
  exit 77
fi
work=$(mktemp -d)
clean() {
  umount "$work/root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$work"
}
trap clean EXIT
chmod 755 "$work"
# the mirrors that this machine uses
sources=$(find /etc/apt/sources.list.d -name '*.sources' | head -n 1)
mmdebstrap --variant=apt --aptopt='APT::Install-Recommends "false"' --include=paraview,python3-paraview \
  "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$work/root" "${sources:-/etc/apt/sources.list}" >"$work/log" 2>&1 ||
  { tail -30 "$work/log"; exit 1; }
in_root() { chroot "$work/root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C "$@"; }
mount -t proc proc "$work/root/proc" 2>/dev/null || true
mkdir "$work/root/source"
tar -C "$source" --exclude=./build --exclude='./build-*' --exclude=./.git -cf - . | tar -C "$work/root/source" -xf -

state() { in_root dpkg-query -W -f='${db:Status-Status} ${Package}\n' | sort; }
state >"$work/before"
in_root /source/scripts/demo 2>&1 | tee "$work/demo"
state >"$work/after"

trouble=0
gone=$(comm -23 "$work/before" "$work/after")
[ -z "$gone" ] || { echo "no longer installed: $gone"; trouble=1; }
for name in paraview python3-paraview; do
  grep -qx "installed $name" "$work/after" || { echo "$name is not installed"; trouble=1; }
done
! grep -qx "installed libvtk9-dev" "$work/after" || { echo "libvtk9-dev is installed: nothing was tried"; trouble=1; }
grep -q 'as packages they would remove ParaView' "$work/demo" || { echo "nothing was said"; trouble=1; }
in_root /source/build/fabricsh --version | grep -q 'VTK 9' || { echo "the program does not run"; trouble=1; }
# a second call finds all in its place
in_root /source/scripts/demo >"$work/again" 2>&1 || { cat "$work/again"; trouble=1; }
! grep -qE '^(installing|unpacking)' "$work/again" || { cat "$work/again"; trouble=1; }
exit $trouble
