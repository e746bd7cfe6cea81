# SPDX-License-Identifier: MIT
"""The installed wheel has what it needs: its own shared libraries beside the module, with their licences."""

import importlib.metadata
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import graze

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = pathlib.Path(graze.__file__).parent
# What any Linux with Python and a C++ program has; the wheel loads them from the machine.
OF_THE_MACHINE = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z))\.so")


def dynamic_entries(library, kind):
    text = subprocess.run(["readelf", "-d", library], capture_output=True, text=True, check=True).stdout
    return re.findall(rf"\({kind}\).*\[(.*)\]", text)


def backend():
    spec = importlib.util.spec_from_file_location("graze_build", ROOT / "bindings/python/graze_build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class WheelTest(unittest.TestCase):
    def test_every_library_is_in_the_wheel_or_of_the_machine(self):
        inside = {path.name for path in PACKAGE.iterdir()}
        libraries = [path for path in PACKAGE.iterdir() if ".so" in path.name]
        self.assertGreater(len(libraries), 4)
        for library in libraries:
            for name in dynamic_entries(library, "NEEDED"):
                self.assertTrue(name in inside or OF_THE_MACHINE.match(name), f"{library.name} needs {name}")
        module = next(path for path in libraries if path.name.startswith("_graze"))
        self.assertEqual(dynamic_entries(module, "R(?:UN)?PATH"), ["$ORIGIN"])

    def test_the_libraries_inside_are_those_that_are_loaded(self):
        program = "import graze; print(open('/proc/self/maps').read())"
        maps = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
        for path in PACKAGE.glob("lib*.so*"):
            loaded = set(re.findall(rf"\S*/{re.escape(path.name.split('.so')[0])}\.so\S*", maps))
            self.assertEqual({str(pathlib.Path(each).parent) for each in loaded}, {str(PACKAGE)}, path.name)

    def test_nothing_is_twice_and_licences_are_there(self):
        files = [str(path) for path in importlib.metadata.files("graze")]
        libraries = [name for name in files if re.match(r"graze/lib.*\.so", name)]
        self.assertEqual(len({name.split(".so")[0] for name in libraries}), len(libraries))
        self.assertTrue(any(name.endswith("dist-info/LICENSE") for name in files))
        if pathlib.Path("/var/lib/dpkg/status").exists():
            self.assertEqual(sum("/licences/" in name for name in files), len(libraries), files)

    def test_metadata(self):
        found = importlib.metadata.metadata("graze")
        self.assertEqual((found["Name"], found["Version"], found["License"]), ("graze", graze.__version__, "MIT"))
        self.assertEqual(importlib.metadata.requires("graze"), ["numpy"])

    def test_the_backend_tells_pip_the_same_metadata(self):
        with tempfile.TemporaryDirectory() as folder:
            info = backend().prepare_metadata_for_build_wheel(folder)
            self.assertEqual(info, f"graze-{graze.__version__}.dist-info")
            text = pathlib.Path(folder, info, "METADATA").read_text()
        self.assertEqual(text.splitlines()[:3], importlib.metadata.distribution("graze").read_text("METADATA").splitlines()[:3])


if __name__ == "__main__":
    unittest.main()
