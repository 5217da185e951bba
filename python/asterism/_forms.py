# SPDX-License-Identifier: MIT
"""Converts the forms in which metrics and fields are given to the module's own."""
from __future__ import annotations

import math
import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError

Fields = Union[npt.ArrayLike, Mapping[str, npt.ArrayLike]]
NamedFields = List[Tuple[str, Any]]
Doubles = npt.NDArray[np.float64]

# Most bytes of a path on Linux.
_LONGEST_NAME = 4095

# Endings of meshes that meshio reads.
MESHIO_FILES = (".xdmf", ".xmf")

# After a product of matrices, roundings may leave two off-diagonal entries this far apart, as a part of the geometric
# mean of the diagonal ones.
_LARGEST_ASYMMETRY = 1e-12


def doubles(name: str, values: Any) -> Doubles:
    """Returns an array of doubles. Complex numbers, masked entries and texts raise InputError."""
    return np.asarray(_asterism._doubles(name, values), order="C")


def tensor_rows(name: str, values: Any, count: Optional[int] = None) -> Doubles:
    """Returns tensors (n, 3), or one (3,) for all, from any form accepted for them.

    A number is a size h, and so is each of (n,) or (n, 1): the tensor 1/h^2 in all directions.
    (2, 2) and (n, 2, 2) are symmetric matrices. (3,) is a tensor, also where there are three points:
    sizes of these are (3, 1).
    """
    given = doubles(name, values)
    if given.ndim >= 2 and given.shape[-2:] == (2, 2) and given.ndim <= 3:
        return _of_matrices(name, given)
    if given.ndim == 0 or (given.ndim == 2 and given.shape[1] == 1):
        return _of_sizes(name, given.reshape(given.shape[:1]))
    if given.ndim == 1 and given.shape != (3,) and given.shape[0] == count:
        return _of_sizes(name, given)
    if given.ndim in (1, 2) and given.shape[-1] == 3:
        return given
    raise InputError(f"{name}: tensors (n, 3) = m11 m12 m22, matrices (n, 2, 2), sizes (n,) or one of them "
                     f"for all are wanted, not an array of the shape {given.shape}")


def _of_sizes(name: str, sizes: Doubles) -> Doubles:
    wrong = np.flatnonzero(~((sizes > 0) & np.isfinite(sizes)).reshape(-1))
    if len(wrong):
        where = "" if sizes.size == 1 else f"number {wrong[0]}: "
        raise InputError(f"{name}: {where}a size is positive and finite, not "
                         f"{sizes.reshape(-1)[wrong[0]]}")
    inverse = 1 / (sizes * sizes)
    return np.stack([inverse, np.zeros_like(inverse), inverse], axis=-1)


def _of_matrices(name: str, matrices: Doubles) -> Doubles:
    m11, m12, m21, m22 = (matrices[..., i, j] for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)))
    uneven = np.abs(m12 - m21) > _LARGEST_ASYMMETRY * np.sqrt(np.abs(m11 * m22))
    if np.any(uneven):
        where = "" if matrices.ndim == 2 else f"matrix {np.flatnonzero(uneven)[0]} "
        raise InputError(f"{name}: {where}is not symmetric")
    return np.stack([m11, (m12 + m21) / 2, m22], axis=-1)


def named_fields(values: Fields, name: str = "u") -> NamedFields:
    """Returns fields by name. A field without a name is called `name`."""
    if isinstance(values, Mapping):
        names = [system_text("a field's name", str(key)) for key in values]
        for of in names:
            if names.count(of) > 1:
                raise InputError(f"{of}: {names.count(of)} fields have this name")
        return list(zip(names, values.values()))
    return [(name, values)]


def system_text(name: str, text: str) -> str:
    """Returns a text that may hold names of files. Raises InputError where a surrogate stands for no byte of one."""
    try:
        os.fsencode(text)
    except UnicodeEncodeError as odd:
        shown = repr(text) if len(text) <= 60 else repr(text[:60]) + "..."
        raise InputError(f"{name}: {shown} has at {odd.start} the lone surrogate {text[odd.start]!r}, which is no "
                         "character") from None
    return text


