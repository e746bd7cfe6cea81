# SPDX-License-Identifier: MIT
"""Runs clang-tidy on the sources of the library and the program and on the examples that include all headers; on tests,
benchmarks and recipes only when asked, for they are several times as many files. A file is looked at again only
when it, something that it includes of the project, its command, or the configuration has changed."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

from content_cache import ContentCache, content_key
from project_files import ROOT, project_files

# What no build for this machine compiles, and what does.
COMPILED_ELSEWHERE = {
    "bindings/wasm/src": "Emscripten, whose headers clang-tidy cannot read: ./dev web",
    "tests/package/consumer": "the tests of the installed package",
}

_FINDING = re.compile(r"^(/.*?):(\d+):(\d+): (warning|error): ", re.MULTILINE)


def compile_commands(root, build):
    """The project's own source files, each with its compile command."""
    database = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    return {Path(entry["file"]).relative_to(root): entry["command"] for entry in database
            if Path(entry["file"]).is_relative_to(root) and not Path(entry["file"]).is_relative_to(root / "build")}


def is_looked_at_always(path):
    """What others include or run. Headers that no source of the library includes are seen through the examples."""
    return path.parts[0] in ("graze", "apps") or path.parent == Path("examples")


def is_compiled_elsewhere(path):
    return any(path.is_relative_to(folder) for folder in COMPILED_ELSEWHERE)


def findings(root, text):
    """clang-tidy's findings, each once, with paths relative to the project."""
    starts = [match.start() for match in _FINDING.finditer(text)] + [len(text)]
    return [text[begin:end].rstrip().replace(f"{root}/", "") for begin, end in zip(starts, starts[1:])]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=Path, default=ROOT, help="the project's folder")
    parser.add_argument("--build", type=Path, help="where compile_commands.json is (default: build/lint)")
    parser.add_argument("--all", action="store_true", help="tests, benchmarks and recipes too")
    options = parser.parse_args()
    root = options.root.resolve()
    build = (options.build or root / "build" / "lint").resolve()

    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    configuration = [(root / path).read_text(encoding="utf-8") for path in project_files(root, [".clang-tidy"])]
    commands = compile_commands(root, build)
    checks = [(path, content_key(root, path, version, configuration, command)) for path, command in commands.items()
              if options.all or is_looked_at_always(path)]

    def tidy(path):
        # The commands may be another compiler's, with warnings that clang has never heard of.
        command = ["clang-tidy", "--quiet", "--extra-arg=-Wno-unknown-warning-option", "-p", build, root / path]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stdout or done.stderr

    failed, looked_at = ContentCache(root / "build" / "cache" / "tidy").run(checks, tidy)
    found = list(dict.fromkeys(finding for _, text in failed for finding in findings(root, text) or [text]))
    for finding in found:
        print(finding, file=sys.stderr)
    missing = [path for path in project_files(root, [".cpp"]) if path not in commands and not is_compiled_elsewhere(path)]
    for path in missing:
        print(f"{path}:1: is in no target, so nothing compiles it", file=sys.stderr)
    print(f"tidy: {len(checks)} files, {looked_at} of them changed, {len(found) + len(missing)} findings")
    return 1 if failed or missing else 0


if __name__ == "__main__":
    sys.exit(main())
