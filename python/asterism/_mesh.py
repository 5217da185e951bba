# SPDX-License-Identifier: MIT
"""Meshes: making, judging, showing and passing them on."""
from __future__ import annotations

import json
import os
import warnings
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import _Domain, _Mesh
from ._reported import ReportedArray

Metric = Union[str, Callable[[Any], Any], Tuple["Mesh", npt.ArrayLike], npt.ArrayLike]


class NotReachedWarning(UserWarning):
    """The mesher ended before its goal; the mesh's `reason` says why."""


class Certificate:
    """What the auditor says of a mesh: attributes are the entries of `data`."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.data: Dict[str, Any] = json.loads(text)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "data":
            raise AttributeError(name)
        for part in (self.data, *[v for v in self.data.values() if isinstance(v, dict)]):
            if name in part:
                return part[name]
        raise AttributeError(name)

    def __repr__(self) -> str:
        return f"<Certificate: {', '.join(self.data)}>"


class Mesh:
    """Triangles and the metric at their vertices.

    points (n, 2), metric (n, 3), sites (n, 5), triangles (t, 3), regions (t,), edges (b, 2) of the
    boundary and edge_markers (b,); `given`: how many points, the first ones, are the domain's.
    From elsewhere: regions, edges and edge_markers are whole numbers of 32 bits, and may be left out:
    the region is 1 then, and sides that are not among the edges have the marker 0, told in a UserWarning.
    """

    def __init__(self, points: npt.ArrayLike, triangles: npt.ArrayLike,
                 metric: npt.ArrayLike = (1, 0, 1), *, regions: Optional[npt.ArrayLike] = None,
                 edges: Optional[npt.ArrayLike] = None,
                 edge_markers: Optional[npt.ArrayLike] = None) -> None:
        self._made = _Mesh.from_arrays(points, triangles, metric, regions, edges, edge_markers)

    @classmethod
    def _of(cls, made: _Mesh) -> Mesh:
        mesh_of = cls.__new__(cls)
        mesh_of._made = made
        return mesh_of

    points = property(lambda self: self._made.points)
    metric = property(lambda self: self._made.metric)
    sites = property(lambda self: self._made.sites)
    triangles = property(lambda self: self._made.triangles)
    disagreeing = property(lambda self: self._made.disagreeing)
    regions = property(lambda self: self._made.regions)
    edges = property(lambda self: self._made.edges)
    edge_markers = property(lambda self: self._made.edge_markers)
    given = property(lambda self: self._made.given)
    complete = property(lambda self: self._made.complete)
    certified = property(lambda self: self._made.certified)
    reason = property(lambda self: self._made.reason)

    @property
    def certificate(self) -> Optional[Certificate]:
        """None of a mesh that came from elsewhere."""
        text = self._made.certificate_text
        return None if text is None else Certificate(text)

    def statistics(self) -> Dict[str, float]:
        """Edge lengths, shapes and more, by name, each as the metric measures it."""
        return self._made.statistics()

    def verify(self, certificate: Optional[str] = None,
               angle_bound: Optional[float] = None) -> Dict[str, Any]:
        return verify(self, certificate, angle_bound)

    def save(self, path: "str | os.PathLike[str]") -> List[str]:
        """Writes .mesh (with .sol), .msh, .vtu, .su2, .node (with .ele), .svg, .png or .pdf by the ending, and
        the certificate, if there is one, beside it. Returns the names of the files."""
        return self._made.save(os.fspath(path))

    def to_meshio(self) -> Any:
        """A meshio.Mesh with the boundary, markers, regions and the metric."""
        import meshio

        points = np.column_stack([self.points, np.zeros(len(self.points))])
        return meshio.Mesh(
            points, [("triangle", np.array(self.triangles)), ("line", np.array(self.edges))],
            point_data={"metric": np.array(self.metric)},
            cell_data={"reference": [np.array(self.regions), np.array(self.edge_markers)]})

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData with the metric at its points and the region of its triangles."""
        import pyvista

        faces = np.column_stack([np.full(len(self.triangles), 3), self.triangles])
        shown = pyvista.PolyData(np.column_stack([self.points, np.zeros(len(self.points))]),
                                 faces.ravel())
        shown.point_data["metric"] = np.array(self.metric)
        shown.cell_data["region"] = np.array(self.regions)
        return shown

    def plot(self, ax: Any = None, **line: Any) -> Any:
        """Draws into a matplotlib Axes, and returns it."""
        import matplotlib.pyplot as plt

        if ax is None:
            ax = plt.gca()
        ax.triplot(self.points[:, 0], self.points[:, 1], self.triangles,
                   **{"linewidth": 0.4, "color": "black", **line})
        for a, b in self.edges:
            ax.plot(self.points[[a, b], 0], self.points[[a, b], 1], color="black", linewidth=1.2)
        ax.set_aspect("equal")
        return ax

    def _repr_svg_(self) -> str:
        return self._made.svg()

    def svg(self, width: int = 600, ellipses: bool = False) -> str:
        """The picture as text; with `ellipses` the unit circles of the metric."""
        return self._made.svg(width=width, ellipses=ellipses)

    def __repr__(self) -> str:
        state = "certified" if self.certified else "not certified"
        return f"<Mesh: {len(self.points)} points, {len(self.triangles)} triangles, {state}>"


