# SPDX-License-Identifier: MIT
"""Adaptation: the metric that a solution asks for, and the solution brought to the next mesh."""
from __future__ import annotations

import warnings
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._mesh import Mesh, NotReachedWarning
from ._reported import ReportedArray

Fields = Union[npt.ArrayLike, Mapping[str, npt.ArrayLike]]


def _fields_and_tensors(values: Fields) -> Tuple[List[Tuple[str, Any]], Optional[Any]]:
    """Named scalar fields, or a metric that is given."""
    if isinstance(values, Mapping):
        return [(str(name), np.asarray(of, dtype=float)) for name, of in values.items()], None
    array = np.asarray(values, dtype=float)
    if array.ndim == 2 and array.shape[1] == 3:
        return [], array
    if array.ndim != 1:
        raise InputError("values: one number a point, tensors (n, 3), or a dict of fields by name")
    return [("u", array)], None


def metric(mesh: Mesh, values: Fields, *, norm: float = 2, complexity: Optional[float] = None,
           vertices: Optional[float] = None, error: Optional[float] = None,
           gradation: Union[float, None, Literal["default"]] = "default", hmin: Optional[float] = None,
           hmax: Optional[float] = None, aspect: Optional[float] = None,
           intersect: Sequence[npt.ArrayLike] = (), step: Optional[float] = None,
           isotropic: bool = False, gradation_keeps_shape: bool = False,
           hessian: str = "green") -> ReportedArray:
    """The metric (n, 3) at the mesh's points in which the next mesh interpolates `values` best.

    values: a number a point (n,); a dict of such fields by name, whose metrics are intersected in
    the order of the names; or a metric (n, 3), which is bounded, graded and scaled.
    norm: p of the L^p norm of the error, at least 1; math.inf for the maximum.
    At most one of complexity (area in the metric), vertices and error; without, as many vertices as
    the mesh has. hmin, hmax: lengths; aspect: how many times as long as wide, at most (1e6).
    gradation: neighbouring lengths grow by this factor at most over a length of one; None: by any. By
    default 6 for fields, with which loops do best, and None for a metric.
    intersect: metrics (n, 3) that are to hold besides. step: how many times a length may change from
    what it is in the mesh. hessian: 'l2', 'green' or 'least_squares' (docs/manual/adaptation.md).
    A target that cannot be met is a NotReachedWarning; `report` of the result has the numbers.
    """
    fields, given = _fields_and_tensors(values)
    if gradation == "default":
        gradation = None if given is not None else _asterism._loop_gradation
    elif isinstance(gradation, str):
        raise InputError(f"gradation: a number above 1 or None is wanted, not {gradation!r}")
    keywords = {"norm": norm, "complexity": complexity, "vertices": vertices, "error": error,
                "gradation": gradation, "hmin": hmin, "hmax": hmax, "aspect": aspect, "step": step,
                "isotropic": isotropic, "gradation_keeps_shape": gradation_keeps_shape,
                "hessian": hessian}
    tensors, report = _asterism._metric(mesh._made, fields, given, list(intersect), keywords)
    if not report["reached"]:
        warnings.warn(report["reason"], NotReachedWarning, stacklevel=2)
    made = tensors.view(ReportedArray)
    made.report = report
    return made


def implied_metric(mesh: Mesh) -> npt.NDArray[np.float64]:
    """The metric (n, 3) that the mesh was made in, as far as its edges tell."""
    return _asterism._implied_metric(mesh._made)


def transfer(mesh: Mesh, values: Fields, to: Mesh, how: str = "conservative") -> Any:
    """Brings values at the points of `mesh` to those of `to`, a mesh of the same domain.

    values: (n,), (n, 2) or (n, 3), or a dict of such arrays by name; the same comes back, with a
    `report`. how: 'interpolate' (no new extrema, integrals change), 'conservative' (the nearest in
    the mean square; integrals stay to rounding, may overshoot) or 'bounded' (both kept).
    """
    named = isinstance(values, Mapping)
    fields = dict(values) if isinstance(values, Mapping) else {"u": values}
    arrays = [(str(name), np.asarray(of, dtype=float)) for name, of in fields.items()]
    moved, report = _asterism._transfer(mesh._made, arrays, to._made, how)
    made = {}
    for (name, before), after in zip(arrays, moved):
        made[name] = (after[:, 0] if before.ndim == 1 else after).view(ReportedArray)
        made[name].report = report
    return made if named else made["u"]
