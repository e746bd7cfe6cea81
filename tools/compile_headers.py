# SPDX-License-Identifier: MIT
"""Compiles every header alone and included twice, to check that it is self-contained and has an include guard."""

import os
import shutil
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from content_cache import ContentCache, content_key
from project_files import include_closure, project_files

_FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror",
          "-ffp-contract=off", "-DGRAZE_NO_CONTRACTION", "-I."]


# Headers that many others include, the largest first; precompiled. Includes come before all code, so precompiling hides no
# errors.
_SHARED = [Path("graze/io/scene_file.hpp"), Path("graze/scene/scene.hpp"), Path("graze/query/contact.hpp"),
           Path("graze/shape/any_shape.hpp"), Path("graze/shape/polytope.hpp"), Path("graze/math/vec.hpp")]


def _precompile(root, compiler, header, folder):
    """Returns the file to `-include` instead of the header, and the compiler's messages if precompiling failed."""
    folder.mkdir()
    named = folder / header.name
    named.write_text(f"#include <{header}>\n", encoding="utf-8")  # #pragma once causes a warning in a main file
    flags = [flag for flag in _FLAGS if flag != "-fsyntax-only"]
    done = subprocess.run([compiler, *flags, "-x", "c++-header", named, "-o", f"{named}.gch"], cwd=root, capture_output=True,
                          text=True, check=False)
    return named, done.stderr if done.returncode else ""


def _flags_of_mpi():
    """Where mpi.h is, for the headers that need it; empty if MPI is not installed, which their compilation then reports."""
    if not shutil.which("mpicxx"):
        return []
    folders = subprocess.run(["mpicxx", "--showme:incdirs"], capture_output=True, text=True, check=False).stdout.split()
    return [flag for folder in folders for flag in ("-isystem", folder)] + ["-DOMPI_SKIP_MPICXX"]


def _is_part(path):
    """Whether other files include this one into their own namespaces: one source for one pair and for many."""
    return path.parts[1] == "query" and path.stem.endswith("-inl")


def compile_headers(root, compiler):
    """Returns the problems as texts and the number of headers. Unchanged headers that passed are not compiled again."""
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    headers = [path for path in project_files(root, [".hpp"]) if path.parts[0] == "graze" and not _is_part(path)]
    mpi = _flags_of_mpi()
    checks = [(path, content_key(root, path, version, _FLAGS)) for path in headers]
    cache = ContentCache(root / "build" / "cache" / "headers")

    with tempfile.TemporaryDirectory() as scratch:
        compiled, problems = {}, []
        if cache.is_due(checks):
            shared = [header for header in _SHARED if header in headers]
            with ThreadPoolExecutor(os.cpu_count()) as threads:
                made = threads.map(lambda header: _precompile(root, compiler, header, Path(scratch) / header.stem), shared)
            for header, (compiled[header], said) in zip(shared, made):
                if said:
                    problems.append(f"{header}:1: cannot be precompiled\n{said}")

        def work(path):
            closure = include_closure(root, path)
            shared = next((named for header, named in compiled.items() if header != path and header in closure), None)
            done = subprocess.run([compiler, *(["-include", shared] if shared else []), *_FLAGS,
                                   *(mpi if path.parts[1] == "distributed" else []), "-x", "c++", "-"],
                                  input=f"#include <{path}>\n" * 2, cwd=root, capture_output=True, text=True, check=False)
            return done.stderr if done.returncode else ""

        failed, _ = cache.run(checks, work)
    problems += [f"{path}:1: does not compile when it is included alone, twice\n{text}" for path, text in failed]
    return problems, len(headers)
