# SPDX-License-Identifier: MIT
"""Prints how the cost of a box grows with the number of boxes, their density and the spread of their sizes: two Markdown
tables, from runs of `graze bench` on one thread. The first has nanoseconds per box in the fastest frame, which other load
on the machine affects least. The second has bytes per box in addition to boxes and pairs."""

import argparse
import csv
import io
import subprocess
import sys

WORLDS = ("brownian", "heavy", "cluster", "line", "plane", "lattice", "giants",
          "2d:brownian", "2d:heavy", "2d:cluster", "2d:line", "2d:lattice", "2d:giants")


def measure(graze, world, count, frames, order):
    """Nanoseconds, bytes and pairs for each box."""
    command = [graze, "bench", "--generate", f"{world}:{count}", "--frames", str(frames), "--threads", "1", "--order", order,
               "--format", "csv"]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    row = next(csv.DictReader(io.StringIO(text)))
    return [number / count for number in (float(row["fastest_ms"]) * 1e6, float(row["bytes"]), float(row["pairs"]))]


def table(head, rows):
    lines = [head, ["---"] + ["--:"] * (len(head) - 1), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("graze", help="the program graze, built with the preset release")
    parser.add_argument("--counts", default="1000,10000,100000,1000000", help="numbers of boxes, ascending (default: %(default)s)")
    parser.add_argument("--worlds", default=",".join(WORLDS), help="default: %(default)s")
    parser.add_argument("--frames", type=int, default=20, help="frames for up to a million boxes; a quarter of them for more (default: 20)")
    options = parser.parse_args()
    counts = [int(count) for count in options.counts.split(",")]
    times = []
    bytes_of_largest = []
    for world in options.worlds.split(","):
        ns = []
        for count in counts:
            print(f"{world}:{count}", file=sys.stderr)
            frames = options.frames if count <= 1_000_000 else max(1, options.frames // 4)
            sorted_pairs = measure(options.graze, world, count, frames, "sorted")
            ns.append(f"{sorted_pairs[0]:.1f}")
        in_any_order = measure(options.graze, world, counts[-1], 1, "any")
        pairs = f"{sorted_pairs[2]:.2f}"
        times.append([world, pairs, *ns])
        bytes_of_largest.append([world, pairs, f"{sorted_pairs[1]:.0f}", f"{in_any_order[1]:.0f}"])
    print(table(["nanoseconds for a box", "pairs for a box", *(f"{count:,}" for count in counts)], times))
    print(table([f"bytes for each of {counts[-1]:,} boxes", "pairs for a box", "sorted", "any order"], bytes_of_largest), end="")


if __name__ == "__main__":
    main()
