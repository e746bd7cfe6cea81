# SPDX-License-Identifier: MIT
"""Writes the manual page and the shell completions of `graze` from its own --help, or checks that they match it.

usage: python3 tools/make_manual.py [--check] [--program build/release/bin/graze]
"""

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

from project_files import ROOT

FOLDER = Path("apps/cli/share")


class Help:
    """The parts of the output of `graze COMMAND --help`."""

    def __init__(self, program, command):
        words = [program, *([command] if command else []), "--help"]
        text = subprocess.run(words, capture_output=True, text=True, check=True, env=os.environ | {"NO_COLOR": "1"}).stdout
        lines = text.splitlines()
        self.summary = lines[0]
        self.usage = lines[1].removeprefix("Usage: ")
        self.tables = {}
        rest, name = [], None
        for line in lines[2:]:
            if line in ("Arguments:", "Options:", "Commands:"):
                name = self.tables[line[:-1]] = []
            elif name is not None and (row := re.match(r"  (\S.*?)(?:  +(.*))?$", line)):
                name.append((row[1], row[2] or ""))
            elif name and line.startswith(" " * 10) and line.strip():
                name[-1] = (name[-1][0], f"{name[-1][1]} {line.strip()}".strip())
            elif line.strip() or rest:
                name = None
                rest.append(line)
        self.paragraphs = [part.strip("\n") for part in "\n".join(rest).split("\n\n") if part.strip()]

    def options(self):
        """Rows of (names, value's name or None, description)."""
        for names, description in self.tables.get("Options", []):
            words = names.replace(",", " ").split()
            values = [word for word in words if not word.startswith("-") and word != "..."]
            yield [word for word in words if word.startswith("-")], values[0] if values else None, description


def choices_of(description):
    """The choices in a description like 'table (the default), json, ndjson or csv'; empty for any other description."""
    words = re.split(r",\s*|\s+or\s+", re.sub(r"\s*\(the default\)", "", description.split(";")[0]))
    return words if len(words) > 1 and all(re.fullmatch(r"[a-z_]+", word) for word in words) else []


def roff(text):
    lines = text.replace("\\", "\\\\").replace("-", "\\-").split("\n")
    return "\n".join(("\\&" if line[:1] in (".", "'") else "") + line for line in lines)


def manual(program, commands):
    top = Help(program, None)
    purpose = roff(top.summary[0].lower() + top.summary[1:])
    out = [".\\\" SPDX-License-Identifier: MIT", ".TH GRAZE 1", ".SH NAME", f"graze \\- {purpose}",
           ".SH SYNOPSIS", f".B {roff(top.usage)}"]

    def table(rows):
        for names, description in rows:
            out.extend([".TP", f".B {roff(names)}", roff(description)])

    def paragraphs(parts):
        for part in parts:
            head, _, body = part.partition("\n")
            if head.endswith(":") and body.startswith("  "):
                out.extend([".PP", roff(head), ".nf", roff(body), ".fi"])
            else:
                out.extend([".PP", roff(part)])

    out.append(".SH OPTIONS")
    table(top.tables["Options"])
    out.append(".SH COMMANDS")
    table(top.tables["Commands"])
    paragraphs(top.paragraphs[1:])
    for command in commands:
        said = Help(program, command)
        out.extend([f".SH GRAZE {command.upper()}", roff(said.summary) + ".", ".PP", f".B {roff(said.usage)}"])
        table(said.tables.get("Arguments", []) + said.tables["Options"])
        paragraphs(said.paragraphs)
    return "\n".join(out) + "\n"


def bash(program, commands):
    cases, values = [], {}
    for command in commands:
        said = Help(program, command)
        names = [name for names, _, _ in said.options() for name in names]
        cases.append(f"    {command}) words='{' '.join(names)}' ;;")
        for names, _, description in said.options():
            if choices := choices_of(description):
                values[f"{command} {names[-1]}"] = choices
    chosen = "\n".join(f"    '{key}') COMPREPLY=($(compgen -W '{' '.join(words)}' -- \"$word\")); return ;;"
                       for key, words in values.items())
    return f"""# SPDX-License-Identifier: MIT
# Completion of graze for bash, written by tools/make_manual.py.
_graze() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} words
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '{' '.join(commands)} --help --version' -- "$word"))
    return
  fi
  case "$command ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{chosen}
  esac
  case "$command" in
{chr(10).join(cases)}
  esac
  case "$word" in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _graze graze
"""


def fish(program, commands):
    top = Help(program, None)
    quote = lambda text: "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
    lines = ["# SPDX-License-Identifier: MIT", "# Completion of graze for fish, written by tools/make_manual.py."]
    lines += [f"complete -c graze -n __fish_use_subcommand -f -a {name} -d {quote(text)}"
              for name, text in top.tables["Commands"]]
    for command in commands:
        for names, value, description in Help(program, command).options():
            flags = "".join(f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}" for name in names)
            choices = choices_of(description)
            wants = f" -x -a {quote(' '.join(choices))}" if choices else " -r" if value else ""
            seen = f"'__fish_seen_subcommand_from {command}'"
            lines.append(f"complete -c graze -n {seen}{flags}{wants} -d {quote(description)}")
    return "\n".join(lines) + "\n"


def zsh(program, commands):
    top = Help(program, None)
    clean = lambda text: text.replace("'", "'\\''").replace("[", "(").replace("]", ")").replace(":", "\\:")
    described = "\n".join(f"    '{name}:{clean(text)}'" for name, text in top.tables["Commands"])
    cases = []
    for command in commands:
        rows = []
        for names, value, description in Help(program, command).options():
            choices = choices_of(description)
            what = f":{value}:({' '.join(choices)})" if choices else f":{value}:_files" if value else ""
            rows += [f"        '{name}[{clean(description)}]{what}'" for name in names]
        rows.append("        '*:file:_files'")
        cases.append(f"    {command})\n      _arguments \\\n" + " \\\n".join(rows) + "\n      ;;")
    return f"""#compdef graze
# SPDX-License-Identifier: MIT
# Completion of graze for zsh, written by tools/make_manual.py.
_graze() {{
  local -a commands=(
{described}
  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  case $words[2] in
{chr(10).join(cases)}
  esac
}}
_graze "$@"
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/graze", help="the program graze")
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a file is out of date")
    options = parser.parse_args()
    program = options.program.resolve()
    commands = [name for name, _ in Help(program, None).tables["Commands"]]
    files = {"graze.1": manual, "graze.bash": bash, "graze.fish": fish, "_graze": zsh}
    stale = []
    for name, make in files.items():
        path, text = ROOT / FOLDER / name, make(program, commands)
        if options.check:
            if not path.is_file() or path.read_text(encoding="utf-8") != text:
                stale.append(str(FOLDER / name))
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    if stale:
        print(f"out of date with `graze --help`: {', '.join(stale)}; run python3 tools/make_manual.py", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
