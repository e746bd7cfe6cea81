# SPDX-License-Identifier: MIT
"""Builds the checkout that contains this file or, as `./dev package conan` packs it, the archive beside it."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, unzip

required_conan_version = ">=2.0"


class GrazeConan(ConanFile):
    name = "graze"
    description = "Collision detection: what touches what, where, how deep"
    license = "MIT"
    topics = ("collision-detection", "geometry", "bvh", "gjk", "ray-casting")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    # tbb: parallel work by oneTBB; compression: compressed tile layers of Tiled's maps; c: the C interface; cli: the program
    options = {
        "shared": [True, False],
        "fPIC": [True, False],
        "tbb": [True, False],
        "compression": [True, False],
        "c": [True, False],
        "cli": [True, False],
    }
    default_options = {"shared": False, "fPIC": True, "tbb": True, "compression": True, "c": True, "cli": False}
    implements = ["auto_shared_fpic"]

    def _checkout(self):
        return Path(self.recipe_folder).resolve().parents[1]

    def _archive(self):
        return next(Path(self.recipe_folder).glob("graze-*.tar.gz"), None)

    def set_version(self):
        if archive := self._archive():
            self.version = archive.name.removeprefix("graze-").removesuffix(".tar.gz")
        else:
            text = load(self, str(self._checkout() / "CMakeLists.txt"))
            self.version = re.search(r"project\(graze VERSION ([0-9.]+)", text)[1]

    def export_sources(self):
        if archive := self._archive():
            copy(self, archive.name, self.recipe_folder, self.export_sources_folder)
            return
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "graze/*", "apps/cli/*", "bindings/c/*"):
            copy(self, pattern, str(self._checkout()), self.export_sources_folder)

    def source(self):
        archive = f"graze-{self.version}.tar.gz"
        if (Path(self.source_folder) / archive).exists():
            unzip(self, archive, strip_root=True)

    def requirements(self):
        self.requires("glm/[>=0.9.9.8 <2]", transitive_headers=True)
        self.requires("fmt/[>=9.1 <13]")
        self.requires("pugixml/[>=1.13 <2]")
        self.requires("highway/[>=1.0.3 <2]")
        self.requires("nlohmann_json/[>=3.11.2 <4]", visible=False)
        self.requires("fast_float/[>=3.9 <9]", visible=False)
        if self.options.tbb:
            self.requires("onetbb/[>=2021.8 <2023]")
        if self.options.compression:
            self.requires("zlib/[>=1.2.13 <2]")
            self.requires("zstd/[>=1.5.4 <2]")
        if self.options.cli:
            self.requires("cli11/[>=2.1.2 <3]", visible=False)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        dependencies = CMakeDeps(self)
        dependencies.set_property("highway", "cmake_file_name", "hwy")
        dependencies.set_property("highway::hwy", "cmake_target_name", "hwy::hwy")
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update({
            "GRAZE_TBB": bool(self.options.tbb),
            "GRAZE_COMPRESSION": bool(self.options.compression),
            "GRAZE_C": bool(self.options.c),
            "GRAZE_BUILD_CLI": bool(self.options.cli),
            "GRAZE_BUILD_TESTS": False,
            "GRAZE_BUILD_EXAMPLES": False,
            "GRAZE_BUILD_BENCH": False,
        })
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, str(Path(self.package_folder) / "licenses"))
        CMake(self).install()

    def package_info(self):
        # Users find the package's own files, which say which flags graze requires and have its components.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/graze"]
        self.cpp_info.libs = ["graze"]
