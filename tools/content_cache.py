# SPDX-License-Identifier: MIT
"""Stores which checks passed on which contents, so that a check is only repeated after a change."""

import hashlib
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from project_files import include_closure


class ContentCache:
    """A folder with one empty file per passed check, named by the hash of everything that the check depends on."""

    def __init__(self, folder):
        self._folder = Path(folder)
        self._folder.mkdir(parents=True, exist_ok=True)

    def is_due(self, checks):
        """Whether any of the checks, given as in `run`, has not passed yet."""
        return any(not (self._folder / key).exists() for _, key in checks)

    def run(self, checks, work):
        """Calls `work(item)` in parallel for each (item, key) of `checks` whose key has not passed yet. `work` returns a
        description of the problem, or an empty text. Returns the failed items with their texts, and the number of calls."""
        due = [check for check in checks if self.is_due([check])]
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            texts = list(threads.map(lambda check: work(check[0]), due))
        for (_, key), text in zip(due, texts):
            if not text:
                (self._folder / key).touch()
        return [(item, text) for (item, _), text in zip(due, texts) if text], len(due)


def content_key(root, paths, *settings):
    """The hash of one or several source files, the project files that they include, and the settings of the check."""
    digest = hashlib.sha256()
    for setting in settings:
        digest.update(str(setting).encode() + b"\0")
    for path in [paths] if isinstance(paths, Path) else paths:
        for part in include_closure(root, path):
            digest.update(str(part).encode() + b"\0" + (Path(root) / part).read_bytes() + b"\0")
    return digest.hexdigest()
