# SPDX-License-Identifier: MIT
"""Compares the conditions under which tools/check_mesh.py accepts an edge with quadratics along segments, in
fractions."""
import pathlib
import random
import sys
import types
import unittest
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import check_mesh  # noqa: E402

SEED, TRIES, REACH, PARTS = 5, 4000, 12, 6
# The checker's scale of coordinates. Edges of this length in units of it leave room for few witnesses.
UNIT = check_mesh.ONE


def some_tensor(choose):
    while True:
        m11, m22, m12 = choose.randint(1, 30), choose.randint(1, 30), choose.randint(-25, 25)
        if m11 * m22 > m12 * m12:
            return m11, m12, m22


def some_plane(choose):
    """Four sites, v and w the ends of an edge, x on its right and y on its left, as the checker has them."""
    while True:
        sites = [(choose.randint(-REACH, REACH), choose.randint(-REACH, REACH)) for _ in range(4)]
        (vx, vy), (wx, wy) = sites[:2]
        of_x, of_y = ((wx - vx) * (py - vy) - (wy - vy) * (px - vx) for px, py in sites[2:])
        if of_x < 0 < of_y:
            return types.SimpleNamespace(x=[x * UNIT for x, _ in sites], y=[y * UNIT for _, y in sites],
                                         metric=[some_tensor(choose) for _ in sites])


def squared(plane, s, p):
    way = p[0] - plane.x[s], p[1] - plane.y[s]
    return check_mesh.product(plane.metric[s], way, way)


def is_nearer_all_the_way(plane, s, z, p):
    """True if f_z > f_s on the whole segment from s to p: tests its ends, and the vertex of the parabola if it lies
    between."""
    def excess(t):
        at = plane.x[s] + t * (p[0] - plane.x[s]), plane.y[s] + t * (p[1] - plane.y[s])
        return squared(plane, z, at) - squared(plane, s, at)
    start, middle, end = excess(0), excess(Fraction(1, 2)), excess(1)
    second, first = 2 * (start + end - 2 * middle), 4 * middle - 3 * start - end
    least = min(start, end)
    if second > 0 and 0 < -first < 2 * second:
        least = excess(Fraction(-first, 2 * second))
    return least > 0


def balanced(plane, choose):
    """Returns a witness (a, b) near a point of the bisector of v and w, found by bisection between the two."""
    b = choose.randint(-2 * UNIT, 2 * UNIT)
    low, high = 0, UNIT

    def excess(a):
        p = [c[0] + (c[1] - c[0]) * a // UNIT + (c[3] - c[0]) * b // UNIT for c in (plane.x, plane.y)]
        return squared(plane, 0, p) - squared(plane, 1, p)
    while high - low > check_mesh.WINDOW // 2:
        middle = (low + high) // 2
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return low - check_mesh.WINDOW // 4, b


class EdgeConditions(unittest.TestCase):
    def test_what_is_shown_is_so(self):
        choose, shown, looking_away = random.Random(SEED), 0, 0
        for number in range(TRIES):
            plane = some_plane(choose)
            witness = balanced(plane, choose)
            if not check_mesh.shows_kept(plane, 0, 1, 2, 3, witness):
                continue
            shown += 1
            ends = [[c[0] + (c[1] - c[0]) // UNIT * a + (c[3] - c[0]) // UNIT * witness[1] for c in (plane.x, plane.y)]
                    for a in (witness[0], witness[0] + check_mesh.WINDOW)]
            for part in range(PARTS + 1):
                p = [Fraction(one * (PARTS - part) + other * part, PARTS) for one, other in zip(*ends)]
                for s in (0, 1):
                    for z in (2, 3):
                        self.assertTrue(is_nearer_all_the_way(plane, s, z, p),
                                        f"try {number}, seed {SEED}: {plane}, {witness}, sites {s} and {z}")
            looking_away += any(
                check_mesh.product(plane.metric[z], *((r[0] - plane.x[z], r[1] - plane.y[z]) for r in (
                    ends[0], (plane.x[s], plane.y[s])))) <= 0 for s in (0, 1) for z in (2, 3))
        self.assertGreater(shown, 100)
        self.assertGreater(looking_away, 10)

    def test_what_is_not_nearer_all_the_way_is_not_shown(self):
        # The witness is (2, 0), half-way from v to w. y is beside the segment from v to it, and its metric sees the
        # segment's ends at more than a right angle. The smaller its tensor is across, the nearer it is to the
        # segment.
        answers, p = [], (2 * UNIT, 0)
        for m22 in range(1, 41):
            plane = types.SimpleNamespace(x=[0, 4 * UNIT, 2 * UNIT, UNIT], y=[0, 0, -9 * UNIT, UNIT],
                                          metric=[(16, 0, 16), (16, 0, 16), (16, 0, 16), (200, 0, m22)])
            holds = all(is_nearer_all_the_way(plane, s, z, p) for s in (0, 1) for z in (2, 3))
            shown = check_mesh.shows_kept(plane, 0, 1, 2, 3, (UNIT // 2 - check_mesh.WINDOW // 2, 0))
            answers.append((holds, shown))
        # From m = 18 on, 4 * 200 m > 64 (200 + m): the quadratic has no zero.
        self.assertEqual(answers, [(False, False)] * 17 + [(True, True)] * 23)


if __name__ == "__main__":
    unittest.main()
