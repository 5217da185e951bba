# SPDX-License-Identifier: MIT
"""The questions of interface_bench.cpp through numpy: nanoseconds of processor time a question, as JSON.
PYTHONPATH names the folder that holds the package.  interface_bench.py [REPEATS]"""
import json
import sys
import time

import numpy as np

import asterism

# A million rows leave every cache. Edge tests of different metrics take microseconds, so there are fewer.
ROWS = {"1000 rows": 1000, "10^6 rows": 1000000}
MOST_EDGE_TESTS = 20000


def sites(rows, centre, random):
    x, y = (centre + 0.05 * random.uniform(-1, 1, (rows, 2))).T
    return np.column_stack([x, y, 1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y])


def nanoseconds(ask, rows, repeats):
    """Returns the shortest time of the repeats, each long enough for the clock."""
    calls = max(1, 200000 // rows)
    best = float("inf")
    for _ in range(repeats):
        start = time.process_time()
        for _ in range(calls):
            ask()
        best = min(best, time.process_time() - start)
    return best / calls / rows * 1e9


def measured(rows, repeats):
    random = np.random.default_rng(1)
    centre = random.uniform(-1, 1, (rows, 2))
    v, w, x, y = (sites(rows, centre, random) for _ in range(4))
    p, q, r, s = (of[:, :2] for of in (v, w, x, y))
    few = min(rows, MOST_EDGE_TESTS)
    edge = [of[:few] for of in (v, w, x, y)]
    one = [tuple(of[0]) for of in (v, w, r)]
    return {
        "orientation": nanoseconds(lambda: asterism.orientation(p, q, r), rows, repeats),
        "in_circle": nanoseconds(lambda: asterism.in_circle(p, q, r, s, metric=v[:, 2:]), rows, repeats),
        "compare_distance": nanoseconds(lambda: asterism.compare_distance(v, w, r), rows, repeats),
        "edge_test": nanoseconds(lambda: asterism.edge_test(*edge), few, repeats),
        "one question": nanoseconds(lambda: asterism.compare_distance(*one), 1, repeats) if rows == 1000
        else None,
    }


def main():
    repeats = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    print(json.dumps({name: measured(rows, repeats) for name, rows in ROWS.items()}))


if __name__ == "__main__":
    main()
