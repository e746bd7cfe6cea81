# SPDX-License-Identifier: MIT
"""The script behind the target `uninstall`."""

import subprocess
import unittest

from project_tree import ROOT, TreeTest


class UninstallTest(TreeTest):
    def uninstall(self):
        return subprocess.run(["cmake", f"-DMANIFEST={self.tree / 'install_manifest.txt'}", "-P", ROOT / "cmake/graze_uninstall.cmake"],
                              capture_output=True, text=True, check=False)

    def test_what_was_installed_is_removed_and_nothing_else(self):
        installed = ["include/graze/math/vec.hpp", "include/graze/graze.hpp", "lib/libgraze.so", "lib/cmake/graze/graze-config.cmake"]
        for path in [*installed, "include/other.hpp", "lib/cmake/graze/own.cmake"]:
            self.write(path, "text")
        (self.tree / "lib/libgraze.so.0").symlink_to("removed before its link")
        manifest = [*installed, "lib/libgraze.so.0", "lib/gone_already"]
        self.write("install_manifest.txt", "\n".join(str(self.tree / path) for path in manifest))
        done = self.uninstall()
        self.assertEqual(done.returncode, 0, done.stderr)
        left = {str(path.relative_to(self.tree)) for path in self.tree.rglob("*")}
        self.assertEqual(left, {"include", "include/other.hpp", "lib", "lib/cmake", "lib/cmake/graze", "lib/cmake/graze/own.cmake"})

    def test_without_an_installation_it_says_so(self):
        self.assertIn("nothing was installed from this build folder", " ".join(self.uninstall().stderr.split()))


if __name__ == "__main__":
    unittest.main()
