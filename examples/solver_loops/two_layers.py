# SPDX-License-Identifier: MIT
"""Two layers on the unit square, by Galerkin's method without stabilisation, and its true error from pass to pass.

  u = g(x) g(y), g(t) = t - (exp((t-1)/e) - exp(-1/e)) / (1 - exp(-1/e)), which is 0 on the sides
  advection: -e lap u + u_x + u_y = g(x) + g(y)
  reaction:  -e^2 lap u + u = f

  two_layers.py [--thickness E] [--equation advection|reaction] [--vertices N] [--passes N] [--aspect A]
                [--from solution|values|derivatives]

--from: what the metric is made of: the solution, u at the vertices, or u's own second derivatives. Printed are
errors in the mean square: of the solution, and of linear interpolation on the same mesh. With --aspect 1e5, that is
without a bound, the first grows while the second falls, whatever the metric is made of (docs/results/adaptation.md).
"""
import argparse

import elements
import numpy as np
from scipy.sparse.linalg import spsolve

import asterism

# Radon's seven points, exact to the fifth degree: barycentric coordinates and weights.
ROOT = np.sqrt(15.0)
PLACES = np.array([[1 / 3] * 3] + [np.roll([1 - 2 * b, b, b], k) for b in ((6 + ROOT) / 21, (6 - ROOT) / 21)
                                   for k in range(3)])
WEIGHTS = np.array([9 / 40] + [(155 + ROOT) / 1200] * 3 + [(155 - ROOT) / 1200] * 3)


class Layers:
    def __init__(self, thickness, equation):
        self.e, self.equation = thickness, equation

    def profile(self, t):
        e = self.e
        return t - (np.exp((t - 1) / e) - np.exp(-1 / e)) / (1 - np.exp(-1 / e))

    def exact(self, x, y):
        return self.profile(x) * self.profile(y)

    def derivatives(self, x, y):
        """Returns xx, xy and yy of u. exp(-1/e) is neglected beside one."""
        rise = [np.exp((t - 1) / self.e) / self.e for t in (x, y)]
        return np.stack([-rise[0] / self.e * self.profile(y), (1 - rise[0]) * (1 - rise[1]),
                         -rise[1] / self.e * self.profile(x)], axis=1)

    def force(self, x, y):
        g, h = self.profile(x), self.profile(y)
        if self.equation == "advection":
            return g + h
        return np.exp((x - 1) / self.e) * h + g * np.exp((y - 1) / self.e) + g * h

    def solve(self, points, triangles):
        areas, gradients = elements.shapes(points, triangles)
        stiffness = np.einsum("tid,tjd->tij", gradients, gradients) * areas[:, None, None]
        if self.equation == "reaction":
            blocks = self.e ** 2 * stiffness + areas[:, None, None] / 12 * (np.ones((3, 3)) + np.eye(3))
        else:
            blocks = self.e * stiffness + (areas / 3)[:, None, None] * gradients.sum(axis=2)[:, None, :]
        matrix = elements.assembled(triangles, blocks, len(points))
        x, y = np.einsum("qi,tid->dtq", PLACES, points[triangles])
        parts = np.einsum("q,tq,qi->ti", WEIGHTS, self.force(x, y), PLACES) * areas[:, None]
        right = np.bincount(triangles.ravel(), parts.ravel(), len(points))
        inside = np.flatnonzero(((points > 0) & (points < 1)).all(axis=1))
        values = np.zeros(len(points))
        values[inside] = spsolve(matrix[inside][:, inside].tocsc(), right[inside])
        return values

    def error(self, points, triangles, values):
        """Integrates by the seven points in each of sixteen parts of a triangle."""
        areas, _ = elements.shapes(points, triangles)
        total = 0.0
        for part in parts_of_a_triangle(4):
            places = PLACES @ part
            x, y = np.einsum("qi,tid->dtq", places, points[triangles])
            off = np.einsum("qi,ti->tq", places, values[triangles]) - self.exact(x, y)
            total += float(areas @ (off ** 2 @ WEIGHTS)) / 16
        return np.sqrt(total)


def parts_of_a_triangle(n):
    """Yields the corners of n^2 equal parts, in barycentric coordinates."""
    def at(i, j):
        return (1 - (i + j) / n, i / n, j / n)
    for i in range(n):
        for j in range(n - i):
            yield np.array([at(i, j), at(i + 1, j), at(i, j + 1)])
            if i + j < n - 1:
                yield np.array([at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)])


def run(layers, vertices, passes, aspect, of):
    mesh, errors = asterism.Mesh(*elements.grid(20, 20, 1, 1)), []
    for number in range(passes + 1):
        points, triangles = mesh.points, mesh.triangles
        found, nodal = layers.solve(points, triangles), layers.exact(*points.T)
        errors.append(layers.error(points, triangles, found))
        print(f"pass {number}: {len(points)} vertices, error {errors[-1]:.3e}, of interpolation "
              f"{layers.error(points, triangles, nodal):.3e}", flush=True)
        if number < passes:
            wishes = {"vertices": vertices, "aspect": aspect}
            mesh = (asterism.adapt(mesh, hessian=layers.derivatives(*points.T), **wishes) if of == "derivatives"
                    else asterism.adapt(mesh, found if of == "solution" else nodal, **wishes)).mesh
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--thickness", type=float, default=1e-2)
    parser.add_argument("--equation", choices=("advection", "reaction"), default="advection")
    parser.add_argument("--vertices", type=int, default=2000)
    parser.add_argument("--passes", type=int, default=10)
    parser.add_argument("--aspect", type=float)
    parser.add_argument("--from", dest="of", choices=("solution", "values", "derivatives"), default="solution")
    options = parser.parse_args()
    layers = Layers(options.thickness, options.equation)
    errors = run(layers, options.vertices, options.passes, options.aspect, options.of)
    print(f"last {errors[-1]:.3e} least {min(errors):.3e} ratio {errors[-1] / min(errors):.3f}")


if __name__ == "__main__":
    main()
