#compdef augicp
# SPDX-License-Identifier: MIT
# Completion for zsh, installed as _augicp. Subcommands and options come from the help texts, so that no second list of them exists.

# Lines "word:what it does" of a subcommand's help.
_augicp_help_words() {
  augicp "$@" --help 2>/dev/null | sed -nE \
    -e '/^Subcommands:/,/^$/s/^  ([a-z]+)  +(.*)/\1:\2/p' \
    -e 's/^  (-[[:alnum:]],)?(--[a-z][-a-z]*).{1,24}  +(.*)/\2:\3/p;t' \
    -e 's/^  (-[[:alnum:]],)?(--[a-z][-a-z]*).*/\2:/p'
}

_augicp() {
  local -a subcommands described
  local word
  for word in ${words[2,CURRENT-1]}; do
    [[ $word == *[^a-z]* ]] && break
    subcommands+=($word)
  done
  if [[ $PREFIX == -* || $#subcommands -eq 0 || ($subcommands[1] == experiment && $#subcommands -eq 1) ]]; then
    described=("${(@f)$(_augicp_help_words $subcommands)}")
    _describe 'subcommand or option' described && return
  fi
  _files
}

# Loaded as a function by compinit, the file is the body of its first call.
[[ $funcstack[1] != _augicp ]] || _augicp "$@"
