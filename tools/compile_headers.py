# SPDX-License-Identifier: MIT
"""Compiles every header alone and included twice: a header needs nothing before it, and guards itself."""

import subprocess
import tempfile
from pathlib import Path

from content_cache import ContentCache, content_key
from project_files import include_closure, project_files

_FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror",
          "-ffp-contract=off", "-I."]


# Headers that many others include, the largest first. Whoever includes one finds it compiled: all includes stand before any
# code, so nothing comes to light later than without.
_SHARED = [Path("graze/shape/any_shape.hpp"), Path("graze/shape/polytope.hpp"), Path("graze/math/vec.hpp")]


def _precompile(root, compiler, header, folder):
    target = folder / header.parent / (header.name + ".gch")
    target.parent.mkdir(parents=True)
    flags = [flag for flag in _FLAGS if flag != "-fsyntax-only"]
    # What is wrong with it is said when it is compiled alone.
    subprocess.run([compiler, *flags, "-x", "c++-header", header, "-o", target], cwd=root, capture_output=True, check=False)


def compile_headers(root, compiler):
    """Returns the problems as texts, and how many headers were looked at. Those that passed unchanged are not compiled again."""
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    headers = [path for path in project_files(root, [".hpp"]) if path.parts[0] == "graze"]
    checks = [(path, content_key(root, path, version, _FLAGS)) for path in headers]
    cache = ContentCache(root / "build" / "cache" / "headers")

    with tempfile.TemporaryDirectory() as scratch:
        compiled = {header: Path(scratch) / header.stem for header in _SHARED if header in headers}
        if cache.is_due(checks):
            for header, folder in compiled.items():
                _precompile(root, compiler, header, folder)

        def work(path):
            closure = include_closure(root, path)
            shared = next((header for header in compiled if header != path and header in closure), None)
            source = (f"#include <{shared}>\n" if shared else "") + f"#include <{path}>\n" * 2
            found = [f"-I{compiled[shared]}"] if shared else []
            done = subprocess.run([compiler, *found, *_FLAGS, "-x", "c++", "-"], input=source, cwd=root, capture_output=True,
                                  text=True, check=False)
            return done.stderr if done.returncode else ""

        failed, _ = cache.run(checks, work)
    return [f"{path}:1: does not compile when it is included alone, twice\n{text}" for path, text in failed], len(headers)
