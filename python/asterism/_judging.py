# SPDX-License-Identifier: MIT
"""Audits of meshes."""
from __future__ import annotations

import os
from typing import Any, Dict, Optional

import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._calls import told
from ._certificate import judged
from ._forms import path_of
from ._mesh import Mesh, read_file


@told
def verify(subject: "Mesh | str | os.PathLike[str]", certificate: Optional[str] = None,
           angle_bound: Optional[float] = None) -> Dict[str, Any]:
    """Audits a mesh again, and compares it with the text of a certificate or with its own. Returns `verified`,
    `contradictions`, `findings` (each with `kind` and `witness`) and the measured numbers."""
    of = subject if isinstance(subject, Mesh) else read_file(path_of(subject), False)
    return judged(_asterism._verify(of._made, {"certificate": certificate, "angle_bound": angle_bound}))


@told
def certify(points: "npt.ArrayLike | Mesh", triangles: Optional[npt.ArrayLike] = None,
            metric: Optional[npt.ArrayLike] = None, angle_bound: float = 20, voronoi: bool = False,
            prove_voronoi: bool = False) -> Dict[str, Any]:
    """Audits a triangulation from elsewhere: whether it consists of its points' stars, and no angle is below the
    bound. metric: in any form that tensors have, one for all or one at each point; None: the identity, or a Mesh's
    own. Returns `certified`, `not_in_all_stars`, `low_triangles`, `findings` (each with `kind` and `witness`) and the
    measured numbers."""
    if isinstance(points, Mesh):
        if triangles is not None or metric is not None:
            raise InputError("triangles, metric: a Mesh has its own; certify(mesh.points, mesh.triangles, metric) "
                             "asks in another metric")
        of = points
    elif triangles is None:
        raise InputError("triangles: (t, 3) are wanted beside the points")
    else:
        of = Mesh._to_judge(points, triangles, (1, 0, 1) if metric is None else metric)
    return judged(_asterism._certify(of._made, {"angle_bound": angle_bound, "voronoi": voronoi or prove_voronoi}))
