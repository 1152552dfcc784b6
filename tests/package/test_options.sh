#!/bin/bash
# Every option of --help is in the man page and in the completions; bash completes options and decks.
# Usage: test_options.sh <fabricsh> <source folder>
set -eu
program=$1 share=$2/share
options=$("$program" --help | grep -oE '^ +--?[a-z-]+' | tr -d ' ')
[ "$(echo "$options" | wc -l)" -ge 8 ]
trouble=0
for option in $options; do
  grep -qE -e "^\.B[I]? ${option//-/\\\\-}( |\$)" "$share/man/fabricsh.1" || { echo "man page: no $option"; trouble=1; }
  grep -qE -e "[ \"]$option[ \"]" "$share/completion/fabricsh.bash" || { echo "bash completion: no $option"; trouble=1; }
  grep -qF -e "$option[" -e "$option:" "$share/completion/_fabricsh" || { echo "zsh completion: no $option"; trouble=1; }
  word=${option#-}
  case $word in
    -*) flag="-l ${word#-}" ;;
    *) flag="-s $word" ;;
  esac
  grep -qE -e " $flag( |\$)" "$share/completion/fabricsh.fish" || { echo "fish completion: no $option"; trouble=1; }
done

if command -v mandoc >/dev/null; then
  mandoc -T lint -W warning "$share/man/fabricsh.1" || trouble=1
fi

# shellcheck source=/dev/null
. "$share/completion/fabricsh.bash"
completed() { # words of a command line, the last one half typed: what bash would offer
  COMP_WORDS=(fabricsh "$@") COMP_CWORD=$#
  _fabricsh
  [ ${#COMPREPLY[@]} -eq 0 ] || printf '%s ' "${COMPREPLY[@]}"
}
rm -rf decks && mkdir decks && cd decks && touch one.lua two.lua data.csv
check() { [ "$1" = "$2" ] || { echo "completion: got '$1', want '$2'"; trouble=1; }; }
check "$(completed --thr)" "--threads "
check "$(completed o)" "one.lua "
check "$(completed one.lua d)" "data.csv "
check "$(completed d)" ""
check "$(completed --threads 4 tw)" "two.lua "
check "$(completed --restart d)" "data.csv "
check "$(completed --restart data.csv o)" "one.lua "
check "$(completed -e '')" ""
exit $trouble
