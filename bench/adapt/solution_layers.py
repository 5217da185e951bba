# SPDX-License-Identifier: MIT
"""Loops of Galerkin's method of degree 1, without stabilisation, for solutions with straight and curved layers: error
of the solution in the mean square times vertices, the geometric mean of the last passes, for several bounds on aspects.

  solution_layers.py [--problems NAME...] [--aspects A...] [--vertices N...] [--passes N] [--last N]

An aspect of 0 stands for none that is named, so that the solution's own layers bound it, and 1e5 for no bound. Run with
the Python package on the path. The tables are in docs/results/adaptation.md.
"""
import argparse
import pathlib
import sys
import warnings

import numpy as np
from scipy.sparse.linalg import spsolve

import asterism

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "solver_loops"))
import elements  # noqa: E402
from two_layers import PLACES, WEIGHTS, parts_of_a_triangle  # noqa: E402

SIDES = ("left", "right", "bottom", "top")


def boundary_layer(e):
    """Returns a function of t with a layer of thickness e at 1, which returns value, slope and second derivative."""
    def profile(t):
        rise, whole = np.exp((t - 1) / e), 1 - np.exp(-1 / e)
        return t - (rise - np.exp(-1 / e)) / whole, 1 - rise / e / whole, -rise / e / e / whole
    return profile


def one_layer(e):
    def jet(x, _):
        value, slope, second = boundary_layer(e)(x)
        return value, slope, 0 * x, second, 0 * x
    return jet


def two_layers(e):
    def jet(x, y):
        (a, b, c), (d, f, g) = boundary_layer(e)(x), boundary_layer(e)(y)
        return a * d, b * d, a * f, c * d, a * g
    return jet


def front(steepness, distance):
    """Returns tanh(steepness s), where distance(x, y) returns s, s_x, s_y, s_xx and s_yy."""
    def jet(x, y):
        s, sx, sy, sxx, syy = (part + 0 * x for part in distance(x, y))
        t, k = np.tanh(steepness * s), steepness
        d = 1 - t * t
        return (t, k * sx * d, k * sy * d, k * sxx * d - 2 * k * k * sx * sx * t * d,
                k * syy * d - 2 * k * k * sy * sy * t * d)
    return jet


class Problem:
    """-diffusion lap u + wind . grad u + reaction u = f on a square from `low` to 1, with u given on some sides.
    jet(x, y) returns u, u_x, u_y, u_xx and u_yy."""

    def __init__(self, jet, diffusion=1.0, wind=(0, 0), reaction=0.0, low=0.0, given=SIDES):
        self.jet, self.diffusion, self.wind, self.reaction = jet, diffusion, np.array(wind), reaction
        self.low, self.given = low, given

    def start(self):
        points, triangles = elements.grid(20, 20, 1, 1)
        return asterism.Mesh(self.low + (1 - self.low) * points, triangles)

    def force(self, x, y):
        u, ux, uy, uxx, uyy = self.jet(x, y)
        return -self.diffusion * (uxx + uyy) + self.wind[0] * ux + self.wind[1] * uy + self.reaction * u

    def is_given(self, points):
        x, y = points.T
        on = {"left": x <= self.low, "right": x >= 1, "bottom": y <= self.low, "top": y >= 1}
        return np.any([on[side] for side in self.given], axis=0)

    def solve(self, points, triangles):
        areas, gradients = elements.shapes(points, triangles)
        blocks = (self.diffusion * np.einsum("tid,tjd->tij", gradients, gradients) * areas[:, None, None]
                  + self.reaction * areas[:, None, None] / 12 * (np.ones((3, 3)) + np.eye(3))
                  + (areas / 3)[:, None, None] * (gradients @ self.wind)[:, None, :])
        matrix = elements.assembled(triangles, blocks, len(points))
        loads = 0
        for part in parts_of_a_triangle(2):
            places = PLACES @ part
            x, y = np.einsum("qi,tid->dtq", places, points[triangles])
            loads = loads + np.einsum("q,tq,qi->ti", WEIGHTS, self.force(x, y), places) * areas[:, None] / 4
        right = np.bincount(triangles.ravel(), loads.ravel(), len(points))
        given = self.is_given(points)
        values = np.where(given, self.jet(*points.T)[0], 0.0)
        right -= matrix @ values
        values[~given] = spsolve(matrix[~given][:, ~given].tocsc(), right[~given])
        return values

    def error(self, points, triangles, values):
        """Integrates by seven points in each of sixteen parts of a triangle."""
        areas, _ = elements.shapes(points, triangles)
        total = 0.0
        for part in parts_of_a_triangle(4):
            places = PLACES @ part
            x, y = np.einsum("qi,tid->dtq", places, points[triangles])
            off = np.einsum("qi,ti->tq", places, values[triangles]) - self.jet(x, y)[0]
            total += float(areas @ (off ** 2 @ WEIGHTS)) / 16
        return np.sqrt(total)


