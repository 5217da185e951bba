# SPDX-License-Identifier: MIT
"""Every form in which a metric is given, for mesh(), adapt() and what a metric is intersected with."""
import pathlib

import numpy as np
import pytest

import asterism


@pytest.fixture(scope="module")
def mesh():
    return asterism.mesh("square", size=0.12)


@pytest.fixture(scope="module")
def other():
    """A mesh of a larger square, with other points."""
    return asterism.mesh([(-2, -2), (2, -2), (2, 2), (-2, 2)], size=0.3)


def graded(points):
    """Returns sizes that are 0.1 at x = 0 and grow."""
    return 0.1 + 0.2 * np.abs(points[:, 0])


def tensors_of(sizes):
    return np.stack([1 / (sizes * sizes), 0 * sizes, 1 / (sizes * sizes)], axis=1)


def wanted_of(mesh, metric, **words):
    return np.asarray(asterism.adapt(mesh, metric=metric, **words).metric)


def test_a_named_metric_and_a_formula_are_evaluated_at_the_points(mesh):
    x, y = mesh.points.T  # the square is (-1, 1)^2, so that p = q
    swirl = np.stack([1 + 24 * y * y, -24 * x * y, 1 + 24 * x * x], axis=1)
    turned = np.stack([1 + 24 * x * x, 24 * x * y, 1 + 24 * y * y], axis=1)
    found = wanted_of(mesh, "swirl:24", vertices=300)
    scales = found[:, 0] / swirl[:, 0]
    fits = [np.allclose(found * (of[:, :1] / found[:, :1]), of, rtol=1e-9, atol=1e-9) for of in (swirl, turned)]
    assert any(fits) and np.ptp(scales if fits[0] else found[:, 0] / turned[:, 0]) < 1e-6
    asked = wanted_of(mesh, "expr:9+x*x;0.5*x;4")
    assert np.allclose(asked, np.stack([9 + x * x, 0.5 * x, np.full_like(x, 4)], axis=1), rtol=1e-12)
    for text in ("swirl:12", "sink", "layer:0.1,0.3", "expr:4;0;9"):
        assert asterism.adapt(mesh, metric=text, vertices=300).mesh.certified


def test_rows_on_another_mesh_are_interpolated(mesh, other, tmp_path):
    sizes = graded(other.points)
    rows = tensors_of(sizes)
    matrices = rows[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    held = asterism.Mesh(other.points, other.triangles, rows, edges=other.edges, edge_markers=other.edge_markers)
    first = asterism.adapt(mesh, metric=(other, rows))
    assert first.mesh.certified
    for given in (sizes, sizes[:, None], list(sizes), matrices, graded):
        assert np.allclose(wanted_of(mesh, (other, given)), first.metric, rtol=1e-12)
    assert np.array_equal(wanted_of(mesh, held), first.metric)
    held.save(tmp_path / "other.mesh")
    for name in (tmp_path / "other.mesh", str(tmp_path / "other.mesh")):
        assert np.array_equal(wanted_of(mesh, name), first.metric)
    at_points = np.asarray(first.metric)[:, 0] ** -0.5
    assert np.abs(at_points / graded(mesh.points) - 1).max() < 0.35  # linear between points 0.3 apart


def test_rows_on_the_mesh_itself_are_taken_as_they_are(mesh, tmp_path):
    rows = tensors_of(graded(mesh.points))
    for given in (rows, (mesh, rows), graded(mesh.points), graded):
        assert np.array_equal(wanted_of(mesh, given), rows)
    held = asterism.Mesh(mesh.points, mesh.triangles, rows, edges=mesh.edges, edge_markers=mesh.edge_markers)
    assert np.array_equal(wanted_of(mesh, held), rows)
    held.save(tmp_path / "own.mesh")
    for name in ("own.mesh", "own.sol"):
        assert np.array_equal(wanted_of(mesh, tmp_path / name), rows)


def test_a_file_of_numbers_belongs_to_the_mesh_that_is_adapted(mesh, other, tmp_path):
    sizes = graded(mesh.points)
    (tmp_path / "h.sol").write_text(f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(sizes)}\n1 1\n"
                                    + "\n".join(map(repr, sizes.tolist())) + "\nEnd\n")
    (tmp_path / "h.mtr").write_text(f"{len(sizes)} 1\n" + "\n".join(map(repr, sizes.tolist())) + "\n")
    for name in ("h.sol", "h.mtr"):
        assert np.allclose(wanted_of(mesh, tmp_path / name), tensors_of(sizes), rtol=1e-12)
        with pytest.raises(asterism.InputError, match=f"metric: .*{name}"):
            asterism.adapt(other, metric=tmp_path / name)
    mesh.save(tmp_path / "own.mesh")
    wanted = asterism.mesh(mesh, metric=(mesh, sizes))
    for domain in (mesh, tmp_path / "own.mesh", str(tmp_path / "own.mesh")):
        assert np.array_equal(asterism.mesh(domain, metric=tmp_path / "h.sol", size=1).sites, wanted.sites)
    with pytest.raises(asterism.InputError, match="metric: .*h.sol"):
        asterism.mesh(other, metric=tmp_path / "h.sol")


