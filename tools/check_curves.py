#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the proof of a mesh whose domain has curves, as check_mesh.py, beside it, does of others.
    check_curves.py MESH PROOF --domain D.poly --chord-tolerance E --angle-bound B --metric SOL
                    [--metric-tolerance T]
The question is check_mesh.py's, of the polygon that has chords in place of the curves of D; besides, that
the chords of each curve lead along it from end to end, that no point of a curve is farther than E from
its chords, and none of the chords farther than that from the curve. A spline is the cubics that the
manual says (docs/manual/domains.md): their control points are doubles, computed here as there.
Theorem 7 of docs/math/proof-format.md is quoted here. Places on cubics are looked for in doubles, and
decide nothing: the theorem holds for any, and a poor one makes the distance larger.
Exit status: 0 proved; 1 not proved, with the reason; 2 files or questions of which nothing can be said.
"""
import argparse
import copy
import functools
import gc
import itertools
import math
import sys
from fractions import Fraction

import check_mesh
from check_mesh import NotProved, need, need_file, number

FINE = 1 << 200         # roots are rounded to 2^-200
SAMPLES = 1 << 10  # places of a cubic that are tried for each vertex


def minus(p, q): return p[0] - q[0], p[1] - q[1]
def dot(p, q): return p[0] * q[0] + p[1] * q[1]
def cross(p, q): return p[0] * q[1] - p[1] * q[0]
def exact(point): return Fraction(point[0]), Fraction(point[1])


def root_below(x):
    """Returns a fraction that is less than the root of x by at most 2^-200."""
    return Fraction(math.isqrt(int(x * FINE * FINE)), FINE)


def root_above(x):
    return root_below(x) + Fraction(2, FINE)


def squared_distance(p, q0, q1):
    """Returns the square of the distance of p from the segment between two other points."""
    along, to_p = minus(q1, q0), minus(p, q0)
    part, length = dot(along, to_p), dot(along, along)
    if part <= 0 or length == 0:
        return dot(to_p, to_p)
    if part >= length:
        return dot(minus(p, q1), minus(p, q1))
    return Fraction(cross(along, to_p)) ** 2 / length


class Arc:
    """A circle's arc from one vertex of the domain to another, or all around from one to itself."""

    def __init__(self, ends, centre, clockwise, marker):
        self.ends, self.centre, self.marker = ends, exact(centre), marker
        self.side = -1 if clockwise else 1

    def distance(self, chain):
        # Theorem 7: "Each chord turns around the centre by less than half a turn, none but the first leaves
        # the direction of the start or comes to it again, but the last of a circle. Then max(r - d, R - r)
        # bounds both distances, d that of the centre from the chord, R from its farther end."
        rays = [minus(point, self.centre) for point in chain]
        squared_radius, start = dot(rays[0], rays[0]), rays[0]
        low, high, greatest = root_below(squared_radius), root_above(squared_radius), Fraction(0)
        for k, (p, q) in enumerate(itertools.pairwise(rays)):
            need(self.side * cross(p, q) > 0, "a chord runs back along its arc, or half around it")
            comes_again = self.side * cross(start, p) < 0 <= self.side * cross(start, q)
            is_end = chain[0] == chain[-1] and k == len(rays) - 2
            need(comes_again == is_end, "chords lead around an arc's centre too far, or not all around")
            nearest = squared_distance((0, 0), p, q)
            greatest = max(greatest, high - root_below(nearest),
                           root_above(max(dot(p, p), dot(q, q))) - low)
        return greatest


