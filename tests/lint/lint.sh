#!/bin/sh
# The order of the rooms, that every deck checks itself, and that nothing but what belongs there lies in the tree's top. Usage: lint.sh <root of the tree>
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
status=0

sources=$(find src -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.in' \) | sort)
# shellcheck disable=SC2086  # names of sources have no spaces
awk -f "$here/includes.awk" src/LAYERS $sources || status=1
if [ -d lua ]; then
  # shellcheck disable=SC2046  # names of modules have no spaces
  awk -f "$here/requires.awk" lua/LAYERS $(find lua/fabric -name '*.lua' | sort) || status=1
fi

if [ -d scripts ]; then
  for deck in $(find scripts -name '*.lua' | sort); do
    grep -Eq '(^|[^A-Za-z_])expect *[{(]' "$deck" && continue
    # A file that hands over to a deck, or that decks load, ends with it.
    tail -n 1 "$deck" | grep -Eq '^(dofile\(|return )' && continue
    echo "$deck: has no expect{...} block"
    status=1
  done
fi

known=" .ci .clang-format .devcontainer .editorconfig .gitattributes .github .gitignore CHANGELOG.md CITATION.cff CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md SECURITY.md lua meshes scripts share src tests "
if command -v git >/dev/null && [ -e .git ]; then
  for name in $(git -c safe.directory='*' ls-files | cut -d/ -f1 | sort -u); do
    case $known in
      *" $name "*) ;;
      *)
        echo "$name: lies in the top folder; written by a test?"
        status=1
        ;;
    esac
  done
fi
exit $status
