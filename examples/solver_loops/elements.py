# SPDX-License-Identifier: MIT
"""Linear elements on triangles, in numpy and scipy, for the loops beside this file."""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

# Radon's seven points, exact to the fifth degree: barycentric coordinates and weights.
ROOT = np.sqrt(15.0)
PLACES = np.array([[1 / 3] * 3] + [np.roll([1 - 2 * b, b, b], k) for b in ((6 + ROOT) / 21, (6 - ROOT) / 21)
                                   for k in range(3)])
WEIGHTS = np.array([9 / 40] + [(155 + ROOT) / 1200] * 3 + [(155 - ROOT) / 1200] * 3)


def grid(columns, rows, width, height, holds=lambda x, y: True):
    """Returns points and triangles of a grid over [0, width] x [0, height]. Keeps cells for whose middle `holds` is
    true. Diagonals alternate."""
    x, y = np.linspace(0, width, columns + 1), np.linspace(0, height, rows + 1)
    triangles = []
    for j in range(rows):
        for i in range(columns):
            if not holds((x[i] + x[i + 1]) / 2, (y[j] + y[j + 1]) / 2):
                continue
            a = j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    used, numbers = np.unique(triangles, return_inverse=True)
    points = np.array([(p, q) for q in y for p in x])[used]
    return points, numbers.reshape(-1, 3)


def shapes(points, triangles):
    """Returns areas (n,) and the gradients of the three hat functions (n, 3, 2)."""
    corners = points[triangles]
    across = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    doubled = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return doubled / 2, np.stack([-across[..., 1], across[..., 0]], axis=-1) / doubled[:, None, None]


def assembled(triangles, blocks, count):
    """Returns the sparse matrix of a 3 by 3 block for each triangle."""
    rows, columns = np.repeat(triangles, 3, axis=1), np.tile(triangles, (1, 3))
    return sparse.csr_matrix((blocks.ravel(), (rows.ravel(), columns.ravel())), (count, count))


def stiffness(points, triangles):
    areas, gradients = shapes(points, triangles)
    blocks = np.einsum("tid,tjd->tij", gradients, gradients) * areas[:, None, None]
    return assembled(triangles, blocks, len(points))


def parts_of_a_triangle(n):
    """Yields the corners of n^2 equal parts, in barycentric coordinates."""
    def at(i, j):
        return (1 - (i + j) / n, i / n, j / n)
    for i in range(n):
        for j in range(n - i):
            yield np.array([at(i, j), at(i + 1, j), at(i, j + 1)])
            if i + j < n - 1:
                yield np.array([at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)])


def solve(points, triangles, force, given, diffusion=1.0, wind=(0, 0), reaction=0.0, parts=1):
    """Returns the solution of -diffusion lap u + wind . grad u + reaction u = force(x, y) by Galerkin's method, without
    stabilisation. `given` has u where it is given, and no number elsewhere. The load is integrated by seven points in
    each of parts^2 parts of a triangle."""
    areas, gradients = shapes(points, triangles)
    blocks = (diffusion * (np.einsum("tid,tjd->tij", gradients, gradients) * areas[:, None, None])
              + reaction * (areas[:, None, None] / 12 * (np.ones((3, 3)) + np.eye(3)))
              + (areas / 3)[:, None, None] * (gradients @ np.array(wind))[:, None, :])
    matrix = assembled(triangles, blocks, len(points))
    loads = np.zeros((len(triangles), 3))
    for part in parts_of_a_triangle(parts):
        places = PLACES @ part
        x, y = np.einsum("qi,tid->dtq", places, points[triangles])
        loads += np.einsum("q,tq,qi->ti", WEIGHTS, force(x, y), places) * areas[:, None] / parts ** 2
    free = np.isnan(given)
    values = np.where(free, 0.0, given)
    right = np.bincount(triangles.ravel(), loads.ravel(), len(points)) - matrix @ values
    values[free] = spsolve(matrix[free][:, free].tocsc(), right[free])
    return values


def error(points, triangles, values, exact):
    """Returns the root of the integral of the squared difference between the values and exact(x, y), by seven points in
    each of sixteen parts of a triangle."""
    areas, _ = shapes(points, triangles)
    total = 0.0
    for part in parts_of_a_triangle(4):
        places = PLACES @ part
        x, y = np.einsum("qi,tid->dtq", places, points[triangles])
        off = np.einsum("qi,ti->tq", places, values[triangles]) - exact(x, y)
        total += float(areas @ (off ** 2 @ WEIGHTS)) / 16
    return np.sqrt(total)


def nodal_areas(points, triangles):
    """Returns the lumped mass: a third of the area of the triangles around each point. The sum of values times it is
    the exact integral of the linear function through them."""
    areas, _ = shapes(points, triangles)
    return np.bincount(triangles.ravel(), np.repeat(areas / 3, 3), len(points))


def second_derivatives(points, triangles, values):
    """Returns weak second derivatives (n, 3) = xx xy yy at the points. At the boundary they are means over inner
    neighbours."""
    areas, gradients = shapes(points, triangles)
    slopes = np.einsum("tid,ti->td", gradients, values[triangles])
    parts = -np.einsum("t,tid,te->tide", areas, gradients, slopes)
    parts = np.stack([parts[..., 0, 0], (parts[..., 0, 1] + parts[..., 1, 0]) / 2, parts[..., 1, 1]], axis=-1)
    weight = nodal_areas(points, triangles)
    count = len(points)
    found = np.stack([np.bincount(triangles.ravel(), parts[..., k].ravel(), count) / weight for k in range(3)], axis=-1)
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, uses = np.unique(sides, axis=0, return_counts=True)
    known = np.ones(count, dtype=bool)
    known[edges[uses == 1].ravel()] = False
    joined = sparse.csr_matrix((np.ones(2 * len(edges)), (edges.ravel(), edges[:, ::-1].ravel())), (count, count))
    while not known.all():
        neighbours = joined @ known.astype(float)
        ready = ~known & (neighbours > 0)
        if not ready.any():
            break
        found[ready] = (joined @ (found * known[:, None]))[ready] / neighbours[ready, None]
        known |= ready
    return found


def picture(path, points, triangles, values, title, window=None):
    """Draws the values and the mesh beside each other, or above each other where the domain is wide."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    low, high = points.min(axis=0), points.max(axis=0)
    is_wide = (high - low)[0] > 1.5 * (high - low)[1]
    figure, axes = pyplot.subplots(*((2, 1) if is_wide else (1, 2)), figsize=(9, 6) if is_wide else (9, 4.6))
    axes[0].tripcolor(*points.T, triangles, values, shading="gouraud", cmap="viridis")
    axes[1].triplot(*points.T, triangles, linewidth=0.3, color="black")
    for each in axes:
        each.set_aspect("equal")
        each.set_axis_off()
        if window is not None:
            each.set_xlim(*window[:2])
            each.set_ylim(*window[2:])
    axes[0].set_title(title, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=110, bbox_inches="tight")  # the title lies above the axes, where a figure is cut off
    pyplot.close(figure)
