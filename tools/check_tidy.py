# SPDX-License-Identifier: MIT
"""Runs clang-tidy on the sources of the library, its C interface and the program and on the examples, which include all
headers; with --all also on tests, benchmarks and recipes, which are several times as many files. So that headers are parsed
only once, one unit has all batches (GRAZE_UNITY) of a target, another all other sources of a folder of the library except
kernels, another all examples. A unit is checked again only if one of its files, a project file that it includes, its
command or the configuration has changed."""

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

# Folders and files that the lint build does not compile, and what compiles them.
COMPILED_ELSEWHERE = {
    "apps/cli/system_windows.cpp": "./dev cross windows",
    "bench/python": "./dev bench python",
    "packaging/conan/test_package": "Conan",
    "bench/contact/of_jolt.cpp": "the benchmarks where Jolt is installed, which Debian has no package of",
    "bench/peers/peer_box2d_v3.cpp": "the same where Box2D 3 is",
    "bench/peers/peer_jolt.cpp": "the same where Jolt is",
    "tests/fuzz": "Clang, because only it has libFuzzer: ./dev test asan",
    "bindings/wasm/src": "Emscripten, whose headers clang-tidy cannot read: ./dev web",
    "bindings/python/src": "the builds of the Python module: ./dev python",
    "tests/package/compiler": "the tests of compilers and their options",
    "tests/package/consumer": "the tests of the installed package",
}

# Instances of templates that other files instantiate with the same dimension and with the same number type: only --all.
SAME_CODE = (Path("graze/query/compiled/pairs_2d_double.cpp"), Path("graze/query/compiled/pairs_3d_float.cpp"))

_FINDING = re.compile(r"^(/.*?):(\d+):(\d+): (warning|error): ", re.MULTILINE)


@dataclass(frozen=True)
class Unit:
    """The sources of one clang-tidy run, their compiler options and, for several sources, the text that includes them."""

    sources: tuple
    flags: tuple
    text: str = ""


def flags_of(command):
    """The options of a compiler command without input and output files."""
    words = iter(shlex.split(command)[1:])
    flags = []
    for word in words:
        if word in ("-o", "-c"):
            next(words, None)
        else:
            flags.append(word)
    return tuple(flags)


def units_of(root, build):
    """The units with the project's own sources in the compile commands."""
    batches, programs, units = {}, {}, []
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        file = Path(entry["file"])
        flags = flags_of(entry["command"])
        if file.is_relative_to(build) and file.parent.name in ("Unity", "together"):
            included = [Path(name).relative_to(root) for _, name, _ in includes(file.read_text(encoding="utf-8"))]
            if file.parent.name == "together":  # examples; or a program that calls the main of one
                if included:
                    programs.setdefault((flags, included[0].parent), []).extend(included)
                continue
            # There are too many tests for one unit in memory.
            batches.setdefault((flags, "" if is_looked_at_always(included[0]) else file), []).extend(included)
        elif file.is_relative_to(root) and file.stem != "cmake_pch.hxx":  # includes files that CMake generates from templates
            source = file.relative_to(root)
            if source.parts[0] == "examples":
                programs.setdefault((flags, source.parent), []).append(source)
            elif source.parts[0] == "graze" and is_looked_at_always(source) and not source.stem.endswith("kernels"):
                batches.setdefault((flags, source.parts[1]), []).append(source)
            else:
                units.append(Unit((source,), flags))
    for (flags, _), sources in batches.items():
        text = "".join(f'#include "{root / source}"\n' for source in sources) if len(sources) > 1 else ""
        units.append(Unit(tuple(sources), flags, text))
    for (flags, _), sources in programs.items():
        text = "".join(f'#define main main_of_{source.stem}\n#include "{root / source}"\n#undef main\n' for source in sources)
        # A renamed `main` may lack a return; the compilers check the other functions.
        units.append(Unit(tuple(sources), (*flags, "-Wno-return-type"), text))
    return units


def is_looked_at_always(path):
    """Library, C interface, program and examples. The examples include headers that no source of the library includes."""
    if path in SAME_CODE:
        return False
    return path.parts[0] in ("graze", "apps") or path.parent in (Path("bindings/c/src"), Path("examples"))


def configuration_for(root, build, path):
    """The nearest configuration above a source. clang-tidy itself would search above the batch or the generated file
    instead of the source or its template."""
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
    parser.add_argument("--root", type=Path, default=ROOT, help="root folder of the project")
    parser.add_argument("--build", type=Path, help="the folder of compile_commands.json (default: build/lint)")
    parser.add_argument("--all", action="store_true", help="also check tests, benchmarks and recipes")
    options = parser.parse_args()
    root = options.root.resolve()
    build = (options.build or root / "build" / "lint").resolve()

    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    configuration = [(root / path).read_text(encoding="utf-8") for path in project_files(root, [".clang-tidy"])]
    units = units_of(root, build)
    checks = [(unit, content_key(root, unit.sources, version, configuration, unit.flags, unit.text)) for unit in units
              if options.all or any(map(is_looked_at_always, unit.sources))]
    # The longest first, to balance the load at the end.
    checks.sort(key=lambda check: -len(check[0].sources))

    def tidy(unit):
        command = ["clang-tidy", "--quiet", f"--config-file={configuration_for(root, build, unit.sources[0])}"]
        with tempfile.TemporaryDirectory() as scratch:
            file = root / unit.sources[0]
            if unit.text:
                file = Path(scratch) / "sources.cpp"
                file.write_text(unit.text, encoding="utf-8")
                command.append("--checks=-bugprone-suspicious-include")  # a batch includes sources on purpose
            # The commands may be for another compiler, with warnings that clang does not know. Highway's kernels include
            # themselves for each instruction set, and one of them suffices.
            flags = [*unit.flags, "-Wno-unknown-warning-option", "-DHWY_COMPILE_ONLY_STATIC"]
            done = subprocess.run([*command, file, "--", *flags], cwd=build, capture_output=True, text=True, check=False)
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