class Cubic:
    """A Bezier curve from one vertex of the domain to another."""

    def __init__(self, ends, control, marker):
        self.ends, self.marker = ends, marker
        self.doubles, self.control = control, [exact(point) for point in control]

    def place(self, t):
        """Returns a point of the curve in doubles."""
        s = 1 - t
        weights = s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t
        return tuple(sum(w * c[k] for w, c in zip(weights, self.doubles)) for k in (0, 1))

    def look_for(self, point, after):
        """Returns, approximately, the parameter above `after` of the curve's point nearest to another point."""
        best = min((k / SAMPLES for k in range(1, SAMPLES) if k / SAMPLES > after),
                   key=lambda t: math.dist(self.place(t), point), default=1.0)
        step = 1 / SAMPLES
        for _ in range(60):     # halves the steps to the better side
            step /= 2
            best = min((t for t in (best - step, best, best + step) if after < t < 1),
                       key=lambda t: math.dist(self.place(t), point), default=best)
        return best

    def blossom(self, u, v, w):
        """Returns the polar form: affine in each of three parameters, and the curve's point where they are equal."""
        points = self.control
        for t in (u, v, w):
            points = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1])
                      for p, q in itertools.pairwise(points)]
        return points[0]

    def distance(self, chain):
        # Theorem 7: "The parameters of the vertices increase from 0 to 1."
        parameters = [0.0]
        for point in chain[1:-1]:
            parameters.append(self.look_for(tuple(map(float, point)), parameters[-1]))
        parameters = [Fraction(t) for t in (*parameters, 1)]
        need(all(s < t for s, t in itertools.pairwise(parameters)), "a chord runs back along its cubic")
        return max(self.distance_of_piece(*piece) for piece in zip(
            itertools.pairwise(parameters), itertools.pairwise(chain)))

    def distance_of_piece(self, parameters, ends):
        # Theorem 7: "Let b0 to b3 be the control points of the piece, d_i their distances from the line of the
        # chord, e at least the distances of b0 and b3 from its ends, m = max(d0, d3) + 3/4 max(d1, d2). Then
        # m + 2 e bounds the distance of the chord from the piece, and that of the piece from the chord where b1
        # and b2 project onto it; else the greatest distance of a b_i from the chord does."
        (s, t), (q0, q1) = parameters, ends
        points = [self.blossom(s, s, s), self.blossom(s, s, t), self.blossom(s, t, t), self.blossom(t, t, t)]
        along = minus(q1, q0)
        length = dot(along, along)
        need(length > 0, "two vertices of a curve are at one place")
        off = [root_above(cross(along, minus(b, q0)) ** 2 / length) for b in points]
        e = root_above(max(dot(minus(b, q), minus(b, q)) for b, q in ((points[0], q0), (points[3], q1))))
        bound = max(off[0], off[3]) + Fraction(3, 4) * max(off[1], off[2]) + 2 * e
        if all(0 <= dot(along, minus(b, q0)) <= length for b in points[1:3]):
            return bound
        return max(bound, *(root_above(squared_distance(b, q0, q1)) for b in points))


def control_after(p0, p1, p2):
    """Returns the control point after p1 of the spline's cubic from p1 to p2 that comes from p0: doubles."""
    d1, d2 = (math.sqrt(math.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])))
              for a, b in ((p0, p1), (p1, p2)))
    of_p1, whole = 2 * d1 * d1 + 3 * d1 * d2 + d2 * d2, 3 * d1 * (d1 + d2)
    return tuple((d1 * d1 * p2[k] - d2 * d2 * p0[k] + of_p1 * p1[k]) / whole for k in (0, 1))


def cubics_of_spline(domain, row):
    """Yields the cubics of a spline, each with the number of its segment."""
    on = [int(word) - domain.first for word in row[2:]]
    need_file(len(on) > 1 and 0 <= min(on) and max(on) < len(domain.segments), "a spline is of segments that are none")
    ends = [domain.segments[s][:2] for s in on]
    chain = [ends[0][0] if ends[0][1] in ends[1] else ends[0][1]]
    for a, b in ends:
        need_file(chain[-1] in (a, b) and a != b, "a segment of a spline does not begin where the one before it ends")
        chain.append(b if chain[-1] == a else a)
    points = [domain.points[v] for v in chain]
    is_closed = len(on) > 2 and chain[0] == chain[-1]
    before, after = (points[-2], points[1]) if is_closed else (
        tuple(2 * p - q for p, q in zip(*pair)) for pair in (points[:2], points[:-3:-1]))
    points = [before, *points, after]
    for k, s in enumerate(on, 1):
        p0, p1, p2, p3 = points[k - 1:k + 3]
        control = [p1, control_after(p0, p1, p2), control_after(p3, p2, p1), p2]
        yield Cubic((chain[k - 1], chain[k]), control, domain.segments[s][2]), s


def curves_of(domain, row):
    """Returns the curves that a line of the file has, each with the number of the segment it stands for, if any."""
    kind, at = row[1], int(row[2]) - domain.first
    if kind == "spline":
        return list(cubics_of_spline(domain, row))
    return [curve_of(domain, row, kind, at)]


def curve_of(domain, row, kind, at):
    numbers = [number(word) for word in row[3:] if word not in ("ccw", "cw")]
    if kind == "circle":
        need_file(0 <= at < len(domain.index) and len(numbers) in (2, 3), "a circle is not as it should be")
        marker = int(row[5]) if len(row) > 5 else 0
        return Arc((domain.index[at],) * 2, numbers[:2], False, marker), None
    need_file(kind in ("arc", "bezier"), f"a curve of kind {kind} cannot be checked")
    need_file(0 <= at < len(domain.segments), "a curve is of a segment that is none")
    a, b, marker = domain.segments[at]
    if kind == "arc":
        need_file(len(row) == 6 and row[5] in ("ccw", "cw"), "an arc is not as it should be")
        return Arc((a, b), numbers, row[5] == "cw", marker), at
    need_file(len(row) == 7 and len(numbers) == 4, "a cubic is not as it should be")
    control = [domain.points[a], tuple(numbers[:2]), tuple(numbers[2:]), domain.points[b]]
    return Cubic((a, b), control, marker), at


