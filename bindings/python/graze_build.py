# SPDX-License-Identifier: MIT
"""Packs the wheel, as pip's build backend (PEP 517) and as a program. Debian 12 has no backend that runs CMake.

    python3 graze_build.py BUILD WHEELS              packs the module of a build folder, and prints the name of the wheel
    python3 graze_build.py --module FOLDER WHEELS    packs a folder `graze` as it is, without the libraries it loads

As a backend it builds the module first, by CMake's preset python-release. The wheel contains the shared libraries that the
module loads, with their licences, so that it needs nothing but NumPy.
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

root = pathlib.Path(__file__).resolve().parents[2]


def version():
    """That of the CMake project."""
    text = (root / "CMakeLists.txt").read_text()
    return re.search(r"project\(graze VERSION ([0-9.]+)", text).group(1)


def tag():
    """The wheel runs on this version of CPython and this platform only."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def metadata():
    return "\n".join(
        [
            "Metadata-Version: 2.1",
            "Name: graze",
            f"Version: {version()}",
            "Summary: Collision detection: what touches what, where, how deep",
            "License: MIT",
            "Requires-Python: >=3.9",
            "Requires-Dist: numpy",
            "",
        ]
    )


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}"


def package_files(package):
    """The files of an installed package. Of a library and the links to it, only those by which it is loaded: the links."""
    paths = sorted(path for path in package.iterdir() if path.is_file())
    linked = {path.resolve() for path in paths if path.is_symlink()}
    return {f"graze/{path.name}": path.read_bytes() for path in paths if path.is_symlink() or path not in linked}


def licences(names):
    """The licences of libraries, as Debian has them. Elsewhere whoever passes the wheel on has to add them."""
    found = {}
    for name in names:
        try:
            done = subprocess.run(["dpkg-query", "-S", f"*/{name}"], capture_output=True, text=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            print(f"graze_build: no package has {name}, so its licence is not in the wheel", file=sys.stderr)
            continue
        package = done.stdout.split(":")[0]
        found[f"licences/{package}"] = pathlib.Path("/usr/share/doc", package, "copyright").read_bytes()
    return found


def information(libraries):
    """The files of the folder dist-info, without the list of all files."""
    wheel = f"Wheel-Version: 1.0\nGenerator: graze_build\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {"METADATA": metadata().encode(), "WHEEL": wheel.encode(), "LICENSE": (root / "LICENSE").read_bytes(), **licences(libraries)}


def pack(package, wheels):
    """Writes the wheel with the files of a folder `graze`; returns its name. The same files give the same bytes."""
    info = f"graze-{version()}.dist-info"
    files = package_files(package)
    libraries = [pathlib.Path(path).name for path in files if pathlib.Path(path).name.startswith("lib")]
    files |= {f"{info}/{name}": data for name, data in information(libraries).items()}
    lines = [record_line(name, data) for name, data in files.items()] + [f"{info}/RECORD,,", ""]
    files[f"{info}/RECORD"] = "\n".join(lines).encode()
    name = f"graze-{version()}-{tag()}.whl"
    wheels.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(wheels / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            wheel.writestr(zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    return name


def pack_build(build, wheels):
    """Installs the component `python` of a CMake build, and packs it."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["cmake", "--install", build, "--component", "python", "--strip", "--prefix", folder]
        subprocess.run(command, check=True, stdout=sys.stderr)
        return pack(pathlib.Path(folder).resolve() / "graze", wheels)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """For pip, which asks for the metadata before it builds."""
    info = f"graze-{version()}.dist-info"
    folder = pathlib.Path(metadata_directory, info)
    folder.mkdir()
    for name, data in information([]).items():
        (folder / name).write_bytes(data)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    subprocess.run(["cmake", "--preset", "python-release", f"-DPython_EXECUTABLE={sys.executable}"], cwd=root, check=True)
    subprocess.run(["cmake", "--build", "--preset", "python-release"], cwd=root, check=True)
    return pack_build(root / "build/release", pathlib.Path(wheel_directory))


if __name__ == "__main__":
    make, arguments = (pack, sys.argv[2:]) if sys.argv[1] == "--module" else (pack_build, sys.argv[1:])
    print(make(*map(pathlib.Path, arguments)))
