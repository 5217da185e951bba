# SPDX-License-Identifier: MIT
"""Domains from arrays, from files, and from objects of other packages."""
from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError, _Domain
from ._calls import meant, told_methods
from ._forms import is_mesh_file, is_table, path_of

if TYPE_CHECKING:
    from ._mesh import Mesh

_BUILT_IN = ("square", "airfoil", "naca0012")


class Repair(NamedTuple):
    """A place where a domain was changed; `what` is one of joined, bent, crossing, trimmed, hole dropped."""

    what: str
    x: float
    y: float


@told_methods
class Domain:
    """A planar straight-line graph that is to be meshed.

    points (n, 2); segments (s, 2) of point numbers; without segments the points are a ring, in their
    order; markers (s,) int, carried to the mesh's edges; holes (h, 2), a point inside each; regions
    (r, 2) and region_numbers (r,), a point inside each and its number. Raises InputError for segments
    that cross, rings that are not closed, and hole points on a segment. Other faults are mended:
    repeated points become one, overlapping segments are split. With `repair`, True or a distance,
    crossings become points, near points one, and gaps are closed; `repairs` says where. With
    `convex_hull` the sides of the convex hull of the points become segments of marker 0 where none is
    given. So points alone are a domain, without a ring.
    """

    _is_meshed = False

    def __init__(self, points: npt.ArrayLike, segments: Optional[npt.ArrayLike] = None,
                 markers: Optional[npt.ArrayLike] = None, holes: npt.ArrayLike = (),
                 regions: npt.ArrayLike = (), region_numbers: Optional[npt.ArrayLike] = None, *,
                 repair: "bool | float" = False, convex_hull: bool = False) -> None:
        if segments is None and convex_hull:
            segments = np.empty((0, 2), np.int64)
        elif segments is None:
            points, segments = _ring(points)
        self._made = _Domain(points, segments, markers, holes, regions, region_numbers, repair, convex_hull)

    @classmethod
    def _of(cls, made: _Domain) -> Domain:
        domain = cls.__new__(cls)
        domain._made = made
        return domain

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """(n, 2), a view."""
        return self._made.points

    @property
    def segments(self) -> npt.NDArray[np.int32]:
        """(s, 2), those of the boundary with the domain on the left."""
        return self._made.segments

    @property
    def markers(self) -> npt.NDArray[np.int32]:
        """(s,)"""
        return self._made.markers

    @property
    def name(self) -> str:
        return self._made.name

    @property
    def box(self) -> Tuple[float, float, float, float]:
        """The bounding box: least x and y, greatest x and y."""
        return self._made.box

    @property
    def __geo_interface__(self) -> Dict[str, Any]:
        """The domain as a Polygon or MultiPolygon of GeoJSON, which shapely.geometry.shape() takes. It has no
        segments inside and no regions, and the chords of curves."""
        polygons = [[_positions(ring) for ring in rings] for rings in _asterism._polygons(self._made)]
        if len(polygons) == 1:
            return {"type": "Polygon", "coordinates": tuple(polygons[0])}
        return {"type": "MultiPolygon", "coordinates": tuple(map(tuple, polygons))}

    @property
    def repairs(self) -> List[Repair]:
        """The places at which a repair changed the domain."""
        return [Repair(*place) for place in self._made.repairs]

    def __repr__(self) -> str:
        return f"<Domain: {len(self.points)} points, {len(self._made.segments)} segments>"

    @classmethod
    def from_arrays(cls, points: npt.ArrayLike, segments: npt.ArrayLike, **more: Any) -> Domain:
        """The same as Domain(points, segments, ...)."""
        return cls(points, segments, **more)

    @classmethod
    def square(cls) -> Domain:
        """The built-in square [-1, 1]^2."""
        return cls._of(_Domain.load("square"))

    @classmethod
    def read(cls, path: "str | os.PathLike[str]", *, repair: "bool | float" = False,
             convex_hull: bool = False) -> Domain:
        """From a file: .poly, .node with convex_hull=True, .geojson, .json or .wkt; .dxf, as read_dxf()
        does; or the area that a mesh file's triangles cover, or its edges bound where it has no
        triangles. Parts that the reader skips are named in a UserWarning."""
        name = path_of(path)
        if not os.path.exists(name):
            raise InputError(f"{name}: cannot be opened for reading: no such file{_near(name)}")
        if name.lower().endswith(".dxf"):
            from ._drawing import read_dxf

            return read_dxf(name, repair=repair, convex_hull=convex_hull)
        if not is_mesh_file(name):
            return cls._of(_Domain.load(name, repair, convex_hull))
        from ._mesh import read_file

        of = read_file(name, False)
        if len(of.triangles) == 0:
            return cls._of(_Domain.load(name, repair, convex_hull))
        _refuse_for_mesh(name, repair, convex_hull)
        return cls._covering(of)

    @classmethod
    def _covering(cls, mesh: Mesh) -> Domain:
        """Returns the domain of a mesh. The mesh may be kept if it already meets the demands."""
        domain = cls.from_mesh(mesh)
        domain._is_meshed = True
        return domain

    @classmethod
    def from_mesh(cls, mesh: Mesh, corner_angle: Optional[float] = None) -> Domain:
        """What a Mesh covers, with its regions and markers.

        An edge between triangles of different regions is a segment, with a UserWarning where it is not
        among the mesh's edges. Every point is one of the domain; with a corner_angle, in degrees, only
        those that determine its shape, as `asterism adapt` finds them: a curved outer boundary becomes
        coarser where the mesh's metric is, lines between regions do not.
        """
        made = getattr(mesh, "_made", None)
        if made is None or not hasattr(made, "domain"):
            raise InputError(f"a Mesh is wanted, not {type(mesh).__name__}")
        return cls._of(made.domain(corner_angle))

    @classmethod
    def from_geo(cls, shape: Any, *, repair: "bool | float" = False, convex_hull: bool = False) -> Domain:
        """From polygons: a shape of shapely, or anything else that has __geo_interface__, or such a dict.

        What they contain, and how sides and regions are numbered, is as in a .geojson file: a polygon's
        holes remove nothing from other polygons, the rings of polygon k have the marker k from 1, a
        stretch of boundary that two polygons share becomes an edge inside the mesh, and of several
        features each is a region. Points, lines, empty geometries and rings without area are skipped,
        with a UserWarning.
        """
        name = type(shape).__name__
        geometry = _bare(shape)
        if not isinstance(geometry, dict):
            raise InputError(f"polygons are wanted, not {name}: a shape of shapely, what has __geo_interface__, or "
                             "a dict as GeoJSON has it")
        try:
            text = json.dumps(geometry, allow_nan=False, default=_plain)
        except (TypeError, ValueError) as odd:
            raise InputError(f"{name}: its coordinates must be finite numbers: {odd}") from odd
        return cls._of(_Domain.parse_geojson(text, name, repair, convex_hull))

    from_shapely = from_geo


