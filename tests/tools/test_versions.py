# SPDX-License-Identifier: MIT
"""The version of the CMake project is the only source: every other file that must name it has the same."""

import json
import re
import unittest

from project_tree import ROOT

VERSION = re.search(r"project\(graze VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
MINOR = VERSION.rsplit(".", 1)[0]


class VersionTest(unittest.TestCase):
    def named(self, path, pattern):
        """The first match of the pattern in a file."""
        found = re.search(pattern, (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE)
        self.assertTrue(found, f"{path} has no {pattern}")
        return found[1]

    def test_packages_have_the_version_of_the_project(self):
        for path in ("bindings/wasm/package.json", "viewer/package.json", "viewer/package-lock.json"):
            self.assertEqual(json.loads((ROOT / path).read_text(encoding="utf-8"))["version"], VERSION, path)
        port = json.loads((ROOT / "packaging/vcpkg/graze/vcpkg.json").read_text(encoding="utf-8"))
        self.assertEqual(port["version-semver"], VERSION)
        self.assertEqual(self.named("packaging/debian/changelog", r"\Agraze \(([0-9.]+)-[0-9]+\)"), VERSION)

    def test_texts_have_the_version_of_the_project(self):
        self.assertEqual(self.named("CITATION.cff", r"^version: (.*)$"), VERSION)
        self.assertEqual(self.named("CHANGELOG.md", r"^## \[([0-9.]+)\]"), VERSION)
        self.assertEqual(self.named("SECURITY.md", r"The only supported version is ([0-9.]+[0-9])\."), MINOR)

    def test_the_header_of_c_has_the_version_of_the_project(self):
        major, minor, patch = VERSION.split(".")
        number = int(major) * 10000 + int(minor) * 100 + int(patch)
        self.assertEqual(int(self.named("bindings/c/graze.h", r"^#define GRAZE_VERSION ([0-9]+)")), number)

    def test_the_names_of_debian_packages_are_those_of_the_shared_libraries(self):
        control = (ROOT / "packaging/debian/control").read_text(encoding="utf-8")
        names = re.findall(r"^Package: (libgraze.*[0-9])$", control, re.MULTILINE)
        self.assertEqual(names, [f"libgraze{MINOR}", f"libgraze-c{MINOR}"])
        for name in names:
            self.assertTrue((ROOT / f"packaging/debian/{name}.install").is_file(), name)


if __name__ == "__main__":
    unittest.main()