def chains_of(plane, given):
    """Returns the chains of the boundary from vertices of the domain to the next ones, both ways."""
    around, chains = {}, []
    for a, b in plane.markers:
        for v, u in ((a, b), (b, a)):
            around.setdefault(v, []).append(u)
    for v in range(given):
        for beside in around.get(v, ()):
            chain = [v, beside]
            while chain[-1] >= given:
                ends = around[chain[-1]]
                need(len(ends) == 2, f"the boundary forks or ends at vertex {chain[-1] + 1}")
                chain.append(ends[0] if ends[1] == chain[-2] else ends[1])
            chains.append(chain)
    return chains


def is_along(plane, chain, curve, most):
    """True if a chain has the marker of a curve and leads along it."""
    if (chain[0], chain[-1]) != curve.ends:
        return False
    if any(plane.markers[plane.key(v, w)] != curve.marker for v, w in itertools.pairwise(chain)):
        return False
    try:
        return curve.distance([exact(plane.doubles[v]) for v in chain]) <= most
    except NotProved:
        return False


def check_domain(plane, domain, most):
    # "2. The domain's vertices are the first ones; no others are required, and all are but for some on curves.
    # For each curve there is a chain along it; what is left of the edges listed is of the other segments."
    given, rows = len(domain.points), domain.curves
    need_file(not rows or (rows[0][0] == "curves" and int(rows[0][1]) == len(rows) - 1), "curves are not as counted")
    straight, rest, on_curves = dict(enumerate(domain.segments)), dict(plane.markers), set()
    chains = chains_of(plane, given)
    for row, (curve, segment) in ((row, found) for row in rows[1:] for found in curves_of(domain, row)):
        chain = next((c for c in chains if plane.key(*c[:2]) in rest and is_along(plane, c, curve, most)), None)
        need(chain, f"no chords are along curve {row[0]} and within {float(most):g} of it")
        need(segment is None or straight.pop(segment, None), "a segment has two curves")
        for v, w in itertools.pairwise(chain):
            need(rest.pop(plane.key(v, w), None) is not None, "a chord is of two curves")
        on_curves.update(chain)
    required = {v - 1 for v, in plane.required}
    need(required.issubset(range(given)) and on_curves.union(required).issuperset(range(given)),
         "other vertices are required than the domain's")
    others, segments = copy.copy(plane), copy.copy(domain)
    others.markers, others.required = rest, [[v + 1] for v in range(given)]
    segments.segments = list(straight.values())
    check_mesh.check_domain(others, segments)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("mesh", help="a Medit file in text")
    parser.add_argument("proof", help="what asterism wrote for --proof")
    parser.add_argument("--domain", required=True, help="a .poly file with curves")
    parser.add_argument("--chord-tolerance", required=True, help="greatest distance of curves and chords")
    parser.add_argument("--angle-bound", type=Fraction, required=True, help="degrees, below 90")
    parser.add_argument("--metric", required=True, help="a .sol file, of m11 m12 m22 a vertex")
    parser.add_argument("--metric-tolerance", type=float, help="of the metric beside the mesh")
    asked = parser.parse_args()
    gc.disable()
    try:
        most = Fraction(number(asked.chord_tolerance))
        need_file(0 <= asked.angle_bound < 90 and 0 <= (asked.metric_tolerance or 0) < math.inf and most >= 0,
                  "--angle-bound is not from 0 to 90, or a tolerance not from 0 on")
        plane = check_mesh.check(
            asked.mesh, asked.proof, asked.domain, asked.angle_bound, asked.metric, asked.metric_tolerance,
            functools.partial(check_mesh.Domain, with_curves=True), functools.partial(check_domain, most=most))
    except NotProved as refusal:
        return print(f"NOT proved: {refusal}") or 1
    except (check_mesh.CannotSay, OSError, ValueError, LookupError, StopIteration) as failure:
        return print(f"check_curves.py: {str(failure) or 'a file ends early'}", file=sys.stderr) or 2
    print(f"proved: {plane.count} sites, {len(plane.inner)} triangles, no angle below "
          f"{float(asked.angle_bound):g} degrees but the domain's own; domain {asked.domain}, its curves within "
          f"{float(most):g}; metric {asked.metric}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
