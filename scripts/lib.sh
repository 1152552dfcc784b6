# Shared by scripts/demo and scripts/test: packages, configure, build. Sourced with $root set.
# shellcheck shell=bash

# Debian and Ubuntu packages; a|b: either will do.
packages=(
  g++ cmake ninja-build 'pkg-config|pkgconf' xvfb
  libeigen3-dev liblua5.4-dev libsuitesparse-dev libopenblas-dev libvtk9-dev zlib1g-dev libedit-dev
  libpng-dev libjpeg-dev libtiff-dev libboost-dev libdxflib-dev libxml2-dev libsvgpp-dev
  catch2 'gnuplot-nox|gnuplot-qt|gnuplot-x11'
)
build=$root/build

say() { printf '%s\n' "$*" >&2; }

# Adds what stands around the program (Python, notebooks, the site, other programs that read what it writes) to the packages, as far as
# the system has it; a test that finds none says so.
want_surroundings() {
  local name around=(python3-numpy python3-pandas python3-meshio python3-ipykernel python3-nbclient
    python3-sphinx python3-myst-parser furo python3-pypdf libjs-katex chromium lua-check
    calculix-ccx assimp-utils python3-vtk9 python3-openpyxl python3-joblib)
  for name in "${around[@]}"; do
    if apt-cache show "$name" >/dev/null 2>&1; then packages+=("$name"); else say "no $name for this system"; fi
  done
}

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
      [ "$name" = libvtk9-dev ] && vtk_unpacked && continue 2
    done
    printf '%s\n' "${wanted%%|*}"
  done
}

# Can apt install these and remove nothing?
installable() { LC_ALL=C apt-get --simulate --no-remove --no-install-recommends install "$@" >/dev/null 2>&1; }

# Debian's ParaView and the Python part of VTK, on which libvtk9-dev insists, exclude each other. Beside ParaView the
# files of libvtk9-dev and of what is excluded lie below build/vtk, where CMake finds them, and are not installed.
vtk=$build/vtk
vtk_unpacked() {
  [ -f "$vtk/version" ] && [ "$(cat "$vtk/version")" = "$(dpkg-query -W -f='${Version}' 'libvtk9.[0-9]' 2>/dev/null)" ]
}

# vtk_needs <file>: what libvtk9-dev stands on, as far as it can be installed; the others go to the file.
vtk_needs() {
  local name needs=()
  : >"$1"
  for name in $(apt-cache show libvtk9-dev | sed -n '/^Depends: /{s///;s/([^)]*)//g;s/|[^,]*//g;s/,/ /g;p;q}'); do
    case $name in
      *vtk9*) installable "$name" || { echo "$name" >>"$1"; continue; } ;;
    esac
    installed "$name" || needs+=("$name")
  done
  [ ${#needs[@]} -eq 0 ] || printf '%s\n' "${needs[@]}"
}

# unpack_vtk <package...>: libvtk9-dev and these. Files that its CMake files name and a package has installed are linked to.
unpack_vtk() (
  say "unpacking libvtk9-dev $* in $vtk: as packages they would remove ParaView"
  rm -rf "$vtk"
  mkdir -p "$vtk/packages"
  cd "$vtk/packages"
  run_logged "$build/apt.log" apt-get download libvtk9-dev "$@"
  local package file
  for package in *.deb; do dpkg-deb -x "$package" "$vtk"; done
  rm -r "$vtk/packages"
  cat "$vtk"/usr/lib/*/cmake/vtk-*/VTK*-targets-*.cmake | grep -oE '_IMPORT_PREFIX}/[^" ]+' | sort -u |
    while IFS= read -r file; do
      file=/usr/${file#*/}
      [ -e "$vtk$file" ] || [ ! -e "$file" ] || { mkdir -p "$(dirname "$vtk$file")" && ln -sf "$file" "$vtk$file"; }
    done
  dpkg-query -W -f='${Version}' 'libvtk9.[0-9]' >"$vtk/version"
)

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: needs the like of ${packages[*]}"
    return 0
  fi
  local missing apt=(env DEBIAN_FRONTEND=noninteractive apt-get) root=yes
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -gt 0 ] || return 0
  mkdir -p "$build"
  if [ "$(id -u)" -ne 0 ]; then
    if sudo -n true 2>/dev/null; then apt=(sudo -n "${apt[@]}"); else root=no; fi
  fi
  [ $root = no ] || run_logged "$build/apt.log" "${apt[@]}" update
  local excluded=()
  if printf '%s\n' "${missing[@]}" | grep -qx libvtk9-dev && ! installable libvtk9-dev; then
    mapfile -t missing < <(printf '%s\n' "${missing[@]}" | grep -vx libvtk9-dev; vtk_needs "$build/excluded")
    mapfile -t excluded <"$build/excluded"
    if [ ${#excluded[@]} -eq 0 ]; then
      say "libvtk9-dev cannot be installed without removing something; why, says: apt-get --simulate install libvtk9-dev"
      exit 1
    fi
  fi
  if [ ${#missing[@]} -gt 0 ] && [ $root = no ]; then
    say "Packages are missing. As root:"
    say "apt-get install --no-remove --no-install-recommends ${missing[*]}"
    exit 1
  fi
  if [ ${#missing[@]} -gt 0 ]; then
    say "installing ${missing[*]}"
    run_logged "$build/apt.log" "${apt[@]}" install -y --no-remove --no-install-recommends "${missing[@]}"
  fi
  [ ${#excluded[@]} -eq 0 ] || unpack_vtk "${excluded[@]}"
}

# configure <option...>: Release with Ninja; a build folder that is there keeps its generator.
configure() {
  mkdir -p "$build"
  local generator=(-G Ninja)
  [ ! -f "$build/CMakeCache.txt" ] || generator=()
  # A compiler cache, where there is one; it must be told that GCC's precompiled headers may be kept.
  local cache=()
  if command -v ccache >/dev/null && [ -z "${CXX:-}${CXXFLAGS:-}" ]; then
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
    cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_FLAGS=-fpch-preprocess)
  fi
  run_logged "$build/configure.log" \
    cmake -S "$root" -B "$build" "${generator[@]}" -DCMAKE_BUILD_TYPE=Release "${cache[@]}" "$@"
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
