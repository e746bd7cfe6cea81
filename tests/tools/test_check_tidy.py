# SPDX-License-Identifier: MIT
import json
import shutil
import unittest

from project_tree import LICENSE, TreeTest

from check_tidy import findings


@unittest.skipUnless(shutil.which("clang-tidy"), "clang-tidy is not installed")
class CheckTidy(TreeTest):
    def setUp(self):
        super().setUp()
        self.write(".clang-tidy", "Checks: '-*,readability-container-size-empty'\nWarningsAsErrors: '*'\n")
        self.write("apps/main.cpp", f"{LICENSE}int main() {{}}\n")
        self.write("build/lint/compile_commands.json", json.dumps([{
            "directory": str(self.tree), "command": f"g++ -std=c++20 -c '{self.tree}/apps/main.cpp'",
            "file": str(self.tree / "apps/main.cpp")}]))

    def test_files_are_looked_at_once_and_again_when_they_change(self):
        self.assertIn("1 files in 1 units, 1 of them changed, 0 findings", self.run_tool("check_tidy.py")[1])
        self.assertIn("1 files in 1 units, 0 of them changed, 0 findings", self.run_tool("check_tidy.py")[1])
        self.write("apps/main.cpp", f"{LICENSE}#include <vector>\nint main() {{ return std::vector<int>().size() == 0; }}\n")
        status, said = self.run_tool("check_tidy.py")
        self.assertIn("apps/main.cpp:3:21: error:", said)
        self.assertIn("1 files in 1 units, 1 of them changed, 1 findings", said)
        self.assertEqual(status, 1)

    def test_tests_benchmarks_and_recipes_are_looked_at_only_when_asked(self):
        commands = json.loads((self.tree / "build/lint/compile_commands.json").read_text(encoding="utf-8"))
        for path in ("tests/some_test.cpp", "bench/some.cpp", "examples/cookbook/some.cpp", "examples/some.cpp"):
            self.write(path, f"{LICENSE}int main() {{}}\n")
            commands.append({"directory": str(self.tree), "command": f"g++ -std=c++20 -c '{self.tree}/{path}'",
                             "file": str(self.tree / path)})
        self.write("build/lint/compile_commands.json", json.dumps(commands))
        self.assertIn("2 files in 2 units, 2 of them changed, 0 findings", self.run_tool("check_tidy.py")[1])
        self.assertIn("5 files in 5 units, 3 of them changed, 0 findings", self.run_tool("check_tidy.py", "--all")[1])

    def test_programs_of_the_examples_are_looked_at_as_one(self):
        commands = []
        (self.tree / "apps/main.cpp").unlink()
        for path in ("examples/one.cpp", "examples/two.cpp"):
            self.write(path, f"{LICENSE}#include <vector>\nint main() {{\n  return std::vector<int>().size() == 0; }}\n")
            commands.append({"directory": str(self.tree), "command": f"g++ -std=c++20 -o {path}.o -c '{self.tree}/{path}'",
                             "file": str(self.tree / path)})
        self.write(".clang-tidy", "Checks: '-*,readability-container-size-empty'\nWarningsAsErrors: '*'\n"
                   "HeaderFilterRegex: '/examples/'\n")
        self.write("build/lint/compile_commands.json", json.dumps(commands))
        status, said = self.run_tool("check_tidy.py")
        for path in ("examples/one.cpp", "examples/two.cpp"):
            self.assertIn(f"{path}:4:10: error:", said)
        self.assertIn("2 files in 1 units, 1 of them changed, 2 findings", said)
        self.assertEqual(status, 1)

    def test_batches_of_a_target_are_looked_at_as_one_and_findings_name_their_sources(self):
        self.write(".clang-tidy", "Checks: '-*,readability-container-size-empty,bugprone-suspicious-include'\n"
                   "WarningsAsErrors: '*'\nHeaderFilterRegex: '/apps/.*\\.[ch]pp$'\n")
        self.write("apps/other.cpp", f"{LICENSE}#include <vector>\nbool other() {{ return std::vector<int>().size() == 0; }}\n")
        commands = []
        for number, name in enumerate(("main", "other")):
            batch = self.tree / f"build/lint/apps/Unity/unity_{number}_cxx.cxx"
            self.write(batch, f'#include "{self.tree}/apps/{name}.cpp"\n')
            commands.append({"directory": str(self.tree), "command": f"g++ -std=c++20 -o {number}.o -c '{batch}'",
                             "file": str(batch)})
        self.write("build/lint/compile_commands.json", json.dumps(commands))
        status, said = self.run_tool("check_tidy.py")
        self.assertIn("apps/other.cpp:3:23: error:", said)
        self.assertIn("2 files in 1 units, 1 of them changed, 1 findings", said)
        self.assertEqual(status, 1)

    def test_examples_that_are_compiled_together_are_looked_at_with_those_compiled_alone(self):
        commands = []
        (self.tree / "apps/main.cpp").unlink()
        self.write(".clang-tidy", "Checks: '-*,readability-container-size-empty'\nWarningsAsErrors: '*'\n"
                   "HeaderFilterRegex: '/examples/'\n")
        for name in ("one", "two"):
            self.write(f"examples/{name}.cpp", f"{LICENSE}#include <vector>\n"
                       "int main() {\n  return std::vector<int>().size() == 0; }\n")
        together = self.tree / "build/lint/examples/together"
        self.write(together / "main_of_one.cpp", "int main_of_one();\nint main() { return main_of_one(); }\n")
        self.write(together / "all.cpp", f'#include "{self.tree}/examples/one.cpp"\n')
        for file in (together / "main_of_one.cpp", together / "all.cpp", self.tree / "examples/two.cpp"):
            commands.append({"directory": str(self.tree), "command": f"g++ -std=c++20 -c '{file}'", "file": str(file)})
        self.write("build/lint/compile_commands.json", json.dumps(commands))
        self.assertIn("2 files in 1 units, 1 of them changed, 2 findings", self.run_tool("check_tidy.py")[1])

    def test_what_cmake_makes_of_a_template_is_looked_at_as_what_lies_beside_the_template(self):
        self.write("tests/.clang-tidy", "Checks: '-*,bugprone-integer-division'\nWarningsAsErrors: '*'\n")
        made = self.tree / "build/lint/tests/made_2d_float.cpp"
        self.write(made, f"{LICENSE}#include <vector>\nbool none() {{ return std::vector<int>().size() == 0; }}\n"
                   "double half(int i) { return i / 2; }\n")
        self.write("build/lint/compile_commands.json", json.dumps([{
            "directory": str(self.tree), "command": f"g++ -std=c++20 -c '{path}'", "file": str(path)}
            for path in (self.tree / "apps/main.cpp", made, self.tree / "build/lint/cmake_pch.hxx.cxx")]))
        status, said = self.run_tool("check_tidy.py", "--all")
        self.assertIn("build/lint/tests/made_2d_float.cpp:4:29: error:", said)
        self.assertIn("2 files in 2 units, 2 of them changed, 1 findings", said)
        self.assertEqual(status, 1)

    def test_a_file_that_no_target_compiles_is_found(self):
        self.write("apps/forgotten.cpp", LICENSE)
        status, said = self.run_tool("check_tidy.py")
        self.assertIn("apps/forgotten.cpp:1: is in no target", said)
        self.assertEqual(status, 1)

    def test_what_another_toolchain_compiles_is_not_missed(self):
        self.write("bindings/wasm/src/module.cpp", LICENSE)
        status, said = self.run_tool("check_tidy.py")
        self.assertIn("0 findings", said)
        self.assertEqual(status, 0)


class Findings(unittest.TestCase):
    def test_paths_are_relative_and_notes_stay_with_their_finding(self):
        text = "9 warnings\n/p/a.hpp:1:2: error: one [x]\n/p/a.hpp:3:4: note: why\n/p/b.cpp:5:6: warning: two [y]\n"
        self.assertEqual(findings("/p", text), ["a.hpp:1:2: error: one [x]\na.hpp:3:4: note: why", "b.cpp:5:6: warning: two [y]"])


if __name__ == "__main__":
    unittest.main()
