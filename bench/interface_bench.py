# SPDX-License-Identifier: MIT
"""The questions of interface_bench.cpp through numpy: nanoseconds a question.  PYTHONPATH names the
folder that holds the package."""
import time

import numpy as np

import asterism


def sites(rows, centre, random):
    x, y = (centre + 0.05 * random.uniform(-1, 1, (rows, 2))).T
    return np.column_stack([x, y, 1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y])


def nanoseconds(ask, rows, repeats=7):
    best = float("inf")
    for _ in range(repeats):
        start = time.process_time()
        ask()
        best = min(best, time.process_time() - start)
    return best / rows * 1e9


def main():
    random = np.random.default_rng(1)
    for rows in (1000, 1000000):
        centre = random.uniform(-1, 1, (rows, 2))
        v, w, x, y = (sites(rows, centre, random) for _ in range(4))
        p = [s[:, :2] for s in (v, w, x, y)]
        print(f"{rows} rows: in_circle "
              f"{nanoseconds(lambda: asterism.in_circle(*p, metric=v[:, 2:]), rows):.1f} ns, "
              "compare_distance "
              f"{nanoseconds(lambda: asterism.compare_distance(v, w, p[2]), rows):.1f} ns, edge_test "
              f"{nanoseconds(lambda: asterism.edge_test(v, w, x, y), rows):.1f} ns")


if __name__ == "__main__":
    main()
