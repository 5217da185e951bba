# SPDX-License-Identifier: MIT
"""Gray and Scott's reaction and diffusion of two substances, with a new mesh after each stretch of time. Transfers
keep the integral of each substance.

  u' = D_u lap u - u v^2 + F (1 - u),   v' = D_v lap v + u v^2 - (F + k) v   on the unit square, no flux

  gray_scott.py [--adaptations N] [--vertices N] [--steps N] [--picture OUT.png]

Linear elements with lumped mass; steps of one unit of time, diffusion implicit, reaction explicit. A mesh is made
of both fields after every --steps steps, `bounded` from mesh to mesh: integrals stay, and no new extrema come.
"""
import argparse

import elements
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

import asterism

SPREAD_U, SPREAD_V, FEED, KILL = 2e-5, 1e-5, 0.037, 0.06


def at_start(points):
    """Returns the initial state: a slightly rotated square of the second substance in the middle of the first."""
    x, y = (points - 0.5).T
    inside = 0.5 * (1 - np.tanh(60 * (np.maximum(np.abs(x + 0.2 * y), np.abs(y - 0.2 * x)) - 0.1)))
    return 1 - 0.5 * inside, 0.25 * inside


def stretch(points, triangles, u, v, steps):
    """Advances by `steps` units of time."""
    mass = elements.nodal_areas(points, triangles)
    stiff = elements.stiffness(points, triangles)
    solve_u, solve_v = (splu((sparse.diags(mass) + d * stiff).tocsc()).solve for d in (SPREAD_U, SPREAD_V))
    for _ in range(steps):
        made = u * v * v
        u, v = solve_u(mass * (u - made + FEED * (1 - u))), solve_v(mass * (v + made - (FEED + KILL) * v))
    return u, v


def integrals(mesh, fields):
    return {name: float(elements.nodal_areas(mesh.points, mesh.triangles) @ f) for name, f in fields.items()}


def run(adaptations, vertices, steps):
    """Returns the last mesh and fields, and the greatest change of an integral by a transfer."""
    mesh = asterism.Mesh(*elements.grid(48, 48, 1, 1))
    for _ in range(3):  # the first mesh
        mesh = asterism.adapt(mesh, dict(zip("uv", at_start(mesh.points))), vertices=vertices).mesh
    fields, drift = dict(zip("uv", at_start(mesh.points))), 0.0
    for number in range(adaptations):
        fields = dict(zip("uv", stretch(mesh.points, mesh.triangles, fields["u"], fields["v"], steps)))
        before = integrals(mesh, fields)
        mesh, fields = asterism.adapt(mesh, fields, vertices=vertices, how="bounded", keep="never")
        after = integrals(mesh, fields)
        drift = max([drift] + [abs(after[k] / before[k] - 1) for k in before])
        if not mesh.certified:
            raise SystemExit(f"adaptation {number + 1}: the mesh is not certified")
        print(f"adaptation {number + 1}: {len(mesh.points)} vertices, u from {fields['u'].min():.4f} to "
              f"{fields['u'].max():.4f}, {after['v']:.6f} of v", flush=True)
    return mesh, fields, drift


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--adaptations", type=int, default=30)
    parser.add_argument("--vertices", type=int, default=2500)
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--picture")
    options = parser.parse_args()
    mesh, fields, drift = run(options.adaptations, options.vertices, options.steps)
    print(f"vertices {len(mesh.points)} drift {drift:.2e} least {min(f.min() for f in fields.values()):.2e} "
          f"v {integrals(mesh, fields)['v']:.6f}")
    if options.picture:
        elements.picture(options.picture, mesh.points, mesh.triangles, fields["u"],
                         f"u after {options.adaptations * options.steps} units of time, {len(mesh.points)} vertices")


if __name__ == "__main__":
    main()
