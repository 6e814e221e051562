# SPDX-License-Identifier: MIT
"""The page of the command, made of its help texts. They are made of the tables of options, so that the page has every option."""
import re
import subprocess

TEXT_COLUMN = 30  # where the help texts begin to explain
LEFT = re.compile(r"(?P<names>[^\s={]+)(?:\{\w+\})?(?: (?P<kind>.*?))?(?:=(?P<default>.*))?")


def help_of(command, *words):
    text = subprocess.run([command.name, *words, "--help"], capture_output=True, text=True, check=True,
                          env={"PATH": str(command.parent)}).stdout
    return text.replace(str(command), command.name)


def entries(lines):
    """Pairs of what is explained, and the explanation. Where the first is long, the second has a line of its own."""
    found = []
    for line in lines:
        if line.startswith(" " * TEXT_COLUMN):
            found[-1] = (found[-1][0] + found[-1][1], line)
        else:
            found.append((line[:TEXT_COLUMN], line[TEXT_COLUMN:]))
    return [(left.strip(), text.strip()) for left, text in found]


def sections(text):
    """The parts of a help text: a title or None, and the lines below it."""
    found = [(None, [])]
    for line in text.splitlines():
        if re.fullmatch(r"[A-Z][\w' ]*:", line):
            found.append((line[:-1], []))
        elif found[-1][0] and line and not line.startswith("  "):
            found.append((None, [line]))
        else:
            found[-1][1].append(line)
    return [(title, [line for line in lines if line]) for title, lines in found]


def as_markdown(text):
    """Plain text, in which the names of options become code."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([\\*_\[\]<>|#])", r"\\\1", parts[i])
        parts[i] = re.sub(r"(?<![\w-])(--?[a-z][\w-]*)", r"`\1`", parts[i])
    return "".join(parts)


def term(left):
    """`--preset {default,paper}`, by default `default`, of --preset ENUM:{default,paper}=default."""
    found = LEFT.fullmatch(left)
    names, kind, default = found["names"].replace(",", ", "), found["kind"] or "", found["default"]
    kind = re.sub(r"^\w+:(?={)", "", kind)
    kind = re.sub(r"^(\w+):[^{]*$", r"\1", kind).replace(" REQUIRED", "")
    words = f"`{names} {kind}`" if kind else f"`{names}`"
    if not default:
        return words
    return f"{words}, by default {default if ' ' in default else f'`{default}`'}"


def definitions(lines):
    return [part for left, text in entries(lines) for part in (term(left), f": {as_markdown(text)}", "")]


def links(lines, words):
    def link(name):
        return f"[{' '.join([*words, name])}](#{'-'.join([*words, name])})"
    return [part for name, text in entries(lines) for part in (link(name), f": {as_markdown(text)}", "")]


def part_of(title, lines, words):
    if title == "Examples":
        return ["Examples:", "", "```sh", *(line.strip() for line in lines), "```", ""]
    if title == "Subcommands":
        return ["**Subcommands**", "", *links(lines, words)]
    if title:
        return [f"**{title}**", "", *definitions(lines)]
    usage = [line for line in lines if line.startswith("Usage: ")]
    prose = [as_markdown(line.strip()) for line in lines if line not in usage]
    return [*prose, "", *(f"    {line.removeprefix('Usage: ')}\n" for line in usage)]


def subcommands(text):
    return [name for title, lines in sections(text) if title == "Subcommands" for name, _ in entries(lines)]


def command_part(command, words):
    """The lines of a command and, below, of its subcommands. words: those after the program's name."""
    text = help_of(command, *words)
    path = [command.name, *words]
    lines = [f"{'#' * max(1, len(path))} {' '.join(path)}", ""]
    for title, part in sections(text):
        lines += part_of(title, part, path)
    return lines + [line for word in subcommands(text) for line in command_part(command, [*words, word])]


def page(command):
    return "\n".join(["# The command", *command_part(command, [])[1:]]) + "\n"
