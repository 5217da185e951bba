# SPDX-License-Identifier: MIT
"""Exact anisotropic predicates and certified triangle meshes.

    mesh = asterism.mesh("part.poly", size=0.05)          # or a polygon, or its corners (n, 2)
    mesh, u = asterism.adapt(mesh, u, vertices=4000)      # the mesh on which the next solution is best

Arrays: points (n, 2), tensors (n, 3) = m11 m12 m22, sites (n, 5) = x y m11 m12 m22, triangles (t, 3)
int32, counter-clockwise; indices count from 0. The arrays of a mesh are views of the library's memory:
nothing is copied, they are read-only, and the memory lives as long as a view of it.

A wrong argument raises InputError, a ValueError whose message names the place. A run that does not
reach its goal raises nothing: it warns, and `complete` and `reason` of the mesh say so.

asterism.dolfinx and asterism.petsc, to be imported by these names, are for meshes of these packages.
"""
from ._adapt import Adapted, adapt, implied_metric, metric, transfer
from ._asterism import InputError, __version__
from ._certificate import Certificate, Finding
from ._domain import Domain, Repair
from ._drawing import poly_of_dxf, read_dxf
from ._judging import certify, verify
from ._mesh import Mesh, read
from ._meshing import NotReachedWarning, mesh
from ._page import Page
from ._predicates import (
    arc_intersection_count,
    compare_distance,
    dominates,
    edge_test,
    encroaches,
    in_circle,
    in_wedge,
    insertion_test,
    is_positive_definite,
    orientation,
    voronoi_vertex_count,
)
from ._reported import ReportedArray
from ._surface import Surface, SurfaceMesh, mesh_surface

InputError.__doc__ = """An invalid argument or file; the message names the fault and its place."""

__all__ = [
    "Adapted", "Certificate", "Domain", "Finding", "InputError", "Mesh", "NotReachedWarning", "Page", "Repair",
    "ReportedArray", "Surface", "SurfaceMesh", "__version__", "adapt", "arc_intersection_count", "certify", "compare_distance", "dominates",
    "edge_test", "encroaches", "implied_metric", "in_circle", "in_wedge", "insertion_test",
    "is_positive_definite", "mesh", "mesh_surface", "metric", "orientation", "poly_of_dxf", "read", "read_dxf", "transfer",
    "verify", "voronoi_vertex_count",
]
