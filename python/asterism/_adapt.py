# SPDX-License-Identifier: MIT
"""Adaptation: the metric that a solution wants, the next mesh, and the transfer of the solution to it."""
from __future__ import annotations

import os
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, TYPE_CHECKING, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._calls import told, told_methods, warn
from ._domain import AnyDomain, Domain, as_domain
from ._forms import (
    check_rows, Fields, fields_and_tensors, gradation_of, like, marker_pairs, named_fields, norm_of, second_derivatives)
from ._mesh import Mesh
from ._meshing import NotReachedWarning, Progress
from ._metric_forms import check_list, Metric, rows_at, split_stack
from ._page import Before, Page
from ._reported import ReportedArray, reported

Gradation = Union[float, str, None]


def _mesh_made(mesh: Any, name: str = "mesh") -> Any:
    if not isinstance(mesh, Mesh):
        raise InputError(f"{name}: a Mesh is wanted, not {type(mesh).__name__}{_made_of(mesh)}")
    return mesh._made


def _made_of(what: Any) -> str:
    """Returns how a Mesh is made of an object that is none, for a message; "" where nothing is known of it."""
    if isinstance(what, (str, os.PathLike)):
        return "; asterism.read() makes one of a file"
    if isinstance(what, (Domain, list, tuple, np.ndarray)):
        return "; asterism.mesh() makes one of a domain, asterism.Mesh(points, triangles) of arrays"
    return "; asterism.Mesh.from_meshio() makes one of meshio's" if hasattr(what, "cells_dict") else ""


def _metrics(given: Any, mesh: Mesh) -> List[Any]:
    """Returns the tensors of a list of metrics at the points of a mesh."""
    given = split_stack(given)
    check_list(given)
    return [rows_at("intersect", one, mesh) for one in given]


@told
def metric(mesh: Mesh, values: Optional[Fields] = None, *, norm: Union[float, str] = 2, complexity: Optional[float] = None,
           vertices: Optional[int] = None, error: Optional[float] = None, gradation: Gradation = "default",
           hmin: Optional[float] = None, hmax: Optional[float] = None, aspect: Optional[float] = None,
           intersect: Sequence[Metric] = (), step: Optional[float] = None, isotropic: bool = False,
           gradation_keeps_shape: bool = False, hessian: Union[str, Fields] = "green",
           relative: bool = False, cutoff: Optional[float] = None) -> ReportedArray:
    """The metric (n, 3) at the mesh's points in which the next mesh interpolates `values` best.

    values: a number a point (n,) or a vector (n, 2); a dict of such fields by name, whose metrics are
    intersected in the order of the names; or a metric (n, 3) or (n, 2, 2), which is bounded, graded and
    scaled.
    norm: p of the L^p norm of the error, at least 1; "inf" for the maximum.
    At most one of complexity (area in the metric), vertices and error; without any, the number of
    vertices of the mesh. hmin, hmax: lengths; aspect: greatest length over width (1e6; along layers of
    values that linear elements computed, what those layers allow).
    gradation: greatest factor by which lengths grow over a length of one; None: any factor. By default
    6 for fields, with which loops do best, and None for a metric.
    intersect: metrics with which this one is intersected, in a list, each in any form that asterism.adapt()
    takes for its metric. step: greatest factor by which a
    length may differ from the mesh's. hessian: 'l2', 'green' or 'lsq' (docs/manual/adaptation.md); or
    the second derivatives themselves, (n, 3) = xx xy yy or (n, 2, 2) of either sign, one or a dict of
    them; the metric is then made of these, without values.
    relative: the error is relative to the greatest less the least value of each field, or, with a
    cutoff C, to the modulus at each point, at least to C times the greatest, as adaptmesh's err. A
    target that cannot be met is a NotReachedWarning; `report` of the result has the numbers.
    """
    made = _mesh_made(mesh)
    method, hessians = _hessians(hessian, len(mesh.points))
    if (values is None) != bool(hessians):
        raise InputError("values: a metric is made of values or of a hessian (n, 3), and "
                         + ("both are" if hessians else "neither is") + " given")
    fields, given = ([], None) if values is None else fields_and_tensors(values)
    check_rows(fields, len(mesh.points), len(mesh.triangles))
    words = {"norm": norm_of(norm), "complexity": complexity, "vertices": vertices, "error": error,
             "gradation": gradation_of(gradation, given is None), "hmin": hmin, "hmax": hmax, "aspect": aspect,
             "step": step, "isotropic": isotropic, "gradation_keeps_shape": gradation_keeps_shape,
             "hessian": method, "hessians": hessians, "relative": relative, "cutoff": cutoff,
             "intersect": _metrics(intersect, mesh)}
    tensors, report = _asterism._metric(made, fields, given, words)
    if not report["reached"]:
        warn(report["reason"], NotReachedWarning)
    return reported(tensors, report)


@told
def implied_metric(mesh: Mesh) -> npt.NDArray[np.float64]:
    """The metric (n, 3) that the mesh was made in, computed from its edges."""
    return _asterism._implied_metric(_mesh_made(mesh))


