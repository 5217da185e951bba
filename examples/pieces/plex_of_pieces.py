# SPDX-License-Identifier: MIT
"""A distributed DMPlex of PETSc from a mesh in pieces, each rank reading its own: nothing is gathered.

    asterism mesh square --metric swirl:12 --size 0.05 --pieces 8 -o pieces/
    mpirun -n 8 python3 examples/pieces/plex_of_pieces.py pieces/

Points of the plex: cells, then the vertices that the rank owns, then those of its cells that other ranks own, then
edges. Labels as PETSc's readers of gmsh name them: "Cell Sets" has the regions, "Face Sets" the markers of edges.
"""
import sys

import numpy
from distributed import DistributedMesh
from mpi4py import MPI
from petsc4py import PETSc


def vertices_here(comm, pieces):
    """Returns global numbers and coordinates of the vertices of this rank's cells, its own first. Of each vertex that
    another rank owns, returns that rank and the number of its point there."""
    first = numpy.array(comm.allgather(pieces.first))
    cells = numpy.array(comm.allgather(len(pieces.cells)))
    owned = pieces.first + numpy.arange(len(pieces.points))
    others = numpy.setdiff1d(pieces.cells.ravel(), owned)
    ranks = numpy.searchsorted(first, others, side="right") - 1
    ask = comm.alltoall([others[ranks == rank] - first[rank] for rank in range(comm.size)])
    told = comm.alltoall([pieces.points[rows] for rows in ask])
    places = numpy.concatenate([pieces.points, *told])
    return numpy.concatenate([owned, others]), places, numpy.stack([ranks, cells[ranks] + others - first[ranks]], axis=1)


def set_coordinates(plex, start, places):
    section = plex.getCoordinateSection()
    section.setNumFields(1)
    section.setFieldComponents(0, 2)
    section.setChart(start, start + len(places))
    for point in range(start, start + len(places)):
        section.setDof(point, 2)
        section.setFieldDof(point, 0, 2)
    section.setUp()
    plex.setCoordinatesLocal(PETSc.Vec().createWithArray(places.ravel().copy(), comm=PETSc.COMM_SELF))


def set_labels(plex, pieces, point_of):
    plex.createLabel("Cell Sets")
    for cell, region in enumerate(pieces.regions):
        plex.setLabelValue("Cell Sets", cell, int(region))
    plex.createLabel("Face Sets")
    for edge, marker in zip(pieces.edges, pieces.markers):
        side, = plex.getJoin([point_of[vertex] for vertex in edge])
        plex.setLabelValue("Face Sets", side, int(marker))


def plex_of(comm, pieces):
    numbers, places, leaves = vertices_here(comm, pieces)
    cells, start = len(pieces.cells), len(pieces.cells)
    point_of = {int(number): start + at for at, number in enumerate(numbers)}
    plex = PETSc.DMPlex().create(comm)
    plex.setDimension(2)
    plex.setCoordinateDim(2)
    plex.setChart(0, cells + len(numbers))
    for cell in range(cells):
        plex.setConeSize(cell, 3)
    plex.setUp()
    for cell, corners in enumerate(pieces.cells):
        plex.setCone(cell, [point_of[int(corner)] for corner in corners])
    plex.symmetrize()
    plex.stratify()
    shared = PETSc.SF().create(comm)
    first_leaf = start + len(pieces.points)
    shared.setGraph(cells + len(numbers), numpy.arange(first_leaf, first_leaf + len(leaves), dtype=PETSc.IntType),
                    leaves.astype(PETSc.IntType))
    if comm.size > 1:
        plex.setPointSF(shared)
    plex.interpolate()
    set_coordinates(plex, start, places)
    set_labels(plex, pieces, point_of)
    return plex


def points_of_others(comm, plex):
    """Returns the forest's graph. A forest that was never set has none: with one rank, no other rank owns
    anything."""
    return plex.getPointSF().getGraph()[1] if comm.size > 1 else numpy.empty(0, dtype=PETSc.IntType)


def owned_points(plex, depth, leaves):
    """Returns how many points of the stratum belong to this rank."""
    begin, end = plex.getDepthStratum(depth)
    return end - begin - int(numpy.count_nonzero((leaves >= begin) & (leaves < end)))


def lengths_by_marker(comm, plex):
    section, coordinates, lengths = plex.getCoordinateSection(), plex.getCoordinatesLocal().array, {}
    others = set(points_of_others(comm, plex).tolist())
    for marker in plex.getLabelIdIS("Face Sets").indices:
        for side in plex.getStratumIS("Face Sets", marker).indices:
            if side not in others:
                a, b = (coordinates[section.getOffset(v):][:2] for v in plex.getCone(side))
                lengths[int(marker)] = lengths.get(int(marker), 0) + float(numpy.hypot(*(a - b)))
    return {marker: sum(part.get(marker, 0) for part in comm.allgather(lengths))
            for marker in sorted(set().union(*comm.allgather(set(lengths))))}


def main():
    comm = MPI.COMM_WORLD
    pieces = DistributedMesh(comm, sys.argv[1])
    plex = plex_of(comm, pieces)
    others = points_of_others(comm, plex)
    counts = [comm.allreduce(owned_points(plex, depth, others)) for depth in range(3)]
    lengths = lengths_by_marker(comm, plex)
    if comm.size > 1:
        plex.distributeOverlap(1)
    begin, end = plex.getHeightStratum(0)
    seen = comm.allreduce(end - begin)
    if comm.rank == 0:
        print(f"{comm.size} ranks: {counts[0]} vertices ({pieces.vertices} in the index), {counts[1]} edges, {counts[2]} triangles, "
              f"{seen - counts[2]} of them in overlaps")
        print("lengths:", ", ".join(f"marker {marker}: {length:.12f}" for marker, length in lengths.items()))


main()
