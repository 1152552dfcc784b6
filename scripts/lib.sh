# Shared by scripts/demo and scripts/test: packages, configure, build. Sourced with $root set.
# shellcheck shell=bash

# Debian and Ubuntu packages; a|b: either will do.
packages=(
  g++ cmake ninja-build 'pkg-config|pkgconf' xvfb
  libeigen3-dev liblua5.4-dev libsuitesparse-dev libopenblas-dev libvtk9-dev zlib1g-dev libedit-dev
  catch2 'gnuplot-nox|gnuplot-qt|gnuplot-x11'
)
build=$root/build

say() { printf '%s\n' "$*" >&2; }

# run_logged <log> <command...>: quiet when it works, the end of the log when it does not.
run_logged() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    say "failed: $*"
    say "whole log: $log"
    return 1
  fi
}

installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# The first name of every wanted package of which no alternative is installed.
missing_packages() {
  local wanted name
  for wanted in "${packages[@]}"; do
    for name in ${wanted//|/ }; do
      installed "$name" && continue 2
    done
    printf '%s\n' "${wanted%%|*}"
  done
}

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: needs the like of ${packages[*]}"
    return 0
  fi
  local missing
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -gt 0 ] || return 0
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get)
  if [ "$(id -u)" -ne 0 ]; then
    if ! sudo -n true 2>/dev/null; then
      say "Packages are missing. As root:"
      say "apt-get install --no-install-recommends ${missing[*]}"
      exit 1
    fi
    apt=(sudo -n "${apt[@]}")
  fi
  say "installing ${missing[*]}"
  mkdir -p "$build"
  run_logged "$build/apt.log" "${apt[@]}" update
  run_logged "$build/apt.log" "${apt[@]}" install -y --no-install-recommends "${missing[@]}"
}

# configure <option...>: Release with Ninja; a build folder that is there keeps its generator.
configure() {
  mkdir -p "$build"
  local generator=(-G Ninja)
  [ ! -f "$build/CMakeCache.txt" ] || generator=()
  run_logged "$build/configure.log" \
    cmake -S "$root" -B "$build" "${generator[@]}" -DCMAKE_BUILD_TYPE=Release "$@"
}

# build_target <target...>: progress on a terminal, silence elsewhere.
build_target() {
  say "building in $build"
  local command=(cmake --build "$build" --parallel "$(nproc)" --target "$@")
  if [ -t 1 ]; then
    "${command[@]}"
  else
    run_logged "$build/build.log" "${command[@]}"
  fi
}
