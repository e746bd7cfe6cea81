# SPDX-License-Identifier: MIT
"""Compares the Python module with C++ and with other libraries of Python, and prints tables. ./dev bench python runs it.

usage: ./dev bench python [--quick] [--only batches|singles|peers] [--name TEXT] [--seconds S]
"""

import argparse
import sys

from batches import batch_rows, single_rows
from peers import peer_rows
from race import Failure, print_table


def main():
    parser = argparse.ArgumentParser(prog="./dev bench python", description="Compares the Python module with C++ and other libraries.")
    parser.add_argument("--quick", action="store_true", help="a twentieth of the work, to see whether everything runs")
    parser.add_argument("--only", choices=["batches", "singles", "peers"], help="one of the tables")
    parser.add_argument("--name", default="", help="of the batches, only those whose name contains this")
    parser.add_argument("--seconds", type=float, default=2, help="for each row")
    options = parser.parse_args()
    scale, seconds = (0.05, 0.05) if options.quick else (1, options.seconds)
    tables = {
        "batches": (["call", "C++", "Python", "ratio"], lambda: batch_rows(scale, seconds, options.name)),
        "singles": (["`intersects` of", "C++", "Python", "difference, ns"], lambda: single_rows(seconds)),
        "peers": (["task", "graze", "peer", "its time, relative"], lambda: peer_rows(scale, seconds)),
    }
    for name, (header, rows) in tables.items():
        if options.only in (None, name):
            print_table(header, rows())


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"bench python: {failure}")
