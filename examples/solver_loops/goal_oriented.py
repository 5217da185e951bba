# SPDX-License-Identifier: MIT
"""A loop in FEniCSx that is after one number: dual-weighted residuals, beside a loop after the whole solution.

  -lap u = f on an L, with u = r^(2/3) sin(2 t / 3) + exp(-|x - p|^2 / w^2); wanted is a mean of u over a disk

The corner is felt all over the domain, and so in the disk; the peak at p hardly is, but has the greatest second
derivatives, so that a loop after the whole solution spends its vertices there.

  goal_oriented.py [--vertices N] [--rounds N] [--by goal|solution|uniform] [--picture OUT.png]

The error of the mean is a(u - u_h, z - z_h) with z the solution of the adjoint problem, whose right-hand side is the
goal's. A product of two errors is at most half the sum of either, divided by what the other has there: so the
metric is made of |H(z)| H(u) and |H(u)| H(z), with |.| the root of the sum of squares. The residual of u_h, weighted by
z in a richer space, tells the error: the number printed as `estimated`.
"""
import argparse

import elements
import numpy as np
import ufl
from dolfinx import fem
from dolfinx import mesh as dmesh
from mpi4py import MPI

import asterism
import asterism.dolfinx

CENTRE, RADIUS = (-0.5, -0.5), 0.2
PEAK, WIDTH = (0.6, 0.5), 0.05


def exact(x):
    """The angle at the corner, from 0 on one of the two sides that meet there to the other. It jumps half way between
    them outside of the domain."""
    angle = 3 / 4 * np.pi + np.arctan2(-x[0] - x[1], x[1] - x[0])
    peak = np.exp(-((x[0] - PEAK[0]) ** 2 + (x[1] - PEAK[1]) ** 2) / WIDTH ** 2)
    return (x[0] ** 2 + x[1] ** 2) ** (1 / 3) * np.sin(2 / 3 * angle) + peak


def source(mesh):
    """Minus the Laplacian of the peak. The other part of u is harmonic."""
    x = ufl.SpatialCoordinate(mesh)
    square = ((x[0] - PEAK[0]) ** 2 + (x[1] - PEAK[1]) ** 2) / WIDTH ** 2
    return 4 / WIDTH ** 2 * (1 - square) * ufl.exp(-square)


def at_start():
    points, triangles = elements.grid(16, 16, 2, 2, lambda x, y: not (x > 1 and y < 1))
    return asterism.dolfinx.to_dolfinx(asterism.Mesh(points - 1, triangles), MPI.COMM_SELF).mesh


def weight_of(mesh):
    """The goal's weight: smooth, zero beyond the radius, with integral one."""
    x = ufl.SpatialCoordinate(mesh)
    square = ((x[0] - CENTRE[0]) ** 2 + (x[1] - CENTRE[1]) ** 2) / RADIUS ** 2
    return ufl.conditional(square < 1, 3 / (np.pi * RADIUS ** 2) * (1 - square) ** 2, 0)


def solved(mesh, degree, adjoint):
    """Returns the solution of the problem, or of the adjoint problem, whose right-hand side is the goal."""
    space = fem.FunctionSpace(mesh, ("CG", degree))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    given = fem.Function(space)
    if not adjoint:
        given.interpolate(exact)
    mesh.topology.create_connectivity(1, 2)
    sides = fem.locate_dofs_topological(space, 1, dmesh.exterior_facet_indices(mesh.topology))
    right = (weight_of(mesh) if adjoint else source(mesh)) * v * ufl.dx(degree=8)
    problem = fem.petsc.LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx, right,
                                      bcs=[fem.dirichletbc(given, sides)],
                                      petsc_options={"ksp_type": "preonly", "pc_type": "lu"})
    return problem.solve()


def integral(form):
    return float(np.real(fem.assemble_scalar(fem.form(form))))


def error_of_goal(u):
    """Returns the goal of the difference, so that the error of integrating the weight cancels."""
    mesh = u.function_space.mesh
    true = fem.Function(fem.FunctionSpace(mesh, ("CG", 3)))
    true.interpolate(exact)
    return integral((u - true) * weight_of(mesh) * ufl.dx(degree=8))


def estimated(u):
    """Returns the residual of u_h on the part of the adjoint solution that linear functions lack."""
    mesh = u.function_space.mesh
    rich = solved(mesh, 2, adjoint=True)
    linear = fem.Function(u.function_space)
    linear.interpolate(rich)
    beyond = rich - linear
    return integral(source(mesh) * beyond * ufl.dx(degree=8) - ufl.inner(ufl.grad(u), ufl.grad(beyond)) * ufl.dx)


def at_nodes(u):
    """Returns the values of a linear function in the order of the mesh's points."""
    mesh = u.function_space.mesh
    cells, dofs = mesh.geometry.dofmap.array.reshape(-1, 3), u.function_space.dofmap.list.array.reshape(-1, 3)
    made = np.empty(len(mesh.geometry.x))
    made[cells.ravel()] = np.real(u.x.array)[dofs.ravel()]
    return made


def weighted_hessian(u):
    """Returns the second derivatives of which the metric for the goal is made, by name."""
    mesh = u.function_space.mesh
    points, cells = mesh.geometry.x[:, :2], asterism.dolfinx.from_dolfinx(mesh).triangles
    mine, adjoint = (elements.second_derivatives(points, cells, at_nodes(f))
                     for f in (u, solved(mesh, 1, adjoint=True)))
    size = [np.sqrt(h[:, 0] ** 2 + 2 * h[:, 1] ** 2 + h[:, 2] ** 2)[:, None] for h in (mine, adjoint)]
    return moduli(size[1] * mine) + moduli(size[0] * adjoint)


def moduli(tensors):
    """Returns the matrix with the absolute values of the eigenvalues."""
    full = tensors[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    values, vectors = np.linalg.eigh(full)
    made = np.einsum("nik,nk,njk->nij", vectors, np.abs(values), vectors)
    return np.stack([made[:, 0, 0], made[:, 0, 1], made[:, 1, 1]], axis=1)


def run(by, vertices, rounds):
    mesh = at_start()
    for number in range(rounds + 1):
        u = solved(mesh, 1, adjoint=False)
        count, error = len(mesh.geometry.x), error_of_goal(u)
        print(f"vertices {count} error {error:.3e} estimated {-estimated(u):.3e}", flush=True)
        if number == rounds:
            return mesh, u
        if by == "uniform":
            mesh = asterism.dolfinx.adapt(mesh, metric=np.tile([1.0, 0.0, 1.0], (count, 1)), vertices=vertices).mesh
        elif by == "solution":
            mesh = asterism.dolfinx.adapt(mesh, u, vertices=vertices).mesh
        else:
            made = asterism.dolfinx.adapt(mesh, hessian=weighted_hessian(u), norm=1, vertices=vertices)
            mesh = made.mesh
    return mesh, u


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vertices", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--by", choices=("goal", "solution", "uniform"), default="goal")
    parser.add_argument("--picture")
    options = parser.parse_args()
    mesh, u = run(options.by, options.vertices, options.rounds)
    if options.picture:
        ours = asterism.dolfinx.from_dolfinx(mesh)
        elements.picture(options.picture, ours.points, ours.triangles, at_nodes(u),
                         f"u, and the mesh for its mean over the disk, {len(ours.points)} vertices")


if __name__ == "__main__":
    main()
