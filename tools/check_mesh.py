#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the proof of a mesh, in whole numbers and fractions, without any search.
    check_mesh.py MESH PROOF --domain D.poly --angle-bound B --metric SOL [--metric-tolerance T]
The question is what the options and MESH say: that MESH triangulates the domain D, that no angle is
below B degrees, and that its triangles are the stars of its vertices in the metric SOL; with T, in
the metric of the .sol beside MESH, in which no length is more than exp(T) times as long or as short.
PROOF holds witnesses; nothing in it is believed. docs/math/proof-format.md numbers the statements that
are quoted here and proves that what is accepted has the properties 0 to 4 of docs/math/certificate.md.
Exit status: 0 proved; 1 not proved, with the reason; 2 files or questions of which nothing can be said.
"""
import argparse
import gc
import math
import struct
import sys
from fractions import Fraction

GRID, WINDOW = 26, 64       # witnesses are in steps of 2^-26 of edges; an edge's is 64 steps wide
ONE, NOBODY, MOST_POINTS, STEPS = 1 << GRID, (1 << 32) - 1, 32, 1 << 192
class NotProved(Exception): pass
class CannotSay(Exception): pass
def need(holds, what, otherwise=NotProved):
    if not holds: raise otherwise(what)
def need_file(good, what): need(good, what, CannotSay)
# ---- Files ------------------------------------------------------------------------------------------
def number(word):           # the double nearest to a decimal, as every reader of these files takes it
    value = float(word)
    need_file(value - value == 0, f"{word} is no finite number")
    return value
WIDTHS = {"Vertices": 3, "Triangles": 4, "Edges": 3, "Corners": 1, "RequiredVertices": 1,
          "RequiredEdges": 1, "Ridges": 1, "SolAtVertices": 3}
def rows_of(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return [row for row in (line.split("#", 1)[0].split() for line in file) if row]
def read_medit(path):       # the sections of a Medit file in text: {name: rows of numbers}
    words, sections, i = [word for row in rows_of(path) for word in row], {}, 0
    while i < len(words) and words[i] != "End":
        name, count, i = words[i], int(words[i + 1]), i + 2
        if name == "MeshVersionFormatted" or (name == "Dimension" and count == 2): continue
        need_file(name in WIDTHS and name not in sections and count >= 0, f"{path}: {name}")
        need_file(name != "SolAtVertices" or words[i:i + 2] == ["1", "3"], f"{path}: the solution is no metric")
        i += 2 * (name == "SolAtVertices")
        width, kind = WIDTHS[name], number if name in ("Vertices", "SolAtVertices") else int
        need_file(i + width * count <= len(words), f"{path}: {name} ends early")
        sections[name] = [list(map(kind, words[k:k + width])) for k in range(i, i + width * count, width)]
        i += width * count
    return sections
class Domain:
    def __init__(self, path, with_curves=False):    # points, segments, markers, hole and region points
        need_file(path.endswith(".poly"), f"{path}: only .poly files can be checked; 'asterism convert' makes others so")
        rows = iter(rows_of(path))
        count, known, self.segments = int(next(rows)[0]), {}, []
        need_file(count > 0, f"{path}: vertices in another file cannot be checked yet")
        def take(count):        # rows whose numbers go up by one
            taken = [next(rows) for _ in range(count)]
            need_file(count >= 0 and all(
                int(row[0]) - i == int(taken[0][0]) in (0, 1) for i, row in enumerate(taken)), path)
            return taken
        points, head = take(count), next(rows)
        # "A point that is repeated counts once"; `index` numbers each among those that count.
        self.index = [known.setdefault((number(p[1]), number(p[2])), len(known)) for p in points]
        self.points, self.first = list(known), int(points[0][0])
        for row in take(int(head[0])):
            ends = int(row[1]) - self.first, int(row[2]) - self.first
            need_file(0 <= min(ends) and max(ends) < count, f"{path}: segment {row[0]}")
            marker = int(row[3]) if {"0": False, "1": True}[head[1]] else 0
            self.segments.append((self.index[ends[0]], self.index[ends[1]], marker))
        holes, regions, self.curves = *[take(int(next(rows, ["0"])[0])) for _ in range(2)], list(rows)
        need_file(with_curves or not self.curves, f"{path}: curves are for check_curves.py, beside this one")
        need_file(all(number(p[3]) == int(number(p[3])) for p in regions), f"{path}: regions")
        self.holes = [(number(p[1]), number(p[2])) for p in holes]
        self.regions = [(number(p[1]), number(p[2]), int(number(p[3]))) for p in regions]
class Proof:
    def __init__(self, path):   # the witnesses, as docs/math/proof-format.md lays them out
        with open(path, "rb") as file: self.data, self.at = file.read(), 80
        need(self.data[:8] == b"ASTPROOF" and len(self.data) >= 80, "it is no proof")
        head = struct.unpack_from("<8I5d", self.data, 8)
        need(head[0] == 2 and all(x - x == 0 for x in head[8:]), "it is of another version, or not finite")
        self.sites, self.triangles, self.rectangle, self.radius = *head[1:3], head[8:12], head[12]
        self.outside, places, self.edges, self.gaps = (
            self.take(count, form) for count, form in zip(head[3:7], ("<3I", "<I", "<2i", "<4i")))
        self.places, self.exceptions = [t for t, in places], {}
        for _ in range(head[7]):
            (gap, site, kind, turn, count), = self.take(1, "<2I2BH")
            points, sizes = self.take(count, "<2i"), (1, 3, 6)[kind - 4:kind - 3] if kind > 3 else ()
            weights = [[self.whole() for _ in range(size)] for size in 3 * sizes]
            self.exceptions[gap, site] = kind, turn, points, weights
        need(self.at == len(self.data), "the proof goes on after its end")
    def take(self, count, form):
        begin, self.at = self.at, self.at + count * struct.calcsize(form)
        need(self.at <= len(self.data), "the proof ends early")
        return list(struct.iter_unpack(form, self.data[begin:self.at]))
    def whole(self):            # a number of bytes, negative for a negative number, then these
        (size,), = self.take(1, "<h")
        return int.from_bytes((byte for byte, in self.take(abs(size), "<B")), "little") * (1 if size > 0 else -1)
def power_of(values):       # the least exponent of a power of two by which all of these doubles are whole
    return max((value.as_integer_ratio()[1].bit_length() - 1 for value in values), default=0)
def scaled(value, power):
    top, bottom = value.as_integer_ratio()
    return top << (power - (bottom.bit_length() - 1))
def series(term, factor):   # a sum of positive terms, each factor(k) of the one before, rounded down
    total, k = 0, 1
    while term:
        total, term, k = total + term, int(term * factor(k)), k + 1
    return total
# ---- Points 0 to 2 ----------------------------------------------------------------------------------
class Plane:
    def __init__(self, mesh, tensors, proof):   # all in whole numbers; with triangles around the mesh
        self.count, low_x, low_y, high_x, high_y = len(mesh.get("Vertices", [])), *proof.rectangle
        self.doubles = [*((x, y) for x, y, _ in mesh.get("Vertices", [])), (low_x, low_y), (high_x, low_y),
                        (high_x, high_y), (low_x, high_y)]
        self.power = power_of(x for place in self.doubles for x in place)
        self.metric_power = power_of(entry for tensor in tensors for entry in tensor)
        # Coordinates are multiplied by 2^power, and by 2^26, so that every witness is whole.
        self.x, self.y = ([scaled(p[k], self.power) << GRID for p in self.doubles] for k in (0, 1))
        self.metric = [tuple(scaled(entry, self.metric_power) for entry in t) for t in tensors]
        rows = mesh.get("Triangles", [])
        self.inner = [(a - 1, b - 1, c - 1) for a, b, c, _ in rows]
        self.region, self.required = [row[3] for row in rows], mesh.get("RequiredVertices", [])
        self.triangles, self.markers = self.inner + proof.outside, {}
        for a, b, marker in mesh.get("Edges", []):
            need(self.key(a - 1, b - 1) not in self.markers and 0 < min(a, b) and max(a, b) <= self.count,
                 f"edge {a}-{b} is listed twice, or of vertices that are none")
            self.markers[self.key(a - 1, b - 1)] = marker
        # "0. Numbers are finite, tensors positive definite; indices are those of vertices."
        need(low_x < high_x and low_y < high_y and rows, "the rectangle or the mesh is empty")
        need(len(tensors) == self.count, "the metric is of another number of vertices")
        need((proof.sites, proof.triangles) == (self.count, len(rows)), "the proof is of another mesh")
        for v, (m11, m12, m22) in enumerate(self.metric):
            need(m11 > 0 and m11 * m22 > m12 * m12, f"the metric of vertex {v + 1} is not definite")
        for t, c in enumerate(self.triangles):
            need(0 <= min(c) and max(c) < self.count + 4 * (t >= len(rows)), f"triangle {t + 1} has no such corner")
        self.join()
    def key(self, a, b): return (a, b) if a < b else (b, a)
    def is_segment(self, a, b): return self.key(a, b) in self.markers
    def turn(self, a, b, c):    # is positive if these vertices turn counter-clockwise
        x, y = self.x, self.y
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])
    def join(self):
        # Theorem 1: "(A) Every triangle turns counter-clockwise. (B) No two have a directed edge in common. (C) The
        # reverse of every edge is one, but for the sides of the rectangle. (D) Every vertex is a corner of a
        # triangle of the mesh. (E) The edges listed are edges of the mesh, and include all that it has in common
        # with the triangles outside."
        n, edges = self.count, [{} for _ in range(self.count + 4)]  # edges that leave, by their ends
        for t, corners in enumerate(self.triangles):
            need(self.turn(*corners) > 0, f"triangle {t + 1} is not counter-clockwise")           # (A)
            for i, a in enumerate(corners):
                b = corners[i - 2]
                need(b not in edges[a], f"triangle {t + 1} has an edge that another one has")     # (B)
                edges[a][b] = 3 * t + i
        sides = {(n + i, n + (i + 1) % 4) for i in range(4)}
        self.across, self.most = [-1] * (3 * len(self.triangles)), 3 * len(self.inner)
        for a, b, edge in ((a, b, edge) for a in range(n + 4) for b, edge in edges[a].items()):
            reverse = edges[b].get(a, -1)
            need((reverse < 0) == ((a, b) in sides), f"edge {a + 1}-{b + 1} has nothing beyond")  # (C)
            self.across[edge] = reverse
            need(edge >= self.most or reverse < self.most or self.is_segment(a, b),               # (E)
                 f"edge {a + 1}-{b + 1} of the boundary is not listed")
        need(len({v for t in self.inner for v in t}) == n, "a vertex is in no triangle")          # (D)
        for a, b in self.markers:
            need(min(edges[a].get(b, self.most), edges[b].get(a, self.most)) < self.most,         # (E)
                 f"the edge listed from {a + 1} to {b + 1} is no edge of the mesh")
    def parts(self):            # of each triangle its part's number, as the edges listed cut the rectangle
        part, self.order = [-1] * len(self.triangles), []   # and one in which neighbours are near
        for first in range(len(part)):
            ahead = [first] if part[first] < 0 else []
            for t in ahead:
                part[t] = first
                for i, v in enumerate(self.triangles[t]):
                    beyond = self.across[3 * t + i] // 3
                    if beyond >= 0 > part[beyond] and not self.is_segment(v, self.triangles[t][i - 2]):
                        part[beyond], _ = first, ahead.append(beyond)
            self.order += ahead
        return part
    def corners(self):  # of the mesh's triangles, by their numbers; also those of the edges they begin
        return (3 * t + i for t in self.order if t < len(self.inner) for i in range(3))
    def around(self, corner):   # the corner, the next and the third
        t, i = self.inner[corner // 3], corner % 3
        return t[i], t[i - 2], t[i - 1]
    def contains(self, t, place):   # if a point of doubles is in t, or on an edge that is no segment
        more = max(0, power_of(place) - self.power)
        px, py = (scaled(value, self.power + more) << GRID for value in place)
        for i, v in enumerate(self.triangles[t]):
            u = self.triangles[t][i - 2]
            (ax, ay), (bx, by) = ((self.x[z] << more, self.y[z] << more) for z in (v, u))
            side = (bx - ax) * (py - ay) - (by - ay) * (px - ax)
            if side < 0 or (side == 0 and self.is_segment(v, u)): return False
        return True
def check_faces(plane, domain, proof):
    # "2. Triangles with no segment between them have the same region. Outside are the part around, and those with a
    # hole point; the mesh has all others. A region has the number of its point; 0 where others have one, 1 where
    # none has."
    part, number_of, inner = plane.parts(), {}, len(plane.inner)
    for t, region in enumerate(plane.region):
        need(number_of.setdefault(part[t], region) == region, f"triangle {t + 1} is of two regions")
    if not domain: return
    places = domain.holes + domain.regions
    need(len(proof.places) == len(places), "the proof does not place the domain's holes and regions")
    named, outside = {}, {part[edge // 3] for edge, across in enumerate(plane.across) if across < 0}
    for k, (t, place) in enumerate(zip(proof.places, places)):
        need(t < len(part) and plane.contains(t, place[:2]), "a hole or region is not where it is said")
        need((t >= inner) == (k < len(domain.holes)), "a hole is in the mesh, or a region outside")
        need(t >= inner or named.setdefault(part[t], place[2]) == place[2], "a region has two numbers")
        outside.update(part[t:t + 1] if t >= inner else ())
    need(all(p in outside for p in part[inner:]), "a part of the domain is not in the mesh")
    need(not outside.intersection(part[:inner]), "the mesh is where the domain is not")
    for p, region in number_of.items():
        need(region == named.get(p, 1 if not domain.regions else 0), f"a region is numbered {region}")
def check_domain(plane, domain):
    # "2. The domain's vertices are the first ones, and required. Every edge listed is in one chain from one of them
    # to the next. Every segment is a chain, or several in a row where vertices are exactly on it; every chain is of
    # a segment, and has the first marker of its segments that is not 0."
    given, around, chains, marker_of = len(domain.points), {}, {}, {}
    need(plane.doubles[:given] == domain.points and given <= plane.count and
         plane.required == [[v + 1] for v in range(given)], "the first vertices are not the domain's")
    for a, b in plane.markers:
        for v, u in ((a, b), (b, a)): around.setdefault(v, []).append(u)
    for chain in ([v, beside] for v in range(given) for beside in around.get(v, ())):
        while chain[-1] >= given:
            ends = around[chain[-1]]
            need(len(ends) == 2, f"the boundary forks or ends at vertex {chain[-1] + 1}")
            chain.append(ends[0] if ends[1] == chain[-2] else ends[1])
        need(chain[-1] not in chains.setdefault(chain[0], {}), f"two chains leave vertex {chain[0] + 1} alike")
        chains[chain[0]][chain[-1]] = chain
    need(sum(len(chain) - 1 for v in chains for chain in chains[v].values()) == 2 * len(plane.markers),
         "a ring of the boundary has no vertex of the domain")
    for a, b, marker in domain.segments:
        v = a
        while v != b:
            ahead = [u for u in chains.get(v, ()) if plane.turn(v, b, u) == 0 and all(
                min(c[v], c[b]) <= c[u] <= max(c[v], c[b]) for c in (plane.x, plane.y))]
            need(len(ahead) == 1, f"the edges from vertex {v + 1} to {b + 1} are no segment's")
            key = plane.key(v, ahead[0])
            marker_of[key], v = marker_of.get(key) or marker, ahead[0]
    for v, u, chain in ((v, u, chain) for v in chains for u, chain in chains[v].items()):
        need(plane.key(v, u) in marker_of, f"the edges from {v + 1} to {u + 1} are no segment's")
        check_chain(plane, chain, marker_of[plane.key(v, u)])
def check_chain(plane, chain, marker):
    # "2. Along a chain every edge advances. A split point is no farther from the segment than two units in the last
    # place of the greatest coordinate of its ends, or than sixteen that are at most 2^-10 of its length."
    x, y, start, end = plane.x, plane.y, chain[0], chain[-1]
    dx, dy = x[end] - x[start], y[end] - y[start]
    length = dx * dx + dy * dy
    greatest = max(map(abs, plane.doubles[start] + plane.doubles[end]))
    unit = len(chain) > 2 and Fraction(math.ulp(greatest)) * (1 << plane.power + GRID)
    for v, w in zip(chain, chain[1:]):
        need(plane.markers[plane.key(v, w)] == marker, f"edge {v + 1}-{w + 1} has another marker")
        need((x[w] - x[v]) * dx + (y[w] - y[v]) * dy > 0, f"edge {v + 1}-{w + 1} runs back")
        square = (dx * (y[w] - y[start]) - dy * (x[w] - x[start])) ** 2   # by the length squared
        need(w == end or square <= (2 * unit) ** 2 * length or (
            square <= (16 * unit) ** 2 * length and square << 20 <= length * length),
             f"vertex {w + 1} is beside its segment")
# ---- Point 3 ----------------------------------------------------------------------------------------
def squared_cotangent(degrees):     # fractions below and above cot^2; it itself where it is rational
    if degrees in (30, 45, 60): return (Fraction({30: 9, 45: 3, 60: 1}[int(degrees)], 3),) * 2
    def inverse_tangent(n):     # of 1/n, by Euler's series
        return series(STEPS * n // (n * n + 1), lambda k: Fraction(2 * k, (2 * k + 1) * (n * n + 1)))
    # Pi is 740 steps too small at most, the cosine 100 more off: 2^10 of them are 2^-182.
    slack, pi = Fraction(1, 1 << 180), Fraction(16 * inverse_tangent(5) - 4 * inverse_tangent(239), STEPS)
    x = pi * 2 * degrees / 180                  # cot^2 a = (1 + cos 2a) / (1 - cos 2a)
    even = series(STEPS, lambda k: x ** 4 / math.prod(range(4 * k - 3, 4 * k + 1)))
    odd = series(int(x * x / 2 * STEPS), lambda k: x ** 4 / math.prod(range(4 * k - 1, 4 * k + 3)))
    cos = Fraction(even - odd, STEPS)
    low, high = (1 + cos - slack) / (1 - cos + slack), (1 + cos + slack) / (1 - cos - slack)
    return Fraction(int(low * 2 ** 160), 2 ** 160), Fraction(int(high * 2 ** 160) + 1, 2 ** 160)
class Angles:
    def __init__(self, plane, given, degrees):
        self.plane, self.given, self.exempt = plane, given, set()
        self.low, self.high = squared_cotangent(degrees)
        # "3. At every corner, with edges a and b, in the metric M of each vertex of the triangle, a^T M b <= 0 or
        # (a^T M b)^2 <= cot^2 det M (a x b)^2, unless the angle is exempt."
        x, y, top, bottom = plane.x, plane.y, self.low.numerator, self.low.denominator
        for t, (a, b, c) in ((t, plane.inner[t]) for t in plane.order if t < len(plane.inner)):
            ways = ((x[b] - x[a], y[b] - y[a]), (x[c] - x[b], y[c] - y[b]), (x[a] - x[c], y[a] - y[c]))
            area = ways[0][0] * ways[1][1] - ways[0][1] * ways[1][0]
            for p in (a, b, c):
                metric, limit = plane.metric[p], top * determinant(plane.metric[p]) * area * area
                for i in range(3):
                    along = -product(metric, ways[i], ways[i - 1])
                    if along > 0 and bottom * along * along > limit: self.excuse(t, i, p)
        # "3. Not more than half of the triangles have an exempt angle and segments for all sides, one of them inside
        # the domain." Where the mesh is its own domain, not all inner edges are segments.
        enclosed = [t for t in self.exempt if min(plane.across[3 * t:3 * t + 3]) < plane.most and all(
            plane.is_segment(*plane.around(3 * t + i)[:2]) for i in range(3))]
        free = given <= plane.count or not self.exempt or any(
            edge < plane.across[edge] < plane.most and not plane.is_segment(*plane.around(edge)[:2])
            for edge in plane.corners())
        need(free and 2 * len(enclosed) <= len(plane.inner), "next to nothing of the mesh is judged")
    def excuse(self, t, i, p):
        # "3. Exempt is an angle at a vertex of the domain whose own angle there, between segments in a row, is below
        # the bound in the metric of the vertex and in the one that measures."
        plane, v = self.plane, self.plane.inner[t][i]
        said = f"triangle {t + 1} has an angle below the bound at vertex {v + 1}, seen by {p + 1}"
        need(v < self.given, said)
        first, last = 3 * t + i, before(3 * t + i)
        for _ in range(plane.most):     # first goes clockwise to a segment, last counter-clockwise
            a, b = plane.around(first)[1], plane.around(last)[0]
            if plane.is_segment(v, a) and plane.is_segment(v, b): break
            if not plane.is_segment(v, a): first = after(plane.across[first])
            if not plane.is_segment(v, b): last = before(plane.across[last])
        need(plane.is_segment(v, a) and plane.is_segment(v, b), said)
        to_a, to_b = ((plane.x[u] - plane.x[v], plane.y[u] - plane.y[v]) for u in (a, b))
        area = to_a[0] * to_b[1] - to_a[1] * to_b[0]
        for metric in (plane.metric[v], plane.metric[p]):
            along = product(metric, to_a, to_b)
            need(min(area, along) > 0 and along ** 2 > self.high * determinant(metric) * area ** 2, said)
        self.exempt.add(t)
def after(edge): return edge - 2 if edge % 3 == 2 else edge + 1
def before(edge): return edge - 1 if edge % 3 else edge + 2
def product(m, p, q): return p[0] * (m[0] * q[0] + m[1] * q[1]) + p[1] * (m[1] * q[0] + m[2] * q[1])
def dual(m, x, y): return m[0] * x + m[1] * y, m[1] * x + m[2] * y
def determinant(m): return m[0] * m[2] - m[1] * m[1]
# ---- Point 4: neighbours stay -----------------------------------------------------------------------
def keeps(plane, v, w, x, y):
    # "In one metric v and w keep each other if y is outside the circle of v, w and x; of four sites on a circle, if
    # the greatest is x or y" (x is on the right of the way from v to w, y on the left).
    px, py = plane.x, plane.y
    (along_x, area_x), (along_y, area_y) = (
        (product(plane.metric[v], a, b), a[0] * b[1] - a[1] * b[0]) for a, b in (
            ((px[v] - px[z], py[v] - py[z]), (px[w] - px[z], py[w] - py[z])) for z in (x, y)))
    excess = along_x * area_y - along_y * area_x
    return excess > 0 or (excess == 0 and max((v, w, x, y), key=lambda z: (px[z], py[z])) in (x, y))
def by_number(asked, witnesses, what):  # the witnesses of what is asked about, in order of numbers
    need(len(asked) == len(witnesses), f"there are not as many witnesses of {what} as {what}")
    return dict(zip(sorted(asked), witnesses))
def have_one_metric(plane, *sites): return all(plane.metric[s] == plane.metric[sites[0]] for s in sites)
def check_neighbours(plane, proof, gaps):
    # "An inner edge v-w with y on its left and x on its right is asked about if v or w asks: v, x, y turn
    # counter-clockwise and w is not strictly within, or w, y, x do and v is not."
    turn, asked = plane.turn, {}
    for edge, reverse in ((edge, plane.across[edge]) for edge in plane.corners()):
        if edge < reverse < plane.most:
            (v, w, y), (_, _, x) = plane.around(edge), plane.around(reverse)
            if not plane.is_segment(v, w) and ((turn(v, x, y) > 0 and turn(x, y, w) <= 0)
                                               or (turn(w, y, x) > 0 and turn(y, x, v) <= 0)):
                if have_one_metric(plane, v, w, x, y):
                    need(keeps(plane, v, w, x, y), f"edge {v + 1}-{w + 1} is not kept")
                else: asked[edge] = v, w, x, y
    witnesses = by_number(asked, proof.edges, "edges")
    for edge, (v, w, x, y) in asked.items():
        need(shows_kept(plane, v, w, x, y, witnesses[edge]) or gaps.keep(edge),
             f"edge {v + 1}-{w + 1} is not shown to be kept")
def shows_kept(plane, v, w, x, y, witness):
    # Theorem 2: "(1) f_v < f_w at the first point and f_v > f_w at the second: at a p between they are equal. (2) v
    # and w see p. (3) For z = x and z = y, s = v and s = w, let k be the least value of F = f_z - f_s at the points and
    # of its product of both: k and each product f_z(s, p) are positive, or the square of this is below f_z(s) k. (4) x
    # and y are outside the closed triangle v, w, p."
    at, (a, b) = {s: (plane.x[s], plane.y[s]) for s in (v, w, x, y)}, witness
    p, q = points = [tuple(at[v][k] + (at[w][k] - at[v][k] >> GRID) * steps + (at[y][k] - at[v][k] >> GRID) * b
                           for k in (0, 1)) for steps in (a, a + WINDOW)]
    seen = {s: [dual(plane.metric[s], r[0] - sx, r[1] - sy) for r in points] for s, (sx, sy) in at.items()}
    def form(s, r, t):          # the product of p - s (r = 0) or q - s (r = 1) and t - s in the metric of s
        return seen[s][r][0] * (t[0] - at[s][0]) + seen[s][r][1] * (t[1] - at[s][1])
    of = {s: (form(s, 0, p), form(s, 1, q), form(s, 0, q)) for s in at}
    def is_nearer(s, z):
        k, d = min(map(int.__sub__, of[z], of[s])), (at[s][0] - at[z][0], at[s][1] - at[z][1])
        return k > 0 and all(c > 0 or c * c < k * product(plane.metric[z], d, d) for c in (
            mx * d[0] + my * d[1] for mx, my in seen[z]))
    return (of[v][0] < of[w][0] and of[v][1] > of[w][1]                                     # (1)
            and all(form(v, r, at[w]) > 0 and form(w, r, at[v]) > 0 for r in (0, 1))        # (2)
            and all(is_nearer(s, z) for s in (v, w) for z in (x, y))                        # (3)
            and are_outside(*at.values(), points))                                          # (4)
def are_outside(at_v, at_w, at_x, at_y, points):    # (4) for all points between these
    def side(o, r, t): return (r[0] - o[0]) * (t[1] - o[1]) - (r[1] - o[1]) * (t[0] - o[0])
    return all(all(left * side(at_v, at_w, r) <= 0 for r in points) or
               all(left * side(at_v, r, at_z) > 0 for r in points) or
               all(left * side(at_w, r, at_z) < 0 for r in points) for at_z, left in ((at_y, 1), (at_x, -1)))
POWERS = (0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)    # of s and t, in the order of coefficients
def is_positive(p): return p[0] + sum(min(c, 0) for c in p[1:]) > 0     # where variables are from 0 to 1
def shows_meeting(plane, v, x, y, w, c1, m, c2, weights):
    # Theorem 8: "On the box n + s (c1 - n) + t (c2 - n), m across from n: (1) the weights of x and y are positive, or
    # 0 with (2), w's negative; the weighted sum of f_z - f_v is (2) negative, or (3) 0, that of weights positive, the
    # greatest site v or w. (4) f_x > f_v if s = 0, f_x < f_v if s = 1, f_y > f_v if t = 0, f_y < f_v if t = 1, slopes
    # turn. (5) f_z(p, u) > 0 for z = v, w, u = x, y; x, y see each other from p. (6) v, w are outside triangle x, y, p."
    px, py, n = plane.x, plane.y, (c1[0] + c2[0] - m[0], c1[1] + c2[1] - m[1])
    d1, d2 = ((c[0] - n[0], c[1] - n[1]) for c in (c1, c2))
    def expand(z):
        r = n[0] - px[z], n[1] - py[z]
        return [product(plane.metric[z], a, b) * (1 if a is b else 2) for a, b in (
            (r, r), (r, d1), (r, d2), (d1, d1), (d1, d2), (d2, d2))]
    own, total = expand(v), {}
    excess = f, g, _ = [[a - b for a, b in zip(expand(z), own)] for z in (x, y, w)]
    for (i, j), (k, l), value in ((i, k, a * b) for weight, of_z in zip(weights, excess)
                                  for i, a in zip(POWERS, weight) for k, b in zip(POWERS, of_z)):
        total[i + k, j + l] = total.get((i + k, j + l), 0) + value
    rest, greatest = [-c for c in total.values()], max((v, w, x, y), key=lambda z: (px[z], py[z]))
    signs = [*(p for p in weights[:2] if any(p) or not any(rest)), [-c for c in weights[2]], (f[0], f[2], f[5]),
             (-f[0] - f[1] - f[3], -f[2] - f[4], -f[5]), (g[0], g[1], g[3]), (-g[0] - g[2] - g[5], -g[1] - g[4], -g[3])]
    slopes = [[(h[1] + 2 * s * h[3] + t * h[4], h[2] + s * h[4] + 2 * t * h[5]) for s in (0, 1) for t in (0, 1)]
              for h in (f, g)]
    return (all(map(is_positive, signs)) and all(a[0] * b[1] > a[1] * b[0] for a in slopes[0] for b in slopes[1])
            and (is_positive(rest) or (not any(rest) and greatest in (v, w)                       # (2) and (3)
                                       and is_positive([sum(of_all) for of_all in zip(*weights)])))
            and all(product(plane.metric[a], (p[0] - px[a], p[1] - py[a]), (px[b] - px[a], py[b] - py[a])) > 0
                    for a, b in ((v, x), (v, y), (w, x), (w, y), (x, y), (y, x)) for p in (n, c1, m, c2))  # (5)
            and are_outside(*((px[z], py[z]) for z in (x, y, w, v)), (n, c1, m, c2)))                    # (6)
# ---- Point 4: others stay out -----------------------------------------------------------------------
class Gaps:
    def __init__(self, plane, proof):
        self.plane, self.proof, self.regions, self.known = plane, proof, {}, {}
        radius = Fraction(proof.radius) * (1 << 2 * plane.power + 2 * GRID + plane.metric_power)
        self.radius, self.beyond = math.floor(radius), math.ceil(radius)
        # "A gap of the star of v, from x counter-clockwise to y, is asked about unless x-y is a segment. Its points
        # are sound and within the radius, as v measures."
        asked = [gap for gap in plane.corners() if not plane.is_segment(*plane.around(gap)[1:])]
        witnesses = by_number(asked, proof.gaps, "gaps")
        for gap in asked:
            (v, x, y), (on_x, a, b, on_y) = plane.around(gap), witnesses[gap]
            _, turn_at, points, _ = ((0, 1, ((on_x, 0), (a, b), (0, on_y)), ()) if on_x else
                                     self.exception(gap, NOBODY))   # has a row of more points
            region = self.region(v, x, y, points, turn_at)
            need(region and max(*region[4], *region[6:]) <= self.radius,
                 f"the gap at vertex {v + 1} of triangle {gap // 3 + 1} is not shown to end")
            # The last two: it is in its own triangle; or may be, but for what is behind x-y.
            ends = on_x > 0 and max(on_x, on_y) <= ONE
            self.regions[gap] = *region, ends and a + b <= ONE, ends
    def exception(self, gap, w): return self.proof.exceptions.get((gap, w), (3, 0, (), ()))
    def meeting(self, gap, w):  # if one shows that x and y keep each other, not v and w; if its row refuses w
        key, (v, x, y), (kind, turn, points, weights) = (gap, w), self.plane.around(gap), self.exception(gap, w)
        if key not in self.known:
            if turn > 127: v, x, y, w, turn = w, y, x, v, turn - 128    # of the gap at w from y to x, for v
            kept = kind > 3 and len(weights) == 3 and 0 < turn < len(points) - 1 and shows_meeting(
                self.plane, v, x, y, w, *self.span(v, x, y, points[turn - 1:turn + 2])[3], weights)
            # Theorem 9: "Without the point at which the row turns its region refuses w."
            self.known[key] = kept, kept and self.region(v, x, y, points, turn) and self.refuses(
                self.span(v, x, y, points[:turn] + points[turn + 1:]), w)
        return self.known[key]
    def keep(self, edge):       # the ends of an inner edge, by a meeting of the gap on either side
        left, right, around = before(edge), before(self.plane.across[edge]), self.plane.around
        return self.meeting(left, around(right)[0])[0] or self.meeting(right, around(left)[0])[0]
    def span(self, v, x, y, points):    # what the region of these is held against, and v, x and y measure there
        plane, vx, vy, own = self.plane, self.plane.x[v], self.plane.y[v], self.plane.metric[v]
        to_x, to_y = ((plane.x[z] - vx, plane.y[z] - vy) for z in (x, y))
        at = [((a * to_x[0] + b * to_y[0]) >> GRID, (a * to_x[1] + b * to_y[1]) >> GRID) for a, b in points]
        of_x, of_y = (product(plane.metric[z], d, d) for z, d in (
            (x, (at[0][0] - to_x[0], at[0][1] - to_x[1])), (y, (at[-1][0] - to_y[0], at[-1][1] - to_y[1]))))
        return (v, x, y, [(p[0] + vx, p[1] + vy) for p in at], [product(own, p, p) for p in at],
                [product(own, p, q) for p, q in zip(at, at[1:])], of_x, of_y)
    def region(self, v, x, y, points, turn):    # that these points span, or None if they are not sound
        # Lemma 2: "The first is on the ray to x, the last on the ray to y, each on the left of the one before or on
        # its ray. The segment to the next, if that is on another ray, is behind x up to the point `turn`, then y."
        if (not 2 <= len(points) <= MOST_POINTS or turn >= len(points) or points[0][1] or points[-1][0]
                or min(min(p) for p in points) < 0 or min(a + b for a, b in points) == 0): return None
        region = self.span(v, x, y, points)
        for i, ((a, b), (c, d)) in enumerate(zip(points, points[1:])):
            if (side := a * d - b * c) < 0 or (side and not self.is_behind(region, i, x if i < turn else y)): return None
        return region
    def is_behind(self, region, i, z):
        # Lemma 2: "A segment p-q is behind z if p^T M_v z > 0, q^T M_v z > 0 and f_v - f_z is nowhere negative on it:
        # not at p and q, and the product is not either, or its square is no more than that of the ends."
        plane, v, (px, py), (qx, qy) = self.plane, region[0], *region[3][i:i + 2]
        zx, zy, vx, vy, other = plane.x[z], plane.y[z], plane.x[v], plane.y[v], plane.metric[z]
        p, q, (mx, my) = (px - zx, py - zy), (qx - zx, qy - zy), dual(plane.metric[v], zx - vx, zy - vy)
        if mx * (px - vx) + my * (py - vy) <= 0 or mx * (qx - vx) + my * (qy - vy) <= 0: return False
        at_p, at_q = region[4][i] - product(other, p, p), region[4][i + 1] - product(other, q, q)
        both = region[5][i] - product(other, p, q)
        return at_p >= 0 and at_q >= 0 and (both >= 0 or both * both <= at_p * at_q)
    def walk(self, w, around):
        # Lemma 3: "From the triangles at w, across edges that its ball meets, one comes to all that it meets."
        plane, beyond, radius, seen = self.plane, self.beyond, self.radius, {}
        x, y, wx, wy, (m11, m12, m22) = plane.x, plane.y, plane.x[w], plane.y[w], plane.metric[w]
        def look(u):
            if u not in seen:
                dx, dy = x[u] - wx, y[u] - wy
                mx, my = m11 * dx + m12 * dy, m12 * dx + m22 * dy
                seen[u] = dx, dy, mx, my, mx * dx + my * dy
            return seen[u]
        met, known = list(around[w]), set(around[w])
        for t in met:
            corners = plane.triangles[t]
            for i in range(3):
                a, b, reverse = corners[i], corners[i - 2], plane.across[3 * t + i]
                if a == w or b == w or (reverse >= 0 and reverse // 3 in known): continue
                (_, _, mx, my, of_a), (bx, by, _, _, of_b) = look(a), look(b)
                both = mx * bx + my * by
                # The ball misses the edge if both ends are outside and the edge's nearest point is an end or outside.
                if of_a > radius and of_b > radius and (both >= of_a or both >= of_b or (
                        of_a * of_b - both * both > beyond * (of_a + of_b - 2 * both))): continue
                need(reverse >= 0, f"the ball around vertex {w + 1} meets the rectangle's rim")
                known.add(reverse // 3), met.append(reverse // 3)
        return met
    def check(self):
        # Theorem 4: "If no w that is strictly between the rays of a gap is accepted, of those whose ball meets a
        # triangle in which a part of its region may be, none is. It is in the gap's own triangle if a + b <= 2^26;
        # else in that and the one behind, if the point is in it; else in triangles that the ball around v meets."
        plane, turn, listed, around = self.plane, self.plane.turn, {}, [[] for _ in range(self.plane.count + 4)]
        for t, v in ((t, v) for t, corners in enumerate(plane.triangles) for v in corners): around[v].append(t)
        for gap in (gap for gap, region in self.regions.items() if not region[8]):
            for t in self.behind(gap, around): listed.setdefault(t, []).append(gap)
        for w in dict.fromkeys(v for t in plane.order for v in plane.triangles[t] if v < plane.count):   # all
            for t in self.walk(w, around):
                corners = plane.triangles[t]
                if 3 * t < plane.most and w not in corners:
                    left = [turn(corners[i], corners[i - 2], w) > 0 for i in range(3)]
                    for i in range(3):  # strictly between the rays of corner i
                        if left[i] and left[i - 1]: self.ask(3 * t + i, w)
                for gap in listed.get(t, ()):
                    v, x, y = self.regions[gap][:3]
                    if w not in (v, x, y) and turn(v, x, w) > 0 and turn(y, v, w) > 0: self.ask(gap, w)
    def behind(self, gap, around):  # triangles that hold what is of a gap's region beyond x-y
        plane, (v, x, y, points), q = self.plane, self.regions[gap][:4], self.regions[gap][3][1]
        t = plane.across[after(gap)] // 3
        sides = zip(plane.triangles[t], plane.triangles[t][1:] + plane.triangles[t][:1])
        holds = self.regions[gap][9] and all((a, b) == (y, x) or (
            (plane.x[b] - plane.x[a]) * (q[1] - plane.y[a])
            >= (plane.y[b] - plane.y[a]) * (q[0] - plane.x[a])) for a, b in sides)
        return [t] if holds else [s for s in self.walk(v, around) if s != gap // 3]
    def ask(self, gap, w):  # needs that a gap refuses a site that is strictly between its rays
        region = self.regions.get(gap)
        if region is None: return       # x-y is a segment: nothing is seen beyond
        plane, (v, x, y) = self.plane, region[:3]
        said = f"vertex {v + 1} is not shown to refuse vertex {w + 1} between {x + 1} and {y + 1}"
        if have_one_metric(plane, v, w, x, y):
            return need(not keeps(plane, v, w, x, y), f"vertex {v + 1} accepts vertex {w + 1}")
        # "v accepts w between x and y if w accepts v between y and x": its gap will do, too.
        behind = before(plane.across[after(gap)])
        back = self.regions.get(behind, (None,))
        if (self.refuses(region, w) or (back[0] == w and self.refuses(back, v))
                or self.meeting(gap, w)[1] or (back[0] == w and self.meeting(behind, v)[1])): return
        kind, turn_at, points, _ = self.exception(gap, w)
        if kind < 2:
            row, other = (self.region(*(w, y, x) if kind else (v, x, y), points, turn_at), v if kind else w)
            return need(row and self.refuses(row, other), said)
        # "A segment crosses the way from v to w: v does not see w."
        need(kind == 2 and len(points) == 1 and plane.is_segment(*points[0]), said)
        turn, (a, b) = plane.turn, points[0]
        need(turn(v, w, a) * turn(v, w, b) < 0 and turn(a, b, v) * turn(a, b, w) < 0, said)
    def refuses(self, region, w):
        # Theorem 3: "f_w > f_v on the triangles of v and two points in a row, f_w > f_x from the first to x, f_w > f_y
        # from the last to y, each as all its Bernstein coefficients are positive: then w is not accepted."
        v, x, y, points, squares, products, on_x, on_y = region[:8]
        plane, first, last = self.plane, None, None
        wx, wy, (m11, m12, m22) = plane.x[w], plane.y[w], plane.metric[w]
        ux, uy = plane.x[v] - wx, plane.y[v] - wy
        kx, ky = m11 * ux + m12 * uy, m12 * ux + m22 * uy
        for i, (qx, qy) in enumerate(points):
            dx, dy = qx - wx, qy - wy
            mx, my = m11 * dx + m12 * dy, m12 * dx + m22 * dy
            of_w = mx * dx + my * dy
            if kx * dx + ky * dy <= 0 or of_w <= squares[i]: return False
            if last and last[0] * dx + last[1] * dy <= products[i - 1]: return False
            last = mx, my, of_w
            first = first or last
        return all(of_w > of_z and mx * (plane.x[z] - wx) + my * (plane.y[z] - wy) > 0
                   for (mx, my, of_w), z, of_z in ((first, x, on_x), (last, y, on_y)))
# ---- The question -----------------------------------------------------------------------------------
def check_tolerance(asked, own, tolerance):
    # "No length differs by more than the factor e^T: c A - M and c M - A are nowhere negative, for the tensors A
    # asked for and M that the stars are of, and a fraction c of at most e^2T."
    total = series(STEPS, lambda k: Fraction(2 * min(tolerance, 1000)) / k)
    need(len(asked) == len(own), "the metric asked for is of another number of vertices")
    power = power_of(entry for tensors in (asked, own) for tensor in tensors for entry in tensor)
    for v, pair in enumerate(zip(asked, own)):
        one_way, other = ([scaled(entry, power) for entry in tensor] for tensor in pair)
        for a, b in ((one_way, other), (other, one_way)):
            m11, m12, m22 = (total * p - STEPS * q for p, q in zip(a, b))
            need(m11 >= 0 and m22 >= 0 and m11 * m22 >= m12 * m12,
                 f"the metric of vertex {v + 1} is farther than the tolerance from the one asked for")
def check(mesh, proof, domain, angle_bound, metric, metric_tolerance=None, read=Domain, check_domain=check_domain):
    shape, subject = read(domain) if domain else None, read_medit(mesh)
    need_file(metric.endswith(".sol"), f"{metric}: only a .sol file can be checked; 'asterism convert "
              "MESH ASKED.mesh --metric METRIC' writes a metric at the vertices as ASKED.sol")
    asked = tensors = read_medit(metric).get("SolAtVertices", [])
    if metric_tolerance is not None: tensors = read_medit(mesh.removesuffix(".mesh") + ".sol").get("SolAtVertices", [])
    witnesses = Proof(proof)
    plane = Plane(subject, tensors, witnesses)
    check_faces(plane, shape, witnesses)
    if shape: check_domain(plane, shape)
    if angle_bound > 0: Angles(plane, len(shape.points) if shape else plane.count + 1, angle_bound)
    # Theorem 5: "If all sites have one metric, nothing else is to be asked."
    gaps = None if have_one_metric(plane, *range(plane.count)) else Gaps(plane, witnesses)
    check_neighbours(plane, witnesses, gaps)
    if gaps: gaps.check()
    if metric_tolerance is not None: check_tolerance(asked, tensors, metric_tolerance)
    return plane
def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("mesh", help="a Medit file in text")
    parser.add_argument("proof", help="what asterism wrote for --proof")
    parser.add_argument("--domain", help="a .poly file (default: what the mesh's boundary encloses)")
    parser.add_argument("--angle-bound", type=Fraction, required=True, help="degrees, below 90")
    parser.add_argument("--metric", required=True, help="a .sol file, of m11 m12 m22 a vertex")
    parser.add_argument("--metric-tolerance", type=float, help="of the metric beside the mesh")
    asked = parser.parse_args()
    gc.disable()    # nothing is cyclic here; looking for it takes longer the more there is
    try:
        need_file(0 <= asked.angle_bound < 90 and 0 <= (asked.metric_tolerance or 0) < math.inf,
                  "--angle-bound is not from 0 to 90, or --metric-tolerance not from 0 on")
        plane = check(**vars(asked))
    except NotProved as refusal:
        return print(f"NOT proved: {refusal}") or 1
    except (CannotSay, OSError, ValueError, LookupError, StopIteration) as failure:
        return print(f"check_mesh.py: {str(failure) or 'a file ends early'}", file=sys.stderr) or 2
    within = "" if asked.metric_tolerance is None else f", within a tolerance of {asked.metric_tolerance:g}"
    return print(f"proved: {plane.count} sites, {len(plane.inner)} triangles, no angle below "
          f"{float(asked.angle_bound):g} degrees but the domain's own; domain "
          f"{asked.domain or 'as the boundary encloses it'}; metric {asked.metric}{within}") or 0
if __name__ == "__main__":
    sys.exit(main())
