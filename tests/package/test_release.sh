#!/bin/bash
# Two source archives, made from clones in different folders, at different times, with another time zone, language and mask, are the
# same bits and hold the tree; a release in a clone sets the version where it stands; what is not fit for a release is refused.
# Usage: test_release.sh <source folder>
set -eu
export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=safe.directory GIT_CONFIG_VALUE_0='*'
export GIT_AUTHOR_NAME=t GIT_AUTHOR_EMAIL=t@t GIT_COMMITTER_NAME=t GIT_COMMITTER_EMAIL=t@t
if ! git -C "$1" rev-parse HEAD >/dev/null 2>&1; then
  echo "SKIPPED: the sources are no checkout of git"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone -q "$1" "$work/one"
(umask 077 && git clone -q "$1" "$work/another place")
"$work/one/scripts/release" --archive "$work/a" >/dev/null
(umask 077 && TZ=Asia/Tokyo LC_ALL=C.UTF-8 "$work/another place/scripts/release" --archive "$work/b" >/dev/null)
cmp "$work"/a/*.tar.gz "$work"/b/*.tar.gz
mkdir "$work/tree"
tar -xzf "$work"/a/*.tar.gz -C "$work/tree" --strip-components=1
(cd "$work/one" && git ls-files) | while IFS= read -r file; do
  [ -e "$work/tree/$file" ] || { echo "the archive has no $file"; exit 1; }
done

cd "$work/one"
git checkout -q -B main
refused() { # <words> <arguments...>
  local words=$1 said
  shift
  if said=$(scripts/release "$@" 2>&1); then echo "not refused: $*"; exit 1; fi
  case $said in *"$words"*) ;; *) echo "'$words' is not in: $said"; exit 1 ;; esac
  [ -z "$(git status --porcelain --untracked-files=no)" ] || { echo "refused, and yet changed: $*"; exit 1; }
}
refused "wants a version" 1.2
refused "no decks in tests/archive/7.3.0" 7.3.1
refused "is not newer than" 0.0.1
touch new && git add new
said=$(scripts/release 0.1.0 2>&1) && exit 1
case $said in *"not committed"*) ;; *) echo "$said"; exit 1 ;; esac
git rm -qf new
mkdir -p tests/archive/7.3.0 && echo '-- a deck' >tests/archive/7.3.0/deck.lua && git add . && git commit -qm "decks"
grep -q '^## Unreleased' CHANGELOG.md
printf '%s\n' '## Unreleased' '' '- something' '' '## 0.1.0' >CHANGELOG.md && git commit -qam "changes"
sed -i 's|^set(FABRICSH_REPOSITORY ""|set(FABRICSH_REPOSITORY "https://example.org/f"|' scripts/cmake/FabricshOwner.cmake && git commit -qam "owner"
scripts/release 7.3.0 2030-01-31 >/dev/null
[ "$(git cat-file -t v7.3.0)" = tag ]
grep -q 'project(fabricsh VERSION 7.3.0' CMakeLists.txt
grep -qx '## 7.3.0, 2030-01-31' CHANGELOG.md
grep -qx 'version: 7.3.0' CITATION.cff
grep -qx 'date-released: 2030-01-31' CITATION.cff
grep -qx 'repository-code: "https://example.org/f"' CITATION.cff
grep -qx 'version = "7.3.0"' share/python/pyproject.toml
grep -q '^git clone https://example.org/f fabricsh && cd fabricsh$' README.md
[ -f build/fabricsh-7.3.0.tar.gz ]
[ -z "$(git status --porcelain --untracked-files=no)" ]
refused "nothing under" 7.3.1
refused "is there already" 7.3.0
