# SPDX-License-Identifier: MIT
"""Distributed meshes of PETSc (DMPlex) adapted: gathered, meshed by threads, scattered again.

    import asterism.petsc
    made = asterism.petsc.adapt(dm, metric, threads=8)      # under mpirun: every process calls it
    dm = made.dm

The mesh is put into one order, whatever its distribution, before it is meshed on the first process: the
same mesh comes out for any number of processes and of threads. Plane triangles. Tried with PETSc 3.18.
"""
from __future__ import annotations

import contextlib
import ctypes
import os
import sys
import traceback
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._adapt import adapt as _adapt_arrays
from ._asterism import InputError
from ._forms import definite, doubles, second_derivatives, tensor_rows
from ._mesh import Mesh
from ._metric_forms import check_list, has_rows, is_on_mesh, is_text, split_stack

# Names of labels that a DMPlex makes for itself.
_OWN_LABELS = ("celltype", "depth")

Pair = Tuple[str, int]  # name and value of a label


class AdaptedPlex(NamedTuple):
    """What asterism.petsc.adapt() makes, on each process: the distributed dm; values and carried at its local
    vertices, in the form in which they were given; the report; and on the first process the `asterism` mesh with
    its certificate, elsewhere None."""

    dm: Any
    values: Any
    carried: Any
    report: Dict[str, Any]
    asterism: Optional[Mesh]


class _Part(NamedTuple):
    """The part of a process: its vertices, which of them it owns, its own cells by them, labelled cells, edges and
    vertices, rows of fields, and the plain ones among the other arguments."""

    points: npt.NDArray[np.float64]
    own_points: npt.NDArray[np.bool_]
    cells: npt.NDArray[np.int64]
    labels: List[Tuple[Pair, npt.NDArray[np.int64], npt.NDArray[np.int64], npt.NDArray[np.int64]]]
    rows: Dict[str, npt.NDArray[np.float64]]
    wishes: Dict[str, Any]


class _Whole(NamedTuple):
    """The mesh in its own order: vertices by x, then y; cells by their vertices."""

    points: npt.NDArray[np.float64]
    cells: npt.NDArray[np.int64]
    cell_labels: Dict[Pair, npt.NDArray[np.int64]]
    edge_labels: Dict[Pair, npt.NDArray[np.int64]]
    vertex_labels: Dict[Pair, npt.NDArray[np.int64]]
    rows: Dict[str, npt.NDArray[np.float64]]


def adapt(dm: Any, metric: Any = None, *, values: Any = None, carry: Any = None, hessian: Any = "green",
          intersect: Sequence[Any] = (), periodic: Sequence[Tuple[Pair, Pair]] = (), overlap: int = 0,
          **wishes: Any) -> AdaptedPlex:
    """The next mesh of a DMPlex, as asterism.adapt() makes it, distributed along a space-filling curve.

    metric: one in any form that tensors have, or a Vec as dm.metricCreate() makes it; or values: fields, or a
    dict of them, from which the metric is made. carry: fields to transfer that do not affect the metric. hessian,
    intersect: as in asterism.adapt(). All of these are arrays with a row for each local vertex, in the order of the
    dm, ghosts among them, or local Vecs of such rows. A metric may be in the other forms of asterism.adapt(), too, a
    callable, a text, a Mesh or a pair (mesh, rows), alike on all processes; the first process evaluates it at the
    vertices of the whole mesh. periodic: pairs of sides with the same points, each side the name and the value of
    a label: [(("Face Sets", 4), ("Face Sets", 2))]. overlap: of the new distribution. wishes: the other arguments of
    asterism.adapt().
    Labels stay: on cells and edges as they are, on vertices where they are those of labelled edges and cells, or
    else with the vertices, which are kept. Every process calls this; one that fails, or is interrupted, ends the
    call on all of them with its error.
    """
    comm = _comm_of(dm)
    asked = _Asked(metric, values, carry, hessian, _listed(intersect), periodic, wishes)
    part = _together(comm, lambda: _part_of(dm, asked.rows_given(), {"overlap": _layers(overlap), **asked.plain()}))
    parts = comm.gather(part)
    plan = _on_first(comm, lambda: _adapted(parts, asked))
    made, scattered = plan if comm.rank == 0 else (None, None)
    with abort_on_exception(comm):
        new, index = _scatter(dm.comm, scattered, overlap)
        wanted, carried, report = _rows_for(comm, index, made, scattered)
    return AdaptedPlex(new, _as_given(values, wanted), _as_given(carry, carried), report,
                       made.mesh if comm.rank == 0 else None)


def _listed(intersect: Any) -> Any:
    """Returns the metrics to intersect with in a list. A Vec is one metric."""
    return [intersect] if hasattr(intersect, "array_r") else split_stack(intersect)


