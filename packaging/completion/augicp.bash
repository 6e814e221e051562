# SPDX-License-Identifier: MIT
# Completion for bash. Subcommands and options come from the help texts, so that no second list of them exists.

_augicp_help_words() {
  augicp "$@" --help 2>/dev/null | sed -nE \
    -e '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p' \
    -e 's/^  (-[[:alnum:]],)?(--[a-z][-a-z]*).*/\2/p'
}

_augicp() {
  local word=$2 subcommands=() i
  for ((i = 1; i < COMP_CWORD; i++)); do
    case ${COMP_WORDS[i]} in
      -*) break ;;
      # Only the first words can be subcommands; experiment has its own.
      [a-z]*) [[ ${COMP_WORDS[i]} == *[!a-z]* ]] && break; subcommands+=("${COMP_WORDS[i]}") ;;
      *) break ;;
    esac
  done
  if [[ $word == -* || ${#subcommands[@]} -eq 0 || (${subcommands[0]} == experiment && ${#subcommands[@]} -eq 1) ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_augicp_help_words "${subcommands[@]}")" -- "$word")
  fi
  [ ${#COMPREPLY[@]} -gt 0 ] || mapfile -t COMPREPLY < <(compgen -f -- "$word")
}

complete -o filenames -F _augicp augicp