def parabola(x, y):
    return x - y * y, 1, -2 * y, 0, -2


def oblique(x, y):
    return x - 0.3 * y - 0.1, 1, -0.3, 0, 0


def sine(x, y):
    return y - 0.3 * np.sin(3 * x), -0.9 * np.cos(3 * x), 1, 2.7 * np.sin(3 * x), 0


def circle(x, y):
    r = np.hypot(x, y) + 1e-12
    return r - 0.6, x / r, y / r, y * y / r ** 3, x * x / r ** 3


PROBLEMS = {
    "one layer, advection, 0.01": Problem(one_layer(0.01), 0.01, (1, 0), given=("left", "right")),
    "one layer, advection, 0.001": Problem(one_layer(0.001), 0.001, (1, 0), given=("left", "right")),
    "one layer, reaction, 0.01": Problem(one_layer(0.01), 1e-4, reaction=1, given=("left", "right")),
    "one layer, Poisson, 0.01": Problem(one_layer(0.01), given=("left", "right")),
    "two layers, advection, 0.03": Problem(two_layers(0.03), 0.03, (1, 1)),
    "two layers, advection, 0.01": Problem(two_layers(0.01), 0.01, (1, 1)),
    "two layers, advection, 0.001": Problem(two_layers(0.001), 0.001, (1, 1)),
    "two layers, reaction, 0.03": Problem(two_layers(0.03), 9e-4, reaction=1),
    "two layers, reaction, 0.01": Problem(two_layers(0.01), 1e-4, reaction=1),
    "two layers, Poisson, 0.01": Problem(two_layers(0.01)),
    "front on a line, Poisson": Problem(front(40, oblique), low=-1.0),
    "front on a parabola, Poisson": Problem(front(40, parabola), low=-1.0),
    "front on a sine, Poisson": Problem(front(40, sine), low=-1.0),
    "front on a sine, reaction": Problem(front(40, sine), 1e-3, reaction=1, low=-1.0),
    "front on a circle, Poisson": Problem(front(40, circle), low=-1.0),
}


def loop(problem, vertices, aspect, options):
    """Returns the geometric mean of error times vertices over the last passes."""
    mesh, found = problem.start(), []
    for number in range(options.passes + 1):
        points, triangles = np.asarray(mesh.points), np.asarray(mesh.triangles)
        values = problem.solve(points, triangles)
        found.append(len(points) * problem.error(points, triangles, values))
        if number < options.passes:
            mesh = asterism.adapt(mesh, values, vertices=vertices, aspect=aspect or None).mesh
    return np.exp(np.mean(np.log(found[-options.last:])))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--problems", nargs="+", choices=list(PROBLEMS), default=list(PROBLEMS))
    parser.add_argument("--aspects", nargs="+", type=float, default=[0, 7, 10, 14, 20, 30, 60, 1e5])
    parser.add_argument("--vertices", nargs="+", type=int, default=[400, 800, 1600])
    parser.add_argument("--passes", type=int, default=9)
    parser.add_argument("--last", type=int, default=5)
    options = parser.parse_args()
    warnings.simplefilter("ignore")  # of targets not met
    names = ["by the layers" if a == 0 else "none" if a >= 1e5 else f"{a:g}" for a in options.aspects]
    print(f"| problem | vertices | {' | '.join(names)} |\n|---|---|{'---|' * len(names)}", flush=True)
    for name in options.problems:
        for vertices in options.vertices:
            row = [f"{loop(PROBLEMS[name], vertices, a, options):.3g}" for a in options.aspects]
            print(f"| {name} | {vertices} | {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()
