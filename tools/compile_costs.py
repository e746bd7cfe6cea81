# SPDX-License-Identifier: MIT
"""Prints compile times and sizes as a table in Markdown: user CPU of single files and of the library with the program, built from
nothing without a compiler cache, and the sizes of the results."""

import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FLAGS = ["-std=c++20", "-O2", "-DNDEBUG", "-ffp-contract=off", "-DGRAZE_NO_CONTRACTION", "-DGRAZE_COMPILED_QUERIES", f"-I{ROOT}"]

# The header, and one call with the any shapes a and b.
CALLS = {
    "contact": "contact(a, b).has_value()",
    "manifold": "manifold(a, b).size > 0",
    "distance": "distance(a, b) > 0",
    "shape_cast": "shape_cast(a, Vec<3>{1, 0, 0}, b).has_value()",
    "time_of_impact": "time_of_impact(a, {}, b, {}).has_value()",
    "ray_cast": "ray_cast(a, Ray<3>{}).has_value()",
}


def user_seconds(command, **options):
    """User CPU of a command and of all that it runs."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True, stdout=sys.stderr, **options)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def compile_seconds(compiler, source, folder):
    """Of the fastest of three times: memory and the disk's cache only add to it."""
    (folder / "costs.cpp").write_text(source, encoding="utf-8")
    command = [compiler, *FLAGS, "-c", folder / "costs.cpp", "-o", folder / "costs.o"]
    return min(user_seconds(command) for _ in range(3))


def call_source(query):
    return (f"#include <graze/query/{query}.hpp>\nusing namespace graze;\n"
            f"bool ask(const AnyShape<3>& a, const AnyShape<3>& b) {{ return {CALLS[query]} && a.index() == b.index(); }}\n")


def built(folder, jobs, target, *options):
    """Configures the preset release anew in a folder and builds a target; the user CPU of the latter."""
    environment = {name: value for name, value in os.environ.items() if name != "CMAKE_CXX_COMPILER_LAUNCHER"}
    subprocess.run(["cmake", "--preset", "release", "-B", folder, *options], cwd=ROOT, check=True, stdout=sys.stderr,
                   env=environment)
    return user_seconds(["cmake", "--build", folder, "-j", str(jobs), "--target", target], cwd=ROOT, env=environment)


def stripped_size(file, folder):
    copy = folder / "stripped"
    subprocess.run(["strip", file, "-o", copy], check=True)
    return copy.stat().st_size


def exported_symbols(library):
    """The names that a shared library defines for others."""
    names = subprocess.run(["nm", "--dynamic", "--defined-only", "--extern-only", library], capture_output=True, text=True, check=True)
    return names.stdout.splitlines()


def compile_rows(compiler, folder):
    yield "`#include <graze/graze.hpp>` alone", f"{compile_seconds(compiler, '#include <graze/graze.hpp>', folder):.1f} s"
    for query in CALLS:
        yield f"one call of `{query}` of any shape", f"{compile_seconds(compiler, call_source(query), folder):.1f} s"


def build_rows(jobs, folder):
    seconds = built(folder / "static", jobs, "graze_cli")
    yield "library and program from nothing (preset `release`)", f"{seconds:.0f} s"
    built(folder / "static", jobs, "graze_example_quick_start", "-DGRAZE_BUILD_EXAMPLES=ON")
    quick_start = folder / "static/examples/quick_start"
    yield "quick start, linked statically, stripped", f"{stripped_size(quick_start, folder) / 1e6:.1f} MB"
    built(folder / "shared", jobs, "graze_graze", "-DBUILD_SHARED_LIBS=ON")
    library = folder / "shared/graze/libgraze.so"
    yield "shared library, stripped", f"{stripped_size(library, folder) / 1e6:.1f} MB"
    yield "symbols exported by the shared library", f"{len(exported_symbols(library)):,}"


def module_rows(module):
    if module.is_file() and shutil.which("brotli"):
        size = len(subprocess.run(["brotli", "--best", "--stdout", module], capture_output=True, check=True).stdout)
        yield "WebAssembly module, brotli", f"{size / 1e6:.2f} MB"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compiler", default="g++", help="of the single files (default: %(default)s)")
    parser.add_argument("--files-only", action="store_true", help="leave out what needs the whole library to be compiled")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="compilers at once (default: %(default)s)")
    parser.add_argument("--module", type=Path, default=ROOT / "build/web/package/graze_wasm.wasm",
                        help="made by ./dev web wasm; left out if it is not there (default: %(default)s)")
    options = parser.parse_args()
    print("| user CPU or size | |\n|---|--:|")
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for name, cost in compile_rows(options.compiler, folder):
            print(f"| {name} | {cost} |", flush=True)
        if options.files_only:
            return
        for name, cost in [*build_rows(options.jobs, folder), *module_rows(options.module)]:
            print(f"| {name} | {cost} |", flush=True)


if __name__ == "__main__":
    main()