class _Asked(NamedTuple):
    """The arguments of adapt() on one process."""

    metric: Any
    values: Any
    carry: Any
    hessian: Any
    intersect: Any
    periodic: Any
    wishes: Dict[str, Any]

    def rows_given(self) -> Dict[str, Any]:
        """Returns by their use the arguments that have a row for each local vertex, or a dict of such arguments."""
        check_list(self.intersect)
        besides = {str(k): of for k, of in enumerate(self.intersect) if has_rows(of)}
        return {"metric": self.metric if has_rows(self.metric) else None, "u": self.values, "carried": self.carry,
                "hessian": None if isinstance(self.hessian, str) else self.hessian, "intersect": besides}

    def plain(self) -> Dict[str, Any]:
        """Returns the arguments that each process gives alike, but for the plain ones among the wishes."""
        kinds = [_kind_of(of) for of in (self.metric, *self.intersect)]
        return {**self.wishes, "metric, intersect": ", ".join(kinds), "hessian": self.hessian,
                "periodic": str(self.periodic)}


def _kind_of(metric: Any) -> str:
    """Returns what a metric is given as, or its text."""
    if is_text(metric):
        return f"the text {os.fsdecode(metric)!r}"
    return "rows" if has_rows(metric) else "on a mesh" if is_on_mesh(metric) else "a callable"


def gathered(dm: Any) -> Optional[Mesh]:
    """The asterism.Mesh of a distributed DMPlex in its one order, on the first process; elsewhere None."""
    comm = _comm_of(dm)
    parts = comm.gather(_together(comm, lambda: _part_of(dm, {})))
    made: Optional[Mesh] = _on_first(comm, lambda: _mesh_of(_whole_of(parts))[0])
    return made


@contextlib.contextmanager
def abort_on_exception(comm: Any = None) -> Iterator[None]:
    """Ends all processes by MPI's Abort if one fails, or exits with a status other than 0, while the others wait for
    it. For a whole program: `with asterism.petsc.abort_on_exception():`, or as the decorator of its main function.
    comm: of PETSc or mpi4py; all processes unless named. On one process alone the error is raised as ever."""
    if comm is None:
        from mpi4py import MPI

        comm = MPI.COMM_WORLD
    comm = comm.tompi4py() if hasattr(comm, "tompi4py") else comm
    try:
        yield
    except BaseException as error:
        status = error.code if isinstance(error, SystemExit) else 1
        if comm.size == 1 or status in (None, 0):
            raise
        traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        comm.Abort(status if isinstance(status, int) else 1)


# Errors: a process that fails sends its error to the others before any of them waits for it.


def _raise_first(told: List[Optional[BaseException]]) -> None:
    for rank, error in enumerate(told):
        if isinstance(error, InputError):
            raise InputError(f"{error} (process {rank})" if len(told) > 1 else str(error))
        if error is not None:
            raise error


def _kept(error: BaseException) -> BaseException:
    """Returns an error that can be sent. One that cannot be pickled is replaced by its text."""
    import pickle

    try:
        pickle.loads(pickle.dumps(error))
        return error
    except Exception:  # exceptions of some packages cannot be pickled
        return RuntimeError(f"{type(error).__name__}: {error}")


def _together(comm: Any, work: Callable[[], Any]) -> Any:
    """Returns the result of work on this process. Raises the first error of any process on all of them."""
    done, error = None, None
    try:
        done = work()
    except BaseException as raised:  # an interrupt is sent, too
        error = _kept(raised)
    _raise_first(comm.allgather(error))
    return done


def _on_first(comm: Any, work: Callable[[], Any]) -> Any:
    """Returns the result of work on the first process, None on others. Raises its error on all of them."""
    done, error = None, None
    if comm.rank == 0:
        try:
            done = work()
        except BaseException as raised:  # an interrupt is sent, too
            error = _kept(raised)
    error = comm.bcast(error)
    if error is not None:
        _raise_first([error])
    return done


# The part of a process.


def _comm_of(dm: Any) -> Any:
    """Returns the processes that have the dm. Raises an error on each where it is none."""
    from petsc4py import PETSc

    if not isinstance(dm, PETSc.DMPlex):
        raise InputError(f"dm: a DMPlex of PETSc is wanted, not {type(dm).__name__}")
    return dm.comm.tompi4py()


def _cones(dm: Any, cells: Tuple[int, int], edges: Tuple[int, int]) -> Tuple[Any, Any]:
    """Returns the edges of each cell and the vertices of each edge, as numbers of points."""
    from petsc4py import PETSc

    count = [cells[1] - cells[0], edges[1] - edges[0]]
    flat = None
    try:  # one call of the library that petsc4py is linked with
        first = ctypes.c_void_p()
        library = ctypes.CDLL(PETSc.__file__)
        if library.DMPlexGetCones(ctypes.c_void_p(dm.handle), ctypes.byref(first)) == 0 and first.value:
            whole = ctypes.c_int64 if np.dtype(PETSc.IntType).itemsize == 8 else ctypes.c_int32
            size = 3 * count[0] + 2 * count[1]
            flat = np.ctypeslib.as_array(ctypes.cast(first, ctypes.POINTER(whole)), (size,)).astype(np.int64)
    except (OSError, AttributeError):
        pass
    if flat is not None and cells[0] == 0 and count[0]:
        of_cells, of_edges = flat[:3 * count[0]].reshape(-1, 3), flat[3 * count[0]:].reshape(-1, 2)
        ends = [(of_cells, cells[0]), (of_edges, edges[0])]
        if all(np.array_equal(table[k], dm.getCone(start + k)) for table, start in ends for k in (0, len(table) - 1)):
            return of_cells, of_edges
    return (np.array([dm.getCone(p) for p in range(*cells)], dtype=np.int64).reshape(-1, 3),
            np.array([dm.getCone(p) for p in range(*edges)], dtype=np.int64).reshape(-1, 2))


