# SPDX-License-Identifier: MIT
"""Converts and adapts meshes, tags and functions of FEniCSx (dolfinx), without a file.

    import asterism.dolfinx
    mesh, uh, cell_tags, facet_tags = asterism.dolfinx.adapt(mesh, uh, cell_tags, facet_tags, vertices=4000)

Triangles of degree 1 in the plane, on one process. Functions are Lagrange, of degree 1 or 2, scalars or
vectors, of real numbers. Tried with dolfinx 0.5.2.
"""
from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Tuple

import numpy as np
import numpy.typing as npt

from ._adapt import adapt as _adapt_arrays
from ._adapt import transfer as _transfer_arrays
from ._asterism import InputError
from ._mesh import Mesh
from ._reported import ReportedArray

Values = Any  # a Function, an array with a row for each node of the geometry, or a dict or list of these


class ToDolfinx(NamedTuple):
    """A dolfinx mesh with its tags, and for each node of its geometry the number of its point in the
    asterism.Mesh."""

    mesh: Any
    cell_tags: Any
    facet_tags: Any
    points: npt.NDArray[np.int64]


def from_dolfinx(mesh: Any, cell_tags: Any = None, facet_tags: Any = None) -> Mesh:
    """The asterism.Mesh of a dolfinx mesh. Point k is node k of its geometry, triangle k its cell k.

    Tags of cells become regions, of facets, inside too, markers; a cell without a tag has the region 0,
    a facet without one the marker 0, and so 0 is refused as a facet's tag, and as a cell's where others have none.
    """
    cells = _cells(mesh)
    at = np.asarray(mesh.geometry.x)
    if len(at) and (at[:, 2] != at[0, 2]).any():
        raise InputError("mesh: it is not in one plane z = constant")
    points = at[:, :2]
    regions = np.ones(len(cells), dtype=np.int64)
    if cell_tags is not None:
        _check_tags(mesh, cell_tags, 2, "cell_tags")
        if len(cell_tags.indices) < len(cells) and (np.asarray(cell_tags.values) == 0).any():
            raise InputError("cell_tags: 0 is the region of cells without a tag, which there are, too; give the cells "
                             "of tag 0 another number, or all cells a tag")
        regions[:] = 0
        regions[cell_tags.indices] = cell_tags.values
    edges, markers = _edges_and_markers(mesh, cells, regions, facet_tags)
    # A height other than 0 is left out with a warning.
    return Mesh(at, _counter_clockwise(points, cells), regions=regions, edges=edges, markers=markers)


def to_dolfinx(mesh: Mesh, comm: Any = None) -> ToDolfinx:
    """The dolfinx mesh of an asterism.Mesh: its regions are tags of all cells, its markers, but for 0, tags
    of facets. comm: MPI.COMM_SELF unless named."""
    import dolfinx.mesh
    from mpi4py import MPI

    if not isinstance(mesh, Mesh):
        raise InputError(f"mesh: an asterism.Mesh is wanted, not {type(mesh).__name__}")
    comm = MPI.COMM_SELF if comm is None else comm
    _check_alone(comm)
    cells = np.array(mesh.triangles, dtype=np.int64)
    made = dolfinx.mesh.create_mesh(comm, cells, x=np.array(mesh.points), **_domain())
    points = np.asarray(made.geometry.input_global_indices, dtype=np.int64)
    own = np.asarray(made.topology.original_cell_index)
    regions = np.asarray(mesh.regions)[own].astype(np.int32)
    cell_tags = dolfinx.mesh.meshtags(made, 2, np.arange(len(own), dtype=np.int32), regions)
    return ToDolfinx(made, cell_tags, _facet_tags(made, mesh, points), points)


class AdaptedDolfinx:
    """The next dolfinx mesh, the fields transferred to it, and its tags. `mesh, uh, cell_tags,
    facet_tags =` takes the first four; also `carried`, `points` (as ToDolfinx has them), the `asterism`
    mesh with its certificate, the `metric` wanted and the `report`."""

    def __init__(self, made: ToDolfinx, values: Any, carried: Any, asterism: Mesh, metric: ReportedArray,
                 report: Dict[str, Any]) -> None:
        self.mesh, self.cell_tags, self.facet_tags, self.points = made
        self.values = values
        self.carried = carried
        self.asterism = asterism
        self.metric = metric
        self.report = report

    def __iter__(self) -> Iterator[Any]:
        return iter((self.mesh, self.values, self.cell_tags, self.facet_tags))

    def __repr__(self) -> str:
        return f"<AdaptedDolfinx: {self.asterism!r}>"