def check_rows(fields: NamedFields, points: int, triangles: int) -> None:
    """Raises InputError for a field with a row for each triangle, in place of one for each point."""
    for name, of in fields:
        rows = np.shape(of)[0] if np.ndim(of) else 0
        if rows == triangles != points:
            raise InputError(f"{name}: it has {rows} rows, one a triangle, and {points} are wanted, one a point; "
                             "materials are `regions` of the Mesh; other values v of triangles are brought to the "
                             "triangles of a next mesh by v[mesh.locate(next.points[next.triangles].mean(axis=1))], "
                             "where locate() is not -1, which is outside")


def like(given: Fields, moved: NamedFields) -> Any:
    """Returns arrays in the form of the argument: one array, or a dict."""
    return dict(moved) if isinstance(given, Mapping) else moved[0][1]


def fields_and_tensors(values: Fields) -> Tuple[NamedFields, Optional[Doubles]]:
    """Returns scalars and vectors by name, or a metric if one is given."""
    if isinstance(values, (str, os.PathLike)):
        raise InputError(f"values: arrays are wanted, not {str(values)!r}; asterism.read() of the mesh's file gives a "
                         "Mesh, whose `values` are the fields in it")
    if not isinstance(values, Mapping):
        array = doubles("values", values)
        if (array.ndim == 2 and array.shape[1] == 3) or (array.ndim == 3 and array.shape[1:] == (2, 2)):
            return [], definite("values", tensor_rows("values", array))
        if array.ndim != 1 and not (array.ndim == 2 and array.shape[1] in (1, 2)):
            raise InputError("values: one number a point, vectors (n, 2), tensors (n, 3), or a dict of fields by "
                             "name")
        return [("u", array)], None
    fields = [(name, doubles(name, of)) for name, of in named_fields(values)]
    for name, of in fields:
        if of.ndim == 2 and of.shape[1] == 3:
            raise InputError(f"{name}: a tensor has no metric of its own among other fields")
    return fields, None


def norm_of(norm: Any) -> Any:
    """Returns the exponent of a norm. Takes the command's spelling 'inf', too."""
    return math.inf if norm == "inf" else norm


def gradation_of(gradation: Any, of_fields: bool) -> Any:
    if isinstance(gradation, str) and gradation == "default":
        return _asterism._loop_gradation if of_fields else None
    if isinstance(gradation, str) and gradation != "none":
        raise InputError(f"gradation: a number above 1 or None is wanted, not {gradation!r}")
    return None if isinstance(gradation, str) else gradation


def definite(name: str, rows: Doubles) -> Doubles:
    """Returns tensors (n, 3) or (3,), all of them finite, and positive definite by exact signs."""
    if rows.size:
        finite = np.isfinite(np.atleast_2d(rows)).all(axis=1)
        if not finite.all():
            raise InputError(f"{name}: row {int(np.argmin(finite))} is not finite")
        wrong = np.flatnonzero(np.atleast_1d(_asterism._is_positive_definite(rows)) == 0)
        if len(wrong):
            tensor = np.atleast_2d(rows)[wrong[0]]
            raise InputError(f"{name}: row {wrong[0]}, {_asterism._tensor_text(*tensor)}, is not positive definite: m11 "
                             "and m11 m22 - m12^2 above 0 are wanted")
    return rows


class CalledMetric:
    """A callable from points to tensors (n, 3), made of one to sizes, tensors or matrices."""

    def __init__(self, function: Callable[[Any], Any], somewhere: Doubles) -> None:
        """Asks at one point of the domain, (1, 2), whether the callable returns sizes, tensors or matrices."""
        self.function = function
        answer = doubles("the metric's answer", function(somewhere.copy()))
        kinds: Dict[Tuple[int, ...], str] = {
            (): "size", (1,): "size", (1, 1): "size", (3,): "tensor", (1, 3): "tensor",
            (2, 2): "matrix", (1, 2, 2): "matrix"}
        if answer.shape not in kinds:
            raise InputError(f"the metric's answer: a size, m11 m12 m22 or a matrix (2, 2) for each point is "
                             f"wanted, not an array of the shape {answer.shape} for one; it is called with an array "
                             "of points (n, 2), whose x are p[:, 0]")
        self.kind = kinds[answer.shape]

    def __call__(self, points: Doubles) -> Any:
        answer = self.function(points)
        if self.kind == "tensor":
            return answer
        count = len(points)
        name = "the metric's answer" + (" at ({:.6g}, {:.6g})".format(*points[0]) if count == 1 else "")
        rows = doubles(name, answer)
        shape = (count,) if self.kind == "size" else (count, 2, 2)
        if rows.size != math.prod(shape):
            raise InputError(f"{name}: an array of the shape {rows.shape} for {count} points")
        rows = rows.reshape(shape)
        if self.kind != "size":
            return _of_matrices(name, rows)
        if not np.all((rows > 0) & np.isfinite(rows)):
            wrong = rows[~((rows > 0) & np.isfinite(rows))][0]
            raise InputError(f"{name}: a size is positive and finite, not {wrong:.6g}; a callable returns for each "
                             "point a size, or a positive definite tensor, m11 m12 m22 or (2, 2)")
        return _of_sizes(name, rows)


