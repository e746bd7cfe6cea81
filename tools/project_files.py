# SPDX-License-Identifier: MIT
"""Lists the files of the project and their includes.

As a program: prints the files whose names end with one of the arguments.
"""

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
_NOT_OURS = {"build", "__pycache__", "node_modules"}


def project_files(root, suffixes):
    """The sorted paths, relative to `root`, of the files whose name ends with one of `suffixes` (".hpp", "" for all) or is
    one of them ("CMakeLists.txt"): those that git tracks or does not ignore or, outside a git checkout, all except build
    and hidden folders."""
    return [path for path in _all_files(Path(root)) if any(_matches(path, suffix) for suffix in suffixes)]


def _matches(path, suffix):
    return str(path).endswith(suffix) if suffix[:1] in ("", ".") else path.name == suffix


def _all_files(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, check=False) if (root / ".git").exists() else None
    if listed and listed.returncode == 0:
        paths = {Path(os.fsdecode(name)) for name in listed.stdout.split(b"\0") if name}
        return sorted(path for path in paths if (root / path).is_file())
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in folders if name not in _NOT_OURS and (name == ".ci" or not name.startswith("."))]
        found += [(Path(folder) / name).relative_to(root) for name in names]
    return sorted(found)


def includes(text):
    """The includes of a source text as (line number, name, True for one in quotes)."""
    return [(text.count("\n", 0, match.start()) + 1, match[2], match[1] == '"') for match in _INCLUDE.finditer(text)]


@cache
def _included_files(root, path):
    found = []
    for _, name, _ in includes((root / path).read_text(encoding="utf-8")):
        for candidate in (path.parent / name, Path(name), Path("tests") / name):
            if (root / candidate).is_file():
                found.append(Path(os.path.normpath(candidate)))
                break
    return found


def include_closure(root, path):
    """`path` and all files of the project that it includes, directly or not; sorted."""
    seen, waiting = set(), [Path(path)]
    while waiting:
        current = waiting.pop()
        if current not in seen:
            seen.add(current)
            waiting += _included_files(Path(root), current)
    return sorted(seen)


if __name__ == "__main__":
    print("\n".join(map(str, project_files(ROOT, sys.argv[1:]))))