def _strata(dm: Any) -> Tuple[Tuple[int, int], Tuple[int, int], Tuple[int, int]]:
    if dm.getDimension() != 2 or dm.getDepth() not in (2, -1) or dm.getCoordinateDim() != 2:
        raise InputError("dm: triangles in the plane, with their edges (interpolate=True, or dm.interpolate()), are "
                         "wanted")
    return dm.getHeightStratum(0), dm.getDepthStratum(1), dm.getDepthStratum(0)


def _layers(overlap: Any) -> int:
    if not isinstance(overlap, (int, np.integer)) or overlap < 0:
        raise InputError(f"overlap: a number of layers of cells from 0 on is wanted, not {overlap!r}")
    return int(overlap)


def _part_of(dm: Any, given: Dict[str, Any], wishes: Optional[Dict[str, Any]] = None) -> _Part:
    cells, edges, vertices = _strata(dm)
    if any(dm.getConeSize(p) != 3 for p in (cells[0], cells[1] - 1) if cells[1] > cells[0]):
        raise InputError("dm: triangles are wanted")
    cell_edges, edge_vertices = _cones(dm, cells, edges)
    corners = _corners(cell_edges - edges[0], edge_vertices - vertices[0])
    is_own = np.ones(max(cells[1], vertices[1]), dtype=bool)
    if dm.comm.size > 1:
        leaves = _shared_points(dm)
        is_own[leaves[leaves < len(is_own)]] = False
    own = is_own[cells[0]:cells[1]]
    labels = []
    for name in (dm.getLabelName(k) for k in range(dm.getNumLabels())):
        if name not in _OWN_LABELS:
            labels += _stratum(dm, name, own, edge_vertices - vertices[0])
    count = vertices[1] - vertices[0]
    besides = {name: _tensors_of(dm, of, count) for name, of in given.get("intersect", {}).items()}
    rows = _rows_of({**given, "metric": _tensors_of(dm, given.get("metric"), count), "intersect": besides}, count)
    plain = {name: of for name, of in (wishes or {}).items() if isinstance(of, (int, float, str, np.number))}
    return _Part(_places(dm, vertices), is_own[vertices[0]:vertices[1]], corners[own], labels, rows, plain)


def _corners(edges_of: Any, ends: Any) -> Any:
    """Returns the vertices of each cell, of its edges and their ends: those of the first edge, and the end of the
    second one that is not among them."""
    first, second = ends[edges_of[:, 0]], ends[edges_of[:, 1]]
    is_shared = (second[:, 0] == first[:, 0]) | (second[:, 0] == first[:, 1])
    return np.column_stack([first, np.where(is_shared, second[:, 1], second[:, 0])])


def _places(dm: Any, vertices: Tuple[int, int]) -> Any:
    """Returns the coordinates of the local vertices."""
    at = np.array(dm.getCoordinatesLocal().array_r).reshape(-1, 2) + 0.0  # -0.0 and 0.0 are one place
    section = dm.getCoordinateSection()
    count = vertices[1] - vertices[0]
    last = count and section.getOffset(vertices[1] - 1) == section.getOffset(vertices[0]) + 2 * (count - 1)
    if last and len(at) == count and section.getChart() == vertices and section.getMaxDof() == 2:
        return at
    place = np.array([section.getOffset(v) for v in range(*vertices)], dtype=np.int64) // 2
    return at[place].reshape(-1, 2)


def _shared_points(dm: Any) -> Any:
    """Returns the points that other processes own; none of a mesh that was never distributed, whose graph is not
    set: petsc4py makes an array of -1 entries of it then."""
    try:
        return dm.getPointSF().getGraph()[1]
    except ValueError:
        return np.zeros(0, dtype=np.int64)


def _said(use: str, name: str) -> str:
    """Returns what a field is called in messages."""
    return name if name and use != "intersect" else {"u": "values", "carried": "carry"}.get(use, use)


def _stratum(dm: Any, name: str, own: Any, edge_vertices: Any) -> List[Any]:
    """Returns for each value of a label its own cells, edges by their vertices, and vertices."""
    cells, edges, vertices = _strata(dm)
    number = np.cumsum(own) - 1
    found = []
    for value in dm.getLabelIdIS(name).getIndices() if dm.getLabelSize(name) else []:
        points = dm.getStratumIS(name, int(value)).getIndices().astype(np.int64)
        of_cells = points[(points >= cells[0]) & (points < cells[1])] - cells[0]
        of_edges = points[(points >= edges[0]) & (points < edges[1])] - edges[0]
        of_vertices = points[(points >= vertices[0]) & (points < vertices[1])] - vertices[0]
        found.append(((name, int(value)), number[of_cells[own[of_cells]]], edge_vertices[of_edges], of_vertices))
    return found


