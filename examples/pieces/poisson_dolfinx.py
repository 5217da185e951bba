# SPDX-License-Identifier: MIT
"""Solves a Poisson equation on a mesh in pieces with dolfinx, each rank reading its own.

    asterism mesh square --metric swirl:12 --size 0.05 --pieces 8 -o pieces/
    mpirun -n 8 python3 examples/pieces/poisson_dolfinx.py pieces/

-laplace u = f in the square [-1,1]^2, u = 0 on its sides; f is that of u = cos(pi x / 2) cos(pi y / 2).
"""
import sys

import dolfinx
import numpy
import ufl
from distributed import DistributedMesh
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI
from petsc4py.PETSc import ScalarType


def make_mesh(comm, pieces):
    """Cells stay on the rank that read them; dolfinx exchanges what it needs beside them."""
    def stay(_comm, _parts, _dimension, cells, *_ghosts):
        where = numpy.full((cells.num_nodes, 1), comm.rank, dtype=numpy.int32)
        return dolfinx.graph.create_adjacencylist(where)
    element = ufl.VectorElement("Lagrange", ufl.triangle, 1)
    return dolfinx.mesh.create_mesh(comm, pieces.cells, pieces.points, ufl.Mesh(element),
                                    partitioner=stay)


def main():
    comm = MPI.COMM_WORLD
    pieces = DistributedMesh(comm, sys.argv[1])
    mesh = make_mesh(comm, pieces)
    space = fem.FunctionSpace(mesh, ("Lagrange", 1))
    x = ufl.SpatialCoordinate(mesh)
    exact = ufl.cos(ufl.pi * x[0] / 2) * ufl.cos(ufl.pi * x[1] / 2)
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    sides = dolfinx.mesh.locate_entities_boundary(
        mesh, 1, lambda q: numpy.isclose(numpy.maximum(abs(q[0]), abs(q[1])), 1))
    fixed = fem.dirichletbc(ScalarType(0), fem.locate_dofs_topological(space, 1, sides), space)
    solved = LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx,
                           ufl.pi ** 2 / 2 * exact * v * ufl.dx, bcs=[fixed],
                           petsc_options={"ksp_type": "cg", "pc_type": "jacobi",
                                          "ksp_rtol": 1e-10}).solve()
    error = comm.allreduce(fem.assemble_scalar(fem.form((solved - exact) ** 2 * ufl.dx)))
    area = comm.allreduce(fem.assemble_scalar(fem.form(ScalarType(1) * ufl.dx(domain=mesh))))
    vertices = space.dofmap.index_map.size_global
    triangles = mesh.topology.index_map(2).size_global
    if comm.rank == 0:
        print(f"{comm.size} ranks: {vertices} vertices ({pieces.vertices} in the index), "
              f"{triangles} triangles, area {area:.12f}, error {error ** 0.5:.6e}")


main()
