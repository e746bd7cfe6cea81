# SPDX-License-Identifier: MIT
import unittest

from project_tree import TreeTest

from markdown import anchor_of, read_page

PROGRAM = '#!/bin/sh\n[ "$1" = check ] || { echo "no command $1" >&2; exit 2; }\necho "2 pairs in 0.1 s"\n'


class CheckDocs(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("dev", "#!/bin/sh\necho 'usage: ./dev COMMAND'\necho '  demo  shows it'\n")
        self.write("build/graze", PROGRAM)
        for name in ("dev", "build/graze"):
            (self.tree / name).chmod(0o755)

    def check(self, page):
        self.write("README.md", page)
        return self.run_tool("check_docs.py", "--program", str(self.tree / "build" / "graze"))

    def assert_problem(self, page, problem):
        status, said = self.check(page)
        self.assertIn(problem, said)
        self.assertEqual(status, 1)

    def test_commands_run_in_a_copy_of_the_project(self):
        status, said = self.check("```sh\ngraze check x >out.txt\ntest -f out.txt  # still there\n```\n")
        self.assertIn("1 pages, 2 commands run", said)
        self.assertEqual(status, 0)
        self.assertFalse((self.tree / "out.txt").exists())

    def test_a_command_that_fails_is_found_with_its_line(self):
        self.assert_problem("```sh\ngraze check x\n\ngraze chekc x\n```\n", "README.md:4: exit status 2 of: graze chekc x")

    def test_a_command_may_be_longer_than_a_line(self):
        self.assertEqual(self.check("```sh\nfor i in 1 2\ndo graze check $i\ndone\ncat <<'END'\n`\nEND\ngraze \\\n  check\n```\n")[0], 0)

    def test_output_that_is_shown_must_come(self):
        self.assertEqual(self.check("```console\n$ graze check x\n2 pairs in ... s\n```\n")[0], 0)
        self.assert_problem("```console\n$ graze check x\n3 pairs in ... s\n```\n", "README.md:2: shows another output of")

    def test_text_blocks_are_not_run(self):
        self.assertEqual(self.check("```text\ngraze chekc x\n```\n")[0], 0)

    def test_commands_that_reach_beyond_the_project_are_refused(self):
        self.assert_problem("```sh\nsudo apt-get install g++\n```\n", "README.md:2: cannot be run in a test, so mark its block ```text")

    def test_dev_commands_are_looked_up_not_run(self):
        self.assertEqual(self.check("```sh\n./dev demo\n```\n")[0], 0)
        self.assert_problem("```sh\n./dev dmeo\n```\n", "README.md:2: ./dev has no command 'dmeo'; its commands are: demo")

    def test_a_block_that_shows_a_file_must_be_that_file(self):
        self.write("examples/one.cpp", "// SPDX-License-Identifier: MIT\n\nint main() {}\n")
        marker = "<!-- file: examples/one.cpp -->\n"
        self.assertEqual(self.check(f"{marker}```cpp\nint main() {{}}\n```\n")[0], 0)
        self.assert_problem(f"{marker}```cpp\nint main() {{ }}\n```\n", "README.md:3: differs from examples/one.cpp")
        self.assert_problem("<!-- file: examples/two.cpp -->\n```cpp\n```\n", "shows examples/two.cpp, which does not exist")

    def test_a_block_may_show_a_part_of_a_file(self):
        self.write("examples/one.cpp", "int main() {\n  int a = 1;\n  int b = 2;\n}\n")
        marker = "<!-- from: examples/one.cpp -->\n"
        self.assertEqual(self.check(f"{marker}```cpp\nint a = 1;\nint b = 2;\n```\n")[0], 0)
        self.assert_problem(f"{marker}```cpp\nint b = 2;\nint a = 1;\n```\n", "README.md:3: is not found in examples/one.cpp")

    def test_links_must_lead_somewhere(self):
        self.write("docs/guide.md", "# The guide: how?\n[back](../README.md)\n")
        self.assertEqual(self.check("[a](docs/guide.md#the-guide-how) [web](https://example.org/x) `[no](link)`\n")[0], 0)
        self.assert_problem("![a](docs/picture.svg)\n", "README.md:1: links to docs/picture.svg, which does not exist")
        self.assert_problem("[a](docs/guide.md#why)\n", "links to docs/guide.md#why, but docs/guide.md has no such heading")


class ReadPage(unittest.TestCase):
    def test_a_block_has_the_line_of_its_first_line_of_code(self):
        page = read_page("text\n\n  ```sh\n  one\n    two\n  ```\n")
        self.assertEqual([(block.line, block.language, block.code) for block in page.blocks], [(4, "sh", "one\n  two\n")])

    def test_a_comment_names_the_source_of_the_next_block_only(self):
        page = read_page("<!-- file: a.cpp -->\n\n```cpp\n```\n```cpp\n```\n")
        self.assertEqual([block.source for block in page.blocks], [("file", "a.cpp"), None])

    def test_headings_inside_of_code_are_none(self):
        self.assertEqual(read_page("# One `two`\n```sh\n# three\n```\n").anchors, {"one-two"})

    def test_anchors_are_those_of_web_pages(self):
        self.assertEqual(anchor_of("`graze check`: what [touches](x.md)?"), "graze-check-what-touches")


if __name__ == "__main__":
    unittest.main()