def _tensors_of(dm: Any, metric: Any, count: int) -> Any:
    """Returns a metric as it is given, and one of PETSc's isotropic or uniform ones, whose numbers are the entries of
    its tensors, as tensors."""
    if not hasattr(metric, "array_r") or len(metric.array_r) not in (1, count):
        return metric
    if not dm.metricIsIsotropic():
        raise InputError("metric: a Vec with a number for each vertex is PETSc's isotropic metric where "
                         "dm.metricIsIsotropic() is true, and here it is not; sizes are given as an array")
    entries = np.array(metric.array_r)
    return np.column_stack([entries, 0 * entries, entries]) if len(entries) == count else (entries[0], 0.0, entries[0])


def _rows_of(given: Dict[str, Any], count: int) -> Dict[str, Any]:
    """Returns the arrays by their names, prefixed by their use, with rows for the local vertices."""
    rows: Dict[str, Any] = {}
    for use, fields in given.items():
        if fields is None:
            continue
        for name, of in (fields.items() if isinstance(fields, Mapping) else [("", fields)]):
            remedy = "; dm.globalToLocal() makes a local Vec of a global one" if hasattr(of, "array_r") else ""
            of = np.array(of.array_r) if hasattr(of, "array_r") else of
            array = doubles(_said(use, name), of)
            if array.ndim == 1 and count and array.size % count == 0 and array.size // count > 1:
                array = array.reshape(count, -1)
            if use in ("metric", "intersect", "hessian"):
                array = _tensor_rows(use, _said(use, name), array, count)
            if array.ndim == 0 or len(array) != count:
                raise InputError(f"{_said(use, name)}: rows for the {count} local vertices are wanted, not an array of "
                                 f"the shape {array.shape}{remedy}")
            finite = np.isfinite(array.reshape(count, -1)).all(axis=1) if count else np.ones(0, dtype=bool)
            if not finite.all():
                raise InputError(f"{_said(use, name)}: row {int(np.argmin(finite))} is not finite")
            rows[f"{use}/{name}"] = array
    return rows


def _tensor_rows(use: str, name: str, array: Any, count: int) -> Any:
    """Returns tensors (n, 3) at the local vertices: of a metric, positive definite, or second derivatives."""
    if count == 0:
        return np.zeros((0, 3))
    array = array.reshape(-1, 2, 2) if array.ndim == 2 and array.shape[1] == 4 else array
    if use == "hessian":
        return second_derivatives(name, array, count)
    array = definite(name, tensor_rows(name, array, count))
    return np.tile(array, (count, 1)) if array.ndim == 1 else array


# Gathering the mesh.


def _whole_of(parts: List[_Part]) -> _Whole:
    points = np.concatenate([part.points for part in parts])
    starts = np.cumsum([0] + [len(part.points) for part in parts])
    order = np.argsort(np.ascontiguousarray(points).view(np.complex128)[:, 0])  # by x, then by y
    in_order = points[order]
    is_new = np.ones(len(order), dtype=bool)
    is_new[1:] = (in_order[1:] != in_order[:-1]).any(axis=1)
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.cumsum(is_new) - 1
    _check_places(in_order[is_new], number[np.concatenate([part.own_points for part in parts])])
    cells = np.concatenate([number[part.cells + start] for part, start in zip(parts, starts)])
    cells = _one_way_round(in_order[is_new], cells)
    # Two triangles on one side of an edge overlap, and are refused later: two vertices say which triangle it is.
    # numpy sorts numbers of 16 bits by counting, in a quarter of the time.
    cell_order = np.lexsort([(cells[:, k] >> shift).astype(np.uint16) for k in (1, 0) for shift in (0, 16)])
    cell_number = np.empty(len(cells), dtype=np.int64)
    cell_number[cell_order] = np.arange(len(cells))
    of_cells, of_edges, of_vertices = _whole_labels(parts, starts, number, cell_number)
    return _Whole(in_order[is_new], cells[cell_order], of_cells, of_edges, of_vertices,
                  _whole_rows(parts, order, is_new, number))


def _check_places(places: Any, owned: Any) -> None:
    """Raises InputError unless each place has one vertex that a process owns. Where it has two, as on the sides of a
    crack, the mesh would come back without the crack."""
    times = np.bincount(owned, minlength=len(places))
    if (times != 1).any():
        wrong = int(np.argmax(times != 1))
        x, y = places[wrong]
        raise InputError(f"dm: at ({x:.6g}, {y:.6g}) there are {times[wrong]} vertices that a process owns, and one is "
                         "wanted: the sides of a crack are not kept apart here" if times[wrong] else
                         f"dm: the vertex at ({x:.6g}, {y:.6g}) is nowhere but among ghosts; coordinates of ghosts are "
                         "those of the vertices")


