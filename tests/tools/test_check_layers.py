# SPDX-License-Identifier: MIT
import unittest

from project_tree import LICENSE, TreeTest


class CheckLayers(TreeTest):
    def setUp(self):
        super().setUp()
        self.write_header("graze/math/vec.hpp", "#include <vector>\ninline std::vector<int> numbers() { return {}; }\n")
        self.write_header("graze/shape/sphere.hpp", "#include <graze/math/vec.hpp>\n")

    def assert_problem(self, problem):
        status, said = self.run_tool("check_layers.py")
        self.assertIn(problem, said)
        self.assertEqual(status, 1)

    def test_a_tree_that_keeps_the_rules_passes(self):
        status, said = self.run_tool("check_layers.py")
        self.assertIn("2 sources with mirror tests, 2 headers compiled alone, 0 problems", said)
        self.assertEqual(status, 0)

    def test_an_upward_include_is_found_with_its_line(self):
        self.write_header("graze/math/pose.hpp", "#include <graze/shape/sphere.hpp>\n")
        self.assert_problem("graze/math/pose.hpp:3: includes upwards: graze/shape/sphere.hpp; math may include math")

    def test_a_commented_include_is_none(self):
        self.write_header("graze/math/pose.hpp", "// #include <graze/shape/sphere.hpp>\n")
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)

    def test_the_umbrella_stands_above_every_layer(self):
        self.write("graze/graze.hpp", f"{LICENSE}#pragma once\n#include <graze/shape/sphere.hpp>\n")
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)
        self.write_header("graze/shape/obb.hpp", "#include <graze/graze.hpp>\n")
        self.assert_problem("graze/shape/obb.hpp:3: includes graze/graze.hpp, which is above every layer")

    def test_glm_has_one_door(self):
        self.write_header("graze/shape/obb.hpp", "#include <glm/vec3.hpp>\n")
        self.assert_problem("graze/shape/obb.hpp:3: includes GLM (glm/vec3.hpp); only graze/math/vec.hpp may")

    def test_the_geometry_needs_no_other_library(self):
        self.write_header("graze/query/text.hpp", "#include <fmt/format.h>\n")
        self.assert_problem("graze/query/text.hpp:3: includes fmt/format.h, but graze::geometry")

    def test_the_c_interface_includes_c_alone(self):
        self.write("bindings/c/graze.h", f"{LICENSE}#include <stdint.h>\n")
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)
        self.write("bindings/c/graze.h", f"{LICENSE}#include <cstdint>\n")
        self.assert_problem("bindings/c/graze.h:2: includes cstdint, which is C++; the C interface may include C alone")
        self.write("bindings/c/examples/balls.c", f"{LICENSE}#include <graze/shape/sphere.hpp>\n")
        self.assert_problem("bindings/c/examples/balls.c:2: includes graze/shape/sphere.hpp, which is C++")

    def test_the_geometry_throws_by_the_macro(self):
        self.write_header("graze/shape/sphere.hpp", "inline void f() {}  // does not throw\ninline void g() { throw 1; }\n")
        self.assert_problem("graze/shape/sphere.hpp:4: uses throw, try or catch; use GRAZE_THROW")
        self.write_header("graze/shape/sphere.hpp", "inline void f() {}  // does not throw\n")
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)

    def test_an_include_of_a_file_that_is_not_there_is_found(self):
        self.write("tests/shape/sphere_test.cpp", f"{LICENSE}#include <graze/shape/spere.hpp>\n")
        self.assert_problem("tests/shape/sphere_test.cpp:2: includes graze/shape/spere.hpp, which does not exist")

    def test_a_source_without_a_mirror_test_is_found(self):
        (self.tree / "tests/shape/sphere_test.cpp").unlink()
        self.assert_problem("graze/shape/sphere.hpp:1: has no mirror test; write tests/shape/sphere_test.cpp")

    def test_a_header_that_needs_another_one_before_it_is_found(self):
        self.write_header("graze/shape/box.hpp", "inline std::vector<int> box() { return {}; }\n")
        self.assert_problem("graze/shape/box.hpp:1: does not compile when it is included alone")

    def test_a_header_without_a_guard_is_found(self):
        self.write_header("graze/shape/box.hpp")
        self.write("graze/shape/box.hpp", f"{LICENSE}struct Box {{}};\n")
        self.assert_problem("graze/shape/box.hpp:1: does not compile when it is included alone, twice")

    def test_a_header_is_compiled_again_when_one_that_it_includes_has_changed(self):
        self.write_header("graze/shape/obb.hpp", "#include <graze/math/vec.hpp>\ninline auto n() { return numbers(); }\n")
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)
        self.write_header("graze/math/vec.hpp")
        self.assert_problem("graze/shape/obb.hpp:1: does not compile")

    def test_a_file_without_a_license_line_is_found(self):
        self.write("tools/tool.py", "#!/usr/bin/env python3\n# SPDX-License-Identifier: MIT\n")
        self.write("apps/cli/main.cpp", "int main() {}\n")
        self.assert_problem("apps/cli/main.cpp:1: the first line (the second after #!) must say SPDX-License-Identifier: MIT")
        self.assertNotIn("tool.py:", self.run_tool("check_layers.py")[1])

    def test_a_long_file_is_found(self):
        self.write("apps/cli/main.cpp", LICENSE + "\n" * 449)
        self.assertEqual(self.run_tool("check_layers.py")[0], 0)
        self.write("apps/cli/main.cpp", LICENSE + "\n" * 450)
        self.assert_problem("apps/cli/main.cpp:451: has 451 lines")


if __name__ == "__main__":
    unittest.main()
