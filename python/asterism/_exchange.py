# SPDX-License-Identifier: MIT
"""Meshes of other packages, which are imported when they are asked for."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._asterism import InputError
from ._calls import warn
from ._mesh import Mesh


def _in_space(points: Any) -> Any:
    return np.column_stack([points, np.zeros(len(points))])


def _point_data(mesh: Mesh) -> Any:
    return {"metric": np.array(mesh.metric), **{name: np.array(of) for name, of in mesh.values.items()}}


def to_meshio(mesh: Mesh) -> Any:
    """With the entities of gmsh's geometry, without which meshio writes no .msh 4.1 of lines and triangles.

    All are in its group 0, which is none: meshio writes one group for each block of cells, and the
    references as data. mesh.save("x.msh") has groups.
    """
    from ._outside import Outside

    references = [np.array(mesh.regions), np.array(mesh.edge_markers)]
    entities = np.full((len(mesh.points), 2), (2, 1), dtype=np.int32)
    entities[np.unique(mesh.edges), 0] = 1
    if (entities[:, 0] == 1).all():  # meshio writes no entity without points
        entities[-1, 0] = 2
    return Outside(
        _in_space(mesh.points), [("triangle", np.array(mesh.triangles)), ("line", np.array(mesh.edges))],
        point_data={**_point_data(mesh), "gmsh:dim_tags": entities},
        cell_data={"reference": references,
                   "gmsh:geometrical": [np.ones(len(of), dtype=np.int32) for of in references],
                   "gmsh:physical": [np.zeros(len(of), dtype=np.int32) for of in references]})


# Names under which meshio has regions and markers.
_REFERENCES = ("reference", "gmsh:physical", "medit:ref")


def _references(other: Any, kind: str) -> Any:
    for name in _REFERENCES:
        if name in other.cell_data:
            parts = [of for cells, of in zip(other.cells, other.cell_data[name]) if cells.type == kind]
            if parts:
                return np.concatenate(parts)
    return None


def _cells(other: Any, kind: str) -> Any:
    parts = [cells.data for cells in other.cells if cells.type == kind]
    return np.concatenate(parts) if parts else None


def _warn_of_left_out(other: Any, lines: Any, new: Any) -> None:
    """Names what a Mesh has no place for: data and sets of cells, and lines with points in no triangle."""
    data = [name for name in other.cell_data if name not in (*_REFERENCES, "gmsh:geometrical")]
    sets = [name for name in other.cell_sets if not name.startswith("gmsh:")] if hasattr(other, "cell_sets") else []
    if data:
        warn(f"data of cells have no place in a Mesh, and are left out: {', '.join(data)}; regions and markers are in "
             f"{', '.join(_REFERENCES[:-1])} or {_REFERENCES[-1]}")
    if sets:
        warn(f"sets of cells have no place in a Mesh, and are left out: {', '.join(sets)}")
    lost = 0 if lines is None else int((new[lines] < 0).any(axis=1).sum())
    if lost:
        warn(f"{lost} of {len(lines)} lines have points in no triangle, and are left out")


def from_meshio(other: Any) -> Mesh:
    if not hasattr(other, "cells") or not hasattr(other, "point_data"):
        raise InputError(f"a meshio.Mesh is wanted, not {type(other).__name__}")
    unknown = sorted({cells.type for cells in other.cells} - {"triangle", "line", "vertex"})
    triangles = _cells(other, "triangle")
    if triangles is None or unknown:
        raise InputError("triangles and lines are wanted, and there are " + ", ".join(unknown or ["none"]))
    points = np.asarray(other.points)
    if points.shape[1] == 3 and (points[:, 2] != points[0, 2]).any():
        raise InputError("points: they are not in one plane z = constant")
    used, numbers = np.unique(triangles, return_inverse=True)
    lines = _cells(other, "line")
    new = np.full(len(points), -1)
    new[used] = np.arange(len(used))
    values = {name: np.asarray(of)[used] for name, of in other.point_data.items()
              if not name.startswith("gmsh:") and name != "metric" and np.ndim(of) in (1, 2)}
    more: Any = {}
    if "metric" in other.point_data:
        more["metric"] = np.asarray(other.point_data["metric"])[used]
    _warn_of_left_out(other, lines, new)
    if lines is not None:
        markers = _references(other, "line")
        stays = (new[lines] >= 0).all(axis=1)
        more.update(edges=new[lines][stays], markers=None if markers is None else np.asarray(markers)[stays])
    return Mesh(points[used, :2], numbers.reshape(triangles.shape), regions=_references(other, "triangle"),
                values=values, **more)


def to_pyvista(mesh: Mesh) -> Any:
    import pyvista

    faces = np.column_stack([np.full(len(mesh.triangles), 3), mesh.triangles])
    shown = pyvista.PolyData(_in_space(mesh.points), faces.ravel())
    for name, of in _point_data(mesh).items():
        shown.point_data[name] = of
    shown.cell_data["region"] = np.array(mesh.regions)
    return shown
