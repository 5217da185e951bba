# SPDX-License-Identifier: MIT
"""Exact anisotropic predicates and certified triangle meshes.

Arrays: points (n, 2), tensors (n, 3) = m11 m12 m22, sites (n, 5) = x y m11 m12 m22, triangles (t, 3)
int32, counter-clockwise; indices count from 0. What a mesh shows is a view of the library's memory:
nothing is copied, nothing can be written, and it lives as long as the view.

What is wrong with an argument raises InputError, a ValueError that says where. A run that does not
reach its goal raises nothing: it warns, and the mesh says so by `complete` and `reason`.
"""
from ._asterism import (
    InputError,
    __version__,
    arc_intersection_count,
    compare_distance,
    dominates,
    edge_test,
    encroaches,
    in_wedge,
    insertion_test,
    is_positive_definite,
    orientation,
    voronoi_vertex_count,
)
from ._adapt import implied_metric, metric, transfer
from ._domain import Domain
from ._mesh import Certificate, Mesh, NotReachedWarning, certify, in_circle, mesh, read, verify
from ._reported import ReportedArray

__all__ = [
    "Certificate", "Domain", "InputError", "Mesh", "NotReachedWarning", "ReportedArray", "__version__",
    "arc_intersection_count", "certify", "compare_distance", "dominates", "edge_test", "encroaches",
    "implied_metric", "in_circle", "in_wedge", "insertion_test", "is_positive_definite", "mesh", "metric",
    "orientation", "read",
    "transfer", "verify", "voronoi_vertex_count",
]