def mesh(domain: _Domain, metric: Metric = "identity", size: Optional[float] = None,
         angle_bound: float = 20, *, on: Optional[Mesh] = None, max_sites: Optional[int] = None,
         gradation: Optional[float] = None, prove_voronoi: bool = False,
         improve: int = 0, vertices: Optional[int] = None, complexity: Optional[float] = None,
         metric_tolerance: Optional[float] = None, chord_tolerance: Optional[float] = None,
         progress: Optional[Callable[[Dict[str, Any]], Any]] = None) -> Mesh:
    """Makes a mesh whose angles are at least angle_bound degrees, each measured by the metric of all
    three vertices of its triangle, and audits it.

    metric: a text as the command takes it ("swirl:12", "expr:1+x*x;0;1"); a callable from (n, 2) points
    to (n, 3) tensors = m11 m12 m22; a pair (mesh, tensors (n, 3)), or the tensors alone with on=mesh.
    A callable is asked for thousands of points at a time, each once, and for single ones (n = 1) where
    they are not known in advance; each row is to depend on its point alone. One that does not give n
    rows, or raises, for n > 1 is asked for one point at a time from then on.
    size: edges are to have this length in the metric; None: no longer than angles need, but 1 in a
    metric that asterism.metric() made.
    vertices, complexity: in place of a size, the number of vertices, or the area of the domain as the
    metric measures it; the metric is scaled to that. A mesh with over 5 % more or fewer vertices than
    that is made again with another scale, ten times at most, and the nearest is returned.
    metric_tolerance: how far the metric delivered may be from the one wanted, as ln of the greatest
    ratio of two lengths; 0: no tensor is changed; None: any, but of half of the sites no more than
    ln 10, and on the whole no more than ten times as dense or as thin.
    max_sites: refinement ends at this many; None: at 100000, or three times those asked for,
    or ten times the vertices of the domain.
    chord_tolerance: greatest distance of a curve of the domain from its chords; None: a fiftieth of each
    chord, and with a size, vertices or complexity a fiftieth of the size wanted across the curve, or a
    hundredth where the metric is on a mesh. Curves are divided for each mesh: the vertices of the domain
    that stay are the ends of its curves and those that are on none.
    progress: called now and then with a dict of counts. Ctrl-C ends the run.
    """
    if max_sites is None:
        asked = vertices or 1.2 * (complexity or 0)
        max_sites = int(min(max(100000, 3 * asked + 1000, 10 * len(domain.points)), 1e8))
    if on is not None:
        metric = (on, metric)  # type: ignore[assignment]
    if isinstance(metric, tuple) and len(metric) == 2 and isinstance(metric[0], Mesh):
        if (size, vertices, complexity) == (None,) * 3 and isinstance(metric[1], ReportedArray):
            size = 1
        metric = (metric[0]._made, metric[1])
    made = Mesh._of(_asterism._mesh(domain, metric, size, angle_bound, max_sites, gradation,
                                    prove_voronoi, improve, vertices, complexity, metric_tolerance,
                                    chord_tolerance, progress))
    if not made.complete:
        warnings.warn(made.reason, NotReachedWarning, stacklevel=2)
    return made


def read(path: "str | os.PathLike[str]") -> Mesh:
    """Reads a .mesh, .meshb, .msh or .vtu, with the metric of its .sol or in it (without one: the
    plane's) and the certificate beside it. What its reader changed is a UserWarning."""
    return Mesh._of(_Mesh.read(os.fspath(path)))


def verify(subject: "Mesh | str | os.PathLike[str]", certificate: Optional[str] = None,
           angle_bound: Optional[float] = None) -> Dict[str, Any]:
    """Audits a mesh again, against the text of a certificate or its own: `verified`,
    `contradictions`, `findings` and what was measured."""
    of = subject if isinstance(subject, Mesh) else read(subject)
    return _asterism._verify(of._made, certificate, angle_bound)


def certify(points: "npt.ArrayLike | Mesh", triangles: Optional[npt.ArrayLike] = None,
            metric: npt.ArrayLike = (1, 0, 1), angle_bound: float = 20,
            prove_voronoi: bool = False) -> Dict[str, Any]:
    """Is a triangulation from elsewhere the mesh of its points' stars, with no angle below the bound?
    `certified`, `not_in_all_stars`, `low_triangles`, `findings` and what was measured."""
    of = points if isinstance(points, Mesh) else Mesh(points, triangles, metric)  # type: ignore
    return _asterism._certify(of._made, angle_bound, prove_voronoi)


def in_circle(a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike, p: npt.ArrayLike,
              metric: npt.ArrayLike = (1, 0, 1), *, counts: bool = False) -> Any:
    """1 where p is inside the circle of the metric through a, b, c (these counter-clockwise; else
    the other way round), -1 outside, 0 on it. Points (n, 2), tensors (n, 3)."""
    return _asterism._in_circle(metric, a, b, c, p, counts=counts)