def adapt(mesh: Any, values: Values = None, cell_tags: Any = None, facet_tags: Any = None, *,
          carry: Values = None, how: str = "interpolate", **wishes: Any) -> AdaptedDolfinx:
    """The mesh on which the next solution is best, as asterism.adapt() makes it, with the tags on it.

    values, carry: Functions of degree 1 or 2, arrays with a row for each node of the geometry, or dicts or
    lists of them; they come back on the new mesh in the form in which they were given. The metric is made
    of the values at the vertices. how: as in asterism.adapt(); Functions of degree 2 are interpolated, and
    any other way refused. wishes: the other arguments of asterism.adapt().
    """
    old = from_dolfinx(mesh, cell_tags, facet_tags)
    wanted, brought = _Given(mesh, values, "u"), _Given(mesh, carry, "carried")
    _check_way(wanted, how)
    _check_way(brought, how)
    carried = {**brought.at_nodes()} if brought.all else None
    _take_tensors_at_nodes(mesh, wishes)
    made = _adapt_arrays(old, wanted.alone_or_named() if wanted.all else None, carry=carried, how=how, **wishes)
    new = to_dolfinx(made.mesh, mesh.comm)
    if cell_tags is None:
        new = new._replace(cell_tags=None)
    elif len(cell_tags.indices) < len(_cells(mesh)):
        new = new._replace(cell_tags=_without_zero(new))
    if facet_tags is None:
        new = new._replace(facet_tags=None)
    first = _named(made.values, wanted.names())
    return AdaptedDolfinx(new, wanted.on(new, old, first), brought.on(new, old, made.carried or {}), made.mesh,
                          made.metric, made.report)


def transfer(values: Values, to: Any, how: str = "project", *, mesh: Any = None) -> Any:
    """Functions, or arrays at the nodes of the geometry of `mesh`, transferred to the dolfinx mesh
    `to`, as by asterism.transfer(). Functions of degree 2 are interpolated: how="interpolate"."""
    source = mesh if mesh is not None else _mesh_of(values)
    old, new = from_dolfinx(source), from_dolfinx(to)
    given = _Given(source, values, "u")
    _check_way(given, how)
    moved = _transfer_arrays(old, given.at_nodes(), new, how)
    nodes = ToDolfinx(to, None, None, np.arange(len(new.points)))
    return given.on(nodes, old, moved)


# Fields: Functions and arrays, alone, in a list or in a dict.


class _Given:
    """Functions and arrays by name, and the form in which they were given."""

    def __init__(self, mesh: Any, given: Values, name: str) -> None:
        self.form = given
        self.all: Dict[str, Any] = {}
        if given is None:
            return
        if isinstance(given, Mapping):
            self.all = {str(key): of for key, of in given.items()}
        elif isinstance(given, (list, tuple)) and any(_is_function(of) for of in given):
            self.all = {f"{name}{k + 1}": of for k, of in enumerate(given)}
        else:
            self.all = {name: given}
        for key, of in list(self.all.items()):
            _check_no_expression(key, of)
            if _is_function(of):
                of = self.all[key] = _collapsed(of)
                _check_function(key, of, mesh)

    def names(self) -> List[str]:
        return list(self.all)

    def at_nodes(self) -> Dict[str, Any]:
        """Returns arrays with a row for each node of the geometry."""
        return {name: _at_nodes(of) if _is_function(of) else of for name, of in self.all.items()}

    def alone_or_named(self) -> Any:
        """Returns the arrays by name; one that was given without a name, which may be a metric, alone."""
        arrays = self.at_nodes()
        return arrays if isinstance(self.form, (Mapping, list, tuple)) or len(arrays) != 1 else next(iter(arrays.values()))

    def on(self, new: ToDolfinx, old: Mesh, moved: Dict[str, Any]) -> Any:
        """Returns the fields after a transfer, arrays with a row for each point of the new mesh, in the form in which
        they were given."""
        if not moved:
            return None
        made: Dict[str, Any] = {}
        for name, of in self.all.items():
            if _is_function(of) and _degree(of) == 2:
                made[name] = _interpolated(of, old, new.mesh)
            elif _is_function(of):
                made[name] = _function(of, new, np.asarray(moved[name]))
            else:
                made[name] = moved[name][new.points]
        if isinstance(self.form, Mapping):
            return made
        return list(made.values()) if isinstance(self.form, (list, tuple)) and len(made) > 0 and any(
            _is_function(of) for of in self.form) else next(iter(made.values()))


