# SPDX-License-Identifier: MIT
"""tools/pair_growth.py with a program that prints what graze bench would."""

import subprocess
import sys
import unittest

from project_tree import ROOT, TreeTest


class PairGrowthTest(TreeTest):
    def test_costs_are_for_one_box_and_of_the_fastest_frame(self):
        self.write("graze", "#!/bin/sh\n"
                            'echo "$*" >> "$(dirname "$0")/calls"\n'
                            "echo method,chosen,median_ms,fastest_ms,slowest_ms,pairs,bytes\n"
                            "echo automatic,tree,9,0.5,10,20000,400000\n")
        (self.tree / "graze").chmod(0o755)
        done = subprocess.run([sys.executable, "-B", ROOT / "tools/pair_growth.py", self.tree / "graze", "--worlds", "2d:line",
                               "--counts", "1000,10000", "--frames", "3"], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "| nanoseconds for a box | pairs for a box | 1,000 | 10,000 |\n"
                                      "| --- | --: | --: | --: |\n"
                                      "| 2d:line | 2.00 | 500.0 | 50.0 |\n"
                                      "\n"
                                      "| bytes for each of 10,000 boxes | pairs for a box | sorted | any order |\n"
                                      "| --- | --: | --: | --: |\n"
                                      "| 2d:line | 2.00 | 40 | 40 |\n")
        calls = (self.tree / "calls").read_text(encoding="utf-8").splitlines()
        self.assertEqual(calls[0], "bench --generate 2d:line:1000 --frames 3 --threads 1 --order sorted --format csv")
        self.assertIn("--order any", calls[-1])


if __name__ == "__main__":
    unittest.main()
