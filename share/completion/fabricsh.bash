# bash completion for fabricsh
_fabricsh() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=
  ((COMP_CWORD > 0)) && prev=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  case $prev in
    -e | -l | --threads | --case | --limit-*) return ;;
    --output)
      mapfile -t COMPREPLY < <(compgen -d -- "$cur")
      return
      ;;
    --restart)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$cur")
      return
      ;;
  esac
  if [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "-e -i -l - --check --restart --strict --cases --case --threads --safe --output --limit-memory --limit-seconds --limit-instructions --quiet --version --help" -- "$cur")
    return
  fi
  compopt -o filenames 2>/dev/null
  local i word deck=
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    case $word in
      -e | -l | --threads | --case | --restart | --output | --limit-*) ((i++)) ;;
      -?*) ;;
      *) deck=$word ;;
    esac
  done
  if [[ -n $deck ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$cur")
  else
    mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X '!*.lua' -- "$cur")
  fi
}
complete -F _fabricsh fabricsh
