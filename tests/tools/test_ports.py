# SPDX-License-Identifier: MIT
"""The vcpkg port and the Conan recipe, run with replacements of the functions that they call, which record the calls."""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

from project_tree import ROOT

PORT = ROOT / "packaging/vcpkg/graze"
RECIPE = ROOT / "packaging/conan"
CMAKE_OPTIONS = set(re.findall(r"^(?:option|graze_option_of_all|set)\((GRAZE_\w+) ", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE))

# Each prints its name and its arguments, one line a call.
VCPKG = """
cmake_minimum_required(VERSION 3.25)
foreach(name vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_copy_tools vcpkg_install_copyright
        vcpkg_cmake_configure vcpkg_check_features)
  cmake_language(EVAL CODE "function(${name})
    message(\\"${name} \\${ARGV}\\")
    set(features -DFEATURES=ON PARENT_SCOPE)
  endfunction()")
endforeach()
function(vcpkg_extract_source_archive result)
  message("vcpkg_extract_source_archive ${ARGN}")
  set(${result} "/unpacked" PARENT_SCOPE)
endfunction()
include("${PORT}/portfile.cmake")
"""


class VcpkgTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.scratch = Path(holder.name)
        self.manifest = json.loads((PORT / "vcpkg.json").read_text(encoding="utf-8"))

    def calls(self, port, *features):
        """The calls of the portfile, by function: the words of each."""
        (self.scratch / "vcpkg.cmake").write_text(VCPKG, encoding="utf-8")
        done = subprocess.run(
            ["cmake", f"-DPORT={port}", f"-DVERSION={self.manifest['version-semver']}", f"-DFEATURES={';'.join(features)}",
             f"-DCURRENT_PACKAGES_DIR={self.scratch}", "-P", self.scratch / "vcpkg.cmake"],
            capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line.split(" ", 1) for line in done.stderr.splitlines() if line.startswith("vcpkg_")]
        return {line[0]: line[1].split(";") if len(line) > 1 else [] for line in lines}

    def test_every_feature_sets_an_option_of_the_project(self):
        words = self.calls(PORT)["vcpkg_check_features"]
        pairs = words[words.index("FEATURES") + 1:]
        options = dict(zip(pairs[::2], pairs[1::2]))
        self.assertEqual(set(options), set(self.manifest["features"]))
        self.assertLessEqual(set(options.values()), CMAKE_OPTIONS)
        self.assertLessEqual(set(self.manifest["default-features"]), set(options))

    def test_a_port_in_a_checkout_builds_the_checkout(self):
        calls = self.calls(PORT)
        words = calls["vcpkg_cmake_configure"]
        self.assertEqual(Path(words[words.index("SOURCE_PATH") + 1]).resolve(), ROOT.resolve())
        self.assertIn("-DFEATURES=ON", words)
        self.assertLessEqual({word[2:].split("=")[0] for word in words if word.startswith("-DGRAZE")}, CMAKE_OPTIONS)
        self.assertTrue(Path(calls["vcpkg_install_copyright"][1]).is_file())
        self.assertNotIn("vcpkg_extract_source_archive", calls)
        self.assertNotIn("vcpkg_copy_tools", calls)
        self.assertIn("vcpkg_copy_tools", self.calls(PORT, "tools"))

    def test_a_packed_port_builds_the_archive_beside_it(self):
        port = self.scratch / "graze"
        shutil.copytree(PORT, port)
        (port / f"graze-{self.manifest['version-semver']}.tar.gz").touch()
        calls = self.calls(port)
        self.assertEqual(calls["vcpkg_extract_source_archive"][0], "ARCHIVE")
        self.assertIn("/unpacked", calls["vcpkg_cmake_configure"])


class Recorder:
    """Stands for an object of Conan: every call of a method is recorded."""

    def __init__(self, *_):
        self.recorded = []
        self.cache_variables = {}

    def __getattr__(self, name):
        return lambda *words, **_: self.recorded.append((name, *words))