@overload
def transfer(mesh: Mesh, values: Mapping[str, npt.ArrayLike], to: Mesh, how: str = ...) -> Dict[str, ReportedArray]:
    ...


@overload
def transfer(mesh: Mesh, values: npt.ArrayLike, to: Mesh, how: str = ...) -> ReportedArray:
    ...


@told
def transfer(mesh: Mesh, values: Fields, to: Mesh, how: str = "project") -> Any:
    """Brings values at the points of `mesh` to those of `to`, a mesh of the same domain.

    values: (n,), (n, 2) or (n, 3), or a dict of such arrays by name; the same comes back, with a
    `report`. how: 'interpolate' (no new extrema, integrals change), 'project' (the nearest in
    the mean square; integrals stay to rounding, may overshoot) or 'bounded' (both kept).
    """
    fields = named_fields(values)
    if isinstance(mesh, Mesh):
        check_rows(fields, len(mesh.points), len(mesh.triangles))
    moved, report = _asterism._transfer(_mesh_made(mesh), fields, _mesh_made(to, "to"), how)
    _warn_if_outside(report)
    return like(values, _as_given(fields, moved, report))


# Greatest distance of points from the mesh that had the values, as a part of the root of its area, without a warning:
# coarse chords of curved boundaries are nearer than that.
_FAR_OUTSIDE = 0.05


def _warn_if_outside(report: Optional[Dict[str, Any]]) -> None:
    if report is None or not report["greatest_distance"] > _FAR_OUTSIDE * report["area_before"] ** 0.5:
        return
    warn(f"{report['outside']} points are outside of the mesh that has the values, by up to "
         f"{report['greatest_distance']:.6g}: they have values of the nearest points in it")


def _as_given(fields: Any, moved: Any, report: Dict[str, Any]) -> Any:
    """Returns the arrays of a transfer by name. Scalars have the shape (n,) if they had it before."""
    return [(name, reported(after[:, 0] if np.ndim(before) == 1 else after, report))
            for (name, before), after in zip(fields, moved)]


if TYPE_CHECKING:
    class _Pair(Tuple[Mesh, Any]):
        """Type of the pair in `mesh, u = asterism.adapt(...)`, for type checkers."""
else:
    _Pair = object


@told_methods
class Adapted(_Pair):
    """The next mesh of a loop, with the fields transferred to it.

    mesh: the Mesh; values: the fields that its metric was made of, at its points, in the form in which
    they were given (None of a metric); carried: the fields that were only transferred, in their form,
    too; metric: the tensors (n, 3) wanted at the points of the mesh before; report: `metric`,
    `transfer`, whether the mesh was `kept`, `boundary_distance`, `reached` and `reason`. `mesh, u =
    asterism.adapt(...)` takes the first two.
    """

    def __init__(self, mesh: Mesh, values: Any, carried: Any, metric: ReportedArray,
                 report: Dict[str, Any], before: Optional[Before] = None) -> None:
        self.mesh = mesh
        self._before = before
        self.values = values
        self.carried = carried
        self.metric = metric
        self.report = report

    def __iter__(self) -> Iterator[Any]:
        return iter((self.mesh, self.values))

    def show(self, height: int = 640) -> Page:
        """Returns the page about the mesh with the one before, and the fields on both; see Mesh.show()."""
        carried = {} if self.carried is None else dict(named_fields(self.carried, "carried"))
        return self.mesh.show({**self.mesh.values, **carried}, before=self._before, height=height)

    def __repr__(self) -> str:
        return f"<Adapted: {self.mesh!r}>"


