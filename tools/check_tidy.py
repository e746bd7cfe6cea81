# SPDX-License-Identifier: MIT
"""Runs clang-tidy on the sources of the library and the program and on the examples that include all headers; on tests,
benchmarks and recipes only when asked, for they are several times as many files. All batches (GRAZE_UNITY) of a target are
looked at as one, and so are all examples, which reads their headers once for all. What was looked at is looked at again only
when a file of it, something that it includes of the project, its command, or the configuration has changed."""

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from content_cache import ContentCache, content_key
from project_files import ROOT, includes, project_files

# What the build that lint reads does not compile, and what does.
COMPILED_ELSEWHERE = {
    "tests/fuzz": "Clang, which alone has libFuzzer: ./dev test asan",
    "bindings/wasm/src": "Emscripten, whose headers clang-tidy cannot read: ./dev web",
    "tests/package/compiler": "the tests of compilers and their options",
    "tests/package/consumer": "the tests of the installed package",
}

_FINDING = re.compile(r"^(/.*?):(\d+):(\d+): (warning|error): ", re.MULTILINE)


@dataclass(frozen=True)
class Unit:
    """What is looked at at a time: the project's sources, how they are compiled, and the text that includes them, if it is
    not the only one of them itself."""

    sources: tuple
    flags: tuple
    text: str = ""


def flags_of(command):
    """The options of a compiler's command but for what it reads and writes."""
    words = iter(shlex.split(command)[1:])
    flags = []
    for word in words:
        if word in ("-o", "-c"):
            next(words, None)
        else:
            flags.append(word)
    return tuple(flags)


def units_of(root, build):
    """The units of the compile commands that hold the project's own sources."""
    batches, programs, units = {}, {}, []
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        file = Path(entry["file"])
        flags = flags_of(entry["command"])
        if file.is_relative_to(build) and file.parent.name == "Unity":
            included = [Path(name).relative_to(root) for _, name, _ in includes(file.read_text(encoding="utf-8"))]
            # Tests are too many to be held in memory at once.
            batches.setdefault((flags, "" if is_looked_at_always(included[0]) else file), []).extend(included)
        elif file.is_relative_to(root) and file.stem != "cmake_pch.hxx":  # what CMake makes of a template is there, too
            source = file.relative_to(root)
            if source.parts[0] == "examples":
                programs.setdefault((flags, source.parent), []).append(source)
            else:
                units.append(Unit((source,), flags))
    for (flags, _), sources in batches.items():
        units.append(Unit(tuple(sources), flags, "".join(f'#include "{root / source}"\n' for source in sources)))
    for (flags, _), sources in programs.items():
        text = "".join(f'#define main main_of_{source.stem}\n#include "{root / source}"\n#undef main\n' for source in sources)
        # Only of `main` may the end be reached without a return; of others the compilers know.
        units.append(Unit(tuple(sources), (*flags, "-Wno-return-type"), text))
    return units


def is_looked_at_always(path):
    """What others include or run. Headers that no source of the library includes are seen through the examples."""
    return path.parts[0] in ("graze", "apps") or path.parent == Path("examples")


def configuration_for(root, build, path):
    """The nearest configuration above a source: for one in a batch, clang-tidy would look above the batch, and for one that
    CMake makes of a template not where the template is."""
    place = root / path
    if place.is_relative_to(build):
        place = root / place.relative_to(build)
    return next(folder / ".clang-tidy" for folder in place.parents if (folder / ".clang-tidy").is_file())


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
    units = units_of(root, build)
    checks = [(unit, content_key(root, unit.sources, version, configuration, unit.flags, unit.text)) for unit in units
              if options.all or any(map(is_looked_at_always, unit.sources))]
    # The longest first, so that none is left to one processor at the end.
    checks.sort(key=lambda check: -len(check[0].sources))

    def tidy(unit):
        command = ["clang-tidy", "--quiet", f"--config-file={configuration_for(root, build, unit.sources[0])}"]
        with tempfile.TemporaryDirectory() as scratch:
            file = root / unit.sources[0]
            if unit.text:
                file = Path(scratch) / "sources.cpp"
                file.write_text(unit.text, encoding="utf-8")
                command.append("--checks=-bugprone-suspicious-include")  # to include sources is its purpose
            # The commands may be another compiler's, with warnings that clang has never heard of.
            done = subprocess.run([*command, file, "--", *unit.flags, "-Wno-unknown-warning-option"], cwd=build,
                                  capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stdout or done.stderr

    failed, looked_at = ContentCache(root / "build" / "cache" / "tidy").run(checks, tidy)
    found = list(dict.fromkeys(finding for _, text in failed for finding in findings(root, text) or [text]))
    for finding in found:
        print(finding, file=sys.stderr)
    compiled = {source for unit in units for source in unit.sources}
    missing = [path for path in project_files(root, [".cpp"]) if path not in compiled and not is_compiled_elsewhere(path)]
    for path in missing:
        print(f"{path}:1: is in no target, so nothing compiles it", file=sys.stderr)
    files = sum(len(unit.sources) for unit, _ in checks)
    print(f"tidy: {files} files in {len(checks)} units, {looked_at} of them changed, {len(found) + len(missing)} findings")
    return 1 if failed or missing else 0


if __name__ == "__main__":
    sys.exit(main())