def copy_files(_, pattern, source, target):
    """Conan's copy: patterns match paths, so * also crosses folders."""
    for path in Path(source).glob(pattern.replace("*", "**/*")):
        if path.is_file():
            place = Path(target) / path.relative_to(source)
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, place)


class ConanTest(unittest.TestCase):
    def load(self, path):
        """The recipe's class, with the functions of Conan replaced."""
        made = []
        self.unpacked = []

        def recorder(*_):
            made.append(Recorder())
            return made[-1]

        modules = {
            "conan": {"ConanFile": object},
            "conan.tools": {},
            "conan.tools.build": {"check_min_cppstd": lambda *_: None, "can_run": lambda _: True},
            "conan.tools.cmake": {"CMake": recorder, "CMakeDeps": recorder, "CMakeToolchain": recorder, "cmake_layout": lambda _: None},
            "conan.tools.files": {"copy": copy_files, "load": lambda _, name: Path(name).read_text(encoding="utf-8"),
                                  "unzip": lambda *words, **_: self.unpacked.append(words[1])},
        }
        for name, values in modules.items():
            module = types.ModuleType(name)
            vars(module).update(values)
            self.addCleanup(sys.modules.pop, name, None)
            sys.modules[name] = module
        names = {}
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), names)
        return next(value for name, value in names.items() if name.startswith("Graze")), made

    def recipe(self, folder=RECIPE, **options):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        made_class, self.made = self.load(RECIPE / "conanfile.py")
        recipe = made_class()
        recipe.recipe_folder = str(folder)
        recipe.export_sources_folder = recipe.source_folder = holder.name
        recipe.options = types.SimpleNamespace(**{**recipe.default_options, **options})
        self.required = []
        recipe.requires = lambda reference, **_: self.required.append(reference.split("/")[0])
        return recipe

    def test_the_version_is_that_of_the_project(self):
        recipe = self.recipe()
        recipe.set_version()
        self.assertIn(f"project(graze VERSION {recipe.version} ", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))

    def test_a_packed_recipe_builds_the_archive_beside_it(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "graze-1.2.3.tar.gz").touch()
            recipe = self.recipe(folder)
            recipe.set_version()
            recipe.export_sources()
            recipe.source()
        self.assertEqual(recipe.version, "1.2.3")
        self.assertEqual(self.unpacked, ["graze-1.2.3.tar.gz"])

    def test_options_select_what_is_required(self):
        self.recipe().requirements()
        self.assertIn("onetbb", self.required)
        self.assertNotIn("cli11", self.required)
        self.recipe(tbb=False, compression=False, cli=True).requirements()
        self.assertIn("cli11", self.required)
        self.assertFalse({"onetbb", "zlib", "zstd"} & set(self.required))

    def test_the_exported_files_are_enough_to_configure_with_the_options_of_the_recipe(self):
        recipe = self.recipe(cli=True)
        recipe.set_version()
        recipe.export_sources()
        recipe.source()
        self.assertEqual(self.unpacked, [])
        recipe.generate()
        variables = next(each.cache_variables for each in self.made if each.cache_variables)
        self.assertLessEqual(set(variables), CMAKE_OPTIONS)
        folder = Path(recipe.export_sources_folder)
        done = subprocess.run(
            ["cmake", "-S", folder, "-B", folder / "build", *(f"-D{name}={value}" for name, value in variables.items())],
            capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("no sources", done.stdout)

    def test_the_program_that_tries_the_package_is_complete(self):
        self.load(RECIPE / "test_package/conanfile.py")
        text = (RECIPE / "test_package/CMakeLists.txt").read_text(encoding="utf-8")
        for name in re.findall(r"\b\w+\.cpp\b", text):
            self.assertTrue((RECIPE / "test_package" / name).is_file(), name)


if __name__ == "__main__":
    unittest.main()
