# SPDX-License-Identifier: MIT
"""A shared library would export what programs need, and hide the rest: the objects of the program, the bindings and the
examples use no function of the library without GRAZE_EXPORT. The tests' library is static, but its objects state which
symbols are hidden."""

import os
import re
import subprocess
import unittest
from pathlib import Path

BUILD = Path(os.environ["GRAZE_BUILD"])
LIBRARY = Path(os.environ["GRAZE_LIBRARY"])

_SYMBOL = re.compile(r"^ *\d+: +\S+ +\S+ +(\S+) +(GLOBAL|WEAK|UNIQUE) +(\S+) +(\S+) +(\S+)", re.MULTILINE)


def symbols_of(*files):
    """(name, visibility, whether it is defined) of the files' symbols that are not local."""
    listing = subprocess.run(["readelf", "--symbols", "--wide", *files], capture_output=True, text=True, check=True).stdout
    return [(name, visibility, section != "UND") for _, _, visibility, section, name in _SYMBOL.findall(listing)]


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.of_library = {name: visibility for name, visibility, is_defined in symbols_of(LIBRARY) if is_defined}
        objects = [path for folder in ("apps", "bindings", "examples") for path in (BUILD / folder).rglob("*.o")
                   if not {"test", "tests"} & set(path.parts)]
        cls.used = {name for name, _, is_defined in symbols_of(*objects) if not is_defined} & cls.of_library.keys()

    def test_programs_need_nothing_hidden(self):
        self.assertGreater(len(self.used), 100)
        self.assertEqual([name for name in sorted(self.used) if self.of_library[name] != "DEFAULT"], [])

    def test_most_is_hidden(self):
        exported = [name for name, visibility in self.of_library.items() if visibility == "DEFAULT" and "graze" in name]
        self.assertLess(len(exported), 2000)
        self.assertLess(len(exported), len(self.of_library) / 10)


if __name__ == "__main__":
    unittest.main()