def _one_way_round(points: Any, cells: Any) -> Any:
    """Returns the triangles counter-clockwise, each from its least vertex on."""
    from ._predicates import orientation

    first, second, third = np.sort(cells, axis=1).T
    turns = np.asarray(orientation(points[first], points[second], points[third])).reshape(-1)
    return np.column_stack([first, np.where(turns < 0, third, second), np.where(turns < 0, second, third)])


def _whole_labels(parts: Any, starts: Any, number: Any, cell_number: Any) -> Tuple[Any, Any, Any]:
    of_cells: Dict[Pair, Any] = {}
    of_edges: Dict[Pair, Any] = {}
    of_vertices: Dict[Pair, Any] = {}
    first_cell = 0
    for part, start in zip(parts, starts):
        for pair, cells, edges, vertices in part.labels:
            of_cells.setdefault(pair, []).append(cell_number[cells + first_cell])
            of_edges.setdefault(pair, []).append(number[edges + start])
            of_vertices.setdefault(pair, []).append(number[vertices + start])
        first_cell += len(part.cells)
    return ({pair: _distinct(found, len(cell_number)) for pair, found in sorted(of_cells.items())},
            {pair: _distinct_edges(np.concatenate(found), len(number)) for pair, found in sorted(of_edges.items())},
            {pair: _distinct(found, len(number)) for pair, found in sorted(of_vertices.items())})


def _distinct(found: List[Any], count: int) -> Any:
    """Returns the numbers below count in any of the arrays, in their order. Marks them where they are many, which
    takes a pass over count, and sorts them where they are few."""
    numbers = np.concatenate(found)
    if len(numbers) < count // 32:
        return np.unique(numbers)
    is_there = np.zeros(count, dtype=bool)
    is_there[numbers] = True
    return np.flatnonzero(is_there)


def _distinct_edges(edges: Any, count: int) -> Any:
    keys = np.unique(_keys(edges, count))
    return np.column_stack([keys // count, keys % count]) if count else edges


def _check_alike(parts: List[_Part]) -> None:
    """Raises InputError where a process gives other fields than the first one, or of another kind."""
    for rank, part in enumerate(parts):
        for name in sorted((part.wishes.keys() | parts[0].wishes.keys()) - {"threads"}):
            mine, first = (of.wishes.get(name) for of in (part, parts[0]))
            if mine != first:
                raise InputError(f"{name}: process {rank} gives {mine!r} and process 0 {first!r}; every process gives "
                                 "the same")
    kinds = [{name: rows.shape[1:] for name, rows in part.rows.items() if len(rows)} for part in parts]
    for rank, (part, kind) in enumerate(zip(parts, kinds)):
        odd = sorted(set(part.rows) ^ set(parts[0].rows))
        odd = odd or sorted(name for name in kind if kind[name] != kinds[0].get(name, kind[name]))
        if odd:
            raise InputError(f"{_said(*odd[0].split('/', 1))}: process {rank} and process 0 give different fields; "
                             "every process gives its rows of the same ones")


def _whole_rows(parts: List[_Part], order: Any, is_new: Any, number: Any) -> Dict[str, Any]:
    rows: Dict[str, Any] = {}
    _check_alike(parts)
    for name in parts[0].rows:
        together = np.concatenate([part.rows[name] for part in parts])
        rows[name] = together[order][is_new]
        if not np.array_equal(rows[name][number], together, equal_nan=True):
            raise InputError(f"{_said(*name.split('/', 1))}: a vertex that processes share has several values; bring "
                             "ghosts up to date (dm.globalToLocal)")
    return rows


# The gathered mesh as an asterism.Mesh, with labels as regions, markers and required vertices.


class _Labelling(NamedTuple):
    """The labels for which the numbers of regions and markers, and the required vertices, stand."""

    regions: List[Tuple[Pair, ...]]
    markers: List[Tuple[Pair, ...]]
    vertices: Dict[Pair, npt.NDArray[np.float64]]  # coordinates
    to_edges: List[Pair]  # pairs of name and value on edges of labelled cells
    to_vertices: List[Pair]  # pairs of name and value on vertices of labelled edges and cells


def _combined(labels: Dict[Pair, Any], count: int) -> Tuple[Any, List[Tuple[Pair, ...]]]:
    """Returns for each item the number of its set of labels, from 1 where it has none."""
    numbers = np.zeros(count, dtype=np.int64)
    sets: List[Tuple[Pair, ...]] = [()]
    for pair, items in labels.items():
        before, place = _ranks(numbers[items])
        numbers[items] = len(sets) + place
        sets += [(*sets[int(old)], pair) for old in before]
    used, compact = _ranks(numbers)
    if len(used) and used[0] != 0:
        used, compact = np.concatenate([[0], used]), compact + 1
    return compact, [sets[int(k)] for k in used]


def _ranks(numbers: Any) -> Tuple[Any, Any]:
    """Returns the distinct ones of numbers from 0 on, in their order, and for each number its place among them."""
    if len(numbers) == 0:
        return numbers, numbers
    least = numbers.min()
    is_used = np.bincount(numbers - least) > 0
    return np.flatnonzero(is_used) + least, (np.cumsum(is_used) - 1)[numbers - least]


def _keys(edges: Any, count: int) -> Any:
    return np.minimum(edges[:, 0], edges[:, 1]) * count + np.maximum(edges[:, 0], edges[:, 1])


def _mesh_of(whole: _Whole) -> Tuple[Mesh, _Labelling]:
    count = len(whole.points)
    edges, edges_of = _asterism._numbered_edges(whole.cells, count)
    regions, region_sets = _combined(whole.cell_labels, len(whole.cells))
    of_edges, to_edges = _edges_apart(whole, edges, edges_of)
    markers, marker_sets = _combined(of_edges, len(edges))
    listed = np.flatnonzero((markers != 0) | _is_outline(regions, edges_of, len(edges)))
    listed = listed[np.argsort(_keys(edges[listed], count))]
    required, to_vertices = _vertices_apart(whole, count)
    kept = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *required.values()]))
    # A part without a number may have region 0; the numbers here begin at 1.
    made = Mesh(whole.points, whole.cells, regions=regions + 1, edges=edges[listed], markers=markers[listed],
                required_points=kept)
    places = {pair: whole.points[found] for pair, found in required.items()}
    return made, _Labelling(region_sets, marker_sets, places, to_edges, to_vertices)


