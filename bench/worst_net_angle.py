#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bench/worst_net_angle.py [--seconds S] [--sites-only] [--variations S...]

The smallest angle a triangle of a net can have when the metric varies by sigma: what point 5 of
docs/math/refinement.md rests on. Random search, then hill-climbing, over three sites and their
metrics at distance eps = 1 from their Voronoi vertex x, where the metric is the identity. Kept:
tau(p, x) <= 1/(1 - s) and, of every two sites, tau <= 1/(1 - s d) for the smaller distance d
(H1, s = sigma eps), and the earlier of two sites is at least 1 from the later as it measures.
With --sites-only what theorem 3 of docs/math/angle-theorem.md asks is kept alone: nothing is asked
of tau(p, x), and of two sites one measures at least 1 to the other.
An upper bound of the true minimum: what is found exists, what is not found may.
"""
import argparse
import math
import random
import time


def metric(t, a, b):
    """Returns a tensor rotated by t, with eigenvalues exp(2a), exp(2b)."""
    c, s, e, f = math.cos(t), math.sin(t), math.exp(2 * a), math.exp(2 * b)
    return c * c * e + s * s * f, c * s * (e - f), s * s * e + c * c * f


def inner(m, u, v):
    return m[0] * u[0] * v[0] + m[1] * (u[0] * v[1] + u[1] * v[0]) + m[2] * u[1] * v[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def distortion(p, q):
    dp, dq = p[0] * p[2] - p[1]**2, q[0] * q[2] - q[1]**2
    t, d = (p[2] * q[0] - 2 * p[1] * q[1] + p[0] * q[2]) / dp / 2, dq / dp
    largest = t + math.sqrt(max(0.0, t * t - d))
    return math.sqrt(max(1.0, largest, largest / d))


def smallest_angle(c, s, most, sites_only):
    """Returns the least angle of configuration c, three times (direction, t, a, b); None when it breaks a
    hypothesis."""
    metrics, sites = [], []
    for direction, t, a, b in (c[i:i + 4] for i in (0, 4, 8)):
        if max(abs(a), abs(b)) > most:
            return None
        m = metric(t, a, b)
        u = math.cos(direction), math.sin(direction)
        r = 1 / math.sqrt(inner(m, u, u))
        metrics.append(m)
        sites.append((r * u[0], r * u[1]))
    for i in range(3):
        for j in range(i):
            e = minus(sites[i], sites[j])
            early, late = (math.sqrt(inner(metrics[k], e, e)) for k in (j, i))
            if (max(early, late) if sites_only else early) < 1:
                return None
            tau = distortion(metrics[i], metrics[j])
            if tau * (1 - s * min(early, late)) > 1 or (sites_only and tau * (1 - s)**2 > 1):
                return None
    least = 180.0
    for m in metrics:
        for i in range(3):
            u, v = minus(sites[i - 2], sites[i]), minus(sites[i - 1], sites[i])
            cosine = inner(m, u, v) / math.sqrt(inner(m, u, u) * inner(m, v, v))
            least = min(least, math.degrees(math.acos(max(-1.0, min(1.0, cosine)))))
    return least


def search(s, seconds, sites_only, seed=1):
    draw = random.Random(seed)
    # Logarithm of the greatest tau(p, x). Sites bound each other's metrics, and the frame is free:
    # three times as much leaves room for all of them.
    most = -math.log(1 - s) * (3 if sites_only else 1)
    best, end = 180.0, time.process_time() + seconds
    while time.process_time() < end:
        now, value = None, None
        while value is None:
            now = []
            for k in range(3):
                now += [k * 2.1 + draw.uniform(-1.1, 1.1), draw.uniform(0, math.pi),
                        draw.uniform(-most, most), draw.uniform(-most, most)]
            value = smallest_angle(now, s, most, sites_only)
        step = 0.5
        while step > 1e-6:
            better = False
            for _ in range(60):
                near = [x + step * draw.gauss(0, 1) * (1 if k % 4 < 2 else most)
                        for k, x in enumerate(now)]
                for k in range(12):
                    if k % 4 >= 2:
                        near[k] = max(-most, min(most, near[k]))
                found = smallest_angle(near, s, most, sites_only)
                if found is not None and found < value:
                    now, value, better = near, found, True
            if not better:
                step /= 2
        best = min(best, value)
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=20, help="for each s")
    parser.add_argument("--sites-only", action="store_true", help="under the hypotheses of theorem 3")
    parser.add_argument("--variations", nargs="+", type=float,
                        default=[0.001, 0.01, 0.02, 0.03, 0.04, 0.052, 0.06, 0.08, 0.113])
    options = parser.parse_args()
    print("| sigma eps | smallest angle found |\n| --- | --- |")
    for s in options.variations:
        print(f"| {s} | {search(s, options.seconds, options.sites_only):.2f} |", flush=True)


if __name__ == "__main__":
    main()
