# SPDX-License-Identifier: MIT
"""Meshes with slits, which have points once for each side. Everything made of such a mesh keeps the sides apart."""
import pickle
import warnings

import numpy as np
import pytest

import asterism


def slit_square(n=8):
    """Returns a square of 2 n^2 triangles with a slit along y = 0 from its left side to the tip in its middle."""
    at = [(-1 + 2 * i / n, -1 + 2 * j / n) for j in range(n + 1) for i in range(n + 1)]
    middle = n // 2
    above = {i + middle * (n + 1): len(at) + i for i in range(middle)}
    at += [at[v] for v in above]

    def corner(i, j, lower):
        v = i + j * (n + 1)
        return v if lower else above.get(v, v)

    triangles = []
    for j in range(n):
        for i in range(n):
            a, b, c, d = (corner(*ij, j < middle) for ij in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            triangles += [(a, b, d), (b, c, d)] if (i + j) % 2 else [(a, b, c), (a, c, d)]
    return np.array(at), np.array(triangles)


def sides(mesh):
    """Returns the slit's points of triangles above it, and those of triangles below it."""
    above = mesh.points[mesh.triangles].mean(axis=1)[:, 1] > 0
    on = np.flatnonzero((mesh.points[:, 1] == 0) & (mesh.points[:, 0] < 0))
    return [np.intersect1d(on, mesh.triangles[rows]) for rows in (above, ~above)]


def check_parted(mesh):
    upper, lower = sides(mesh)
    assert len(upper) > 2 and not np.intersect1d(upper, lower).size
    places = [sorted(map(tuple, mesh.points[side])) for side in (upper, lower)]
    assert places[0] == places[1]


@pytest.fixture(scope="module")
def slit():
    return asterism.Mesh(*slit_square())


def test_points_of_both_sides_stay(slit):
    at, triangles = slit_square()
    assert np.array_equal(slit.points, at) and np.array_equal(slit.triangles, triangles)
    check_parted(slit)


def test_what_is_no_slit_is_refused():
    at, triangles = slit_square(4)
    lone = np.vstack([at, at[18]])
    with pytest.raises(asterism.InputError, match="at the same point.*no slit"):
        asterism.Mesh(lone, triangles)


def test_a_mesh_of_its_domain_has_both_sides(slit, tmp_path):
    domain = asterism.Domain.from_mesh(slit)
    for of in (domain, pickle.loads(pickle.dumps(domain)), slit):
        made = asterism.mesh(of, size=0.15)
        check_parted(made)
        assert made.certified and made.verify()["verified"]
    made.save(str(tmp_path / "n.msh"))
    read = asterism.read(tmp_path / "n.msh")
    assert np.array_equal(read.points, made.points)
    assert read.verify()["verified"]
    check_parted(asterism.mesh(read.domain, size=0.15))


def test_certify_takes_it(slit):
    made = asterism.mesh(slit, size=0.15)
    assert asterism.certify(made.points, made.triangles, made.metric)["certified"]


def test_adapt_brings_each_side_its_values(slit):
    u = np.where(np.isin(np.arange(len(slit.points)), sides(slit)[0]), 1.0, 0.0) + slit.points[:, 1]
    values = slit.points[:, 0] ** 2 + 3 * slit.points[:, 1] ** 2
    answer = asterism.adapt(slit, values, vertices=300, carry={"jump": u})
    check_parted(answer.mesh)
    upper, lower = sides(answer.mesh)
    tip = answer.mesh.points[upper, 0] > -0.25 - 1e-12  # the last edge of the side ends at the tip
    assert answer.carried["jump"][upper][~tip] == pytest.approx(1)
    assert answer.carried["jump"][lower] == pytest.approx(0)
    assert answer.mesh.verify()["verified"]


def test_metric_transfer_and_lookups(slit):
    values = slit.points[:, 0] ** 2
    assert asterism.metric(slit, values, vertices=200).shape == (len(slit.points), 3)
    moved = asterism.transfer(slit, values, slit, how="interpolate")
    assert moved == pytest.approx(values)
    assert (slit.neighbors < 0).sum() == 4 * 8 + 2 * 4
    assert slit.locate([(-0.5, 0.1), (-0.5, -0.1)]).min() >= 0
    assert asterism.mesh("square", metric=(slit, np.full((len(slit.points), 3), (30.0, 0, 30.0)))).certified
    assert "<svg" in slit.svg()


def test_the_hull_closes_points():
    corners = [(0, 0), (2, 0), (2, 1), (0, 1), (1, 0.25)]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the warning that sides were added
        domain = asterism.Domain(corners, convex_hull=True)
        assert len(domain.points) == 5 and len(domain.segments) == 4
        notch = asterism.Domain(corners, [(0, 4), (4, 1), (1, 2), (2, 3), (3, 0)], convex_hull=True)
        assert len(notch.segments) == 6
        assert asterism.mesh(corners, size=0.5, convex_hull=True).certified
    with pytest.warns(UserWarning, match="4 of 4 sides of the convex hull"):
        asterism.Domain(corners, convex_hull=True)
    with pytest.raises(asterism.InputError, match="convex_hull: .*on one line"):
        asterism.Domain([(0, 0), (1, 1), (2, 2)], convex_hull=True)
    with pytest.raises(asterism.InputError, match="convex_hull: .*mesh"):
        asterism.mesh(asterism.Mesh(*slit_square(2)), convex_hull=True)


def test_a_file_of_points_is_a_domain_with_the_hull(tmp_path):
    file = tmp_path / "p.node"
    file.write_text("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n")
    with pytest.warns(UserWarning, match="4 of 4 sides"):
        assert len(asterism.Domain.read(file, convex_hull=True).segments) == 4
    with pytest.raises(asterism.InputError):
        asterism.Domain.read(file)