def _take_tensors_at_nodes(mesh: Any, wishes: Dict[str, Any]) -> None:
    """Replaces each Function among the metrics and second derivatives by rows at the nodes of the geometry."""
    if "metric" in wishes:
        wishes["metric"] = _tensors_at_nodes(mesh, "metric", wishes["metric"], _TENSORS)
    besides = wishes.get("intersect")
    if _is_function(besides) or isinstance(besides, (list, tuple)):
        every: Any = [besides] if _is_function(besides) else besides
        wishes["intersect"] = [_tensors_at_nodes(mesh, "intersect", of, _TENSORS) for of in every]
    given = wishes.get("hessian")
    if isinstance(given, Mapping):
        wishes["hessian"] = {name: _tensors_at_nodes(mesh, str(name), of, _DERIVATIVES) for name, of in given.items()}
    elif given is not None:
        wishes["hessian"] = _tensors_at_nodes(mesh, "hessian", given, _DERIVATIVES)


def _tensors_at_nodes(mesh: Any, name: str, given: Any, meanings: Mapping[int, str]) -> Any:
    """Returns tensors in a form that asterism.adapt() takes: of a Function, which dolfinx makes callable, too, rows at
    the nodes of the geometry."""
    _check_no_expression(name, given)
    if not _is_function(given):
        return given
    given = _collapsed(given)
    _check_function(name, given, mesh, meanings)
    rows = _at_nodes(given)
    return rows.reshape(len(rows), 2, 2) if _block(given) == 4 else rows.reshape(len(rows), -1)


def _check_no_expression(name: str, of: Any) -> None:
    if hasattr(of, "ufl_shape") and not _is_function(of):
        raise InputError(f"{name}: a Function is wanted, not an expression ({type(of).__name__}), which "
                         "Function.interpolate makes one of")


def _named(values: Any, names: List[str]) -> Dict[str, Any]:
    if values is None:
        return {}
    return dict(values) if isinstance(values, Mapping) else {names[0]: values}


def _is_function(of: Any) -> bool:
    return hasattr(of, "function_space") and hasattr(of, "x")


def _collapsed(of: Any) -> Any:
    """Returns a Function with an array of its own: a part of another, as u.sub(0), has the array of the whole."""
    if not list(of.function_space.component()):
        return of
    made = of.collapse()
    made.name = of.name
    return made


def _mesh_of(values: Values) -> Any:
    parts = list(values.values()) if isinstance(values, Mapping) else (
        list(values) if isinstance(values, (list, tuple)) else [values])
    for of in parts:
        _check_no_expression("values", of)
        if _is_function(of):
            return of.function_space.mesh
    raise InputError("mesh: it is to be named where no Function says which one the arrays are on")


def _degree(of: Any) -> int:
    element = of.function_space.ufl_element()
    degree = element.degree() if callable(element.degree) else element.degree
    return int(degree)


def _check_mesh(name: str, on: Any, mesh: Any) -> None:
    if not np.array_equal(on.geometry.x, mesh.geometry.x):
        raise InputError(f"{name}: it is on another mesh")


# Meanings of the components of a Function, by their number.
_COMPONENTS = {1: "a scalar", 2: "a vector", 3: "a vector or tensor"}
_TENSORS = {1: "sizes", 3: "m11 m12 m22", 4: "a matrix"}
_DERIVATIVES = {3: "xx xy yy", 4: "a matrix"}


def _check_function(name: str, of: Any, mesh: Any, meanings: Mapping[int, str] = _COMPONENTS) -> None:
    space = of.function_space
    _check_mesh(name, space.mesh, mesh)
    element = space.ufl_element()
    family = str(element.family() if callable(getattr(element, "family", None)) else getattr(element, "family_name", ""))
    width = len(_dofs(of)[0]) if len(_dofs(of)) else 3
    if family not in ("Lagrange", "CG", "P", "Q") or (_degree(of), width) not in ((1, 3), (2, 6)):
        hint = "; its projection onto degree 1 is one, and materials are cell_tags" if width == 1 else ""
        raise InputError(f"{name}: a continuous Lagrange function of degree 1 or 2 is wanted, not {element}{hint}")
    if np.iscomplexobj(of.x.array):
        raise InputError(f"{name}: complex numbers have no place here; give real and imaginary part as two fields")
    if not np.isfinite(of.x.array).all():
        raise InputError(f"{name}: entry {int(np.argmin(np.isfinite(of.x.array)))} of its array is not finite")
    if _block(of) not in meanings:
        listed = ", ".join(f"{count} ({meaning})" for count, meaning in meanings.items())
        raise InputError(f"{name}: it has {_block(of)} components, and one of these numbers is wanted: {listed}")


