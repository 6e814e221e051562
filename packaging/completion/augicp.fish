# SPDX-License-Identifier: MIT
# Completion for fish. Subcommands and options come from the help texts, so that no second list of them exists.

# Lines "word<tab>what it does" of the help of the subcommand that stands on the command line.
function __augicp_help_words
    set -l subcommands
    for word in (commandline -opc)[2..]
        string match -qr '^[a-z]+$' -- $word; or break
        set -a subcommands $word
    end
    set -l current (commandline -ct)
    if not string match -q -- '-*' $current; and test (count $subcommands) -gt 0; and test "$subcommands" != experiment
        return
    end
    augicp $subcommands --help 2>/dev/null | sed -nE \
        -e '/^Subcommands:/,/^$/s/^  ([a-z]+)  +(.*)/\1\t\2/p' \
        -e 's/^  (-[[:alnum:]],)?(--[a-z][-a-z]*).{0,24}  +(.*)/\2\t\3/p;t' \
        -e 's/^  (-[[:alnum:]],)?(--[a-z][-a-z]*).*/\2/p'
end

complete -c augicp -a '(__augicp_help_words)'