AnyDomain = Union[Domain, "Mesh", str, "os.PathLike[str]", npt.ArrayLike, Mapping[str, Any]]


def _refuse_for_mesh(name: str, repair: "bool | float", convex_hull: bool) -> None:
    if repair is not False:
        raise InputError(f"repair: {name} is a mesh, whose edges are kept as they are")
    if convex_hull:
        raise InputError(f"convex_hull: {name} is a mesh, which has its boundary already")


def as_domain(what: Any, repair: "bool | float" = False, convex_hull: bool = False) -> Domain:
    """Returns a domain made of a Domain or a Mesh, the name of a file or of a built-in domain, polygons, or the
    points of a ring."""
    if isinstance(what, Domain):
        if repair is False and not convex_hull:
            return what
        return Domain._of(what._made.repaired(repair, convex_hull))
    if hasattr(getattr(what, "_made", None), "domain"):
        _refuse_for_mesh("this", repair, convex_hull)
        return Domain._covering(what)
    if isinstance(what, (str, bytes, os.PathLike)):
        name = path_of(what)
        if name in _BUILT_IN:
            return Domain._of(_Domain.load(name, repair, convex_hull))
        return Domain.read(name, repair=repair, convex_hull=convex_hull)
    if hasattr(what, "__geo_interface__") or isinstance(what, Mapping):
        return Domain.from_geo(what, repair=repair, convex_hull=convex_hull)
    if isinstance(what, Iterator):
        what = list(what)
    if not is_table(what):
        raise InputError("a domain is wanted: a Domain, a file's name, polygons or points (n, 2), not "
                         + (repr(what) if isinstance(what, (int, float, type(None))) else type(what).__name__))
    return Domain(what, repair=repair, convex_hull=convex_hull)


def _positions(ring: npt.NDArray[np.float64]) -> Tuple[Tuple[float, float], ...]:
    return tuple((x, y) for x, y in ring.tolist())


def _ring(points: npt.ArrayLike) -> Tuple[Any, npt.NDArray[np.int64]]:
    """Returns the points, without the last one where it repeats the first, and the segments from each to the next."""
    corners: Any = points if isinstance(points, np.ndarray) else _array(points)
    if corners.ndim != 2 or corners.shape[1] != 2:
        raise InputError(f"points: the shape (n, 2) is wanted, not {corners.shape}{_instead(corners.shape)}")
    if len(corners) > 1 and (corners[0] == corners[-1]).all():
        corners = corners[:-1]
    if len(corners) < 3:
        raise InputError(f"points: a ring has three or more, not {len(corners)}; without segments they are one")
    first = np.arange(len(corners))
    return corners, np.column_stack([first, np.roll(first, -1)])


def _array(points: Any) -> Any:
    try:
        return np.asarray(points)
    except ValueError:
        for k, row in enumerate(points):
            if not isinstance(row, (list, tuple, np.ndarray)) or len(row) != 2:
                raise InputError(f"points: rows of two numbers are wanted, and row {k} is {row!r}") from None
        raise InputError("points: rows of two numbers are wanted") from None


def _instead(shape: Tuple[int, ...]) -> str:
    """Returns a hint for a message: which part of a table of this shape has the shape (n, 2); "" where none has."""
    if len(shape) == 2 and shape[0] == 2 and shape[1] > 2:
        return "; points.T has it"
    return "; points[:, :2] leaves the third coordinate out" if len(shape) == 2 and shape[1] == 3 else ""


def _near(name: str) -> str:
    """Returns a hint for a message: the built-in domain, or the file in the same folder, whose name is near to an
    unknown name; "" where none is."""
    folder, last = os.path.split(name)
    try:
        there = [*(() if folder else _BUILT_IN), *os.listdir(folder or ".")]
    except OSError:
        return f"; there is no directory {folder}"
    return meant(last, there)


def _bare(shape: Any) -> Any:
    """Returns the geometry without properties, which may have any type."""
    shape = getattr(shape, "__geo_interface__", shape)
    if not isinstance(shape, dict):
        return shape
    bare = {key: shape[key] for key in ("type", "coordinates") if key in shape}
    if "geometry" in shape:
        bare["geometry"] = _bare(shape["geometry"])
    for key in ("features", "geometries"):
        if key in shape:
            parts = shape[key]
            bare[key] = [_bare(one) for one in parts] if isinstance(parts, (list, tuple)) else parts
    return bare


def _plain(value: Any) -> Any:
    """Returns numbers and arrays of numpy in types that json writes."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no number")
