# SPDX-License-Identifier: MIT
"""Domains from arrays, files, and objects that other packages know."""
from __future__ import annotations

import os
from typing import Any, List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ._asterism import InputError, _Domain


class Domain(_Domain):
    """A planar straight-line graph: what is to be meshed.

    points (n, 2); segments (s, 2) of point numbers; markers (s,) int, carried to the mesh's edges;
    holes (h, 2), a point inside each; regions (r, 2) and region_numbers (r,), a point inside each
    and its number. Raises InputError for what cannot be meant: segments that cross, rings that are
    not closed, hole points on a segment. What can be put in order is: repeated points are one,
    overlapping segments are split.
    """

    def __repr__(self) -> str:
        return f"<Domain: {len(self.points)} points, {len(self.segments)} segments>"

    @classmethod
    def from_arrays(cls, points: npt.ArrayLike, segments: npt.ArrayLike, **more: Any) -> Domain:
        """The same as Domain(points, segments, ...)."""
        return cls(points, segments, **more)

    @classmethod
    def square(cls) -> _Domain:
        """[-1, 1]^2, as the command knows it."""
        return cls.load("square")

    @classmethod
    def read(cls, path: "str | os.PathLike[str]") -> _Domain:
        """From a .poly file of Triangle."""
        if not os.path.exists(path):
            raise InputError(f"{os.fspath(path)}: cannot be opened for reading")
        return cls.load(os.fspath(path))

    @classmethod
    def from_geo(cls, shape: Any) -> Domain:
        """From a Polygon or MultiPolygon: anything with __geo_interface__, or such a dict.

        The rings of polygon k have the marker k + 1. Polygons may touch in points; where two share a
        stretch of boundary it becomes an edge inside the mesh.
        """
        points: List[Tuple[float, float]] = []
        segments: List[Tuple[int, int]] = []
        markers: List[int] = []
        holes: List[Sequence[float]] = []
        for number, rings in enumerate(_polygons(shape)):
            for which, ring in enumerate(rings):
                corners = _open_ring(ring)
                first = len(points)
                points.extend((float(p[0]), float(p[1])) for p in corners)
                segments.extend((first + k, first + (k + 1) % len(corners))
                                for k in range(len(corners)))
                markers.extend([number + 1] * len(corners))
                if which > 0:
                    holes.append(_point_inside(corners))
        return cls(points, segments, markers=markers, holes=np.reshape(holes, (-1, 2)))

    from_shapely = from_geo


def _polygons(shape: Any) -> List[Any]:
    geometry = getattr(shape, "__geo_interface__", shape)
    if isinstance(geometry, dict) and geometry.get("type") == "Feature":
        geometry = geometry["geometry"]
    kind = geometry.get("type") if isinstance(geometry, dict) else None
    if kind == "Polygon":
        return [geometry["coordinates"]]
    if kind == "MultiPolygon":
        return list(geometry["coordinates"])
    raise InputError(f"a Polygon or MultiPolygon is wanted, not {kind or type(shape).__name__}")


def _open_ring(ring: Sequence[Sequence[float]]) -> List[Sequence[float]]:
    corners = [p for p, after in zip(ring, list(ring[1:]) + [None])
               if after is None or tuple(p[:2]) != tuple(after[:2])]
    if len(corners) > 1 and tuple(corners[0][:2]) == tuple(corners[-1][:2]):
        corners.pop()
    if len(corners) < 3:
        raise InputError(f"a ring of {len(corners)} points")
    return corners


def _crossings(corners: Sequence[Sequence[float]], y: float) -> Optional[List[float]]:
    """Where the ring crosses the horizontal line, sorted; None if a corner is on it."""
    found = []
    for (px, py), (qx, qy) in zip(((p[0], p[1]) for p in corners),
                                  ((p[0], p[1]) for p in list(corners[1:]) + [corners[0]])):
        if y in (py, qy):
            return None
        if (py < y) != (qy < y):
            found.append(px + (qx - px) * ((y - py) / (qy - py)))
    return sorted(found)


def _point_inside(corners: Sequence[Sequence[float]]) -> Tuple[float, float]:
    """In the widest place of one of the lines halfway between two corners' heights."""
    heights = sorted({float(p[1]) for p in corners})
    best: Optional[Tuple[float, float, float]] = None
    for low, high in zip(heights, heights[1:]):
        y = 0.5 * (low + high)
        across = _crossings(corners, y) or []
        for left, right in zip(across[::2], across[1::2]):
            room = min(right - left, high - low)
            if best is None or room > best[0]:
                best = (room, 0.5 * (left + right), y)
    if best is None:
        raise InputError("a hole without an inside")
    return best[1], best[2]
