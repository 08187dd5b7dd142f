# Completion of glimt's commands and options in bash: they are read from its help texts.
_glimt() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$(glimt --help 2>/dev/null |
      sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(glimt "$command" --help 2>/dev/null |
      grep -oE '^ +-[^ ]+' | tr ', ' '\n\n')" -- "$word")
  fi
}
complete -o default -F _glimt glimt
