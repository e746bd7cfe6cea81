# SPDX-License-Identifier: MIT
"""Reads the declarations in graze's C headers: what the tests compare with the library and with calls."""

import os
import re
from pathlib import Path

ROOT = Path(os.environ["GRAZE_ROOT"])
HEADERS = [ROOT / "bindings/c" / name for name in ("graze_types.h", "graze.h", "graze_scene.h")]

_FUNCTION = re.compile(r"^GRAZE_API\s+(.+?)\b(graze_\w+)\(([^;]*)\);", re.MULTILINE | re.DOTALL)
_STRUCT = re.compile(r"^typedef struct (\w+) \{(.*?)^\} \1;", re.MULTILINE | re.DOTALL)
_CONSTANT = re.compile(r"^\s*(?:enum \{ )?(GRAZE_\w+) = (-?\d+)|, (GRAZE_\w+) = (-?\d+)", re.MULTILINE)


def source():
    """The text of all headers without comments."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in HEADERS)
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


def functions():
    """{name: (type of the result, list of the types of the parameters)}"""
    found = {}
    for result, name, parameters in _FUNCTION.findall(source()):
        listed = [] if parameters.strip() == "void" else [" ".join(parameter.split()) for parameter in parameters.split(",")]
        found[name] = (" ".join(result.split()), [re.sub(r"\b\w+(?=\)?(\[\d+\])?$|\)\[)", "", p, count=1).strip() for p in listed])
    return found


def structs():
    """{name: list of (type, field, length of the array or None)}, in the order of declaration. A union is ("union", field)."""
    found = {}
    for name, body in _STRUCT.findall(source()):
        fields = []
        body = re.sub(r"union \{.*?\} (\w+);", r"union \1;", body, flags=re.DOTALL)
        for declaration in filter(None, (" ".join(text.split()) for text in body.split(";"))):
            kind, names = re.fullmatch(r"((?:const )?\w+(?: ?\*)?) ?(.+)", declaration).groups()
            for field in names.split(", "):
                plain, length = re.fullmatch(r"(\w+)(?:\[(\d+)\])?", field).groups()
                fields.append((kind.replace(" ", ""), plain, int(length) if length else None))
        found[name] = fields
    return found


def constants():
    return {a or c: int(b or d) for a, b, c, d in _CONSTANT.findall(source())}
