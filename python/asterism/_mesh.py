# SPDX-License-Identifier: MIT
"""Meshes: their arrays, measures, pictures and files."""
from __future__ import annotations

import os
import tempfile
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError, _Mesh
from ._calls import told, told_methods, warn
from ._certificate import Certificate
from ._domain import Domain
from ._forms import MESHIO_FILES, Fields, definite, doubles, named_fields, path_of, tensor_rows, whole
from ._page import Before, Page, page_of

Doubles = npt.NDArray[np.float64]
Wholes = npt.NDArray[np.int32]
Markers = Union[npt.ArrayLike, Mapping[Tuple[int, int], int]]


def _made_of(points: npt.ArrayLike, triangles: npt.ArrayLike, metric: npt.ArrayLike, more: Dict[str, Any]) -> _Mesh:
    at = _in_plane(doubles("points", points))
    if at.ndim == 2 and not np.isfinite(at).all():
        raise InputError(f"points: row {int(np.argmin(np.isfinite(at).all(axis=1)))} is not finite")
    return _Mesh.from_arrays(at, triangles, definite("metric", tensor_rows("metric", metric, len(at))), more)


def _in_plane(at: Doubles) -> Doubles:
    """Leaves out third coordinates that are all the same, with a warning where they are not 0."""
    if at.ndim != 2 or at.shape[1] != 3 or len(at) == 0:
        return at
    height = at[0, 2]
    if not np.all(at[:, 2] == height):
        raise InputError("points: third coordinates differ, and a mesh of the plane is wanted; points[:, :2] leaves "
                         "them out")
    if height != 0:
        warn(f"all points are at the height z = {height:.6g}, which is left out")
    return at[:, :2]


def _edges_in(name: str, markers: Markers) -> Tuple[Any, Any]:
    """Returns the edges and their markers from markers that have the edges with them."""
    if isinstance(markers, Mapping):
        markers = [(*_pair_of(name, edge), marker) for edge, marker in markers.items()] or np.empty((0, 3))
    rows = doubles(name, markers)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError(f"{name}: edges (b, 2) are wanted with markers (b,); without edges, markers are rows (b, 3) "
                         f"of two points and the marker, or {{(i, j): marker}}, not an array of the shape {rows.shape}")
    return rows[:, :2], rows[:, 2]


def _pair_of(name: str, edge: Any) -> Tuple[Any, Any]:
    try:
        first, second = edge
    except (TypeError, ValueError):
        raise InputError(f"{name}: a key is a pair of points (i, j), not {edge!r}") from None
    return first, second