def _is_outline(regions: Any, edges_of: Any, count: int) -> Any:
    """Returns for each edge whether it is of one triangle, or between regions."""
    outlines = np.bincount(edges_of.reshape(-1), minlength=count) == 1
    of_one = np.empty(count, dtype=regions.dtype)
    of_one[edges_of] = regions[:, None]  # that of any of its triangles
    outlines[edges_of[of_one[edges_of] != regions[:, None]]] = True
    return outlines


def _numbers_of(wanted: Any, edges: Any, count: int) -> Any:
    """Returns the numbers of the wanted edges among all. Sorts only edges between ends of wanted ones."""
    is_end = np.zeros(count, dtype=bool)
    is_end[wanted] = True
    near = np.flatnonzero(is_end[edges[:, 0]] & is_end[edges[:, 1]])
    keys = _keys(edges[near], count)
    order = np.argsort(keys)
    keys, wanted_keys = keys[order], _keys(wanted, count)
    place = np.searchsorted(keys, wanted_keys)
    if (np.append(keys, -1)[place] != wanted_keys).any():
        raise InputError("dm: an edge with a label is of no triangle")
    return near[order[place]]


def _edges_apart(whole: _Whole, edges: Any, edges_of: Any) -> Tuple[Dict[Pair, Any], List[Pair]]:
    """Returns labelled edges by their numbers, without edges that have the label of their cell, and the pairs on such
    edges. edges_of: the numbers of each cell's edges."""
    apart: Dict[Pair, Any] = {}
    closed = []
    labelled = np.concatenate([np.zeros((0, 2), dtype=np.int64), *whole.edge_labels.values()])
    numbers = _numbers_of(labelled, edges, len(whole.points))
    cuts = np.cumsum([len(of) for of in whole.edge_labels.values()])
    for pair, found in zip(whole.edge_labels, np.split(numbers, cuts)):
        apart[pair], is_closed = _apart_from(found, edges_of[whole.cell_labels[pair]], len(edges))
        closed += [pair] if is_closed else []
    return apart, closed


def _vertices_apart(whole: _Whole, count: int) -> Tuple[Dict[Pair, Any], List[Pair]]:
    """Returns labelled vertices without those of labelled edges and cells, and the pairs on the latter."""
    apart: Dict[Pair, Any] = {}
    closed = []
    for pair, vertices in whole.vertex_labels.items():
        above = np.concatenate([whole.edge_labels[pair].reshape(-1), whole.cells[whole.cell_labels[pair]].reshape(-1)])
        vertices, is_closed = _apart_from(vertices, above, count)
        closed += [pair] if is_closed else []
        if len(vertices):
            apart[pair] = vertices
    return apart, closed


def _apart_from(labelled: Any, of_others: Any, count: int) -> Tuple[Any, bool]:
    """Returns labelled items without those of labelled edges and cells, if all of the latter are among them, and
    whether that is so."""
    is_other, is_labelled = np.zeros(count, dtype=bool), np.zeros(count, dtype=bool)
    is_other[of_others], is_labelled[labelled] = True, True
    if not is_other.any() or not is_labelled[is_other].all():
        return labelled, False
    return np.flatnonzero(is_labelled & ~is_other), True


class _Scattered(NamedTuple):
    """A mesh to distribute, with the labels of its points, and its fields by use and name."""

    mesh: Mesh
    labelling: _Labelling
    names: List[Pair]  # all pairs on the mesh before
    rows: Dict[str, npt.NDArray[np.float64]]


