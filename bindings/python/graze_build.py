# SPDX-License-Identifier: MIT
"""Packs the wheel, as pip's build backend (PEP 517) and as a program. Debian 12 has no backend that runs CMake.

    python3 graze_build.py PACKAGE WHEELS    packs the folder of a built package, and prints the name of the wheel

As a backend it builds the package first, by CMake's preset python-release.
"""

import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import sysconfig
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


def pack(package, wheels):
    """Writes the wheel with the files of a folder `graze`; returns its name. The same files give the same bytes."""
    info = f"graze-{version()}.dist-info"
    files = {f"graze/{path.name}": path.read_bytes() for path in sorted(package.iterdir()) if path.is_file()}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: graze_build\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    files[f"{info}/LICENSE"] = (root / "LICENSE").read_bytes()
    lines = [record_line(name, data) for name, data in files.items()] + [f"{info}/RECORD,,", ""]
    files[f"{info}/RECORD"] = "\n".join(lines).encode()
    name = f"graze-{version()}-{tag()}.whl"
    wheels.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(wheels / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            wheel.writestr(zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    subprocess.run(["cmake", "--preset", "python-release", f"-DPython_EXECUTABLE={sys.executable}"], cwd=root, check=True)
    subprocess.run(["cmake", "--build", "--preset", "python-release"], cwd=root, check=True)
    return pack(root / "build/release/python/graze", pathlib.Path(wheel_directory))


if __name__ == "__main__":
    print(pack(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
