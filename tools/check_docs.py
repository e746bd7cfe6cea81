# SPDX-License-Identifier: MIT
"""Checks the README and all pages in docs/:

- The commands in ```sh blocks are run. In ```console blocks the lines after "$ " are run, and their output is compared
  with the lines below, in which "..." matches anything. Commands run in a copy of the project, with the program `graze`
  of the release build. Of `./dev COMMAND` only the name is checked. Commands that cannot be run are in ```text blocks.
- A block below <!-- file: PATH --> equals that file, one below <!-- from: PATH --> consecutive lines of it, and one
  below <!-- output: PATH --> the output of that program, which check_recipe.py compares.
- Links to files and headings have a target.
- The tables of accuracy are generated from docs/accuracy.json.
"""

import argparse
import doctest
import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path
from urllib.parse import unquote

import exam_tables
from markdown import read_page
from project_files import ROOT, project_files

_TIMEOUT_SECONDS = 600
_NOT_FOR_A_TEST = re.compile(r"\b(sudo|apt-get|apt|curl|wget)\b|\bgit (clone|push|commit)\b")
_DEV = re.compile(r"^\./dev\b\s*(\S*)(.*)$")


def pages_of(root):
    return [path for path in project_files(root, [".md"]) if len(path.parts) == 1 or path.parts[0] == "docs"]


def without_license_line(text):
    return re.sub(r"\A(//|#) SPDX-License-Identifier:.*\n\n?", "", text)


def source_problem(root, block):
    """A problem of a block that names the file it shows, or None."""
    kind, name = block.source
    if not (root / name).is_file():
        return f"shows {name}, which does not exist"
    if kind == "output":
        return None
    text = (root / name).read_text(encoding="utf-8")
    if kind == "file":
        return None if block.code in (text, without_license_line(text)) else f"differs from {name}"
    lines, wanted = text.splitlines(), block.code.splitlines()
    for start in range(len(lines) - len(wanted) + 1):
        if textwrap.dedent("\n".join(lines[start : start + len(wanted)])) == textwrap.dedent("\n".join(wanted)):
            return None
    return f"is not found in {name} as consecutive lines"


def link_problem(root, path, pages, target):
    """A problem of a link on the page `path`, or None. External links are not followed."""
    if re.match(r"[a-z][a-z+.-]*:", target):
        return None
    name, _, fragment = unquote(target).partition("#")
    place = Path(os.path.normpath(path.parent / name)) if name else path
    if not (root / place).exists():
        return f"links to {target}, which does not exist"
    if fragment and place in pages and fragment not in pages[place].anchors:
        return f"links to {target}, but {place} has no such heading"
    return None


def commands_of(block):
    """The commands of a block, as (line, command, expected output or None)."""
    found, prompt = [], block.language == "console"
    lines = block.code.splitlines()
    index = 0
    while index < len(lines):
        line, start = lines[index], index
        index += 1
        if prompt and not line.startswith("$ "):
            if found:
                found[-1][2].append(line)
            continue
        command = line[2:] if prompt else line
        while index < len(lines) and is_incomplete(command):
            command += "\n" + (lines[index].removeprefix("> ") if prompt else lines[index])
            index += 1
        if command.strip() and not command.lstrip().startswith("#"):
            found.append((block.line + start, command, []))
    return [(line, command, "\n".join(output) + "\n" if output else None) for line, command, output in found]


def is_incomplete(command):
    """True for a command that continues on the next line: after a backslash, inside a loop, quotes or a here-document."""
    parsed = subprocess.run(["bash", "-n", "-c", command], capture_output=True, text=True, check=False)
    return command.endswith("\\") or parsed.returncode != 0 or "delimited by end-of-file" in parsed.stderr


class Shell:
    """Runs commands in a copy of the project, which is kept, so that their builds are incremental."""

    def __init__(self, root, program, folder):
        self.folder = folder
        self._root = root
        self._environment = os.environ | {"PATH": f"{program.parent}{os.pathsep}{os.environ['PATH']}", "NO_COLOR": "1"}
        self._dev_commands = set(re.findall(r"^  (\w+)", subprocess.run(
            [root / "dev", "help"], capture_output=True, text=True, check=True).stdout, re.MULTILINE))
        self._program = program

    def refresh(self):
        """Updates the copy from the project, except its build folder."""
        wanted = set(project_files(self._root, [""]))
        for path in project_files(self.folder, [""]) if self.folder.exists() else []:
            if path not in wanted:
                (self.folder / path).unlink()
        for path in wanted:
            here, there = self._root / path, self.folder / path
            there.parent.mkdir(parents=True, exist_ok=True)
            if not there.is_file() or there.read_bytes() != here.read_bytes():
                shutil.copy(here, there)
        built = self.folder / "build" / "release" / "bin" / "graze"
        built.parent.mkdir(parents=True, exist_ok=True)
        (self.folder / "build" / "demo").mkdir(exist_ok=True)
        built.unlink(missing_ok=True)
        built.symlink_to(self._program)

    def problem(self, command, expected):
        """Runs the command; returns a problem, or None."""
        if _NOT_FOR_A_TEST.search(command):
            return f"cannot be run in a test, so mark its block ```text: {command}"
        if dev := _DEV.match(command.strip()):
            if dev[1] in self._dev_commands | {"--help"}:
                return None
            return f"./dev has no command '{dev[1]}'; its commands are: {', '.join(sorted(self._dev_commands))}"
        try:
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=self.folder, env=self._environment,
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=_TIMEOUT_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return f"took more than {_TIMEOUT_SECONDS} s: {command}"
        if done.returncode != 0:
            return f"exit status {done.returncode} of: {command}\n{textwrap.indent(done.stderr or done.stdout, '    ')}"
        flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
        shown = done.stdout + done.stderr
        if expected is not None and not any(doctest.OutputChecker().check_output(expected, output, flags)
                                            for output in (done.stdout, shown)):
            return f"shows another output of: {command}\n{textwrap.indent(shown, '    ')}"
        return None


def main():
    parser = argparse.ArgumentParser(description="Checks the documentation.")
    parser.add_argument("--root", type=Path, default=ROOT, help="root folder of the project")
    parser.add_argument("--program", type=Path, help="the program graze (default: build/release/bin/graze)")
    parser.add_argument("--scratch", type=Path, help="the folder in which commands are run (default: build/docs)")
    options = parser.parse_args()
    root = options.root.resolve()
    program = (options.program or root / "build" / "release" / "bin" / "graze").resolve()

    pages = {path: read_page((root / path).read_text(encoding="utf-8")) for path in pages_of(root)}
    shell = Shell(root, program, (options.scratch or root / "build" / "docs").resolve())
    problems, counts = [], {"commands": 0, "sources": 0, "links": 0}
    for path, page in pages.items():
        for line, target in page.links:
            counts["links"] += 1
            problems.append((path, line, link_problem(root, path, pages, target)))
        for block in page.blocks:
            if block.source:
                counts["sources"] += 1
                problems.append((path, block.line, source_problem(root, block)))
        shell.refresh()
        for line, command, expected in (entry for block in page.blocks if block.language in ("sh", "console")
                                        for entry in commands_of(block)):
            counts["commands"] += 1
            problems.append((path, line, shell.problem(command, expected)))
    problems += exam_tables.problems(root)
    problems = [f"{path}:{line}: {problem}" for path, line, problem in problems if problem]
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"docs: {len(pages)} pages, {counts['commands']} commands run, {counts['sources']} blocks compared with files, "
          f"{counts['links']} links followed, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
