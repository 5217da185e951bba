# SPDX-License-Identifier: MIT
"""Domains from arrays, files, and objects that other packages know."""
from __future__ import annotations

import json
import os
from typing import Any, Optional

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
        """From a file: .poly, .geojson, .json or .wkt. What its reader passed over is a UserWarning."""
        if not os.path.exists(path):
            raise InputError(f"{os.fspath(path)}: cannot be opened for reading")
        return cls.load(os.fspath(path))

    @classmethod
    def from_mesh(cls, mesh: Any, corner_angle: Optional[float] = None) -> _Domain:
        """What a Mesh covers, with its regions and markers.

        An edge between triangles of different regions is a segment, and told in a UserWarning where it
        is not among the mesh's edges. Every point is one of the domain; with a corner_angle, in degrees,
        those alone that keep its shape, as `asterism adapt` finds them: a curved outer boundary becomes
        coarser where the mesh's metric is, lines between regions do not.
        """
        made: _Domain = mesh._made.domain(corner_angle)
        return made

    @classmethod
    def from_geo(cls, shape: Any) -> _Domain:
        """From polygons: a shape of shapely, or anything else that has __geo_interface__, or such a dict.

        What they contain, and how sides and regions are numbered, is as in a .geojson file: a
        polygon's holes take nothing away from the others, the rings of polygon k have the marker k
        from 1, a stretch of boundary that two polygons share becomes an edge inside the mesh, and of
        several features each is a region. Points and lines, what is empty and rings without area are
        passed over, with a UserWarning.
        """
        name = type(shape).__name__
        geometry = _bare(shape)
        if not isinstance(geometry, dict):
            raise InputError(f"polygons are wanted, not {name}")
        try:
            text = json.dumps(geometry, allow_nan=False, default=_plain)
        except (TypeError, ValueError) as odd:
            raise InputError(f"{name}: its coordinates must be finite numbers: {odd}") from odd
        return cls.parse_geojson(text, name)

    from_shapely = from_geo


def _bare(shape: Any) -> Any:
    """What says where it is, without properties, in which anything may be."""
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
    """Numbers and arrays of numpy, as json takes them."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no number")
