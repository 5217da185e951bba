# SPDX-License-Identifier: MIT
"""Adaptation from Python: the metric a solution asks for, and a mesh in it."""
import numpy as np
import pytest

import asterism


@pytest.fixture(scope="module")
def background():
    return asterism.mesh(asterism.Domain.square(), size=0.12)


def ridge(points):
    return np.tanh(8 * (points[:, 0] ** 2 + points[:, 1] ** 2 - 0.5))


def test_the_metric_of_a_solution_has_the_complexity_asked_for(background):
    u = ridge(background.points)
    wanted = asterism.metric(background, u, norm=2, complexity=400, gradation=1.5, hmin=1e-4, hmax=0.5)
    assert wanted.shape == (len(background.points), 3)
    assert wanted.report["reached"] and abs(wanted.report["complexity_delivered"] - 400) < 8
    assert (asterism.is_positive_definite(wanted) == 1).all()
    made = asterism.mesh(asterism.Domain.square(), metric=(background, wanted))
    assert made.complete and made.certified
    assert 0.8 * 400 < len(made.points) / (2 / np.sqrt(3)) < 1.35 * 400


def test_fields_by_name_are_intersected_in_the_order_of_the_names(background):
    x, y = background.points.T
    both = asterism.metric(background, {"b": x * x, "a": y * y}, vertices=300)
    swapped = asterism.metric(background, {"a": y * y, "b": x * x}, vertices=300)
    assert np.array_equal(both, swapped) and both.report["fields"] == ["a", "b"]