def _check_way(given: _Given, how: str) -> None:
    for name, of in given.all.items():
        if how != "interpolate" and _is_function(of) and _degree(of) == 2:
            raise InputError(f"{name}: it is of degree 2, and is brought along by how='interpolate' alone")


def _block(of: Any) -> int:
    return int(of.function_space.dofmap.index_map_bs)


def _rows(table: Any, width: int) -> npt.NDArray[np.int64]:
    """Returns the rows of a table of dolfinx, an adjacency list in some versions and an array in others."""
    return np.asarray(getattr(table, "array", table), dtype=np.int64).reshape(-1, width)


def _dofs(of: Any) -> npt.NDArray[np.int64]:
    """Returns the degrees of freedom of each cell: at its corners in their order, then on the opposite sides."""
    space = of.function_space
    count = space.mesh.topology.index_map(2).size_local
    flat = np.asarray(getattr(space.dofmap.list, "array", space.dofmap.list), dtype=np.int64).reshape(-1)
    return flat.reshape(count, -1) if count else flat.reshape(0, 3)


def _at_nodes(of: Any) -> npt.NDArray[np.float64]:
    """Returns values at the nodes of the geometry, (n,) or (n, c)."""
    mesh, block = of.function_space.mesh, _block(of)
    values = np.zeros((len(mesh.geometry.x), block))
    values[_cells(mesh)] = np.asarray(of.x.array).reshape(-1, block)[_dofs(of)[:, :3]]
    return values[:, 0] if block == 1 else values


def _space_like(of: Any, mesh: Any) -> Any:
    import dolfinx.fem

    make = getattr(dolfinx.fem, "functionspace", None) or dolfinx.fem.FunctionSpace
    return make(mesh, of.function_space.ufl_element())


def _new_function(of: Any, mesh: Any) -> Any:
    import dolfinx.fem

    made = dolfinx.fem.Function(_space_like(of, mesh))
    made.name = of.name
    return made


def _function(of: Any, new: ToDolfinx, at_points: npt.NDArray[np.float64]) -> Any:
    """Returns a Function of degree 1, in a space like that of `of`, with the values at the points of the
    asterism.Mesh."""
    made, block = _new_function(of, new.mesh), _block(of)
    values = np.asarray(at_points).reshape(-1, block)[new.points]
    made.x.array.reshape(-1, block)[_dofs(made)[:, :3]] = values[_cells(new.mesh)]
    return made


def _interpolated(of: Any, old: Mesh, mesh: Any) -> Any:
    """Returns a Function of degree 2 on the new mesh: the values of the old one at its points. A point outside of the
    old mesh, beside a curved boundary, gets the value of the nearest point."""
    made, block = _new_function(of, mesh), _block(of)
    at = np.asarray(made.function_space.tabulate_dof_coordinates())[:, :2]
    found = np.array(old.locate(at))
    if len(np.unique(np.array(old.points).view(np.complex128))) < len(old.points):
        _find_own_sides(found, at, old, mesh, _dofs(made))
    cells = _cells(of.function_space.mesh)
    weights = np.empty((len(at), 3))
    inside = found >= 0
    weights[inside] = _barycentric(old.points[cells[found[inside]]], at[inside])
    sides = _outer_sides(cells, np.asarray(old.neighbors), np.asarray(old.triangles))
    for k in np.flatnonzero(~inside):
        found[k], weights[k] = _nearest(old.points, cells, sides, at[k])
    a, b, c = weights.T
    shapes = np.column_stack([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * b * c, 4 * a * c, 4 * a * b])
    values = np.asarray(of.x.array).reshape(-1, block)[_dofs(of)[found]]
    made.x.array.reshape(-1, block)[:] = np.einsum("nk,nkc->nc", shapes, values)
    return made


