# SPDX-License-Identifier: MIT
"""Regions of a mesh that is a domain, through Python."""
import warnings
from collections import defaultdict
from fractions import Fraction

import numpy as np
import pytest

import asterism


def grid(n, region_of):
    points = [(i, j) for j in range(n + 1) for i in range(n + 1)]
    triangles, regions = [], []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            triangles += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
            regions += [region_of(i, j, 0), region_of(i, j, 1)]
    return np.array(points, dtype=float), np.array(triangles), np.array(regions)


def areas(points, triangles, regions):
    sums = defaultdict(Fraction)
    for t, region in zip(triangles, regions):
        (ax, ay), (bx, by), (cx, cy) = (map(Fraction, points[v].tolist()) for v in t)
        sums[int(region)] += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
    return dict(sums)


def quietly(call, *arguments, **more):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return call(*arguments, **more)


@pytest.mark.parametrize("seed", range(12))
def test_regions_survive(seed):
    chance = np.random.default_rng(seed)
    numbers = chance.choice([0, 1, -5, 4, 77, 2**31 - 1, -2**31], 3, replace=False)
    cut = chance.integers(1, 5, 3).tolist()
    points, triangles, regions = grid(
        6, lambda i, j, h: int(numbers[int(i < cut[0]) + int(j < cut[1] and i > cut[2] + h - 1)]))
    points = points @ np.array([[1, 0], [chance.choice([0, 0.3, -1 / 7]), 1]]) * chance.choice([1, 0.01])
    old = asterism.Mesh(points, triangles, regions=regions)
    assert (old.regions == regions).all()
    wanted = areas(points, triangles, regions)
    for angle in (None, 30):
        domain = quietly(asterism.Domain.from_mesh, old, angle)
        new = asterism.mesh(domain, size=0.7 * abs(points).max() / 6)
        assert new.certified
        found = areas(new.points, new.triangles, new.regions)
        assert set(found) == set(wanted)
        for region, area in wanted.items():
            assert abs(float(found[region] / area) - 1) < 1e-13
        if set(wanted) == {1}:
            continue
        for row in new.certificate.data["audit"]["regions"]:
            assert row["area"] == float(found[row["region"]])
            assert row["area_of_domain"] == pytest.approx(float(wanted[row["region"]]), rel=1e-13)
        assert new.verify()["verified"]


@pytest.mark.parametrize("ending", ["mesh", "meshb", "msh", "vtu"])
def test_files(tmp_path, ending):
    points, triangles, regions = grid(4, lambda i, j, h: 3 if i < 2 else -1)
    old = quietly(asterism.Mesh, points, triangles, regions=regions, edges=[(2, 7), (7, 12)],
                  edge_markers=[8, 9])
    made = asterism.mesh(quietly(asterism.Domain.from_mesh, old))
    made.save(tmp_path / f"a.{ending}")
    again = asterism.read(tmp_path / f"a.{ending}")
    assert (again.regions == made.regions).all()
    assert sorted(again.edge_markers) == sorted(made.edge_markers)
    assert {8, 9} < set(again.edge_markers)


def test_what_is_not_listed_is_told():
    points, triangles, regions = grid(2, lambda i, j, h: 1 + i)
    with pytest.warns(UserWarning, match="7 of 8 boundary edges are not listed"):
        old = asterism.Mesh(points, triangles, regions=regions, edges=[(0, 1)], edge_markers=[4])
    assert not asterism.certify(old)["certified"]
    assert asterism.certify(old)["findings"][0][0] == "wrong_region"
    with pytest.warns(UserWarning, match="of marker 0: 2, the first"):
        domain = asterism.Domain.from_mesh(old)
    assert sorted(domain.markers) == [0] * 9 + [4]


def test_markers_with_their_edges():
    points, triangles, regions = grid(2, lambda i, j, h: 1)
    sides = [(0, 1), (1, 2), (2, 5), (5, 8), (8, 7), (7, 6), (6, 3), (3, 0)]
    apart = asterism.Mesh(points, triangles, edges=sides, markers=range(1, 9))
    for together in ([(*side, k + 1) for k, side in enumerate(sides)], {side: k + 1 for k, side in enumerate(sides)}):
        mesh = asterism.Mesh(points, triangles, markers=together)
        assert np.array_equal(mesh.edges, apart.edges) and np.array_equal(mesh.edge_markers, apart.edge_markers)
    assert not np.any(asterism.Mesh(points, triangles, markers={}).edge_markers)


def test_wrong_arguments():
    points, triangles, regions = grid(1, lambda i, j, h: 1)
    for more, word in (({"regions": [1]}, r"regions: the shape \(2,\) is wanted, one for each triangle"), ({"edges": [1, 2]}, "edges: the shape"),
                       ({"edges": [(0, 4)]}, "names point 4 of 4"),
                       ({"edge_markers": [1]}, r"edge_markers: edges \(b, 2\) are wanted"),
                       ({"markers": {3: 1}}, "markers: a key is a pair of points"),
                       ({"markers": {(0, 4): 1}}, "names point 4 of 4"),
                       ({"markers": [(0, 1, 2.5)]}, "2.5"),
                       ({"regions": [1, 2**31]}, "more than 32 bits"),
                       ({"edges": [(0, 1)], "edge_markers": [1, 2]}, r"edge_markers: the shape \(1,\) is wanted, one for each edge")):
        with pytest.raises(asterism.InputError, match=word):
            asterism.Mesh(points, triangles, **more)
