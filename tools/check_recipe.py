# SPDX-License-Identifier: MIT
"""Checks that a page of the cookbook shows the output of its program. The recipe NAME is

- a program examples/cookbook/NAME.cpp, at most 60 lines of it, built as cookbook_NAME;
- a picture docs/pictures/cookbook/NAME.svg, which the program draws, byte for byte;
- a page docs/cookbook/NAME.md, which shows the program (check_docs.py compares it), the picture and, below
  <!-- output: examples/cookbook/NAME.cpp -->, what the program prints; and a link to the tab of the viewer that shows its
  shapes, ../../viewer/index.html#TAB?STATE (the viewer's tests follow it);
- a link from the index docs/cookbook/README.md to the page.
"""

import argparse
import difflib
import subprocess
import sys
import tempfile
from pathlib import Path

from markdown import read_page
from project_files import ROOT

_TIMEOUT_SECONDS = 120
_MAX_LINES = 60
_VIEWER = "../../viewer/index.html#"


def run(program):
    """The program's output and picture. Raises RuntimeError if it fails."""
    with tempfile.TemporaryDirectory(prefix="graze recipe ") as folder:
        picture = Path(folder) / "picture.svg"
        done = subprocess.run([program, picture], capture_output=True, text=True, timeout=_TIMEOUT_SECONDS, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{program} ends with exit status {done.returncode}: {done.stderr or done.stdout}")
        if not picture.is_file():
            raise RuntimeError(f"{program} draws no picture in the file that its argument names")
        return done.stdout, picture.read_bytes()


def difference(shown, true):
    return "".join(difflib.unified_diff(shown.splitlines(True), true.splitlines(True), "the page", "the program"))


def problems_of(root, name, program):
    source, page_path = Path("examples/cookbook") / f"{name}.cpp", Path("docs/cookbook") / f"{name}.md"
    picture_path = Path("docs/pictures/cookbook") / f"{name}.svg"
    missing = [f"{path} is missing" for path in (source, page_path, picture_path) if not (root / path).is_file()]
    if missing:
        return missing
    problems = []
    lines = len((root / source).read_text(encoding="utf-8").splitlines())
    if lines > _MAX_LINES:
        problems.append(f"{source} has {lines} lines; the limit is {_MAX_LINES}")
    printed, drawn = run(program)
    if drawn != (root / picture_path).read_bytes():
        problems.append(f"{picture_path} is not what {name} draws; update it by: {program} {picture_path}")

    page = read_page((root / page_path).read_text(encoding="utf-8"))
    blocks = {block.source: block for block in page.blocks if block.source}
    if ("file", str(source)) not in blocks:
        problems.append(f"{page_path} does not show its program: <!-- file: {source} --> is missing")
    output = blocks.get(("output", str(source)))
    if output is None:
        problems.append(f"{page_path} does not show the output of its program: <!-- output: {source} --> is missing")
    elif output.code != printed:
        problems.append(f"{page_path}:{output.line}: shows another output\n{difference(output.code, printed)}")
    if f"../pictures/cookbook/{name}.svg" not in (target for _, target in page.links):
        problems.append(f"{page_path} does not show {picture_path}")
    if not any(target.startswith(_VIEWER) for _, target in page.links):
        problems.append(f"{page_path} has no link to the viewer, which begins with {_VIEWER}")
    index = read_page((root / "docs/cookbook/README.md").read_text(encoding="utf-8"))
    if f"{name}.md" not in (target for _, target in index.links):
        problems.append(f"docs/cookbook/README.md does not link to {name}.md")
    return problems


def main():
    parser = argparse.ArgumentParser(description="Checks that a page of the cookbook shows the output of its program.")
    parser.add_argument("--root", type=Path, default=ROOT, help="root folder of the project")
    parser.add_argument("program", type=Path, help="the built program, cookbook_NAME")
    options = parser.parse_args()
    name = options.program.stem.removeprefix("cookbook_")
    try:
        problems = problems_of(options.root.resolve(), name, options.program.resolve())
    except (OSError, RuntimeError, subprocess.TimeoutExpired) as error:
        problems = [str(error)]
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"recipe {name}: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