def metric_rows(name: str, metric: Any, points: Doubles) -> Doubles:
    """Returns tensors (n, 3) at points, or one (3,) for all, from any form accepted for them or from a callable."""
    if not callable(metric):
        return tensor_rows(name, metric, len(points))
    called = CalledMetric(metric, np.array(points[:1]))
    try:
        rows = tensor_rows(name, called(np.array(points)), len(points))
    except Exception:  # calls for one point raise it again if it is not about the number of points
        rows = np.empty((0, 3))
    if rows.shape != (len(points), 3):
        rows = np.concatenate([tensor_rows(name, called(one), 1).reshape(1, 3) for one in np.array(points)[:, None]])
    return rows


def second_derivatives(name: str, values: Any, count: int) -> Doubles:
    """Returns second derivatives (n, 3) = xx xy yy from that form or from symmetric matrices, of either sign."""
    given = doubles(name, values)
    if given.shape not in ((count, 3), (count, 2, 2)):
        raise InputError(f"{name}: second derivatives (n, 3) = xx xy yy or (n, 2, 2) are wanted, a row for each of the "
                         f"{count} points, not an array of the shape {given.shape}")
    return tensor_rows(name, given, count)


def constant_text(tensor: Doubles) -> str:
    """Returns the formula of a constant metric in the command's form."""
    return "expr:" + ";".join(repr(float(entry)) for entry in tensor.reshape(3))


def is_mesh_file(name: str) -> bool:
    """True if a file of this name is a mesh, by the library's rules or as one of meshio's."""
    return _asterism._is_mesh_file(name) or name.lower().endswith(MESHIO_FILES)


def path_of(path: "str | bytes | os.PathLike[str]") -> str:
    """Returns the name of a file as text."""
    try:
        name = system_text("a file's name", os.fsdecode(path))
    except TypeError:
        raise InputError(f"a file's name is wanted, not {type(path).__name__}") from None
    if not name or "\0" in name or len(os.fsencode(name)) > _LONGEST_NAME:
        shown = repr(name) if len(name) <= 60 else repr(name[:60]) + "..."
        raise InputError(f"a file's name is wanted, and {shown} is none")
    return name


def write_text(name: str, text: str) -> None:
    """Writes a file. Raises InputError if it cannot be written."""
    try:
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
    except OSError as odd:
        raise InputError(f"{name}: cannot be written: {odd.strerror}") from odd


def whole(name: str, value: Any, least: int, what: str = "a whole number") -> int:
    """Returns a whole number, Python's or numpy's, as an int. Raises InputError for others, and below `least`."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value < 2**31:
        raise InputError(f"{name}: {what} of at least {least} is wanted, not {value!r}")
    return int(value)


def is_table(what: Any) -> bool:
    """True if an array can be made of the argument, whatever its entries are. Sets have no order and are excluded."""
    return isinstance(what, (list, tuple)) or hasattr(what, "__array__") or hasattr(what, "__array_interface__")


def marker_pairs(periodic: Sequence[Tuple[int, int]]) -> List[Tuple[int, int]]:
    """Returns pairs of markers of sides that must have the same points."""
    pairs = []
    if not isinstance(periodic, (list, tuple)):
        raise InputError(f"periodic: pairs of markers are wanted, as [(4, 2)], and not {periodic!r}")
    for one in periodic:
        is_pair = isinstance(one, (tuple, list)) and len(one) == 2 and all(
            isinstance(m, (int, np.integer)) and not isinstance(m, bool) and -2**31 <= m < 2**31 for m in one)
        if not is_pair:
            raise InputError(f"periodic: pairs of markers are wanted, as [(4, 2)], and not {one!r}")
        pairs.append((int(one[0]), int(one[1])))
    return pairs
