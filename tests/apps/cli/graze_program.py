# SPDX-License-Identifier: MIT
"""Helpers for the tests of the command line: running the program, input files, and a terminal."""

import contextlib
import json
import os
import pty
import re
import resource
import select
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GRAZE_ROOT", Path(__file__).resolve().parents[3]))
PROGRAM = os.environ.get("GRAZE_CLI", str(ROOT / "build" / "release" / "bin" / "graze"))
TIMEOUT_SECONDS = 60

# Ball and crate overlap, the crate stands on the ground, the lamp touches nothing.
YARD = {
    "schema": "graze.scene/1",
    "dimension": 2,
    "objects": [
        {"name": "ground", "type": "aabb", "min": [-10, -1], "max": [10, 0]},
        {"name": "crate", "type": "aabb", "min": [0, 0], "max": [2, 2]},
        {"name": "ball", "type": "sphere", "center": [2.5, 1], "radius": 1},
        {"name": "lamp", "type": "sphere", "center": [0, 8], "radius": 0.5},
    ],
}
YARD_PAIRS = [("ground", "crate", "touching"), ("ground", "ball", "touching"), ("crate", "ball", "overlapping")]


# A map with only an image layer, which is not read.
IMAGE_LAYER = """<map width="1" height="1" tilewidth="8" tileheight="8">
 <imagelayer name="sky"><image source="sky.png"/></imagelayer>
</map>"""

# Address sanitizers reserve terabytes of address space, so the memory of such programs cannot be limited.
CAN_BE_LIMITED = b"__asan_init" not in Path(PROGRAM).read_bytes() if Path(PROGRAM).is_file() else False


def with_memory_of(mebibytes):
    """An option for `run_graze`: limits the memory of the program."""
    size = mebibytes << 20
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size))} if CAN_BE_LIMITED else {}


def environment(**changes):
    """The environment of a program started on an ordinary terminal."""
    result = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "TERM")}
    result["TERM"] = "xterm-256color"
    result.update(changes)
    return result


def run_graze(*arguments, **options):
    """Runs the program to its end; returns standard output and error as bytes."""
    options.setdefault("stdin", subprocess.DEVNULL if "input" not in options else None)
    if options["stdin"] is None:
        del options["stdin"]
    for stream in ("stdout", "stderr"):
        options.setdefault(stream, subprocess.PIPE)
    options.setdefault("env", environment())
    command = [options.pop("program", PROGRAM), *map(os.fspath, arguments)]
    return subprocess.run(command, timeout=TIMEOUT_SECONDS, check=False, **options)


class CommandLineTest(unittest.TestCase):
    """A test with a working folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="graze-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, content):
        """Writes a file in the folder: bytes unchanged, text in UTF-8, anything else as JSON."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not isinstance(content, (bytes, str)):
            content = json.dumps(content)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def yard(self):
        return self.write("yard.json", YARD)

    def succeed(self, *arguments, code=0, **options):
        """Runs the program, which must exit with `code`; returns standard output and error as text."""
        done = run_graze(*arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return (done.stdout or b"").decode(), (done.stderr or b"").decode()

    def refused(self, *arguments, code=3, says=(), **options):
        """Runs the program, which must print one line of error that names the facts, and write no data."""
        done = run_graze(*arguments, **options)
        said = (done.stderr or b"").decode()
        self.assertEqual(done.returncode, code, said)
        self.assertEqual(done.stdout or b"", b"")
        self.assertRegex(said, r"\Agraze: error: [^\n]+\n")
        for fact in [says] if isinstance(says, str) else says:
            self.assertIn(fact, said)
        return said

    def assert_no_litter(self, *expected):
        """Asserts that the folder contains exactly these files."""
        found = sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file())
        self.assertEqual(found, sorted(expected))


class Terminal:
    """A pseudo-terminal: what a program wrote to it, and its exit status."""

    def __init__(self, command, streams, stdin=subprocess.DEVNULL, during=None, **options):
        """`streams` of the command are the terminal ("stdout", "stderr"), others are pipes; `during` is called with
        the process while it runs."""
        primary, secondary = pty.openpty()
        pipes = {stream: secondary if stream in streams else subprocess.PIPE for stream in ("stdout", "stderr")}
        process = subprocess.Popen(command, stdin=stdin, **pipes, **options)
        os.close(secondary)
        try:
            if during:
                during(process)
            self.text = _read_all(primary, process).decode()
            self.piped = {stream: getattr(process, stream).read().decode()
                          for stream in ("stdout", "stderr") if stream not in streams}
            self.code = process.wait(TIMEOUT_SECONDS)
        finally:
            process.kill()
            process.wait()
            for stream in (process.stdin, process.stdout, process.stderr):
                if stream:
                    with contextlib.suppress(BrokenPipeError):
                        stream.close()
            os.close(primary)

    def screen(self):
        """The visible text, without colours and erased parts."""
        lines = []
        for line in self.text.split("\n"):
            shown = ""
            for part in re.sub(r"\x1b\[[0-9;]*m", "", line).split("\r"):
                if part.startswith("\x1b[K"):
                    shown, part = "", part.removeprefix("\x1b[K")
                part, erased, rest = part.partition("\x1b[K")
                shown = part + rest if erased else part + shown[len(part):]
            lines.append(shown)
        return "\n".join(lines)


def _read_all(terminal, process):
    """Everything written to the terminal until the program has closed it."""
    text, deadline = b"", time.monotonic() + TIMEOUT_SECONDS
    while time.monotonic() < deadline:
        if not select.select([terminal], [], [], 0.1)[0]:
            if process.poll() is not None:
                break
            continue
        try:
            block = os.read(terminal, 65536)
        except OSError:  # Linux reports EIO when the other side is closed
            break
        if not block:
            break
        text += block
    return text