@told_methods
class Mesh:
    """Triangles and the metric at their points.

    From elsewhere: points (n, 2), or (n, 3) at one height, triangles (t, 3); a metric in any form that tensors
    have, one for all or one a point; regions (t,); edges (b, 2) with their markers (b,), also called
    edge_markers, or markers alone, as rows (b, 3) of two points and the marker or as {(i, j): marker}; values:
    fields at the points, as asterism.adapt() takes them. Numbers are whole and of 32 bits. Without regions the
    region is 1; sides that are not among the edges get the marker 0, with a UserWarning.
    corners, required_points (k,) and required_edges (k, 2) stay where the mesh is adapted.
    """

    def __init__(self, points: npt.ArrayLike, triangles: npt.ArrayLike, metric: npt.ArrayLike = (1, 0, 1), *,
                 regions: Optional[npt.ArrayLike] = None, edges: Optional[npt.ArrayLike] = None,
                 markers: Optional[Markers] = None, edge_markers: Optional[Markers] = None,
                 values: Optional[Fields] = None, corners: Optional[npt.ArrayLike] = None,
                 required_points: Optional[npt.ArrayLike] = None,
                 required_edges: Optional[npt.ArrayLike] = None) -> None:
        if markers is not None and edge_markers is not None:
            raise InputError("markers, edge_markers: two names of one thing, and both are given")
        name, given = ("markers", markers) if edge_markers is None else ("edge_markers", edge_markers)
        if edges is None and given is not None:
            edges, given = _edges_in(name, given)
        self._made = _made_of(
            points, triangles, metric,
            {"regions": regions, "edges": edges, "edge_markers": given,
             "corners": corners, "required_points": required_points, "required_edges": required_edges})
        self._take_values(values)

    def _take_values(self, values: Optional[Fields]) -> None:
        self._values: Dict[str, Doubles] = {}
        for name, of in [] if values is None else named_fields(values):
            held = np.array(doubles(name, of))
            if held.ndim not in (1, 2) or len(held) != len(self.points):
                raise InputError(f"{name}: {len(self.points)} rows of numbers are wanted, one a point, not an "
                                 f"array of the shape {held.shape}")
            held.setflags(write=False)
            self._values[name] = held

    @classmethod
    def _to_judge(cls, points: npt.ArrayLike, triangles: npt.ArrayLike, metric: npt.ArrayLike) -> Mesh:
        return cls._of(_made_of(points, triangles, metric, {"is_judged": True}))

    @classmethod
    def _of(cls, made: _Mesh, values: Optional[Mapping[str, Any]] = None) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._made = made
        mesh._take_values(values)
        return mesh

    @property
    def points(self) -> Doubles:
        """(n, 2), a view; the first `given` are the domain's vertices."""
        return self._made.points

    @property
    def metric(self) -> Doubles:
        """(n, 3) = m11 m12 m22, a view."""
        return self._made.metric

    @property
    def sites(self) -> Doubles:
        """(n, 5) = x y m11 m12 m22, a view."""
        return self._made.sites

    @property
    def triangles(self) -> Wholes:
        """(t, 3), counter-clockwise, a view."""
        return self._made.triangles

    @property
    def disagreeing(self) -> Wholes:
        """(d, 3), triangles that are not in the stars of all three corners; none in a complete mesh."""
        return self._made.disagreeing

    @property
    def regions(self) -> Wholes:
        """(t,)"""
        return self._made.regions

    @property
    def edges(self) -> Wholes:
        """(b, 2), of the boundary and inside, the domain on the left."""
        return self._made.edges

    @property
    def edge_markers(self) -> Wholes:
        """(b,)"""
        return self._made.edge_markers

    @property
    def given(self) -> int:
        """Number of points, the first ones, that are vertices of the domain; 0 for a mesh from elsewhere."""
        return self._made.given

    @property
    def complete(self) -> bool:
        """True if the mesher reached its goal."""
        return self._made.complete

    @property
    def certified(self) -> bool:
        """True if the mesher reached its goal, and the auditor found nothing against the mesh. False for a mesh from
        elsewhere, even beside a certificate: verify() audits it."""
        return self._made.certified

    @property
    def reason(self) -> str:
        """A sentence: why the run ended."""
        return self._made.reason

    @property
    def values(self) -> Dict[str, Doubles]:
        """Fields at the points by name: those given with the mesh, or those that adapt() transferred to it."""
        return dict(self._values)

    @property
    def certificate(self) -> Union[Certificate, Any]:
        """The certificate. None for a mesh from elsewhere without one; a checker of types takes it as given."""
        text = self._made.certificate_text
        return None if text is None else Certificate(text)

    @property
    def domain(self) -> Domain:
        """The domain of the run or of the certificate; else the domain that the mesh covers."""
        original = self._made.original()
        return Domain.from_mesh(self) if original is None else Domain._of(original)

    @property
    def angles(self) -> Doubles:
        """(t, 3), degrees: the angle at each corner, the least over the metrics of the three corners."""
        return _asterism._angles(self._made)

    @property
    def lengths(self) -> Doubles:
        """(t, 3): the metric length of the side opposite to each corner, the mean over the metrics of its two
        ends."""
        return _asterism._lengths(self._made)

    @property
    def qualities(self) -> Doubles:
        """(t,): 4 sqrt 3 area / sum of squared lengths in the mean metric of the corners; equilateral: 1."""
        return _asterism._qualities(self._made)

    @property
    def neighbors(self) -> Wholes:
        """(t, 3): the triangle across the side opposite to each corner; -1 at the boundary."""
        return _asterism._neighbors(self._made)

    def locate(self, points: npt.ArrayLike) -> Wholes:
        """(n,): a triangle that contains each point (n, 2), on its sides too, by exact signs; -1 outside."""
        return _asterism._locate(self._made, doubles("points", points))

    def interpolate(self, values: npt.ArrayLike, points: npt.ArrayLike, *,
                    outside: Optional[npt.ArrayLike] = None) -> Doubles:
        """Values at points (n, 2), linear between those at the mesh's points, (m,) or (m, c).

        outside: the value of points in no triangle, or (c,), one a column of values; None: they are refused.
        """
        if isinstance(values, Mapping):
            raise InputError("values: an array is wanted, not a dict; each of its fields is interpolated by itself")
        of = doubles("values", values)
        if of.ndim not in (1, 2) or len(of) != len(self.points):
            raise InputError(f"values: {len(self.points)} rows are wanted, one a point of the mesh, not an array "
                             f"of the shape {of.shape}")
        filling = None if outside is None else doubles("outside", outside)
        if filling is not None and filling.shape not in ((), of.shape[1:]):
            raise InputError(f"outside: a number is wanted, or one for each column of values, not an array of the "
                             f"shape {filling.shape}")
        at = np.atleast_2d(doubles("points", points))
        found = self.locate(at)
        lost = np.flatnonzero(found < 0)
        if len(lost) and filling is None:
            x, y = at[lost[0]]
            raise InputError(f"points: row {lost[0]}, ({x}, {y}), is in no triangle of the mesh; outside=0, say, "
                             f"gives such points a value")
        corners = self.triangles[found]
        weights = _weights(self.points[corners], at)
        made: Doubles = np.einsum("nk,nk...->n...", weights, of[corners])
        if len(lost):
            made[lost] = filling
        return made

    def statistics(self) -> Dict[str, float]:
        """Edge lengths, shapes and more in the metric, by name."""
        return self._made.statistics()

    def verify(self, certificate: Optional[str] = None, angle_bound: Optional[float] = None) -> Dict[str, Any]:
        """Audits the mesh again; see asterism.verify()."""
        from ._judging import verify

        return verify(self, certificate, angle_bound)

    def save(self, path: "str | os.PathLike[str]") -> List[str]:
        """Writes the format that the ending names, and the certificate, if there is one, beside it: .mesh or
        .meshb (with .sol or .solb), .msh (gmsh 4.1), .msh2 (2.2), .vtu, .su2, .node (with .ele and .edge), .svg,
        .png, .pdf, or .html, a page to look at and to judge by. The values are written, too: in .msh,
        .vtu and .html, and for a .mesh in NAME.fields.sol beside it; for other formats, which have no
        place for them, there is a UserWarning. Returns the names of the files."""
        return self._made.save(path_of(path), list(self.values.items()))

    def show(self, values: Optional[Fields] = None, *, before: Optional[Before] = None,
             wanted: Optional[npt.ArrayLike] = None, title: str = "Mesh", label: Optional[str] = None,
             height: int = 640) -> Page:
        """The page about the mesh: a notebook shows it where this is the last line of a cell.

        values: fields on it to colour by, as asterism.adapt() takes them; None: its own `values`.
        before: an earlier mesh or the domain, which a button shows, or the rounds of a loop, which a
        slider shows: a Mesh, with other fields (mesh, u), a Domain, a list of these, or a dict of them
        by label. wanted: the metric asked for, in any form that tensors have: a colour shows the
        distance of the metric delivered from it. label: name of the mesh itself beside the earlier
        ones. height: of the frame, in pixels.
        """
        return page_of(self, values, before, wanted, title, label, height)

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The domain that the mesh covers, as polygons of GeoJSON: for shapely.geometry.shape(mesh) and others."""
        return Domain.from_mesh(self).__geo_interface__

    def to_meshio(self) -> Any:
        """A meshio.Mesh with the boundary, markers, regions, the metric and the values.

        Its write("x.msh") writes gmsh's format. meshio.write("x.msh", ...) takes the ending for that of ANSYS unless
        it is given file_format="gmsh". save("x.msh") here writes gmsh's, too, and names the groups."""
        from ._exchange import to_meshio

        return to_meshio(self)

    @classmethod
    def from_meshio(cls, other: Any) -> Mesh:
        """Makes a Mesh of a meshio.Mesh: triangles and lines with their references, and point data as values."""
        from ._exchange import from_meshio

        return from_meshio(other)

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData with the metric and the values at its points and the region of its triangles."""
        from ._exchange import to_pyvista

        return to_pyvista(self)

    def plot(self, ax: Any = None, **line: Any) -> Any:
        """Draws into a matplotlib Axes, and returns it."""
        import matplotlib.pyplot as plt

        if ax is None:
            ax = plt.gca()
        if not hasattr(ax, "triplot"):
            raise InputError(f"ax: an Axes of matplotlib is wanted, not {type(ax).__name__}")
        ax.triplot(self.points[:, 0], self.points[:, 1], self.triangles,
                   **{"linewidth": 0.4, "color": "black", **line})
        ends = self.points[self.edges]
        ax.plot(ends[:, :, 0].T, ends[:, :, 1].T, color="black", linewidth=1.2)
        ax.set_aspect("equal")
        return ax

    def _repr_svg_(self) -> str:
        return self._made.svg()

    def svg(self, width: int = 600, ellipses: bool = False) -> str:
        """Returns the picture as text; with `ellipses` it shows the unit circles of the metric."""
        return self._made.svg(width=whole("width", width, 16), ellipses=bool(ellipses))

    def __repr__(self) -> str:
        state = "certified" if self.certified else "not certified"
        if not self.certified and self._made.claims_certified:
            state = "certified by its certificate, which verify() holds against it"
        return f"<Mesh: {len(self.points)} points, {len(self.triangles)} triangles, {state}>"


def _weights(corners: Doubles, at: Doubles) -> Doubles:
    """Returns barycentric coordinates (n, 3) of points in triangles (n, 3, 2), none below 0, with sum 1."""
    areas = np.empty((len(at), 3))
    for k in range(3):
        a, b = corners[:, (k + 1) % 3], corners[:, (k + 2) % 3]
        areas[:, k] = (a[:, 0] - at[:, 0]) * (b[:, 1] - at[:, 1]) - (a[:, 1] - at[:, 1]) * (b[:, 0] - at[:, 0])
    areas = np.maximum(areas, 0)
    sums = areas.sum(axis=1, keepdims=True)
    return np.divide(areas, sums, out=np.full_like(areas, 1 / 3), where=sums > 0)


@told
def read(path: "str | os.PathLike[str]") -> Mesh:
    """Reads a mesh: .mesh, .meshb, .msh, .vtu, .vtk, .su2, .14, .grd, .2dm, .stl, or .xdmf through meshio;
    with the metric of its .sol or in it (without one: the plane's) and the certificate beside it. The fields
    in a .msh or .vtu, or of a .mesh in NAME.sol or NAME.fields.sol beside it, are its `values`; of one that is
    there for several steps in time, the last. Changes by the reader are a UserWarning."""
    return read_file(path_of(path), True)


def read_file(name: str, with_values: bool) -> Mesh:
    """Returns the mesh in a file, with the fields in it where they are wanted."""
    if not name.lower().endswith(MESHIO_FILES):
        return _with_fields(*_Mesh.read(name, with_values))
    import meshio

    try:
        given = meshio.read(name)
    except (OSError, meshio.ReadError) as odd:
        raise InputError(f"{name}: {odd}") from odd
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, os.path.basename(name) + ".vtu")
        meshio.write(file, given)
        return _with_fields(*_Mesh.read(file, with_values))


def _with_fields(made: _Mesh, names: List[str], arrays: List[Doubles]) -> Mesh:
    return Mesh._of(made, {name: of[:, 0] if of.shape[1] == 1 else of for name, of in zip(names, arrays)})
