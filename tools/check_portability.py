# SPDX-License-Identifier: MIT
"""Finds what only GCC and Clang, or only POSIX, understand, outside the macros that guard it, so that a change does not
break other compilers and Windows unnoticed."""

import re
import sys

from project_files import ROOT, project_files

# What is searched for, and what it is in messages.
CONSTRUCTS = {
    "an attribute of GCC": re.compile(r"__attribute__"),
    "a builtin of GCC": re.compile(r"\b__builtin_\w+"),
    "an integer of 128 bits": re.compile(r"\b__int128\b"),
    "an extension": re.compile(r"\b(__extension__|__typeof__|typeof|__restrict__|__PRETTY_FUNCTION__)\b"),
    "assembler": re.compile(r"\b(asm|__asm__)\b *(volatile)? *\("),
    "a pragma of GCC": re.compile(r"^ *# *pragma (GCC|clang)\b"),
    "a header of POSIX": re.compile(r"^ *# *include <(unistd|fcntl|poll|termios|dlfcn|pthread|netdb|sys/[\w/]+|arpa/\w+|"
                                    r"netinet/\w+|mach-o/\w+)\.h>"),
    "a header of GCC": re.compile(r"^ *# *include <(\w*intrin|bits/[\w+./]+|cpuid)\.h>"),
    "a header of Windows": re.compile(r"^ *# *include <(windows|winsock2|io|shellapi)\.h>"),
    "a type of POSIX": re.compile(r"(?<!py::)\b(ssize_t|pid_t)\b"),
}

# Code inside these is only seen by compilers and systems that have what it uses.
GUARDS = ["__GNUC__", "__clang__", "__linux__", "__APPLE__", "__EMSCRIPTEN__", "__SSE2__", "__x86_64__", "__has_builtin",
          "__has_include", "GRAZE_HAS_LANES", "GRAZE_HAS_WIDER_LANES", "GRAZE_HAS_INT128", "GRAZE_HAS_FLOCK"]
OF_OTHERS = ["_WIN32", "_MSC_VER"]  # guard what follows their #else, and headers of Windows

# Whole files that CMake compiles on one kind of system only, by the ends of their names.
OF_ONE_SYSTEM = ("_posix.cpp", "_windows.cpp")

# Places without a guard: a file or folder, the construct, and why that is right.
EXEMPT = [
    ("graze/math/platform/bit_cast.hpp", "a builtin of GCC", "MSVC has it, too, from version 19.27 on"),
    ("graze/broad", "a pragma of GCC", "unrolls a loop; other compilers skip it"),
    ("graze/query", "a pragma of GCC", "unrolls a loop; other compilers skip it"),
    ("bench/peers/race.cpp", "a header of POSIX", "the race with other libraries runs on Linux only"),
    ("tests/exam/main.cpp", "a header of POSIX", "the exam starts processes, on Linux only"),
    ("tests/io/file/atomic_file_test.cpp", "a header of POSIX", "links, permissions and descriptors, which Windows lacks"),
]


def exemption_of(path, construct):
    for place, what, _ in EXEMPT:
        if construct == what and (path == place or path.startswith(place + "/")):
            return (place, what)
    return None


class Conditions:
    """The #if directives around a line. Each is a list of conditions that hold, with a leading "!" if they do not."""

    def __init__(self):
        self.open = []

    def read(self, directive, condition):
        if directive in ("if", "ifdef"):
            self.open.append([condition])
        elif directive == "ifndef":
            self.open.append(["!" + condition])
        elif directive in ("elif", "else"):
            branch = self.open[-1]
            branch[-1] = branch[-1][1:] if branch[-1].startswith("!") else "!" + branch[-1]
            if directive == "elif":
                branch.append(condition)
        elif directive == "endif":
            self.open.pop()

    def hold(self):
        return [condition for branch in self.open for condition in branch]


def names(condition, macros):
    """True if the condition asks for one of the macros, not for its absence."""
    return any(re.search(rf"(?<!!)(?<!!defined\(){macro}\b", condition) for macro in macros)


def is_guarded(conditions, construct):
    for condition in conditions:
        if condition.startswith("!"):
            if construct != "a header of Windows" and names(condition[1:], OF_OTHERS):
                return True
        elif names(condition, OF_OTHERS if construct == "a header of Windows" else GUARDS):
            return True
    return False


def code_of(line):
    """The line without comments and the contents of strings."""
    return re.sub(r'"(\\.|[^"\\])*"', '""', line).split("//")[0]


def findings(text):
    """(line number, construct) of everything without a guard."""
    conditions = Conditions()
    joined = re.sub(r"\\\n", " \f", text)  # continued directives; the form feeds keep the numbers of lines right
    number = 1
    for line in joined.split("\n"):
        code = code_of(line)
        directive = re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b\s*(.*)", code)
        if directive:
            conditions.read(directive[1], directive[2])
        else:
            for construct, pattern in CONSTRUCTS.items():
                if pattern.search(code) and not is_guarded(conditions.hold(), construct):
                    yield number, construct
        number += 1 + line.count("\f")


def main():
    problems = []
    used = set()
    files = project_files(ROOT, [".hpp", ".cpp", ".cpp.in", ".h", ".c"])
    for path in files:
        name = path.as_posix()
        if name.endswith(OF_ONE_SYSTEM):
            continue
        for number, construct in findings((ROOT / name).read_text(encoding="utf-8")):
            exempt = exemption_of(name, construct)
            if exempt:
                used.add(exempt)
            else:
                problems.append(f"{name}:{number}: {construct} without a guard: put it inside one of "
                                f"{', '.join(GUARDS[:3])}, ..., or list it in tools/check_portability.py with the reason")
    for place, what, _ in EXEMPT:
        if (place, what) not in used:
            problems.append(f"tools/check_portability.py: the exemption of {what} in {place} is not used; remove it")
    for problem in problems:
        print(problem)
    if problems:
        print(f"portability: {len(problems)} problems")
        return 1
    print(f"portability: {len(files)} files, {len(EXEMPT)} listed exemptions")
    return 0


if __name__ == "__main__":
    sys.exit(main())
