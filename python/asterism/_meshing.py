# SPDX-License-Identifier: MIT
"""Meshes of domains."""
from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from . import _asterism
from ._asterism import InputError
from ._calls import told, warn
from ._domain import AnyDomain, Domain, as_domain
from ._forms import CalledMetric, constant_text, doubles, gradation_of, marker_pairs, path_of, tensor_rows
from ._mesh import Mesh
from ._metric_forms import (background_of, check_form, is_numbers_file, is_on_mesh, is_sized, is_text, Metric, rows_at,
                            text_of)
from ._sizes import Places, Sizes, words_of

Progress = Callable[[Dict[str, Any]], Any]


class NotReachedWarning(UserWarning):
    """The mesher ended before its goal; the mesh's `reason` says why."""


@told
def mesh(domain: AnyDomain, metric: Metric = "identity", size: Optional[float] = None,
         angle_bound: float = 20, *, on: Optional[Mesh] = None, max_sites: Optional[int] = None,
         gradation: Union[float, str, None] = None, voronoi: bool = False, improve: int = 0,
         vertices: Optional[int] = None, complexity: Optional[float] = None,
         metric_tolerance: Optional[float] = None, chord_tolerance: Optional[float] = None,
         size_at: Places = (), size_box: Places = (), size_in: Optional[Sizes] = None,
         size_near: Optional[Sizes] = None, layers: Optional[Sizes] = None, hmin: Optional[float] = None,
         hmax: Optional[float] = None, aspect: Optional[float] = None,
         periodic: Sequence[Tuple[int, int]] = (),
         repair: "bool | float" = False, convex_hull: bool = False, guarantee: bool = False,
         max_seconds: Optional[float] = None, threads: Optional[int] = None, progress: Optional[Progress] = None,
         prove_voronoi: bool = False) -> Mesh:
    """Makes a mesh whose angles are at least angle_bound degrees, each measured by the metric of all
    three vertices of its triangle, and audits it.

    domain: a Domain; the name of a file (.poly, .geojson, .json, .wkt; of a mesh: what it covers) or of
    one that the command knows ("square"); a shape of shapely or anything with __geo_interface__; points
    (n, 2), the corners of a polygon in their order; or a Mesh, for what it covers.
    metric: a text as the command takes it ("swirl:12", "expr:1+x*x;0;1", the name of a mesh's file with
    its metric); a size, the length of an edge; a tensor (3,) = m11 m12 m22 or (2, 2) for the whole
    domain; a callable from (n, 2) points to sizes (n,), tensors (n, 3) or (n, 2, 2); a Mesh, for its own
    metric; or a pair of a mesh and a metric in any of these forms, rows (n, 3), (n, 2, 2) or (n,) at its
    points among them. The rows alone suffice with on=mesh, or where the domain is that mesh. A .sol or .mtr
    file has a row for each point of the domain, if that is a mesh, else of the mesh's file of its name.
    A callable is called at one point to find the kind of its result, then for thousands of points at a
    time, each once, and for single points (n = 1) where they are not known in advance; each row must
    depend on its point alone. If for n > 1 it does not return n rows, or raises, it is called for one
    point at a time from then on.
    size: edges are to have this length in the metric; None: no limit but what angles need, except for
    sizes and a metric of asterism.metric(), with which it is 1.
    vertices, complexity: in place of a size, the number of vertices, or the area of the domain in the
    metric; the metric is scaled to that. A mesh with over 5 % more or fewer vertices than that is made
    again with another scale, ten times at most, and the nearest is returned.
    metric_tolerance: how far the metric delivered may be from the one wanted, as ln of the greatest
    ratio of two lengths; 0: no tensor is changed; None: any at single sites, with a median of at most
    ln 10 and a ratio of densities of at most ten.
    max_sites: refinement ends at this many; None: at 100000, or three times those asked for, or ten times
    the vertices of the domain.
    chord_tolerance: greatest distance of a curve of the domain from its chords; None: a fiftieth of each
    chord, and with a size, vertices or complexity a fiftieth of the size wanted across the curve, or a
    hundredth where the metric is on a mesh. Curves are divided for each mesh: only the ends of curves,
    and the domain's vertices on no curve, are vertices of each mesh.
    size_at, size_box, size_in, size_near: finer sizes at places, of which the finest counts: (x, y,
    radius, h) and (x0, y0, x1, y1, h), and {region: h} and {marker: h}; a number after h, or a pair (h,
    growth), is the factor from edge to edge away from the place, 1.3 where there is none.
    layers: {marker: (h0, growth)} or {marker: (h0, growth, n)}: layers along the segments with a marker,
    the first h0 high, each growth times as high as the one before, n of them.
    hmin, hmax, aspect: bounds on all edges, and on length over width of triangles.
    With any of these and without size, vertices or complexity the size elsewhere is hmax, or the width of
    the domain.
    voronoi: True to prove, too, that the mesh is the dual of the anisotropic Voronoi diagram
    (prove_voronoi is an older name of this argument).
    periodic: pairs of markers, [(4, 2)]: both sides get the same points, one side being the other one
    shifted or turned; `periodic` of the certificate says how they match.
    repair: True, or the distance within which points are joined: a domain whose segments cross or leave
    gaps is repaired, with a UserWarning. convex_hull: the domain is closed by the convex hull of its
    points; these are then not joined to a ring.
    guarantee: edges are made shorter until the theorem on nets applies to the mesh, which then has its
    angles by proof; InputError where a corner is too sharp for it, or the metric jumps. Goes with size or
    sizes, not with vertices, complexity, improve and metric_tolerance.
    max_seconds: refinement ends after this time, and `reason` says so. threads: number of threads; the
    mesh is the same for any number. progress: called now and then with a dict of counts. Ctrl-C ends
    the run.
    """
    if callable(size) or np.ndim(size) > 0:  # type: ignore[arg-type]
        raise InputError(f"size: a number is wanted, not {type(size).__name__}; sizes that differ from place to place "
                         "are a metric, mesh(domain, metric=...), or size_at and the like")
    covered = as_domain(domain, repair, convex_hull)
    if on is None and isinstance(domain, Mesh) and isinstance(metric, np.ndarray) and metric.shape not in ((), (3,)) \
            and len(metric) == len(domain.points):
        on = domain
    if isinstance(domain, Mesh) and is_numbers_file(metric):
        metric = (domain, rows_at("metric", metric, domain))
    wanted, size = _metric_and_size(metric, on, covered, size, (vertices, complexity) == (None, None))
    made = Mesh._of(_asterism._mesh(covered._made, wanted, {
        "size": size, "angle_bound": angle_bound, "max_sites": max_sites,
        "gradation": gradation_of(gradation, False), "voronoi": voronoi or prove_voronoi, "improve": improve,
        "vertices": vertices, "complexity": complexity, "metric_tolerance": metric_tolerance,
        "chord_tolerance": chord_tolerance, "keep_if_complete": covered._is_meshed, "max_seconds": max_seconds,
        "domain_file": path_of(domain) if isinstance(domain, (str, bytes, os.PathLike)) else None,
        "sizes": words_of(size_at, size_box, size_in, size_near, layers,
                          {"hmin": hmin, "hmax": hmax, "aspect": aspect}),
        "guarantee": guarantee, "periodic": marker_pairs(periodic), "threads": threads, "progress": progress}))
    if not made.complete:
        warn(made.reason, NotReachedWarning)
    return made


