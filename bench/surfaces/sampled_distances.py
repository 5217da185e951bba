# SPDX-License-Identifier: MIT
"""Samples the greatest distances between a surface and its mesh, in doubles, from the certificate beside the mesh,
for comparison with the proved bound. Shares no code with the command."""
import json

import numpy as np

COARSE, FINE = 10, 140  # divisions n of a triangle's sides; it has (n + 1) (n + 2) / 2 samples: 66, and 10,011
NEAR = 0.95  # triangles from this part of the greatest coarse distance on are sampled finely


def basis(knots, degree, x):
    """Returns values and derivatives of the B-splines, (n, count) each, by the recursion of de Boor and Cox."""
    knots = np.asarray(knots, float)
    count = len(knots) - degree - 1
    span = np.clip(np.searchsorted(knots, x, side="right") - 1, degree, count - 1)
    values = np.zeros((len(x), len(knots) - 1))
    values[np.arange(len(x)), span] = 1
    before = values
    for d in range(1, degree + 1):
        before = values
        values = np.zeros_like(before)
        for i in range(len(knots) - 1 - d):
            left, right = knots[i + d] - knots[i], knots[i + d + 1] - knots[i + 1]
            if left > 0:
                values[:, i] += (x - knots[i]) / left * before[:, i]
            if right > 0:
                values[:, i] += (knots[i + d + 1] - x) / right * before[:, i + 1]
    slopes = np.zeros((len(x), count))
    for i in range(count):
        left, right = knots[i + degree] - knots[i], knots[i + degree + 1] - knots[i + 1]
        if left > 0:
            slopes[:, i] += degree / left * before[:, i]
        if right > 0:
            slopes[:, i] -= degree / right * before[:, i + 1]
    return values[:, :count], slopes


class Patch:
    def __init__(self, of):
        self.degree = of["degree"]
        control = np.array(of["control"], float)
        weights = np.array(of.get("weights", np.ones(control.shape[:2])), float)
        self.net = np.concatenate([control * weights[..., None], weights[..., None]], axis=2)
        self.knots = [of.get(name) or [0] * (d + 1) + [1] * (d + 1)
                      for name, d in zip(("knots_u", "knots_v"), self.degree)]

    def jet(self, uv):
        """Returns points and both derivatives, (n, 3) each."""
        (bu, du), (bv, dv) = (basis(k, d, uv[:, n]) for n, (k, d) in enumerate(zip(self.knots, self.degree)))
        at, by_u, by_v = (np.einsum("ni,nj,ijc->nc", a, b, self.net, optimize=True)
                          for a, b in ((bu, bv), (du, bv), (bu, dv)))
        p = at[:, :3] / at[:, 3:]
        return p, (by_u[:, :3] - by_u[:, 3:] * p) / at[:, 3:], (by_v[:, :3] - by_v[:, 3:] * p) / at[:, 3:]

    def distance(self, q, uv):
        """Returns distances of points from the patch, by the Gauss-Newton method from parameters nearby."""
        low = np.array([k[0] for k in self.knots], float)
        high = np.array([k[-1] for k in self.knots], float)
        found = np.full(len(q), np.inf)
        for _ in range(8):
            p, u, v = self.jet(uv)
            found = np.minimum(found, np.linalg.norm(q - p, axis=1))
            e, f, g = (np.sum(a * b, axis=1) for a, b in ((u, u), (u, v), (v, v)))
            a, b = np.sum((q - p) * u, axis=1), np.sum((q - p) * v, axis=1)
            det = np.maximum(e * g - f * f, 1e-300)
            step = np.stack([(g * a - f * b) / det, (e * b - f * a) / det], axis=1)
            # On a side of the patch steps across the side are held: only the other parameter moves.
            held = ((uv <= low) & (step < 0)) | ((uv >= high) & (step > 0))
            alone = np.stack([a / np.maximum(e, 1e-300), b / np.maximum(g, 1e-300)], axis=1)
            step = np.where(held, 0, np.where(held[:, ::-1], alone, step))
            uv = np.clip(uv + step, low, high)
        return found