def test_each_metric_of_intersect_takes_the_same_forms(mesh, other, tmp_path):
    u = np.tanh(8 * mesh.points[:, 0])
    rows = tensors_of(graded(other.points))
    at_points = wanted_of(mesh, (other, rows))
    held = asterism.Mesh(other.points, other.triangles, rows, edges=other.edges, edge_markers=other.edge_markers)
    held.save(tmp_path / "other.mesh")
    wanted = asterism.metric(mesh, u, vertices=1000, intersect=[at_points])
    for given in ((other, rows), held, tmp_path / "other.mesh"):
        assert np.array_equal(asterism.metric(mesh, u, vertices=1000, intersect=[given]), wanted)
        assert np.array_equal(asterism.adapt(mesh, u, vertices=1000, intersect=[given]).metric, wanted)
    named = asterism.metric(mesh, u, vertices=1000, intersect=["expr:100;0;100", 0.2])
    assert np.array_equal(named, asterism.metric(mesh, u, vertices=1000, intersect=[(100, 0, 100), 0.2]))


def test_the_mesher_takes_sizes_at_the_points_of_its_domain(mesh, other):
    sizes = graded(mesh.points)
    first = asterism.mesh(mesh, metric=(mesh, sizes))
    for given in (sizes, sizes[:, None]):
        assert np.array_equal(asterism.mesh(mesh, metric=given).sites, first.sites)
    assert len(first.points) == len(asterism.mesh(mesh, metric=(mesh, sizes[:, None])).points)
    named = asterism.mesh("square", metric=(other, graded))
    assert np.array_equal(named.sites, asterism.mesh("square", metric=(other, graded(other.points))).sites)


@pytest.mark.parametrize("metric, message", [
    ("swurl:12", "metric: .*swirl"),
    ("swirl:x", "metric: .*"),
    ("expr:1;0;x", "metric: .*not positive definite"),
    ("", "metric: a text is empty"),
    ("missing.mesh", "metric: .*missing.mesh"),
    (pathlib.Path("missing.sol"), "metric: .*missing.sol"),
    (("other.mesh", np.ones(4)), r"metric: the first of a pair \(mesh, tensors\) is a Mesh, not str; asterism.read"),
    (({}, np.ones(4)), "the first of a pair .* not dict"),
    ({}, "metric: a text, a size, .*not dict"),
    (object(), "metric: a text, a size, .*not object"),
    (np.ones(7), "metric: tensors .*shape .7,"),
    (np.ones((7, 3)), "metric: "),
    (-0.1, "metric: a size is positive"),
])
def test_what_is_no_metric_is_refused_by_every_verb(mesh, metric, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.adapt(mesh, metric=metric)
    with pytest.raises(asterism.InputError, match=message.replace("metric: ", "intersect: ", 1)):
        asterism.metric(mesh, mesh.points[:, 0] ** 2, vertices=200, intersect=[metric])


def test_values_of_triangles_are_brought_along_as_the_message_says(mesh):
    v = (mesh.points[mesh.triangles].mean(axis=1)[:, 0] > 0).astype(float)
    with pytest.raises(asterism.InputError, match=r"one a triangle.*v\[mesh.locate\(next.points\[next.tri"):
        asterism.adapt(mesh, metric=0.2, carry=v)
    next = asterism.adapt(mesh, metric=0.2).mesh
    centroids = next.points[next.triangles].mean(axis=1)
    found = v[mesh.locate(centroids)]
    far = np.abs(centroids[:, 0]) > 0.15
    assert np.array_equal(found[far], (centroids[far, 0] > 0).astype(float))


def test_pairs_with_wrong_rows_are_refused(mesh, other):
    for metric, message in (((other, np.ones(7)), "metric: "),
                            ((other, np.zeros(len(other.points))), "size is positive"),
                            ((other, np.full(len(other.points), np.nan)), "positive and finite"),
                            ((other, object()), "not object")):
        for call in (asterism.adapt, asterism.mesh):
            with pytest.raises(asterism.InputError, match=message):
                call(mesh, metric=metric)
    for given in ((other, np.ones(len(other.points))), "swirl", other, graded):
        with pytest.raises(asterism.InputError, match="intersect: a list of metrics is wanted"):
            asterism.metric(mesh, mesh.points[:, 0] ** 2, intersect=given)
    with pytest.raises(asterism.InputError, match="on: rows at the points"):
        asterism.mesh(mesh, metric="swirl", on=other)