def test_an_array_to_intersect_with_is_one_metric(background):
    u, finer = ridge(background.points), np.tile([100.0, 0, 100], (len(background.points), 1))
    matrices = finer[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    one, array, whole, sizes, two, stack, whole_stack = (
        asterism.metric(background, u, vertices=1500, intersect=given)
        for given in ([finer], finer, matrices, np.full(len(finer), 0.1), [finer, finer], np.stack([finer, finer]),
                      np.stack([matrices, matrices])))
    assert np.array_equal(one, array) and np.array_equal(one, whole)
    assert np.array_equal(two, stack) and np.array_equal(two, whole_stack)
    with pytest.raises(asterism.InputError, match="intersect: 2 tensors"):
        asterism.metric(background, u, vertices=1500, intersect=np.tile([1.0, 0, 1], (1, 2, 1)))
    assert np.allclose(one, sizes, rtol=1e-9, atol=1e-9) and np.allclose(one, two, rtol=1e-9, atol=1e-9)


def test_values_of_any_size_have_the_metric_of_ordinary_ones(background):
    u = 1.5 * ridge(background.points)  # from 1 to 2 at most: no power of two has to be taken out
    ordinary = asterism.metric(background, u, vertices=300)
    for power in (-900, 1000):
        assert np.array_equal(asterism.metric(background, u * 2.0 ** power, vertices=300), ordinary)


def test_points_far_outside_of_the_mesh_with_the_values_are_told(background):
    wider = [(-1, -1), (3, -1), (3, 1), (-1, 1)]
    other = asterism.mesh(wider, size=0.5)
    with pytest.warns(UserWarning, match="points are outside of the mesh that has the values, by up to 2: "):
        asterism.transfer(background, ridge(background.points), other)
    with pytest.warns(UserWarning, match="by up to 2: they have values of the nearest"):
        asterism.adapt(background, ridge(background.points), domain=wider, vertices=200)


@pytest.mark.filterwarnings("ignore::asterism.NotReachedWarning")
def test_a_metric_that_is_given_is_bounded(background):
    graded = np.array(background.metric) * np.linspace(0.2, 5, len(background.points))[:, None]
    bounded = asterism.metric(background, graded, hmin=0.1, hmax=0.2)
    values = np.linalg.eigvalsh(bounded[:, [0, 1, 1, 2]].reshape(-1, 2, 2))
    assert values.min() >= 25 * (1 - 1e-12) and values.max() <= 100 * (1 + 1e-12)


def test_the_gradation_of_a_field_is_six_unless_named_and_of_a_metric_none(background):
    u = np.tanh(100 * (background.points[:, 0] - 0.37))
    by_default, six, none = (asterism.metric(background, u, vertices=400, **words)
                             for words in ({}, {"gradation": 6}, {"gradation": None}))
    assert np.array_equal(by_default, six) and not np.array_equal(six, none)
    steep = np.array(background.metric) * np.exp(3 * background.points[:, :1])
    assert np.array_equal(asterism.metric(background, steep), steep)


def test_the_implied_metric_is_that_of_the_edges(background):
    implied = asterism.implied_metric(background)
    sizes = np.linalg.det(implied[:, [0, 1, 1, 2]].reshape(-1, 2, 2)) ** -0.25
    assert 0.05 < np.median(sizes) < 0.2


def test_targets_that_cannot_be_met_are_warnings(background):
    with pytest.warns(asterism.NotReachedWarning):
        missed = asterism.metric(background, ridge(background.points), complexity=1e5, hmin=0.3)
    assert not missed.report["reached"] and missed.report["reason"]


@pytest.mark.parametrize("values, options, message", [
    (np.zeros(4), {}, "numbers are wanted, one row a point"),
    (np.zeros((2, 5)), {}, "one number a point"),
    (np.zeros((2, 2)), {}, "u: 358 rows of one"),
    ({"u": np.zeros((358, 3)), "v": np.zeros(358)}, {}, "u: a tensor"),
    ({"u": np.zeros(2)}, {}, "u: 358 rows of"),
    ({"u": np.zeros(638)}, {}, "u: it has 638 rows, one a triangle, and 358 are wanted, one a point"),
    (None, {"norm": 0.5}, "norm"),
    (None, {"gradation": "mild"}, "a number above 1 or None"),
    (None, {"hessian": "guess"}, "'lsq' is wanted"),
    (None, {"complexity": 10, "vertices": 10}, "one of"),
    (None, {"intersect": [np.tile([1, 0, 1], (2, 1))]}, "intersect: 2 tensors"),
])
def test_what_is_refused(background, values, options, message):
    if values is None:
        values = ridge(background.points)
    with pytest.raises(asterism.InputError, match=message):
        asterism.metric(background, values, **options)
    bad = ridge(background.points)
    bad[7] = np.nan
    with pytest.raises(asterism.InputError, match="row 7 is not finite"):
        asterism.metric(background, bad)


def integral(mesh, values):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return (np.cross(b - a, c - a) / 6 * values[mesh.triangles].sum(axis=1)).sum()


def test_the_loop_of_the_manual():
    """A solver, the metric it asks for, the next mesh, and the solution brought there."""
    domain = asterism.Domain.square()
    mesh = asterism.mesh(domain, metric="swirl:3", size=0.3)
    for _ in range(2):
        u = ridge(mesh.points)
        wanted = asterism.metric(mesh, u, norm=2, complexity=300, gradation=1.5, hmin=1e-4, hmax=0.5)
        new = asterism.mesh(domain, metric=(mesh, wanted))
        before = integral(mesh, u)
        u, mesh = asterism.transfer(mesh, u, new, how="conservative"), new
        assert u.shape == (len(mesh.points),) and abs(integral(mesh, u) - before) < 1e-12
    assert mesh.complete and mesh.certified and mesh.certificate.worst_angle >= 20


def test_transfer_of_vectors_and_by_name(background):
    finer = asterism.mesh(asterism.Domain.square(), size=0.09)
    x, y = background.points.T
    linear = np.column_stack([1 + x, x - 2 * y])
    for how in ("interpolate", "conservative", "bounded"):
        moved = asterism.transfer(background, {"v": linear, "s": ridge(background.points)}, finer, how)
        if how != "bounded":  # the projection within bounds may diffuse at the boundary
            assert abs(moved["v"] - np.column_stack([1 + finer.points[:, 0], finer.points @ (1, -2)])).max() < 1e-12
        assert moved["s"].report["components"]["s"]["integral_before"] == pytest.approx(
            integral(background, ridge(background.points)))
        if how != "conservative":
            assert moved["s"].max() <= ridge(background.points).max() + 1e-12
    with pytest.raises(asterism.InputError, match="'bounded' is wanted"):
        asterism.transfer(background, x, finer, "guess")
    with pytest.raises(asterism.InputError, match="rows of one, two or three"):
        asterism.transfer(background, x[1:], finer)


def second_derivatives(points):
    """Returns second derivatives of the ridge tanh s, s = 8 (r^2 - 1/2), by the chain rule."""
    x, y = points.T
    t = np.tanh(8 * (x * x + y * y - 0.5))
    slope, bend = 8 * (1 - t * t), -2 * 64 * t * (1 - t * t)
    return np.stack([4 * x * x * bend + 2 * slope, 4 * x * y * bend, 4 * y * y * bend + 2 * slope], axis=1)


def test_a_metric_at_the_points_may_be_a_callable(background):
    at = background.points
    sizes = 0.2 + 0.1 * at[:, 0]
    many, one = lambda p: 0.2 + 0.1 * p[:, 0], lambda p: 0.2 + 0.1 * float(p[0, 0]) if len(p) == 1 else 1 / 0
    wanted = asterism.adapt(background, metric=sizes).mesh
    for called in (many, one):
        assert np.array_equal(asterism.adapt(background, metric=called).mesh.sites, wanted.sites)
    besides = [asterism.adapt(background, ridge(at), vertices=400, intersect=[of]).metric for of in (sizes, many)]
    assert np.array_equal(*besides)
    with pytest.raises(ZeroDivisionError):
        asterism.adapt(background, metric=lambda p: 1 / 0)


def test_second_derivatives_take_the_place_of_values(background):
    given = second_derivatives(background.points)
    wanted = asterism.metric(background, hessian=given, vertices=500)
    assert wanted.report["reached"] and wanted.report["steps"][0] == "hessian given"
    matrices = given[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    assert np.array_equal(wanted, asterism.metric(background, hessian={"w": -matrices}, vertices=500))
    u = ridge(background.points)
    made = asterism.adapt(background, u, hessian=given, vertices=400, gradation=None)
    assert abs(len(made.mesh.points) / 400 - 1) < 0.1 and made.values.shape == (len(made.mesh.points),)
    assert made.mesh.certified
    with pytest.raises(asterism.InputError, match="neither is given"):
        asterism.metric(background)
    with pytest.raises(asterism.InputError, match="both are given"):
        asterism.metric(background, u, hessian=given)
    with pytest.raises(asterism.InputError, match="not finite"):
        asterism.metric(background, hessian=np.where(given > given.max() / 2, np.nan, given))


def test_errors_relative_to_the_values(background):
    u = ridge(background.points)
    first = asterism.metric(background, u, error=0.02, relative=True, gradation=None)
    assert np.array_equal(first, asterism.metric(background, 1024 * u, error=0.02, relative=True, gradation=None))
    assert first.report["steps"][2] == "relative 0.02"
    pointwise = asterism.metric(background, u, error=0.02, relative=True, cutoff=0.1)
    assert pointwise.report["complexity_delivered"] > first.report["complexity_delivered"]
    for words in ({"relative": True}, {"error": 0.1, "cutoff": 0.1}, {"error": 0.1, "relative": True, "cutoff": 2}):
        with pytest.raises(asterism.InputError):
            asterism.metric(background, u, **words)


def test_no_inner_edge_joins_two_points_of_the_boundary():
    slab = asterism.mesh(asterism.Domain.square(), size=0.5)
    made = asterism.adapt(slab, metric=np.full((len(slab.points), 1), 0.4), no_split_across=True)
    sides = np.sort(np.concatenate([made.mesh.triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    edges, counts = np.unique(sides, axis=0, return_counts=True)
    outer = np.unique(edges[counts == 1])
    assert not np.isin(edges[counts == 2], outer).all(axis=1).any()
    assert made.mesh.certified
