# SPDX-License-Identifier: MIT
"""Measures of single triangles, searches for points, and pages."""
from fractions import Fraction

import numpy as np
import pytest

import asterism


@pytest.fixture(scope="module")
def made():
    return asterism.mesh([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)],
                         lambda p: np.column_stack([4 + p[:, 0], p[:, 1] * 0.5, 9 - p[:, 1]]), 0.4)


def angle(m, a, p, q):
    """Computes angles by another route: through the map that makes the metric round."""
    root = np.linalg.cholesky(np.array([[m[0], m[1]], [m[1], m[2]]])).T
    u, v = root @ (p - a), root @ (q - a)
    return np.degrees(np.arccos(u @ v / np.sqrt((u @ u) * (v @ v))))


def test_angles_lengths_and_qualities_are_those_of_the_metric(made):
    for t in range(0, len(made.triangles), 7):
        corners = made.triangles[t]
        for i in range(3):
            a, p, q = (made.points[corners[(i + k) % 3]] for k in range(3))
            wanted = min(angle(made.metric[c], a, p, q) for c in corners)
            assert made.angles[t, i] == pytest.approx(wanted, rel=1e-9)
            measured = [np.sqrt((p - q) @ np.array([[m[0], m[1]], [m[1], m[2]]]) @ (p - q))
                        for m in made.metric[corners[[(i + 1) % 3, (i + 2) % 3]]]]
            assert made.lengths[t, i] == pytest.approx(np.mean(measured), rel=1e-12)
    assert made.angles.min() == pytest.approx(made.certificate.worst_angle, rel=1e-9)
    assert made.qualities.min() == pytest.approx(made.statistics()["least_quality"])
    assert made.qualities.mean() == pytest.approx(made.statistics()["mean_quality"])


def test_neighbors_share_the_side_across(made):
    for t, row in enumerate(made.neighbors):
        for i, other in enumerate(row):
            side = {made.triangles[t, (i + 1) % 3], made.triangles[t, (i + 2) % 3]}
            if other >= 0:
                assert side < set(made.triangles[other]) and t in made.neighbors[other]
            else:
                assert side in [set(edge) for edge in made.edges.tolist()]


def side_of(a, b, p):
    (ax, ay), (bx, by), (px, py) = (map(Fraction, of.tolist()) for of in (a, b, p))
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax)


def test_points_are_located_exactly(made):
    rng = np.random.default_rng(11)
    middles = made.points[made.edges].mean(axis=1)
    points = np.concatenate([rng.uniform(-0.2, 3.2, (3000, 2)), made.points, middles])
    found = made.locate(points)
    for p, t in zip(points[::13], found[::13]):
        inside = [s for s, corners in enumerate(made.triangles) if all(
            side_of(made.points[corners[i]], made.points[corners[(i + 1) % 3]], p) >= 0 for i in range(3))]
        assert t in inside if inside else t == -1
    assert (found[3000:3000 + len(made.points)] >= 0).all()


def test_values_between_points(made):
    rng = np.random.default_rng(4)
    points = rng.uniform(0, 1, (500, 2))
    x, y = made.points.T
    values = made.interpolate(np.column_stack([1 + 2 * x - y, x]), points)
    assert np.allclose(values, np.column_stack([1 + 2 * points[:, 0] - points[:, 1], points[:, 0]]), atol=1e-13)
    u = np.sin(9 * x)
    assert np.array_equal(made.interpolate(u, made.points), u)
    assert made.interpolate(u, points).max() <= u.max()
    with pytest.raises(asterism.InputError, match="row 1, .* is in no triangle"):
        made.interpolate(u, [(0.5, 0.5), (2, 1.5)])
    assert made.interpolate(u, [(0.5, 0.5), (2, 1.5)], outside=-7)[1] == -7
    with pytest.raises(asterism.InputError, match="rows are wanted"):
        made.interpolate(u[1:], points)


def test_the_page_for_a_notebook(made, tmp_path):
    page = made.show(height=500)
    shown = page._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and 'height="500"' in shown and "<html" in page.text
    assert open(page.save(tmp_path / "m.html"), encoding="utf-8").read() == page.text
    made.save(tmp_path / "n.html")
    assert (tmp_path / "n.html").stat().st_size > 10000


def test_other_packages_get_values_and_give_meshes(made, tmp_path):
    meshio = pytest.importorskip("meshio")
    held = asterism.Mesh(made.points, made.triangles, made.metric, edges=made.edges,
                         markers=np.arange(len(made.edges)), values={"u": made.points[:, 0]},
                         regions=np.arange(len(made.triangles)) % 3)
    held.to_meshio().write(tmp_path / "m.msh", file_format="gmsh")
    for other in (held.to_meshio(), meshio.read(tmp_path / "m.msh", file_format="gmsh")):
        again = asterism.Mesh.from_meshio(other)
        assert np.array_equal(again.points, held.points) and np.array_equal(again.triangles, held.triangles)
        assert np.array_equal(again.regions, held.regions)
        assert np.array_equal(np.sort(again.edge_markers), np.arange(len(made.edges)))
        assert np.array_equal(again.values["u"], held.values["u"]) and np.array_equal(again.metric, held.metric)
    with pytest.raises(asterism.InputError, match="there are quad"):
        asterism.Mesh.from_meshio(meshio.Mesh(np.zeros((4, 2)), [("quad", [[0, 1, 2, 3]])]))