@told
def adapt(mesh: Mesh, values: Optional[Fields] = None, *, vertices: Optional[int] = None,
          complexity: Optional[float] = None, error: Optional[float] = None, carry: Optional[Fields] = None,
          how: str = "interpolate", metric: Optional[Metric] = None, implied: bool = False,
          norm: Union[float, str] = 2, gradation: Gradation = "default", hmin: Optional[float] = None,
          hmax: Optional[float] = None, aspect: Optional[float] = None,
          intersect: Sequence[Metric] = (), step: Optional[float] = None, isotropic: bool = False,
          gradation_keeps_shape: bool = False, hessian: Union[str, Fields] = "green",
          relative: bool = False, cutoff: Optional[float] = None, no_split_across: bool = False,
          domain: Optional[AnyDomain] = None, chord_tolerance: Optional[float] = None,
          corner_angle: Optional[float] = None, hausd: Optional[float] = None,
          boundary_part: Optional[float] = None, keep: str = "auto",
          periodic: Sequence[Tuple[int, int]] = (),
          angle_bound: float = 20, metric_tolerance: Optional[float] = None,
          max_sites: Optional[int] = None, max_seconds: Optional[float] = None,
          threads: Optional[int] = None, progress: Optional[Progress] = None) -> Adapted:
    """Makes the mesh on which the next solution is best: the metric that `values` ask for, a mesh of the
    same domain in it, certified, and the values on that.

    mesh: one of ours, or Mesh(points, triangles, regions=, edges=, markers=) from elsewhere; regions,
    markers and lines inside stay. values: as asterism.metric() takes them; None: the mesh's own `values`.
    carry: fields (n,), (n, 2) or (n, 3), or a dict of them, that are only transferred and have no part
    in the metric. how: method of transfer for all fields, as in asterism.transfer().
    metric: a metric in place of values, in any form that asterism.mesh() takes: rows at the mesh's points,
    (n, 3), (n, 2, 2) or (n,), or one for all; a text ("swirl:12", "expr:1+x*x;0;1", the name of a file); a
    callable; a Mesh, for its own metric; or a pair of a mesh and a metric at its points. Formulas and callables
    are evaluated at the points of the mesh adapted, and metrics on another mesh interpolated there. A named
    metric is placed in the bounding box of these points, and a .sol or .mtr file has a row for each of them.
    Or implied=True: the metric of the mesh's edges. norm to cutoff: as in asterism.metric(); with a hessian
    (n, 3) the metric is made of that, and values are only transferred.
    no_split_across: no inner edge joins two points of the boundary, so that no triangle has all three
    there.
    domain: what is meshed, in any form that asterism.mesh() takes, with chord_tolerance for its curves;
    None: what the mesh covers. Of that, vertices where the boundary turns by more than corner_angle (30)
    stay, and the new boundary is within hausd of the old one, both ways (None: where vertices are
    removed, a hundredth of the size wanted across the boundary, or boundary_part of it).
    periodic: pairs of markers of sides that get the same points, as in asterism.mesh().
    keep: whether the mesh may stay: 'auto' where it is as good as a new one, 'never', or 'always' where
    it is certified in the metric. The rest is as in asterism.mesh().
    A goal that is not reached is a NotReachedWarning, and `report` says why.
    """
    made = _mesh_made(mesh)
    method, hessians = _hessians(hessian, len(mesh.points))
    wanted, given = _wanted(mesh, values, metric, implied, bool(hessians))
    carried = [] if carry is None else named_fields(carry, "carried")
    _check_names(wanted, carried)
    check_rows(wanted + carried, len(mesh.points), len(mesh.triangles))
    words = {
        "vertices": vertices, "complexity": complexity, "error": error, "how": how, "implied": implied,
        "norm": norm_of(norm), "gradation": gradation_of(gradation, given is None and not implied), "hmin": hmin,
        "hmax": hmax, "aspect": aspect, "intersect": _metrics(intersect, mesh), "step": step,
        "isotropic": isotropic, "gradation_keeps_shape": gradation_keeps_shape, "hessian": method,
        "hessians": hessians, "relative": relative, "cutoff": cutoff, "no_split_across": no_split_across,
        "chord_tolerance": chord_tolerance, "corner_angle": corner_angle, "hausd": hausd,
        "boundary_part": boundary_part, "keep": keep,
        "periodic": marker_pairs(periodic),
        "angle_bound": angle_bound, "metric_tolerance": metric_tolerance, "max_sites": max_sites,
        "max_seconds": max_seconds, "threads": threads, "progress": progress}
    exact = None if domain is None else as_domain(domain)._made
    next_mesh, tensors, moved, report = _asterism._adapt(made, wanted, given, wanted + carried, exact, words)
    _warn_if_outside(report["transfer"])
    brought = _as_given(wanted + carried, moved, report["transfer"])
    first, rest = brought[:len(wanted)], brought[len(wanted):]
    if not report["reached"]:
        warn(report["reason"], NotReachedWarning)
    form: Any = mesh.values if values is None else values
    return Adapted(Mesh._of(next_mesh, dict(first)), like(form, first) if first else None,
                   like(carry, rest) if carry is not None else None,
                   reported(tensors, report["metric"]), report, (mesh, dict(wanted + carried)))


def _hessians(hessian: Union[str, Fields], count: int) -> Any:
    """Returns the name of a method of recovery, or given second derivatives by name."""
    if isinstance(hessian, str):
        return hessian, []
    given = [(name, second_derivatives(name, of, count)) for name, of in named_fields(hessian, "hessian")]
    if not given:
        raise InputError("hessian: there is none in it")
    return "green", given


def _wanted(mesh: Mesh, values: Optional[Fields], metric: Optional[Metric], implied: bool,
            has_hessians: bool) -> Any:
    """Returns the fields of which the metric is made, those that are only carried, and a given metric."""
    if has_hessians:
        if metric is not None or implied:
            raise InputError("hessian: the metric is made of it, and another one is wanted besides")
        values = values if values is not None else mesh.values or None
        return (fields_and_tensors(values)[0] if values is not None else []), None
    if values is None and metric is None and not implied and mesh.values:
        values = mesh.values
    if (values is not None) + (metric is not None) + bool(implied) != 1:
        raise InputError("values, metric, implied: one of the three says which metric is wanted, not "
                         + ("none" if values is None and metric is None and not implied else "several"))
    if metric is not None:
        return [], rows_at("metric", metric, mesh)
    return fields_and_tensors(values) if values is not None else ([], None)


def _check_names(wanted: Any, carried: Any) -> None:
    both = {name for name, _ in wanted} & {name for name, _ in carried}
    if both:
        raise InputError(f"carry: {sorted(both)[0]!r} is among the values, which come along anyway")
