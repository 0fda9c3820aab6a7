# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# bash completion for rivulet-cli: commands and options are those of its own --help.

_rivulet_cli_commands() {
  "$1" --help 2>/dev/null | sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z-]*\) .*/\1/p'
}

# The options, and after one with a choice its values: {auto,iso,...}.
_rivulet_cli() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local command="" index help choices
  for ((index = 1; index < COMP_CWORD; ++index)); do
    if [[ ${COMP_WORDS[index]} == [a-z]* && ${COMP_WORDS[index - 1]} != --log-level ]]; then
      command=${COMP_WORDS[index]}
      break
    fi
  done
  COMPREPLY=()
  # shellcheck disable=SC2086  # no command: no word
  help=$("$program" $command --help 2>/dev/null)
  choices=""
  if [[ $before == --* ]]; then
    choices=$(sed -n "s/^ *\(-[a-zA-Z],\)\?$before [A-Z]*:{\([^}]*\)}.*/\2/p" <<<"$help")
  fi
  if [[ -n $choices ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${choices//,/ }" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(grep -oE -- '--[a-z][a-z-]*' <<<"$help" | sort -u)" -- "$word")
  elif [[ -z $command ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_rivulet_cli_commands "$program")" -- "$word")
  fi
}

complete -o default -F _rivulet_cli rivulet-cli