def _metric_and_size(metric: Any, on: Optional[Mesh], domain: Domain, size: Optional[float],
                     is_unscaled: bool) -> Tuple[Any, Optional[float]]:
    """Returns the metric in one of the module's three forms, and the size wanted in it."""
    default = 1.0 if size is None and is_unscaled else size
    if on is not None and not isinstance(on, Mesh):
        raise InputError(f"on: a Mesh is wanted, not {type(on).__name__}")
    if on is not None:
        if is_text(metric) or is_on_mesh(metric):
            raise InputError("on: rows at the points of this mesh, or a callable, are wanted as metric= beside it")
        metric = (on, metric)
    if is_on_mesh(metric):
        background, tensors = background_of("metric", metric)
        given = metric.metric if isinstance(metric, Mesh) else metric[1]
        return (background._made, tensors), default if is_sized(given, background) else size
    if is_text(metric):
        return text_of("metric", metric), size
    check_form("metric", metric)
    if callable(metric):
        called = CalledMetric(metric, np.array(domain.points[:1]))
        return called, default if called.kind == "size" else size
    tensor = tensor_rows("metric", metric)
    if tensor.shape != (3,):
        raise InputError("metric: tensors at the points of a mesh want the mesh: metric=(mesh, tensors)")
    return constant_text(tensor), default if doubles("metric", metric).ndim == 0 else size
