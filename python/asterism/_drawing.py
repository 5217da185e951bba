# SPDX-License-Identifier: MIT
"""Outlines of drawings: DXF, which ezdxf reads, as the text of a .poly file with curves."""
from __future__ import annotations

import math
import os
import tempfile
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

from ._asterism import InputError
from ._calls import told, warn
from ._domain import Domain
from ._forms import path_of

Point = Tuple[float, float]

# Ends of entities within this part of the extent are one vertex: ends of arcs are computed from angles of sixteen
# digits.
ROUNDING = 1e-9


class _Drawing:
    """Collects vertices, segments and curves, entity by entity."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.ends: List[Point] = []  # ends as drawn, two for each segment
        self.markers: List[int] = []
        self.curves: List[str] = []  # "arc N x y ccw", where N is the number of its segment
        self.circles: List[Tuple[Point, Point, int]] = []  # circles: vertex, centre, marker
        self.layers: Dict[str, int] = {}
        self.heights: List[Tuple[str, float]] = []
        self.passed_over: Dict[str, int] = {}
        self.approximated = 0

    def marker(self, layer: str) -> int:
        if layer not in self.layers:
            try:
                number = int(layer)
            except ValueError:
                number = 0
            if number <= 0 or number in self.layers.values():
                number = 1
                while number in self.layers.values():
                    number += 1
            self.layers[layer] = number
        return self.layers[layer]

    def flat(self, at: Any, what: str) -> Point:
        x, y = float(at[0]), float(at[1])
        z = float(at[2]) if len(at) > 2 else 0.0
        if not all(map(math.isfinite, (x, y, z))):
            raise InputError(f"{self.name}: {what}: a coordinate is not finite")
        if z != 0:
            self.heights.append((what, z))
        return x, y

    def line(self, a: Point, b: Point, layer: str) -> None:
        if a != b:
            self.ends += [a, b]
            self.markers.append(self.marker(layer))

    def arc(self, a: Point, b: Point, centre: Point, counter_clockwise: bool, layer: str) -> None:
        self.line(a, b, layer)
        way = "ccw" if counter_clockwise else "cw"
        self.curves.append(f"arc {len(self.markers)} {centre[0]!r} {centre[1]!r} {way}")

    def bezier(self, control: Sequence[Point], layer: str) -> None:
        self.line(control[0], control[3], layer)
        (x1, y1), (x2, y2) = control[1:3]
        self.curves.append(f"bezier {len(self.markers)} {x1!r} {y1!r} {x2!r} {y2!r}")

    def bulged(self, a: Point, b: Point, bulge: float, layer: str) -> None:
        """Adds the arc between two points whose quarter angle has this tangent."""
        if bulge == 0 or a == b:
            self.line(a, b, layer)
            return
        # The centre is at this multiple of the chord, rotated to the left, from the chord's middle.
        part = (1 - bulge * bulge) / (4 * bulge)
        centre = ((a[0] + b[0]) / 2 - part * (b[1] - a[1]), (a[1] + b[1]) / 2 + part * (b[0] - a[0]))
        self.arc(a, b, centre, bulge > 0, layer)

    # Entities.

    def add(self, entity: Any, depth: int = 0) -> None:
        kind = entity.dxftype()
        reader = getattr(self, "_" + kind.lower(), None)
        if kind == "INSERT" and depth < 16:
            for part in entity.virtual_entities():
                self.add(part, depth + 1)
        elif reader is None:
            self.passed_over[kind] = self.passed_over.get(kind, 0) + 1
        else:
            reader(entity, entity.dxf.layer)

    def _line(self, e: Any, layer: str) -> None:
        self.line(self.flat(e.dxf.start, "LINE"), self.flat(e.dxf.end, "LINE"), layer)

    def _upright(self, e: Any, kind: str) -> bool:
        """True if the entity's own plane is the drawing's. A mirrored plane is not read."""
        if tuple(map(float, e.dxf.extrusion)) == (0.0, 0.0, 1.0):
            return True
        self.passed_over[kind + " in another plane"] = self.passed_over.get(kind + " in another plane", 0) + 1
        return False

    def _arc(self, e: Any, layer: str) -> None:
        if self._upright(e, "ARC"):
            centre = self.flat(e.dxf.center, "ARC")
            a, b = self.flat(e.start_point, "ARC"), self.flat(e.end_point, "ARC")
            if a == b:
                self._circle(e, layer)
            else:
                self.arc(a, b, centre, True, layer)

    def _circle(self, e: Any, layer: str) -> None:
        if self._upright(e, "CIRCLE"):
            centre, radius = self.flat(e.dxf.center, "CIRCLE"), float(e.dxf.radius)
            if not radius > 0:
                raise InputError(f"{self.name}: CIRCLE: the radius is {radius}")
            self.circles.append(((centre[0] + radius, centre[1]), centre, self.marker(layer)))

    def _polygon(self, points: List[Tuple[Point, float]], closed: bool, layer: str) -> None:
        count = len(points)
        for k in range(count if closed else count - 1):
            (a, bulge), (b, _) = points[k], points[(k + 1) % count]
            self.bulged(a, b, bulge, layer)

    def _lwpolyline(self, e: Any, layer: str) -> None:
        if self._upright(e, "LWPOLYLINE"):
            if float(e.dxf.get("elevation", 0)) != 0:
                self.heights.append(("LWPOLYLINE", float(e.dxf.elevation)))
            points = [((float(x), float(y)), float(b)) for x, y, b in e.get_points("xyb")]
            self._polygon(points, e.closed, layer)

    def _polyline(self, e: Any, layer: str) -> None:
        if not (e.is_2d_polyline or e.is_3d_polyline):
            self.passed_over["POLYLINE of a mesh"] = self.passed_over.get("POLYLINE of a mesh", 0) + 1
        elif e.is_3d_polyline or self._upright(e, "POLYLINE"):
            points = [(self.flat(v.dxf.location, "POLYLINE"), float(v.dxf.get("bulge", 0))) for v in e.vertices]
            self._polygon(points, e.is_closed, layer)

    def _cubics(self, curves: Iterable[Any], layer: str, what: str) -> None:
        for curve in curves:
            control = [self.flat(p, what) for p in curve.control_points]
            if len(control) == 3:  # a quadratic curve as a cubic one
                (ax, ay), (bx, by), (cx, cy) = control
                control = [control[0], ((ax + 2 * bx) / 3, (ay + 2 * by) / 3),
                           ((cx + 2 * bx) / 3, (cy + 2 * by) / 3), control[2]]
            if len(control) == 2:
                self.line(control[0], control[1], layer)
            else:
                self.bezier(control, layer)

    def _spline(self, e: Any, layer: str) -> None:
        spline = e.construction_tool()
        if spline.degree in (1, 2, 3) and not spline.is_rational and spline.is_clamped:
            from ezdxf.math import Bezier
            self._cubics([Bezier(list(c)) for c in spline.bezier_decomposition()], layer, "SPLINE")
        else:
            self.approximated += 1
            self._cubics(spline.cubic_bezier_approximation(level=8), layer, "SPLINE")

    def _ellipse(self, e: Any, layer: str) -> None:
        from ezdxf.math import cubic_bezier_from_ellipse
        self.approximated += 1
        self._cubics(cubic_bezier_from_ellipse(e.construction_tool(), segments=8), layer, "ELLIPSE")


def _joined(points: List[Point], distance: float) -> Tuple[List[Point], List[int], float]:
    """Returns points of which no two are within the distance, for each given point the number of its point, and the
    greatest move."""
    cells: Dict[Tuple[int, int], List[int]] = {}
    kept: List[Point] = []
    numbers: List[int] = []
    most = 0.0
    exact: Dict[Point, int] = {}
    for x, y in points:
        found = exact.get((x, y), -1)
        if found < 0 and distance > 0:
            i, j = math.floor(x / distance), math.floor(y / distance)
            near = [k for u in (i - 1, i, i + 1) for v in (j - 1, j, j + 1) for k in cells.get((u, v), ())]
            near = [k for k in near if math.dist(kept[k], (x, y)) <= distance]
            if near:
                found = min(near)
                most = max(most, math.dist(kept[found], (x, y)))
        if found < 0:
            found = len(kept)
            kept.append((x, y))
            if distance > 0:
                cells.setdefault((math.floor(x / distance), math.floor(y / distance)), []).append(found)
        exact[x, y] = found
        numbers.append(found)
    return kept, numbers, most


def _text(d: _Drawing, join: Optional[float], holes: Sequence[Point], notes: List[str]) -> str:
    everything = d.ends + [p for circle in d.circles for p in circle[:2]]
    if not d.markers and not d.circles:
        raise InputError(f"{d.name}: there is no line, polyline, arc, circle, ellipse or spline")
    extent = max(max(p[k] for p in everything) - min(p[k] for p in everything) for k in (0, 1))
    heights = {z for _, z in d.heights}
    if len(heights) > 1 or (heights and len(d.heights) < len(d.ends) and max(abs(z) for z in heights) > ROUNDING * extent):
        what, z = max(d.heights, key=lambda h: abs(h[1]))
        raise InputError(f"{d.name}: {what}: z is {z}, and others have another: only plane drawings can be read")
    if heights:
        notes.append(f"{d.name}: heights, of {max(heights, key=abs)}, are left out")
    points, numbers, moved = _joined(d.ends, ROUNDING * extent if join is None else join)
    if moved > 0:
        notes.append(f"{d.name}: ends of entities up to {moved:.3g} apart are one vertex")
    lines = [f"# {d.name}", *(f"# marker {number} is layer {layer}" for layer, number in d.layers.items())]
    first_circle = len(points) + 1
    points = points + [vertex for vertex, _, _ in d.circles]
    lines += [f"{len(points)} 2 0 0", *(f"{k + 1} {x!r} {y!r}" for k, (x, y) in enumerate(points))]
    lines.append(f"{len(d.markers)} 1")
    for k, marker in enumerate(d.markers):
        a, b = numbers[2 * k] + 1, numbers[2 * k + 1] + 1
        if a == b:
            raise InputError(f"{d.name}: an entity at {points[a - 1]} is shorter than what is joined")
        lines.append(f"{k + 1} {a} {b} {marker}")
    lines += [str(len(holes)), *(f"{k + 1} {float(x)!r} {float(y)!r}" for k, (x, y) in enumerate(holes)), "0"]
    curves = d.curves + [f"circle {first_circle + k} {cx!r} {cy!r} {marker}"
                         for k, (_, (cx, cy), marker) in enumerate(d.circles)]
    if curves:
        lines += [f"curves {len(curves)}", *(f"{k + 1} {curve}" for k, curve in enumerate(curves))]
    return "\n".join(lines) + "\n"


@told
def poly_of_dxf(path: "str | os.PathLike[str]", layers: Optional[Iterable[str]] = None,
                holes: Sequence[Point] = (), join: Optional[float] = None) -> str:
    """The outlines in the model space of a DXF drawing, as the text of a .poly file, which the command takes.

    Lines, polylines with their bulges, arcs, circles, splines and ellipses, also in blocks; arcs and circles stay
    such, splines up to degree 3 become the same cubics, rational ones and ellipses cubics near them. Each layer
    is a marker: its name if that is a positive whole number, else the next free one; comments say which. `layers`
    names those to take. `holes` are points in holes: a drawing does not say which side of a line is material.
    Ends of entities within `join` of each other, a billionth of the extent unless it is given, are one vertex;
    wider gaps of straight drawings are for --repair-domain. What is joined, passed over or approximated is a
    UserWarning. Needs ezdxf.
    """
    # pylint: disable=import-outside-toplevel
    from ezdxf.filemanagement import readfile
    from ezdxf.lldxf.const import DXFError

    name = path_of(path)
    if not os.path.isfile(name):
        raise InputError(f"{name}: no such file")
    try:
        document = readfile(name)
    except (OSError, DXFError) as odd:
        raise InputError(f"{name}: {odd}") from odd
    drawing = _Drawing(name)
    wanted = None if layers is None else set(layers)
    if wanted is not None and not wanted <= {e.dxf.layer for e in document.modelspace()}:
        missing = sorted(wanted - {e.dxf.layer for e in document.modelspace()})
        raise InputError(f"{name}: nothing is on layer {missing[0]!r}")
    for entity in document.modelspace():
        if wanted is None or entity.dxf.layer in wanted:
            drawing.add(entity)
    notes: List[str] = []
    text = _text(drawing, join, holes, notes)
    if drawing.passed_over:
        told = ", ".join(f"{count} {kind}" for kind, count in sorted(drawing.passed_over.items()))
        notes.append(f"{name}: passed over: {told}")
    if drawing.approximated:
        notes.append(f"{name}: rational splines and ellipses are cubics near them: {drawing.approximated}")
    for note in notes:
        warn(note)
    return text


@told
def read_dxf(path: "str | os.PathLike[str]", layers: Optional[Iterable[str]] = None,
             holes: Sequence[Point] = (), join: Optional[float] = None, *,
             repair: "bool | float" = False, convex_hull: bool = False) -> Domain:
    """The Domain of poly_of_dxf(); `repair` and `convex_hull` as Domain.read() takes them, for drawings
    without curves."""
    text = poly_of_dxf(path, layers, holes, join)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, os.path.basename(path_of(path)) + ".poly")
        with open(file, "w", encoding="ascii", errors="replace") as out:
            out.write(text)
        return Domain.read(file, repair=repair, convex_hull=convex_hull)
