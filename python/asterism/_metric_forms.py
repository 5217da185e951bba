# SPDX-License-Identifier: MIT
"""The forms in which metrics are given: texts, sizes, tensors, callables, and metrics on another mesh."""
from __future__ import annotations

import os
from numbers import Number
from typing import Any, Callable, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._forms import CalledMetric, definite, Doubles, is_table, metric_rows, system_text
from ._mesh import Mesh
from ._reported import ReportedArray

# The second of a pair is any of these again, at the points of the first.
Metric = Union[str, "os.PathLike[str]", float, Callable[[Any], Any], Tuple[Mesh, Any], Mesh, npt.ArrayLike]


def is_text(metric: Any) -> bool:
    return isinstance(metric, (str, os.PathLike))


def text_of(name: str, metric: Any) -> str:
    """Returns a metric's text as the command takes it."""
    text = os.fsdecode(metric)
    if not text:
        raise InputError(f"{name}: a text is empty, and the name of a metric, a formula or a file is wanted")
    return system_text(name, text)


def is_numbers_file(metric: Any) -> bool:
    """True of the name of a file of numbers at the points of a mesh that is not in it: .sol, .solb or .mtr."""
    return is_text(metric) and _asterism._is_metric_file(text_of("metric", metric))


def is_on_mesh(metric: Any) -> bool:
    """True of a Mesh, whose metric is meant, and of a pair of a Mesh and a metric at its points."""
    return isinstance(metric, Mesh) or (isinstance(metric, tuple) and len(metric) == 2 and isinstance(metric[0], Mesh))


def has_rows(metric: Any) -> bool:
    """True of a metric whose rows belong to the points of the mesh it is asked for at, or that is one for all."""
    return not (is_text(metric) or is_on_mesh(metric) or callable(metric))


def split_stack(metrics: Any) -> Any:
    """Returns the metrics of an array in a list, and other objects as they are.

    An array is one metric, unless it is a stack of them: (k, n, 3) or (k, n, 2, 2).
    """
    if not isinstance(metrics, np.ndarray):
        return metrics
    is_stack = metrics.ndim == 4 or (metrics.ndim == 3 and metrics.shape[1:] != (2, 2))
    return list(metrics) if is_stack else [metrics]


def check_list(metrics: Any) -> None:
    """Raises InputError for what `intersect` does not take as a list of metrics."""
    if isinstance(metrics, tuple) and is_on_mesh(metrics):
        raise InputError("intersect: a list of metrics is wanted, and a tuple that begins with a Mesh may be one "
                         "metric or two: [(mesh, tensors)] is one")
    if not isinstance(metrics, (list, tuple)):
        raise InputError(f"intersect: a list of metrics is wanted, as [M], not {type(metrics).__name__}")


def background_of(name: str, metric: Any) -> Tuple[Mesh, Doubles]:
    """Returns the mesh that a metric is given on, and tensors (n, 3) at its points or one (3,) for all."""
    if isinstance(metric, Mesh):
        return metric, definite(name, metric.metric)
    background, given = metric
    return background, rows_at(name, given, background)


def rows_at(name: str, metric: Any, mesh: Mesh) -> Doubles:
    """Returns tensors (n, 3) at the points of a mesh, or one (3,) for all, of a metric in any form."""
    if is_on_mesh(metric):
        background, rows = background_of(name, metric)
        if background is mesh:
            return rows
        return _placed(name, (background._made, rows), mesh)
    if is_text(metric):
        return _placed(name, text_of(name, metric), mesh)
    check_form(name, metric)
    return definite(name, metric_rows(name, metric, mesh.points))


def _placed(name: str, metric: Any, mesh: Mesh) -> Doubles:
    """Returns tensors at the points of a mesh, of a text or of a pair of another mesh and tensors."""
    try:
        return definite(name, _asterism._metric_at(mesh._made, metric))
    except InputError as wrong:
        said = str(wrong)
        raise InputError(said if said.startswith(f"{name}: ") else f"{name}: {said}") from None


def check_form(name: str, metric: Any) -> None:
    """Raises InputError for an object that is no metric in any form."""
    if isinstance(metric, tuple) and len(metric) == 2 and (is_text(metric[0]) or not (
            isinstance(metric[0], Number) or is_table(metric[0]))):
        raise InputError(f"{name}: the first of a pair (mesh, tensors) is a Mesh, not {type(metric[0]).__name__}"
                         + ("; asterism.read() makes one of a file" if is_text(metric[0]) else ""))
    if not (callable(metric) or isinstance(metric, Number) or is_table(metric)):
        raise InputError(f"{name}: a text, a size, a tensor, a callable, a Mesh or a pair (mesh, tensors) is wanted, "
                         f"not {type(metric).__name__}")


def is_sized(given: Any, background: Mesh) -> bool:
    """True if a metric at the points of a mesh determines the lengths of edges: sizes, and asterism.metric()'s."""
    if isinstance(given, ReportedArray):
        return True
    if callable(given):
        return CalledMetric(given, np.array(background.points[:1])).kind == "size"
    if not has_rows(given):
        return False
    shape = np.shape(given)
    return len(shape) < 2 or shape[1:] == (1,)
