# SPDX-License-Identifier: MIT
import json
import unittest

from project_tree import TreeTest

RUN = {"date": "2026-11-28", "compiler": "GCC 12.2.0", "seed": 3, "cases": 40, "points": 0, "contacts": 0, "distances": 20,
       "manifolds": 0, "casts": 0, "impacts": 0, "rays": 0, "hulls": 0, "masses": 0, "seconds": 0.0, "pairs": "sphere",
       "certified": 0.9}
ANSWERS = [
    {"question": "distance", "subject": "sphere, sphere", "cases": 40, "outside": 0, "wrong": 0, "apart": 0.425,
     "distance": {"3D double": 0.5, "3D float": 1.25}, "points": 0.0},
    {"question": "relation", "subject": "sphere, sphere", "cases": 1234, "outside": 0, "wrong": 1, "certified": 0.995,
     "hits": 0.0042, "in_band": 0.0, "gap": {"3D double": 120.0, "3D float": 0.0}},
]
FIGURES = {"false_no": 1, "false_yes": 2, "off": 3, "points_off": 4, "slightly_off": 5, "worst": None}
RIGHT = {"false_no": 0, "false_yes": 0, "off": 0, "points_off": 0, "slightly_off": 0, "worst": 6.2e-08}
SIDE_BY_SIDE = [
    {"question": "distance", "space": "3D float", "subject": "sphere, sphere", "cases": 20, "measured": 9,
     "programs": {"FCL": FIGURES, "graze": RIGHT}},
    {"question": "distance", "space": "3D float", "subject": "all", "cases": 20, "measured": 9,
     "programs": {"FCL": FIGURES, "graze": RIGHT}},
]
DISTANCES = """| pair | cases | apart | wrong | outside | 2D f | 2D d | 3D f | 3D d | points |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|
| sphere, sphere | 40 | 42 % | 0 | 0 | - | - | 1.2 | 0.5 | 0 |
"""


class ExamTables(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("docs/accuracy.json", json.dumps({"run": RUN, "answers": ANSWERS, "side_by_side": SIDE_BY_SIDE}))
        self.write("docs/accuracy.md", "# A\n\n<!-- exam: summary -->\n<!-- exam: end -->\n\nrest\n")
        self.write("docs/accuracy_tables.md", "<!-- exam: distance -->\nold\n<!-- exam: end -->\n")
        self.write("dev", "#!/bin/sh\n")
        (self.tree / "dev").chmod(0o755)

    def page(self, name):
        return (self.tree / "docs" / name).read_text(encoding="utf-8")

    def test_all_tables_are_printed(self):
        status, said = self.run_tool("exam_tables.py")
        self.assertEqual(status, 0)
        self.assertIn("2026-11-28, GCC 12.2.0, seed 3, 40 cases per pair", said)
        self.assertIn(DISTANCES, said)
        self.assertIn("| sphere, sphere | 1234 | 100 % | 0.42 % | 1 | 0 | 0 | - | - | 0 | 1.2e+02 |\n", said)
        self.assertIn("| sphere, sphere | 20 | 9 | 0 + 0, 0 / 0, 6.2e-08, 0 | 2 + 1, 3 / 5, inf, 4 |\n", said)
        self.assertIn("| **all** | 20 |", said)
        self.assertIn("| `distance` | 40 | 0 | 30 % / - |\n| `relation` | 1,234 | 1 |  |\n", said)

    def test_pages_hold_what_lies_between_their_marks(self):
        status, said = self.run_tool("check_docs.py", "--program", str(self.tree / "dev"))
        self.assertIn("docs/accuracy.md:3: differs from docs/accuracy.json; run tools/exam_tables.py --write", said)
        self.assertIn("docs/accuracy_tables.md:1: differs from", said)
        self.assertEqual(status, 1)
        self.assertEqual(self.run_tool("exam_tables.py", "--write")[0], 0)
        self.assertEqual(self.page("accuracy_tables.md"), f"<!-- exam: distance -->\n\n{DISTANCES}\n<!-- exam: end -->\n")
        self.assertTrue(self.page("accuracy.md").startswith("# A\n\n<!-- exam: summary -->\n\n| question | cases |"))
        self.assertTrue(self.page("accuracy.md").endswith("\n\n<!-- exam: end -->\n\nrest\n"))
        status, said = self.run_tool("check_docs.py", "--program", str(self.tree / "dev"))
        self.assertNotIn("accuracy.json", said)
        self.assertEqual(status, 0)

    def test_a_mark_that_the_data_have_nothing_for_is_named(self):
        self.write("docs/accuracy.md", "<!-- exam: contact -->\n<!-- exam: end -->\n")
        said = self.run_tool("check_docs.py", "--program", str(self.tree / "dev"))[1]
        self.assertIn("docs/accuracy.md:1: docs/accuracy.json has nothing for <!-- exam: contact -->", said)
        status, said = self.run_tool("exam_tables.py", "--write")
        self.assertIn("docs/accuracy.json has nothing for <!-- exam: contact -->", said)
        self.assertEqual(status, 1)


if __name__ == "__main__":
    unittest.main()
