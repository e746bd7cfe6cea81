# SPDX-License-Identifier: MIT
"""Compiles every header alone and included twice: a header needs nothing before it, and guards itself."""

import subprocess

from content_cache import ContentCache, content_key
from project_files import project_files

_FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror",
          "-ffp-contract=off", "-I."]


def compile_headers(root, compiler):
    """Returns the problems as texts, and how many headers were looked at. Those that passed unchanged are not compiled again."""
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    headers = [path for path in project_files(root, [".hpp"]) if path.parts[0] == "graze"]
    checks = [(path, content_key(root, path, version, _FLAGS)) for path in headers]

    def work(path):
        source = f"#include <{path}>\n" * 2
        done = subprocess.run([compiler, *_FLAGS, "-x", "c++", "-"], input=source, cwd=root, capture_output=True, text=True,
                              check=False)
        return done.stderr if done.returncode else ""

    failed, _ = ContentCache(root / "build" / "cache" / "headers").run(checks, work)
    return [f"{path}:1: does not compile when it is included alone, twice\n{text}" for path, text in failed], len(headers)
