# SPDX-License-Identifier: MIT
"""Surfaces in space: patches of control points, and certified meshes of them."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._calls import told, told_methods, warn
from ._certificate import Certificate
from ._forms import doubles, path_of, write_text
from ._meshing import NotReachedWarning


@told_methods
class Surface:
    """Patches in space: Bezier, B-spline or NURBS, untrimmed. An invalid patch raises InputError.

        S = asterism.Surface.bspline(control, knots_u, knots_v, weights)    # control: (n, m, 3)
        S = asterism.Surface.named("teapot")

    Sides of two patches that are the same numbers are one edge of the mesh.
    """

    def __init__(self, text: str) -> None:
        """Makes a surface of a JSON text as docs/manual/surfaces.md describes it."""
        if not isinstance(text, str):
            raise InputError(f"text: a text of JSON is wanted, not {type(text).__name__}; Surface.bezier() and "
                             "Surface.bspline() take control points")
        if not text.lstrip().startswith("{"):
            raise InputError(f"text: a text of JSON is wanted, not {text!r}; Surface.named() takes the name of a "
                             "built-in one, Surface.read() that of a file")
        self._text = _asterism._surface_checked(text)

    @classmethod
    def bezier(cls, control: npt.ArrayLike, weights: Optional[npt.ArrayLike] = None, name: str = "") -> "Surface":
        """Control points (n, m, 3) over the unit square, of degrees n - 1 and m - 1. Weights (n, m): all 1."""
        points = _control(control)
        return cls(_text_of(points, (points.shape[0] - 1, points.shape[1] - 1), None, None, weights, name))

    @classmethod
    def bspline(cls, control: npt.ArrayLike, knots_u: npt.ArrayLike, knots_v: npt.ArrayLike,
                weights: Optional[npt.ArrayLike] = None, trims: Optional[Sequence[Any]] = None,
                name: str = "") -> "Surface":
        """Control points (n, m, 3) with all knots, the first and the last repeated degree + 1 times; a
        degree is the number of knots less the number of points less 1. Weights (n, m): all 1. Trims are
        loops of a file (Surface.read); here they raise InputError."""
        if trims:
            raise InputError("trims: patches are trimmed by the loops of a .json file, for Surface.read")
        points = _control(control)
        u, v = doubles("knots_u", knots_u), doubles("knots_v", knots_v)
        if u.ndim != 1 or v.ndim != 1:
            raise InputError("knots_u, knots_v: rows of numbers are wanted")
        return cls(_text_of(points, (len(u) - points.shape[0] - 1, len(v) - points.shape[1] - 1),
                            u.tolist(), v.tolist(), weights, name))

    @classmethod
    def named(cls, name: str) -> "Surface":
        """Returns a built-in surface: torus, wing, teapot, saddle, octant."""
        if not isinstance(name, str):
            raise InputError(f"name: a text is wanted, not {name!r}")
        return cls(_asterism._surface_named(name))

    @classmethod
    def read(cls, path: "str | os.PathLike[str]") -> "Surface":
        """Reads a .json file of patches."""
        return cls(_asterism._surface_read(path_of(path)))

    @property
    def text(self) -> str:
        """The JSON text, which reads back to the same doubles."""
        return self._text

    @property
    def patches(self) -> List[Dict[str, Any]]:
        """The patches as the file has them: `degree`, `control`, and `weights`, `knots_u`, `knots_v`, `name`."""
        found: List[Dict[str, Any]] = json.loads(self._text)["patches"]
        return found

    def __len__(self) -> int:
        return len(self.patches)

    def __repr__(self) -> str:
        return f"<Surface: {len(self)} {'patch' if len(self) == 1 else 'patches'}>"


@told_methods
class SurfaceMesh:
    """Triangles in space, and the results of their proof. The arrays are read-only."""

    def __init__(self, made: Dict[str, Any]) -> None:
        for name in ("points", "triangles", "patches", "uv"):
            made[name].flags.writeable = False
        self.points: npt.NDArray[np.float64] = made["points"]
        """(n, 3)"""
        self.triangles: npt.NDArray[np.int32] = made["triangles"]
        """(t, 3), every edge once each way but on sides that no other patch has"""
        self.patches: npt.NDArray[np.int32] = made["patches"]
        """(t,) the patch of each triangle, from 0"""
        self.uv: npt.NDArray[np.float64] = made["uv"]
        """(t, 3, 2) the parameters of the corners of each triangle in its patch"""
        self.certified: bool = made["certified"]
        self.reason: str = made["reason"]
        """The reason for which it is not certified; empty if it is."""
        self.certificate = Certificate(made["certificate"])

    def save(self, path: "str | os.PathLike[str]") -> List[str]:
        """Writes .obj, .stl, .ply, .mesh, .msh or .vtu. With a .mesh file goes NAME.certificate.json, from
        which `asterism verify` proves it again. Returns the names written."""
        to = Path(path_of(path))
        write_text(str(to), _asterism._space_mesh_text(self.points, self.triangles, self.patches, str(to)))
        if to.suffix != ".mesh":
            return [str(to)]
        beside = to.with_suffix(".certificate.json")
        write_text(str(beside), self.certificate.text)
        return [str(to), str(beside)]

    def __repr__(self) -> str:
        said = "certified" if self.certified else f"not certified: {self.reason}"
        return f"<SurfaceMesh: {len(self.points)} vertices, {len(self.triangles)} triangles, {said}>"


@told
def mesh_surface(surfaces: Union[Surface, Sequence[Surface]], chord: float, *, normal: Optional[float] = None,
                 hmax: Optional[float] = None, aspect: float = 100, vertices: Optional[int] = None,
                 angle_bound: Optional[float] = None, no_crossings: bool = False, max_seconds: Optional[float] = None,
                 threads: Optional[int] = None) -> SurfaceMesh:
    """Triangles within `chord` of a surface, and it within that of them, and the proof.

    normal: degrees that the normal may turn along an edge, about; None: 69. hmax: the longest edge, about.
    aspect: greatest ratio of lengths where the curvature wants one. vertices: about this number,
    whatever the resulting distance. angle_bound: of the plane meshes, degrees; None: 20, or none where
    faces do not come to agree with it how to divide their common sides, which warns. no_crossings:
    prove also that no two triangles cross. max_seconds: making meshes ends after this time. threads:
    number of threads; the mesh is the same for any number. Ctrl-C ends the run.

    A mesh that is not certified warns with NotReachedWarning, and says why by `reason`.
    """
    all_of_them = list(surfaces) if isinstance(surfaces, (list, tuple)) else [surfaces]
    for one in all_of_them or [None]:
        if not isinstance(one, Surface):
            raise InputError(f"surfaces: a Surface is wanted, not {type(one).__name__}; Surface.named('torus') is one, "
                             "Surface.read() makes one of a file, Surface.bezier() of control points")
    text = all_of_them[0].text if len(all_of_them) == 1 else json.dumps(
        {"patches": [patch for one in all_of_them for patch in one.patches]})
    made = SurfaceMesh(_asterism._mesh_surface(text, {
        "chord": chord, "normal": normal, "hmax": hmax, "aspect": aspect, "vertices": vertices,
        "angle_bound": angle_bound, "no_crossings": no_crossings, "max_seconds": max_seconds, "threads": threads,
        "progress": None}))
    if not made.certified:
        warn(made.reason, NotReachedWarning)
    return made


def _control(control: npt.ArrayLike) -> npt.NDArray[np.float64]:
    points = doubles("control", control)
    if points.ndim != 3 or points.shape[2] != 3:
        raise InputError(f"control: (n, m, 3) is wanted, not {points.shape}")
    return points


def _text_of(points: npt.NDArray[np.float64], degree: Sequence[int], knots_u: Optional[List[float]],
             knots_v: Optional[List[float]], weights: Optional[npt.ArrayLike], name: str) -> str:
    patch: Dict[str, Any] = {"degree": list(degree), "control": points.tolist()}
    if name:
        patch["name"] = name
    if knots_u is not None and knots_v is not None:
        patch["knots_u"], patch["knots_v"] = knots_u, knots_v
    if weights is not None:
        given = doubles("weights", weights)
        if given.shape != points.shape[:2]:
            raise InputError(f"weights: {points.shape[:2]} are wanted, not {given.shape}")
        patch["weights"] = given.tolist()
    for what, numbers in (("control", points), ("weights", patch.get("weights", 1)),
                          ("knots", [*(knots_u or []), *(knots_v or [])])):
        if not np.all(np.isfinite(numbers)):
            raise InputError(f"{what}: numbers must be finite")
    return json.dumps({"patches": [patch]})
