# SPDX-License-Identifier: MIT
"""./dev in a tree of its own, where CMake and the built programs are replaced by programs that print how they were
called."""

import os
import re
import shutil
import subprocess
import tarfile
import unittest

from project_tree import ROOT, TreeTest


class DevTest(TreeTest):
    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / "dev", self.tree / "dev")
        (self.tree / "tools").mkdir(exist_ok=True)
        for part in (ROOT / "tools").glob("dev_*.sh"):
            shutil.copy(part, self.tree / "tools" / part.name)
        self.write_program("bin/cmake", 'echo "cmake $*" >&2')

    def write_program(self, path, body):
        self.write(path, f"#!/bin/sh\n{body}\n")
        (self.tree / path).chmod(0o755)

    def dev(self, *arguments, **variables):
        environment = {**os.environ, "GRAZE_NO_INSTALL": "1", "GRAZE_SHARED_DATA": "nowhere",
                       "PATH": f"{self.tree / 'bin'}:{os.environ['PATH']}", **variables}
        return subprocess.run([self.tree / "dev", *arguments], capture_output=True, text=True, check=False, env=environment)

    def test_help_names_every_command(self):
        done = self.dev("help")
        self.assertEqual(done.returncode, 0)
        for command in ("demo", "test", "lint", "bench", "exam", "web", "mpi", "python", "cross", "package", "release", "clean", "help"):
            self.assertRegex(done.stdout, rf"(?m)^  {command}\b")

    def test_an_unknown_command_is_told_the_known_ones(self):
        done = self.dev("exma")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no command 'exma'", done.stderr)
        self.assertIn("exam", done.stderr)

    def test_commands_without_arguments_refuse_them(self):
        done = self.dev("clean", "all")
        self.assertEqual(done.returncode, 2)
        self.assertIn("clean takes no arguments, but was given: all", done.stderr)

    def test_one_benchmark_runs_with_its_options_and_an_unknown_one_is_told_the_known_ones(self):
        self.write("bench/bounding.cpp", "")
        for name in ("bounding", "graze_peers"):
            self.write_program(f"build/bench/bench/{name}", 'echo "$(basename "$0"): $*"')
        done = self.dev("bench", "fast")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no benchmark 'fast'; they are: bounding graze_peers python", done.stderr)
        self.assertEqual(self.dev("bench", "bounding", "--quick").stdout, "bounding: --quick\n")
        everything = self.dev("bench").stdout
        self.assertIn("bounding: \n", everything)
        self.assertIn("--markdown docs/benchmarks.md", everything)
        self.assertIn("--scenes all,", everything)
        self.assertNotIn("--boxes", everything)

    def test_the_race_takes_files_of_boxes_where_they_are(self):
        self.write("bench/bounding.cpp", "")
        self.write("data_beside/chip_aes.csv", "")
        self.write_program("build/bench/bench/graze_peers", 'echo "$*"')
        done = self.dev("bench", "graze_peers", GRAZE_SHARED_DATA="data_beside")
        self.assertIn("--boxes data_beside/chip_aes.csv", done.stdout)

    def test_the_exam_is_built_alone_and_gets_the_options_after_those_of_dev(self):
        self.write_program("build/exam/bin/graze_exam", 'for word in "$@"; do echo "[$word]"; done')
        done = self.dev("exam", "--cases", "20", "--pairs", "3D float obb, triangle")
        self.assertEqual(done.returncode, 0)
        words = done.stdout.splitlines()
        self.assertEqual(words[0], "[--jobs]")
        self.assertEqual(words[2:], ["[--output]", "[build/exam/accuracy.json]", "[--cases]", "[20]", "[--pairs]", "[3D float obb, triangle]"])
        self.assertIn("cmake --build --preset exam", done.stderr)
        self.assertIn("--target graze_exam", done.stderr)

    def test_the_exam_on_meshes_reads_the_paths_that_it_is_given(self):
        self.write("part.stl", "")
        self.write_program("build/exam/bin/graze_mesh_exam", 'echo "$*"')
        done = self.dev("exam", "meshes", "--rays", "5", "part.stl")
        self.assertEqual(done.stdout, "--rays 5 part.stl\n")
        self.assertIn("--target graze_mesh_exam", done.stderr)

    def test_the_exam_prints_tables_of_what_it_has_written_and_fails_when_an_answer_was_wrong(self):
        self.write_program("build/exam/bin/graze_exam", 'echo data >build/exam/accuracy.json; exit 1')
        self.write("tools/exam_tables.py", "import sys\nprint('tables of', open(sys.argv[1]).read())\n")
        done = self.dev("exam")
        self.assertIn("tables of data", done.stdout)
        self.assertEqual(done.returncode, 1)

    def write_node(self, version, summary):
        self.write_program("bin/node", f'if [ "$1" = -p ]; then echo {version}; else printf "{summary}"; fi')
        self.write("build/pugixml/src/pugixml.cpp", "")

    def test_web_builds_the_module_and_says_where_it_is(self):
        self.write_node(18, "")
        done = self.dev("web", "wasm")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("cmake --build --preset web", done.stderr)
        self.assertRegex(done.stdout, r"^the module: /.*/build/web/package\n$")

    def test_web_refuses_an_old_node_and_other_words(self):
        self.write_node(16, "")
        self.assertIn("node is version 16; at least 18 is needed", self.dev("web").stderr)
        done = self.dev("web", "tests")
        self.assertEqual(done.returncode, 2)
        self.assertIn("web takes the word wasm or test, but was given: tests", done.stderr)

    def test_web_counts_the_tests_of_module_and_viewer(self):
        self.write_node(20, "# pass 3\\n# fail 0\\n")
        self.write_program("bin/npm", 'if [ "$3" = test ]; then printf "i pass 4\\ni fail 0\\n"; fi')
        self.assertIn("web: 3 tests passed\n", self.dev("web", "test").stdout)
        self.write("viewer/package.json", "{}")
        done = self.dev("web", "test")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("web: 7 tests passed\n", done.stdout)

    def test_web_fails_when_a_test_fails_or_none_came_to_an_end(self):
        self.write_node(20, "# pass 3\\n# fail 1\\n")
        done = self.dev("web", "test")
        self.assertEqual(done.returncode, 1)
        self.assertIn("web: 1 of 4 tests failed", done.stderr)
        self.write_node(20, "")
        self.assertIn("the tests of wasm did not finish", self.dev("web", "test").stderr)

    def test_mpi_builds_and_runs_the_tests_of_its_presets(self):
        self.write_program("bin/ctest", 'echo "ctest $*"')
        for words, preset in ((["test"], "mpi"), (["test", "asan"], "mpi-asan")):
            done = self.dev("mpi", *words)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"(?m)^cmake --build --preset {preset} ")
            self.assertEqual(done.stdout, f"ctest --preset {preset}\n")

    def test_cross_builds_and_runs_the_tests_of_its_presets(self):
        self.write_program("bin/ctest", 'echo "ctest $*"')
        for source in ("pugixml/src/pugixml.cpp", "rapidcheck/include/rapidcheck.h", "highway/hwy/targets.cc"):
            self.write(f"build/{source}", "")
        for words, presets in ((["arm64"], ["arm64"]), (["all"], ["arm64", "windows", "libcxx"])):
            done = self.dev("cross", *words)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(re.findall(r"(?m)^cmake --build --preset (\w+) ", done.stderr), presets)
            self.assertEqual(done.stdout, "".join(f"ctest --preset {preset}\n" for preset in presets))

    def test_cross_refuses_other_words(self):
        for words in ([], ["vax"], ["arm64", "windows"]):
            done = self.dev("cross", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("cross takes one word: arm64, windows, libcxx or all", done.stderr)

    def test_mpi_refuses_other_words(self):
        for words in ([], ["tests"], ["test", "tsan"], ["test", "asan", "more"]):
            done = self.dev("mpi", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn("mpi", done.stderr)

    def write_python(self, summary, status=0):
        """A Python whose virtual environments print a summary of tests."""
        self.write_program("inner", f'printf "{summary}"; exit {status}')
        self.write_program("bin/python", """case "$*" in
          *graze_build.py*) mkdir -p "$4"; touch "$4/graze-1.whl"; echo graze-1.whl ;;
          *venv*) mkdir -p "$4/bin"; cp inner "$4/bin/python"; cp bin/cmake "$4/bin/pip" ;;
        esac""")
        return str(self.tree / "bin/python")

    def test_the_benchmark_of_python_runs_with_its_options(self):
        done = self.dev("bench", "python", "--quick", GRAZE_PYTHON=self.write_python(""))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("cmake --build --preset python-bench", done.stderr)
        self.assertIn("bench/python/table.py --quick", done.stderr)

    def test_python_builds_a_wheel_and_says_where_it_is(self):
        done = self.dev("python", GRAZE_PYTHON=self.write_python(""))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("cmake --build --preset python-release", done.stderr)
        self.assertRegex(done.stdout, r"^the wheel: /.*/build/python/dist/graze-1.whl\n$")

    def test_python_counts_the_tests_of_the_installed_wheel(self):
        done = self.dev("python", "test", GRAZE_PYTHON=self.write_python("Ran 12 tests in 3s\\n\\nOK\\n"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"cmake --build --preset python ")
        self.assertEqual(done.stdout, "python: 12 tests passed\n")

    def test_python_fails_when_a_test_fails_or_none_came_to_an_end(self):
        python = self.write_python("FAIL: test_a\\nERROR: test_b\\nRan 12 tests in 3s\\n", 1)
        done = self.dev("python", "test", GRAZE_PYTHON=python)
        self.assertEqual(done.returncode, 1)
        self.assertIn("python: 2 of 12 tests failed", done.stderr)
        done = self.dev("python", "test", GRAZE_PYTHON=self.write_python("Segmentation fault", 139))
        self.assertEqual(done.returncode, 1)
        self.assertIn("the tests of Python did not finish", done.stderr)

    def test_python_refuses_other_words(self):
        done = self.dev("python", "wheel")
        self.assertEqual(done.returncode, 2)
        self.assertIn("python takes the word test, but was given: wheel", done.stderr)

    def commit_tree(self):
        """Makes the tree a checkout with one commit, of version 1.2.3."""
        self.write("CMakeLists.txt", "project(graze VERSION 1.2.3 LANGUAGES CXX)\n")
        self.write("packaging/vcpkg/graze/portfile.cmake", "# the port\n")
        self.write(".gitignore", "/build/\n")
        git = ["git", "-C", self.tree, "-c", "user.name=a", "-c", "user.email=a@b.example"]
        for words in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "All", "--date=2020-01-01T00:00:00Z"]):
            subprocess.run([*git, *words], check=True, capture_output=True)

    def test_the_source_package_has_the_same_bytes_again_and_leaves_changes_out(self):
        self.commit_tree()
        archive = self.tree / "build/package/graze-1.2.3.tar.gz"
        self.assertEqual(self.dev("package", "source").stdout, "the source: build/package/graze-1.2.3.tar.gz\n")
        first = archive.read_bytes()
        self.write("later.txt", "a change")
        done = self.dev("package", "source")
        self.assertIn("without later changes", done.stderr)
        self.assertEqual(archive.read_bytes(), first)
        with tarfile.open(archive) as members:
            self.assertIn("graze-1.2.3/CMakeLists.txt", members.getnames())
            self.assertNotIn("graze-1.2.3/later.txt", members.getnames())

    def test_a_packed_recipe_contains_the_source_and_dates_of_the_commit_alone(self):
        self.commit_tree()
        archive = self.tree / "build/package/graze-1.2.3-vcpkg.tar.gz"
        self.assertEqual(self.dev("package", "vcpkg").returncode, 0)
        first = archive.read_bytes()
        with tarfile.open(archive) as members:
            self.assertLessEqual({"vcpkg/graze/portfile.cmake", "vcpkg/graze/graze-1.2.3.tar.gz"}, set(members.getnames()))
            self.assertEqual(len({member.mtime for member in members}), 1)
        self.assertEqual(self.dev("package", "vcpkg").returncode, 0)
        self.assertEqual(archive.read_bytes(), first)

    def test_packages_need_a_commit_and_a_known_name(self):
        self.assertIn("packages are made from a commit", self.dev("package", "source").stderr)
        done = self.dev("package", "rpm")
        self.assertEqual(done.returncode, 2)
        self.assertIn("package takes one of these words: source deb wheel npm vcpkg conan", done.stderr)

    def test_a_release_refuses_changes_without_a_commit_and_a_check_without_a_release(self):
        self.commit_tree()
        self.write("later.txt", "a change")
        self.assertIn("a release is made from a commit", self.dev("release").stderr)
        self.assertIn("Run ./dev release first", self.dev("release", "check").stderr)
        self.assertEqual(self.dev("release", "again").returncode, 2)


if __name__ == "__main__":
    unittest.main()