def _adapted(parts: List[_Part], asked: _Asked) -> Any:
    whole = _whole_of(parts)
    old, labelling = _mesh_of(whole)
    values, carry, metric = asked.values, asked.carry, asked.metric
    besides = [whole.rows[f"intersect/{k}"] if has_rows(of) else of for k, of in enumerate(asked.intersect)]
    made = _adapt_arrays(
        old, _fields(whole, "u", values), carry=_fields(whole, "carried", carry),
        metric=whole.rows["metric/"] if metric is not None and has_rows(metric) else metric,
        hessian=asked.hessian if isinstance(asked.hessian, str) else _fields(whole, "hessian", asked.hessian),
        intersect=besides, periodic=_marker_pairs(asked.periodic, labelling.markers), **asked.wishes)
    rows = {f"{use}/{name}": np.asarray(of) for use, form, moved in (
        ("u", values, made.values), ("carried", carry, made.carried)) if form is not None
        for name, of in (moved.items() if isinstance(form, Mapping) else [("", moved)])}
    names = sorted({*whole.cell_labels, *whole.edge_labels, *whole.vertex_labels})
    return made, _Scattered(made.mesh, labelling, names, rows)


def _marker_pairs(periodic: Any, markers: List[Tuple[Pair, ...]]) -> List[Tuple[int, int]]:
    """Returns for each pair of sides, named by labels, the pair of their markers."""
    pairs = []
    for sides in periodic if isinstance(periodic, (list, tuple)) else [periodic]:
        try:
            (first, first_value), (second, second_value) = sides
        except (TypeError, ValueError):
            raise InputError("periodic: pairs of sides are wanted, each the name and the value of a label, as "
                             f"[(('Face Sets', 4), ('Face Sets', 2))], not {sides!r}") from None
        pairs.append((_marker_of((first, first_value), markers), _marker_of((second, second_value), markers)))
    return pairs


def _marker_of(side: Pair, markers: List[Tuple[Pair, ...]]) -> int:
    found = [number for number, pairs in enumerate(markers) if side in pairs]
    if len(found) == 1:
        return found[0]
    if found:
        raise InputError(f"periodic: edges with the label {side} differ in their other labels; a side has the same "
                         "labels on all its edges")
    there = ", ".join(str(pair) for pair in sorted({pair for pairs in markers for pair in pairs}))
    raise InputError(f"periodic: no edge has the label {side}; the labels of edges are: {there or 'none'}")


def _fields(whole: _Whole, use: str, form: Any) -> Any:
    if form is None:
        return None
    found = {name.split("/", 1)[1]: of for name, of in whole.rows.items() if name.startswith(f"{use}/")}
    return found if isinstance(form, Mapping) else found[""]


# Distributing the new mesh.


