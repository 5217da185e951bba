# SPDX-License-Identifier: MIT
"""The meshio.Mesh that a mesh becomes, in a module of its own: it imports meshio, and can be pickled."""
from __future__ import annotations

import pathlib
from typing import Any

import meshio


class Outside(meshio.Mesh):  # type: ignore[misc]
    """Writes gmsh's format to a .msh, whose ending meshio takes for that of ANSYS."""

    def write(self, path_or_buf: Any, file_format: str | None = None, **more: Any) -> None:
        is_path = isinstance(path_or_buf, (str, pathlib.PurePath))
        if file_format is None and is_path and pathlib.PurePath(path_or_buf).suffix == ".msh":
            file_format = "gmsh"
        super().write(path_or_buf, file_format, **more)