def distance_from_triangles(p, a, b, c):
    """Returns distances of points from triangles, one each."""
    def dot(x, y):
        return np.sum(x * y, axis=-1)

    def to_segment(x, y):
        e = y - x
        s = np.clip(dot(p - x, e) / np.maximum(dot(e, e), 1e-300), 0, 1)[..., None]
        return np.linalg.norm(p - x - s * e, axis=-1)
    n = np.cross(b - a, c - a)
    inside = (dot(n, n) > 0)
    for x, y in ((a, b), (b, c), (c, a)):
        inside = inside & (dot(np.cross(y - x, p - x), n) >= 0)
    height = np.abs(dot(p - a, n)) / np.sqrt(np.maximum(dot(n, n), 1e-300))
    edges = np.minimum(np.minimum(to_segment(a, b), to_segment(b, c)), to_segment(c, a))
    return np.where(inside, height, edges)


def shares(n):
    return np.array([[i / n, j / n, (n - i - j) / n] for i in range(n + 1) for j in range(n + 1 - i)])


class Sampling:
    """A shell, from its certificate and the vertices of its .mesh file."""

    def __init__(self, certificate, mesh):
        claim = json.loads(open(certificate).read())
        lines = open(mesh).read().split("\n")
        first = lines.index("Vertices") + 2
        points = np.array([list(map(float, line.split()[:3]))
                           for line in lines[first:first + int(lines[first - 1])]])
        self.patches = [Patch(of) for of in claim["surface"]["patches"]]
        self.uv, self.space, self.patch = [], [], []
        for face in claim["faces"]:
            sites = np.array(face["sites"])
            t = np.array(face["triangles"]) - 1
            vertex = sites[:, 5].astype(int) - 1
            self.uv.append((sites[:, :2] * 2.0 ** -np.array(face["scale"]))[t])
            self.space.append(points[vertex][t])
            self.patch += [face["patch"] - 1] * len(t)
        self.uv, self.space, self.patch = np.concatenate(self.uv), np.concatenate(self.space), np.array(self.patch)

    def own(self, which, n):
        """Returns distances of these triangles' samples, (t, samples): of the surface's points from their triangle,
        and of the triangle's points from the surface. Also returns the former points."""
        weights = shares(n)
        uv = np.einsum("sk,tkd->tsd", weights, self.uv[which])
        flat = np.einsum("sk,tkd->tsd", weights, self.space[which])
        to_mesh, to_surface = np.zeros(uv.shape[:2]), np.zeros(uv.shape[:2])
        on = np.zeros(flat.shape)
        for patch in np.unique(self.patch[which]):
            own = np.flatnonzero(self.patch[which] == patch)
            of = self.patches[patch]
            p = of.jet(uv[own].reshape(-1, 2))[0].reshape(len(own), -1, 3)
            corners = self.space[which][own]
            on[own] = p
            to_mesh[own] = distance_from_triangles(p, *(corners[:, k][:, None] for k in range(3)))
            to_surface[own] = of.distance(flat[own].reshape(-1, 3), uv[own].reshape(-1, 2)).reshape(len(own), -1)
        return to_mesh, to_surface, on

    def from_all(self, points, most):
        """Returns the greatest distance of these points from the whole mesh; `most` are their distances from one
        triangle of it."""
        best = 0
        for k in np.argsort(-most):
            if most[k] <= best:
                break
            best = max(best, distance_from_triangles(points[k][None], *(self.space[:, n] for n in range(3))).min())
        return best

    def greatest(self):
        """Returns the greatest distance of the surface's points from the mesh, and of the mesh's points from the
        surface."""
        every = np.arange(len(self.uv))
        coarse = [np.concatenate(x) for x in zip(*(self.own(some, COARSE)[:2] for some in np.array_split(
            every, max(1, len(every) // 500))))]
        found = [0.0, 0.0]
        for way in range(2):
            of = coarse[way].max(axis=1)
            for t in every[of >= NEAR * of.max()]:
                to_mesh, to_surface, on = self.own(np.array([t]), FINE)
                one = to_surface.max() if way else (
                    self.from_all(on[0], to_mesh[0]) if to_mesh.max() > found[0] else 0)
                found[way] = max(found[way], one)
        return found