def _find_own_sides(found: Any, at: Any, old: Mesh, mesh: Any, dofs: Any) -> None:
    """Sets the triangles of points on the boundary of the new mesh of a domain with slits to those on the side of the
    slit where the new cell is. dofs: the numbers of points of each new cell, as _dofs() has them."""
    cells = _cells(mesh)
    keys = _keys(cells[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), len(mesh.geometry.x))
    _, of, times = np.unique(keys, return_inverse=True, return_counts=True)
    t, i = np.nonzero((times[of] == 1).reshape(-1, 3))
    middles = np.asarray(mesh.geometry.x)[cells[t], :2].mean(axis=1)
    links = np.asarray(old.points), np.asarray(old.triangles), np.asarray(old.neighbors)
    for cell, side, middle, start in zip(t, i, middles, old.locate(middles)):
        for dof in dofs[cell, [(side + 1) % 3, (side + 2) % 3, 3 + side]]:
            end = _walked(links, int(start), middle, at[dof])
            found[dof] = end if end >= 0 else found[dof]


def _walked(links: Tuple[Any, Any, Any], start: int, first: Any, last: Any) -> int:
    """Returns the triangle in which a walk along a segment ends. Returns -1 where it leaves the mesh, or begins outside.
    A segment within a new cell crosses no slit. links: points, triangles and neighbors."""
    from ._predicates import orientation

    points, triangles, neighbors = links
    t, steps = start, 0
    while t >= 0 and steps <= len(triangles):
        a, b = points[np.roll(triangles[t], -1)], points[np.roll(triangles[t], -2)]
        is_beyond = np.asarray(orientation(a, b, last)) < 0
        if not is_beyond.any():
            return t
        crossed = is_beyond & (np.asarray(orientation(first, last, a)) <= 0)
        crossed &= np.asarray(orientation(first, last, b)) >= 0
        t, steps = (int(neighbors[t, np.argmax(crossed)]) if crossed.any() else -1), steps + 1
    return -1


def _barycentric(corners: Any, at: Any) -> Any:
    def doubled(p: Any, q: Any, r: Any) -> Any:
        return (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])

    p, q, r = corners[:, 0], corners[:, 1], corners[:, 2]
    parts = np.column_stack([doubled(at, q, r), doubled(p, at, r), doubled(p, q, at)])
    return parts / parts.sum(axis=1, keepdims=True)


def _outer_sides(cells: Any, neighbors: Any, triangles: Any) -> Any:
    """Returns cells with an edge on the boundary, and that edge's two corners."""
    t, i = np.nonzero(neighbors < 0)
    a, b = triangles[t, (i + 1) % 3], triangles[t, (i + 2) % 3]
    first = (cells[t] == a[:, None]).argmax(axis=1)
    second = (cells[t] == b[:, None]).argmax(axis=1)
    return t, first, second


def _nearest(points: Any, cells: Any, sides: Any, at: Any) -> Tuple[int, Any]:
    t, first, second = sides
    a, b = points[cells[t, first]], points[cells[t, second]]
    along = b - a
    part = np.clip(((at - a) * along).sum(axis=1) / (along * along).sum(axis=1), 0, 1)
    k = int(np.argmin(((a + part[:, None] * along - at) ** 2).sum(axis=1)))
    weights = np.zeros(3)
    weights[first[k]], weights[second[k]] = 1 - part[k], part[k]
    return int(t[k]), weights


# Meshes and tags.


def _check_alone(comm: Any) -> None:
    if comm.size > 1:
        raise InputError(f"comm: it has {comm.size} processes, and dolfinx meshes are taken on one (MPI.COMM_SELF); "
                         "asterism.petsc adapts a mesh that is distributed")


def _cells(mesh: Any) -> npt.NDArray[np.int64]:
    """Returns the nodes of each cell."""
    if not hasattr(mesh, "topology") or not hasattr(mesh, "geometry"):
        raise InputError(f"mesh: a dolfinx mesh is wanted, not {type(mesh).__name__}")
    _check_alone(mesh.comm)
    count = mesh.topology.index_map(2).size_local if mesh.topology.dim == 2 else 0
    flat = np.asarray(getattr(mesh.geometry.dofmap, "array", mesh.geometry.dofmap), dtype=np.int64).reshape(-1)
    if mesh.topology.dim != 2 or count == 0 or flat.size != 3 * count:
        raise InputError("mesh: triangles of degree 1 are wanted")
    return flat.reshape(count, 3)


