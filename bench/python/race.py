# SPDX-License-Identifier: MIT
"""How the benchmarks of Python measure: two contestants in turns, the best time of each."""

import time

import numpy as np


class Failure(Exception):
    """Two contestants have different answers."""


def seconds_of(call):
    """One call: its seconds and its answer."""
    start = time.perf_counter()
    answer = call()
    return time.perf_counter() - start, answer


def best_times(contestants, seconds, least=5):
    """The best time of each contestant, which returns its seconds and its answer, and all last answers. They take turns for
    about this many seconds, so that other load of the machine meets all alike."""
    best, answers, rounds, end = [float("inf")] * len(contestants), [None] * len(contestants), 0, time.perf_counter() + seconds
    while rounds < least or time.perf_counter() < end:
        for i, contestant in enumerate(contestants):
            answers[i] = None  # frees the memory of the last answer, outside of the measured time
            taken, answers[i] = contestant()
            best[i] = min(best[i], taken)
        rounds += 1
    return best, answers


def require_equal(name, ours, theirs, tolerance=None):
    """Numbers or arrays that are the same, or up to a tolerance."""
    same = np.array_equal(ours, theirs) if tolerance is None else np.allclose(ours, theirs, rtol=0, atol=tolerance)
    if not same:
        raise Failure(f"{name}: the answers differ")


def spelled(seconds):
    """Three digits, with a unit."""
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def print_table(header, rows):
    """As Markdown."""
    print("| " + " | ".join(header) + " |")
    print("|---|" + "--:|" * (len(header) - 1))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)
    print()