def _scatter(comm: Any, scattered: Optional[_Scattered], overlap: int) -> Tuple[Any, Any]:
    """Returns the distributed dm, and for each local vertex the number of its point in the mesh."""
    from petsc4py import PETSc

    mpi = comm.tompi4py()
    cells, points, order = np.zeros((0, 3), dtype=PETSc.IntType), np.zeros((0, 2)), None
    if scattered is not None:
        points, triangles = np.array(scattered.mesh.points), scattered.mesh.triangles
        order = _asterism._order_along_curve(sum(points[triangles[:, k]] for k in range(3)) / 3)
        cells = np.array(triangles[order], dtype=PETSc.IntType)
    dm = _plex_of(comm, cells, points)
    names = mpi.bcast(None if scattered is None else sorted({name for name, _ in scattered.names}))
    for name in names:
        if not dm.hasLabel(name):
            dm.createLabel(name)
    start, end = dm.getDepthStratum(0)
    index = np.full(dm.getChart()[1], -1, dtype=np.int64)
    index[start:end] = np.arange(end - start)
    _on_first(mpi, lambda: _set_labels(dm, scattered, order, start))
    if mpi.size == 1:
        return dm, index[start:end]
    partitioner = dm.getPartitioner()
    partitioner.setType("shell")
    if scattered is not None:
        cuts = np.array([len(cells) * k // mpi.size for k in range(mpi.size + 1)])
        partitioner.setShellPartition(mpi.size, np.diff(cuts).astype(PETSc.IntType),
                                      np.arange(len(cells), dtype=PETSc.IntType))
    else:
        partitioner.setShellPartition(mpi.size, np.zeros(mpi.size, dtype=PETSc.IntType),
                                      np.zeros(0, dtype=PETSc.IntType))
    moved = dm.distribute(overlap=overlap)
    return dm, _brought(dm, moved, index)


def _plex_of(comm: Any, cells: Any, points: Any) -> Any:
    """Returns the dm that createFromCellList() makes, with edges. Numbers the edges here, as PETSc's own search for
    them takes most of the time of a distribution (0.34 of 0.43 s for 100,000 vertices)."""
    from petsc4py import PETSc

    make = None
    with contextlib.suppress(OSError, AttributeError):  # one call of the library that petsc4py is linked with
        make = ctypes.CDLL(PETSc.__file__).DMPlexCreateFromDAG
    if make is None:
        return PETSc.DMPlex().createFromCellList(2, cells, points, interpolate=True, comm=comm)
    edges, of = _asterism._numbered_edges(cells, len(points))
    is_turned = edges[:, 0][of] != cells
    first_edge = len(cells) + len(points)
    cone_sizes = np.repeat([3, 0, 2], [len(cells), len(points), len(edges)])
    cones = np.concatenate([of.reshape(-1) + first_edge, edges.reshape(-1) + len(cells)])
    turns = np.concatenate([-is_turned.reshape(-1).astype(np.int64), np.zeros(2 * len(edges), dtype=np.int64)])
    counts = np.array([len(points), len(edges), len(cells)])
    tables = [np.ascontiguousarray(table, dtype=PETSc.IntType) for table in (counts, cone_sizes, cones, turns)]
    tables.append(np.ascontiguousarray(points, dtype=PETSc.ScalarType))
    dm = PETSc.DMPlex().create(comm)
    dm.setDimension(2)
    failed = make(ctypes.c_void_p(dm.handle), (ctypes.c_int64 if tables[0].itemsize == 8 else ctypes.c_int32)(2),
                  *[ctypes.c_void_p(table.ctypes.data) for table in tables])
    if failed:
        raise PETSc.Error(failed)
    return dm


def _brought(dm: Any, moved: Any, index: Any) -> Any:
    from mpi4py import MPI

    local = np.full(dm.getChart()[1], -1, dtype=np.int64)
    moved.bcastBegin(MPI.INT64_T, index, local, MPI.REPLACE)
    moved.bcastEnd(MPI.INT64_T, index, local, MPI.REPLACE)
    return local[slice(*dm.getDepthStratum(0))]


def _set_labels(dm: Any, scattered: Any, order: Any, first_vertex: int) -> None:
    """Sets the labels of cells, edges and vertices of the dm, all of which the first process has."""
    from petsc4py import PETSc

    mesh, labelling = scattered.mesh, scattered.labelling
    cells, edges, vertices = _strata(dm)
    cell_edges, edge_vertices = _cones(dm, cells, edges)
    edge_vertices = edge_vertices - first_vertex
    has: Dict[Pair, List[Any]] = {}
    regions = np.asarray(mesh.regions)[order] - 1
    for number, pairs in enumerate(labelling.regions):
        for pair in pairs:
            has.setdefault(pair, []).append(np.flatnonzero(regions == number) + cells[0])
    points_of = edges[0] + _numbers_of(np.asarray(mesh.edges, dtype=np.int64), edge_vertices, len(mesh.points))
    markers = np.asarray(mesh.edge_markers)
    for number, pairs in enumerate(labelling.markers):
        for pair in pairs:
            has.setdefault(pair, []).append(points_of[markers == number])
    for pair in labelling.to_edges:
        own = np.concatenate(has.get(pair, [np.zeros(0, dtype=np.int64)]))
        has.setdefault(pair, []).append(cell_edges[own[own < cells[1]]].reshape(-1))
    for pair in labelling.to_vertices:
        own = np.concatenate(has.get(pair, [np.zeros(0, dtype=np.int64)]))
        of_cells = cell_edges[own[own < cells[1]]].reshape(-1) - edges[0]
        of_edges = own[(own >= edges[0]) & (own < edges[1])] - edges[0]
        has.setdefault(pair, []).append(first_vertex + edge_vertices[np.concatenate([of_cells, of_edges])].reshape(-1))
    for pair, found in _vertices_at(labelling.vertices, mesh.points[:mesh.given]).items():
        has.setdefault(pair, []).append(first_vertex + found)
    for (name, value), parts in has.items():
        every = _distinct(parts, edges[1]).astype(PETSc.IntType)
        dm.getLabel(name).setStratumIS(value, PETSc.IS().createGeneral(every, comm=PETSc.COMM_SELF))


def _vertices_at(places: Dict[Pair, Any], points: Any) -> Dict[Pair, Any]:
    """Returns the numbers of the points at the given places."""
    if not places:
        return {}
    as_one = [np.ascontiguousarray(of).view(np.complex128)[:, 0] for of in (*places.values(), points)]
    wanted, at = np.unique(np.concatenate(as_one[:-1])), as_one[-1]
    place = np.minimum(np.searchsorted(wanted, at), len(wanted) - 1)
    found = np.flatnonzero(wanted[place] == at)
    number = np.full(len(wanted), -1, dtype=np.int64)
    number[place[found]] = found
    return {pair: number[np.searchsorted(wanted, of)] for pair, of in zip(places, as_one)}


def _rows_for(comm: Any, index: Any, made: Any, scattered: Optional[_Scattered]) -> Tuple[Any, Any, Any]:
    """Returns fields at the local vertices, and the report."""
    wanted = comm.gather(index)
    sent = None
    if scattered is not None:
        sent = [({name: of[rows] for name, of in scattered.rows.items()}, made.report) for rows in wanted]
    rows, report = comm.scatter(sent)
    return ({name: of for name, of in rows.items() if name.startswith("u/")},
            {name: of for name, of in rows.items() if name.startswith("carried/")}, report)


def _as_given(form: Any, rows: Dict[str, Any]) -> Any:
    if form is None:
        return None
    found = {name.split("/", 1)[1]: of for name, of in rows.items()}
    return found if isinstance(form, Mapping) else found[""]