def _counter_clockwise(points: Any, cells: Any) -> Any:
    from ._predicates import orientation

    turned = np.array(cells)
    corners = points[cells]
    clockwise = np.asarray(orientation(corners[:, 0], corners[:, 1], corners[:, 2])).reshape(-1) < 0
    turned[clockwise, 1], turned[clockwise, 2] = cells[clockwise, 2], cells[clockwise, 1]
    return turned


def _check_tags(mesh: Any, tags: Any, dim: int, name: str) -> None:
    if getattr(tags, "dim", None) != dim:
        given = f"those of dimension {tags.dim}" if hasattr(tags, "dim") else type(tags).__name__
        raise InputError(f"{name}: MeshTags of dimension {dim} are wanted, not {given}")
    if np.asarray(tags.values).dtype.kind not in "iu":
        raise InputError(f"{name}: whole numbers are wanted, not {np.asarray(tags.values).dtype}")
    if hasattr(tags, "mesh"):  # newer versions know their topology alone
        _check_mesh(name, tags.mesh, mesh)


def _facets(mesh: Any) -> npt.NDArray[np.int64]:
    """Returns the nodes of each facet."""
    topology = mesh.topology
    topology.create_connectivity(1, 0)
    topology.create_connectivity(2, 0)
    corners = _rows(topology.connectivity(2, 0), 3)
    node = np.empty(topology.index_map(0).size_local, dtype=np.int64)
    node[corners] = _cells(mesh)
    return node[_rows(topology.connectivity(1, 0), 2)]


def _keys(pairs: Any, count: int) -> Any:
    return pairs.min(axis=1).astype(np.int64) * count + pairs.max(axis=1)


def _edges_and_markers(mesh: Any, cells: Any, regions: Any, facet_tags: Any) -> Tuple[Any, Any]:
    """Returns the edges on the boundary, between regions and with a tag, and their markers."""
    count = len(mesh.geometry.x)
    sides = cells[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2)
    keys = _keys(sides, count)
    order = np.argsort(keys, kind="stable")
    found, first, times = np.unique(keys[order], return_index=True, return_counts=True)
    left, right = order[first], order[first + times - 1]
    parts = (times == 1) | (regions[left // 3] != regions[right // 3])
    marked = np.zeros(len(found), dtype=np.int64)
    if facet_tags is not None:
        _check_tags(mesh, facet_tags, 1, "facet_tags")
        if (np.asarray(facet_tags.values) == 0).any():
            raise InputError("facet_tags: 0 is the marker of facets without a tag; give them another number")
        tagged = np.searchsorted(found, _keys(_facets(mesh)[facet_tags.indices], count))
        marked[tagged] = facet_tags.values
        parts[tagged] = True
    return sides[left[parts]], marked[parts]


def _facet_tags(made: Any, mesh: Mesh, points: Any) -> Any:
    import dolfinx.mesh

    count = len(mesh.points)
    facets = _keys(points[_facets(made)], count)
    keys = _keys(np.asarray(mesh.edges), count)
    markers = np.asarray(mesh.edge_markers)
    order = np.argsort(facets)
    at = order[np.searchsorted(facets[order], keys[markers != 0])].astype(np.int32)
    sorted_at = np.argsort(at)
    return dolfinx.mesh.meshtags(made, 1, at[sorted_at], markers[markers != 0][sorted_at].astype(np.int32))


def _without_zero(new: ToDolfinx) -> Any:
    import dolfinx.mesh

    values = np.asarray(new.cell_tags.values)
    kept = np.flatnonzero(values != 0).astype(np.int32)
    return dolfinx.mesh.meshtags(new.mesh, 2, kept, values[kept].astype(np.int32))


def _domain() -> Dict[str, Any]:
    """Returns the coordinate element of plane triangles as the keyword of create_mesh() of the installed version. It
    stands before or behind the points, depending on the version."""
    import inspect

    import dolfinx.mesh
    import ufl

    try:
        import basix.ufl

        element = basix.ufl.element("Lagrange", "triangle", 1, shape=(2,))
    except ImportError:
        element = ufl.VectorElement("Lagrange", "triangle", 1)
    is_element = "e" in inspect.signature(dolfinx.mesh.create_mesh).parameters
    return {"e": element} if is_element else {"domain": ufl.Mesh(element)}
