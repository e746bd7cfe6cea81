# SPDX-License-Identifier: MIT
import unittest

from project_tree import LICENSE, TreeTest

SOURCE = "examples/cookbook/two.cpp"
PAGE = f"""# Two
![Two](../pictures/cookbook/two.svg)
[Live](../../viewer/index.html#rays)

<!-- file: {SOURCE} -->
```cpp
int main() {{}}
```

<!-- output: {SOURCE} -->
```text
1 + 1 = 2
```
"""
PROGRAM = '#!/bin/sh\necho "1 + 1 = 2"\nprintf "<svg/>" >"$1"\n'


class CheckRecipe(TreeTest):
    def setUp(self):
        super().setUp()
        self.write(SOURCE, f"{LICENSE}\nint main() {{}}\n")
        self.write("docs/cookbook/two.md", PAGE)
        self.write("docs/cookbook/README.md", "[Two](two.md)\n")
        self.write("docs/pictures/cookbook/two.svg", "<svg/>")
        self.write_program(PROGRAM)

    def write_program(self, text):
        self.write("build/cookbook_two", text)
        (self.tree / "build/cookbook_two").chmod(0o755)

    def check(self):
        return self.run_tool("check_recipe.py", str(self.tree / "build" / "cookbook_two"))

    def assert_problem(self, problem):
        status, said = self.check()
        self.assertIn(problem, said)
        self.assertEqual(status, 1)

    def test_a_page_that_shows_what_its_program_does_is_accepted(self):
        self.assertEqual(self.check(), (0, "recipe two: 0 problems\n"))

    def test_the_page_must_show_what_the_program_prints(self):
        self.write("docs/cookbook/two.md", PAGE.replace("1 = 2", "1 = 3"))
        self.assert_problem("docs/cookbook/two.md:12: shows another output")
        self.write("docs/cookbook/two.md", PAGE.replace("output:", "result:"))
        self.assert_problem("does not show the output of its program")

    def test_the_page_must_show_the_program_and_its_picture(self):
        self.write("docs/cookbook/two.md", PAGE.replace("file:", "fill:"))
        self.assert_problem("does not show its program")
        self.write("docs/cookbook/two.md", PAGE.replace("two.svg", "one.svg"))
        self.assert_problem("does not show docs/pictures/cookbook/two.svg")

    def test_the_page_must_link_to_the_viewer(self):
        self.write("docs/cookbook/two.md", PAGE.replace("viewer/index.html#", "viewer/index.html"))
        self.assert_problem("docs/cookbook/two.md has no link to the viewer")

    def test_the_picture_must_be_what_the_program_draws(self):
        self.write("docs/pictures/cookbook/two.svg", "<svg></svg>")
        self.assert_problem("docs/pictures/cookbook/two.svg is not what two draws; update it by")

    def test_the_index_must_link_to_the_page(self):
        self.write("docs/cookbook/README.md", "[One](one.md)\n")
        self.assert_problem("docs/cookbook/README.md does not link to two.md")

    def test_a_program_is_short(self):
        self.write(SOURCE, LICENSE + "\n" * 60)
        self.assert_problem("examples/cookbook/two.cpp has 61 lines; the limit is 60")

    def test_what_is_missing_is_named(self):
        (self.tree / "docs/cookbook/two.md").unlink()
        (self.tree / SOURCE).unlink()
        self.assert_problem("examples/cookbook/two.cpp is missing\ndocs/cookbook/two.md is missing")

    def test_a_program_that_fails_or_draws_nothing_is_found(self):
        self.write_program("#!/bin/sh\necho wrong >&2\nexit 3\n")
        self.assert_problem("ends with exit status 3: wrong")
        self.write_program("#!/bin/sh\necho '1 + 1 = 2'\n")
        self.assert_problem("draws no picture")


if __name__ == "__main__":
    unittest.main()
