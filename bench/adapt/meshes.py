# SPDX-License-Identifier: MIT
"""Meshes and metrics for the adaptation benchmark: files, L2-optimal metrics, interpolation error."""
import numpy as np


class Mesh:
    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles

    def areas(self):
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def grid(n):
    """Returns n by n squares on [-1,1]^2, each cut in two, with diagonals in alternating directions."""
    s = np.linspace(-1, 1, n + 1)
    points = np.array([(x, y) for y in s for x in s])
    triangles = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    return Mesh(points, np.array(triangles))


def read(path):
    """Returns vertices and triangles of a .mesh file."""
    words = path.read_text(encoding="utf-8").split()
    points = triangles = None
    i = 0
    while i < len(words):
        if words[i] == "Vertices":
            n = int(words[i + 1])
            table = np.array(words[i + 2:i + 2 + 3 * n], dtype=float).reshape(n, 3)
            points, i = table[:, :2], i + 2 + 3 * n
        elif words[i] == "Triangles":
            n = int(words[i + 1])
            table = np.array(words[i + 2:i + 2 + 4 * n], dtype=np.int64).reshape(n, 4)
            triangles, i = table[:, :3] - 1, i + 2 + 4 * n
        else:
            i += 1
    return Mesh(points, triangles)


def border(mesh):
    """Returns the edges on the square's boundary, as pairs of vertices, by the number of the side from 1 to 4."""
    t = mesh.triangles
    edges = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    keys = np.sort(edges, axis=1)
    _, first, count = np.unique(keys, axis=0, return_index=True, return_counts=True)
    found = edges[first[count == 1]]
    middle = mesh.points[found].mean(axis=1)
    distance = np.stack([middle[:, 1] + 1, 1 - middle[:, 0], 1 - middle[:, 1], middle[:, 0] + 1])
    return found, np.argmin(distance, axis=0) + 1


def write(path, mesh):
    """Writes the mesh with boundary edges and corners, which BAMG needs of a background mesh."""
    edges, sides = border(mesh)
    corners = [int(np.argmin(np.hypot(*(mesh.points - c).T)))
               for c in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"MeshVersionFormatted 1\nDimension\n2\nVertices\n{len(mesh.points)}\n")
        out.writelines(f"{x:.17g} {y:.17g} 0\n" for x, y in mesh.points)
        out.write(f"Edges\n{len(edges)}\n")
        out.writelines(f"{a + 1} {b + 1} {s}\n" for (a, b), s in zip(edges, sides))
        out.write(f"Triangles\n{len(mesh.triangles)}\n")
        out.writelines(f"{a + 1} {b + 1} {c + 1} 1\n" for a, b, c in mesh.triangles)
        out.write("Corners\n4\n" + "".join(f"{c + 1}\n" for c in corners))
        out.write("End\n")


def write_mtr(path, tensors):
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"{len(tensors)} 3\n")
        out.writelines(f"{m[0, 0]:.17g} {m[0, 1]:.17g} {m[1, 1]:.17g}\n" for m in tensors)


def write_sol(path, tensors):
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(tensors)}\n1 3\n")
        out.writelines(f"{m[0, 0]:.17g} {m[0, 1]:.17g} {m[1, 1]:.17g}\n" for m in tensors)
        out.write("End\n")


def read_sol(path):
    """Returns the tensors of a metric as text."""
    words = path.read_text(encoding="utf-8").split()
    at = words.index("SolAtVertices") + 1
    a, b, c = np.array(words[at + 3:at + 3 + 3 * int(words[at])], dtype=float).reshape(-1, 3).T
    return np.stack([np.stack([a, b], -1), np.stack([b, c], -1)], -2)


def node_areas(mesh):
    shares = np.zeros(len(mesh.points))
    for i in range(3):
        np.add.at(shares, mesh.triangles[:, i], mesh.areas() / 3)
    return shares


def l2_metric(mesh, hessians, vertices, longest=1.0, widest=1000.0):
    """Returns the metric of least L2 error (Loseille, Alauzet 2011), with a complexity of 2 / sqrt 3 for each of the
    vertices wanted. Eigenvalues are at least 1e-8 of the greatest, aspects at most `widest`, edges at most `longest`.
    Bisection finds the factor with which these bounds give the complexity."""
    values, vectors = np.linalg.eigh(hessians)
    values = np.abs(values)
    values = np.maximum(values, 1e-8 * values.max())
    values = np.maximum(values, values.max(axis=1, keepdims=True) / widest**2)
    values *= (values[:, 0] * values[:, 1])[:, None] ** (-1 / 6)
    area, wanted = node_areas(mesh), vertices * np.sqrt(3) / 2

    def bounded(log_factor):
        return np.maximum(values * np.exp(log_factor), longest**-2)

    low, high = -60.0, 60.0
    for _ in range(80):
        middle = (low + high) / 2
        if (area * np.sqrt(bounded(middle).prod(axis=1))).sum() > wanted:
            high = middle
        else:
            low = middle
    return np.einsum("nij,nj,nkj->nik", vectors, bounded(low), vectors)


def recovered_hessians(mesh, values):
    """Returns the Hessian of the piecewise linear function: gradients averaged at the vertices by area, twice."""
    def gradients(u):
        a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
        ua, ub, uc = (u[mesh.triangles[:, i]] for i in range(3))
        twice = 2 * mesh.areas()
        e, f = b - a, c - a
        gx = ((ub - ua) * f[:, 1] - (uc - ua) * e[:, 1]) / twice
        gy = ((uc - ua) * e[:, 0] - (ub - ua) * f[:, 0]) / twice
        sums = np.zeros((len(u), 2))
        for i in range(3):
            np.add.at(sums, mesh.triangles[:, i], (np.stack([gx, gy], -1) * twice[:, None]) / 6)
        return sums / node_areas(mesh)[:, None]

    g = gradients(values)
    hx, hy = gradients(g[:, 0]), gradients(g[:, 1])
    xy = (hx[:, 1] + hy[:, 0]) / 2
    return np.stack([np.stack([hx[:, 0], xy], -1), np.stack([xy, hy[:, 1]], -1)], -2)


def l2_error(mesh, function, order=6):
    """Returns the error of linear interpolation, by a product rule of order^2 points in each triangle."""
    nodes, weights = np.polynomial.legendre.leggauss(order)
    nodes, weights = (nodes + 1) / 2, weights / 2
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    ua, ub, uc = (function(p) for p in (a, b, c))
    total = np.zeros(len(a))
    for s, ws in zip(nodes, weights):
        for t, wt in zip(nodes, weights):
            lb, lc = s * (1 - t), s * t
            p = a + lb * (b - a) + lc * (c - a)
            difference = function(p) - (ua + lb * (ub - ua) + lc * (uc - ua))
            total += ws * wt * s * difference**2
    return float(np.sqrt((2 * np.abs(mesh.areas()) * total).sum()))


def angles_in(mesh, tensors):
    """Returns the least angle of each triangle, in degrees, over its corners and the metrics of all three
    vertices."""
    least = np.full(len(mesh.triangles), 180.0)
    p = [mesh.points[mesh.triangles[:, i]] for i in range(3)]
    for k in range(3):
        m = tensors[mesh.triangles[:, k]]
        root = np.sqrt(np.linalg.det(m))
        for i in range(3):
            e, f = p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]
            dot = np.einsum("ni,nij,nj->n", e, m, f)
            cross = (e[:, 0] * f[:, 1] - e[:, 1] * f[:, 0]) * root
            least = np.minimum(least, np.degrees(np.arctan2(cross, dot)))
    return least
