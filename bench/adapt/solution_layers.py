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

import asterism

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "solver_loops"))
import elements  # noqa: E402
from two_layers import profile  # noqa: E402

SIDES = ("left", "right", "bottom", "top")


def one_layer(e):
    def jet(x, _):
        value, slope, second = profile(x, e)
        return value, slope, 0 * x, second, 0 * x
    return jet


def two_layers(e):
    def jet(x, y):
        (a, b, c), (d, f, g) = profile(x, e), profile(y, e)
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
        self.jet, self.diffusion, self.wind, self.reaction = jet, diffusion, wind, reaction
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
        given = np.where(self.is_given(points), self.jet(*points.T)[0], np.nan)
        return elements.solve(points, triangles, self.force, given, self.diffusion, self.wind, self.reaction, parts=2)

    def error(self, points, triangles, values):
        return elements.error(points, triangles, values, lambda x, y: self.jet(x, y)[0])


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
