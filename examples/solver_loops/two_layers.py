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

import asterism


def profile(t, e):
    """Returns g(t) with a layer of thickness e at 1, its slope and its second derivative."""
    rise, whole = np.exp((t - 1) / e), 1 - np.exp(-1 / e)
    return t - (rise - np.exp(-1 / e)) / whole, 1 - rise / e / whole, -rise / e / e / whole


class Layers:
    def __init__(self, thickness, equation):
        self.e, self.equation = thickness, equation

    def exact(self, x, y):
        return profile(x, self.e)[0] * profile(y, self.e)[0]

    def derivatives(self, x, y):
        """Returns xx, xy and yy of u."""
        (g, g_x, g_xx), (h, h_y, h_yy) = profile(x, self.e), profile(y, self.e)
        return np.stack([g_xx * h, g_x * h_y, g * h_yy], axis=1)

    def force(self, x, y):
        g, h = profile(x, self.e)[0], profile(y, self.e)[0]
        if self.equation == "advection":
            return g + h
        return np.exp((x - 1) / self.e) * h + g * np.exp((y - 1) / self.e) + g * h

    def solve(self, points, triangles):
        inside = ((points > 0) & (points < 1)).all(axis=1)
        terms = {"diffusion": self.e ** 2, "reaction": 1} if self.equation == "reaction" else {
            "diffusion": self.e, "wind": (1, 1)}
        return elements.solve(points, triangles, self.force, np.where(inside, np.nan, 0.0), **terms)

    def error(self, points, triangles, values):
        return elements.error(points, triangles, values, self.exact)


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
