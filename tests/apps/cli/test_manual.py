# SPDX-License-Identifier: MIT
import os
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(os.environ["GRAZE_ROOT"])
SHARE = ROOT / "apps/cli/share"


class Manual(unittest.TestCase):
    def test_manual_page_and_completions_are_what_help_says(self):
        tool = [sys.executable, "-B", ROOT / "tools/make_manual.py", "--check", "--program", os.environ["GRAZE_CLI"]]
        done = subprocess.run(tool, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def complete(self, *words):
        quoted = " ".join(f"'{word}'" for word in words)
        script = (f"source '{SHARE / 'graze.bash'}'; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _graze; "
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        return subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.split()

    def test_bash_completes_commands_options_and_values(self):
        self.assertEqual(self.complete("graze", "rep"), ["replay"])
        self.assertEqual(self.complete("graze", "check", "--fo"), ["--format"])
        self.assertEqual(self.complete("graze", "check", "--format", ""), ["table", "json", "ndjson", "csv"])


if __name__ == "__main__":
    unittest.main()
