# SPDX-License-Identifier: MIT
"""Solves a Poisson equation on a mesh in pieces with PETSc, each rank reading its own.

    asterism mesh square --metric swirl:12 --size 0.05 --pieces 8 -o pieces/
    mpirun -n 8 python3 examples/pieces/poisson_petsc.py pieces/

-laplace u = f in the square [-1,1]^2, u = 0 on its sides, by linear elements; f is that of
u = cos(pi x / 2) cos(pi y / 2).
"""
import sys

import numpy
from distributed import DistributedMesh
from mpi4py import MPI
from petsc4py import PETSc


def exact(q):
    return numpy.cos(numpy.pi * q[..., 0] / 2) * numpy.cos(numpy.pi * q[..., 1] / 2)


def vector(comm, pieces):
    return PETSc.Vec().createMPI((len(pieces.points), pieces.vertices), comm=comm)


def corners_of_cells(comm, pieces):
    """Returns the positions of the cells' corners. Those of vertices that another rank owns are fetched from it."""
    wanted = PETSc.IS().createGeneral(pieces.cells.ravel().astype(PETSc.IntType), comm=comm)
    columns = []
    for axis in range(2):
        whole = vector(comm, pieces)
        whole.array[:] = pieces.points[:, axis]
        local = PETSc.Vec().createSeq(pieces.cells.size)
        PETSc.Scatter().create(whole, wanted, local, None).scatter(whole, local)
        columns.append(local.array.reshape(-1, 3).copy())
    return numpy.stack(columns, axis=2)


def assemble(comm, pieces, corners):
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    across = numpy.stack([c - b, a - c, b - a], axis=1)  # the side opposite to each corner
    twice = (across[:, 2, 0] * -across[:, 1, 1] + across[:, 2, 1] * across[:, 1, 0])
    stiffness = numpy.einsum("tik,tjk->tij", across, across) / (2 * twice)[:, None, None]
    middles = (corners[:, [0, 1, 2]] + corners[:, [1, 2, 0]]) / 2
    at_middles = numpy.pi ** 2 / 2 * exact(middles) * twice[:, None] / 6
    load = (at_middles + at_middles[:, [2, 0, 1]]) / 2  # exact for quadratics
    size = (len(pieces.points), pieces.vertices)
    matrix = PETSc.Mat().createAIJ((size, size), nnz=(32, 32), comm=comm)
    matrix.setOption(PETSc.Mat.Option.NEW_NONZERO_ALLOCATION_ERR, False)
    right = vector(comm, pieces)
    for cell, values, force in zip(pieces.cells.astype(PETSc.IntType), stiffness, load):
        matrix.setValues(cell, cell, values, addv=PETSc.InsertMode.ADD_VALUES)
        right.setValues(cell, force, addv=PETSc.InsertMode.ADD_VALUES)
    matrix.assemble()
    right.assemble()
    return matrix, right, twice


def main():
    comm = MPI.COMM_WORLD
    pieces = DistributedMesh(comm, sys.argv[1])
    corners = corners_of_cells(comm, pieces)
    matrix, right, twice = assemble(comm, pieces, corners)
    sides = pieces.first + numpy.flatnonzero(abs(pieces.points).max(axis=1, initial=0) == 1)
    matrix.zeroRowsColumns(sides.astype(PETSc.IntType), diag=1, x=vector(comm, pieces), b=right)
    solution = vector(comm, pieces)
    solver = PETSc.KSP().create(comm)
    solver.setOperators(matrix)
    solver.setType("cg")
    solver.getPC().setType("jacobi")
    solver.setTolerances(rtol=1e-10)
    solver.solve(right, solution)
    error = abs(solution.array - exact(pieces.points)).max(initial=0)
    error = comm.allreduce(error, MPI.MAX)
    area = comm.allreduce(twice.sum() / 2)
    vertices, triangles = comm.allreduce(len(pieces.points)), comm.allreduce(len(pieces.cells))
    if comm.rank == 0:
        print(f"{comm.size} ranks: {vertices} vertices ({pieces.vertices} in the index), "
              f"{triangles} triangles, area {area:.12f}, error {error:.3e}")


main()
