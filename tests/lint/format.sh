#!/bin/sh
# Sources are as clang-format 14 leaves them. Other versions disagree with it in places, so they are not asked:
# exit code 77 tells ctest that the test was skipped. Usage: format.sh <root of the tree>
set -eu
cd "$1"
formatter=
for name in clang-format-14 clang-format; do
  command -v "$name" >/dev/null 2>&1 || continue
  "$name" --version | grep -q 'version 14\.' || continue
  formatter=$name
  break
done
if [ -z "$formatter" ]; then
  echo "SKIPPED: clang-format 14 is not installed, the form of the sources was not checked"
  exit 77
fi
find src tests \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 "$formatter" --dry-run -Werror
