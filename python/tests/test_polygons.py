# SPDX-License-Identifier: MIT
"""Shapes of shapely as domains: the mesh covers what shapely says that they contain."""
import json
import random
import warnings

import numpy as np
import pytest

import asterism

geometry = pytest.importorskip("shapely.geometry")
operations = pytest.importorskip("shapely.ops")
affinity = pytest.importorskip("shapely.affinity")

GRID = 12


def areas(domain):
    """Returns the areas of a mesh of few triangles by region."""
    mesh = asterism.mesh(domain, size=50, angle_bound=5)
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    sizes = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    regions = np.array(mesh.regions)
    return {int(region): sizes[regions == region].sum() for region in np.unique(regions)}


def polygons_of(shape):
    if shape.geom_type == "Polygon":
        return [] if shape.is_empty else [shape]
    return [p for part in getattr(shape, "geoms", []) for p in polygons_of(part)]


def collected(shape):
    return geometry.MultiPolygon(polygons_of(shape))


def blob(dice):
    """A box, a polygon of a few corners, a disk of 4 to 12 corners, or a square on its tip."""
    x, y, size, kind = dice.randrange(GRID), dice.randrange(GRID), dice.randrange(1, GRID // 3), dice.random()
    if kind < 0.4:
        return geometry.box(x, y, x + size, y + dice.randrange(1, GRID // 2))
    if kind < 0.6:
        while True:
            corners = [(dice.randrange(GRID), dice.randrange(GRID)) for _ in range(dice.randrange(3, 6))]
            shape = geometry.Polygon(corners)
            if shape.is_valid and shape.area > 0:
                return shape
    if kind < 0.8:
        return geometry.Point(x, y).buffer(size, dice.randrange(1, 4))
    return affinity.rotate(geometry.box(x, y, x + size, y + size), 45)


def one_shape(dice):
    """Returns the result of a few random operations: parts that touch in points, lakes, islands in lakes."""
    shape = blob(dice)
    for _ in range(dice.randrange(1, 7)):
        operation = dice.choice(["union", "difference", "intersection"] + 3 * ["symmetric_difference"])
        changed = getattr(shape, operation)(blob(dice))
        shape = shape if changed.is_empty else changed
    return [collected(shape)]


def several_features(dice):
    """Returns features made of the pieces into which outlines cut the plane; some pieces belong to none. They have
    enclaves, lakes between features, holes of one under another, and common sides on which only one feature has a
    vertex."""
    outlines = operations.unary_union([blob(dice).boundary for _ in range(dice.randrange(3, 8))])
    count = dice.randrange(2, 6)
    dealt = [[] for _ in range(count + 1)]
    for piece in operations.polygonize(outlines):
        dealt[dice.randrange(count + 1)].append(piece)
    return [collected(operations.unary_union(pieces)) for pieces in dealt[:count]]


def collection(shapes):
    return {"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"n": float("nan")}, "geometry": shape} for shape in shapes]}


@pytest.mark.parametrize("make, seed", [(one_shape, 1), (several_features, 2)])
def test_areas_by_feature_are_those_of_shapely(make, seed):
    done = 0
    for number in range(270):
        shapes = make(random.Random(1000 * seed + number))
        assert all(shape.is_valid for shape in shapes)
        wanted = {k: shape.area for k, shape in enumerate(shapes, 1) if shape.area > 0}
        if not wanted:
            continue
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # warnings that features are empty
            domain = asterism.Domain.from_geo(collection(shapes))
        found = areas(domain)
        assert found.keys() == wanted.keys(), (seed, number)
        for feature, area in wanted.items():
            assert abs(found[feature] - area) <= 1e-12 * max(1, area), (seed, number, feature)
        done += 1
    assert done >= 250


def test_differences_that_shapely_rounded_are_right_or_refused_by_name():
    """shapely cuts a feature out of another. The corners are rounded, and are beside the other's sides."""
    refused = 0
    for number in range(60):
        dice = random.Random(3000 + number)
        (first,), (second,) = one_shape(dice), one_shape(dice)
        second = collected(second.difference(first))
        if first.is_empty or second.is_empty:
            continue
        try:
            domain = asterism.Domain.from_geo(collection([first, second]))
        except asterism.InputError as refusal:
            assert "(feature 2) crosses" in str(refusal) or "(feature 1) crosses" in str(refusal), number
            refused += 1
            continue
        found = areas(domain)
        for feature, shape in ((1, first), (2, second)):
            assert abs(found[feature] - shape.area) <= 1e-12 * max(1, shape.area), (number, feature)
    assert 0 < refused < 50


def test_shapes_and_texts_give_the_same_domain(tmp_path):
    shape = geometry.box(0, 0, 3, 3).difference(geometry.box(1, 1, 2, 2))
    both = geometry.MultiPolygon([shape, geometry.box(1, 1, 2, 2)])
    (tmp_path / "both.wkt").write_text(both.wkt)
    (tmp_path / "both.geojson").write_text(json.dumps(geometry.mapping(both)))
    made = [asterism.Domain.from_shapely(both), asterism.Domain.read(tmp_path / "both.wkt"),
            asterism.Domain.read(tmp_path / "both.geojson")]
    for domain in made:
        assert areas(domain) == {1: 9}
        assert (domain.points == made[0].points).all() and (domain.segments == made[0].segments).all()
        assert sorted(domain.markers) == [1] * 8
    assert repr(made[0]) == "<Domain: 8 points, 8 segments>"


def test_what_is_passed_over_is_a_warning():
    triangle = geometry.Polygon([(0, 0), (1, 0), (0, 1)])
    mixed = geometry.GeometryCollection([geometry.Point(0.1, 0.1), triangle])
    with pytest.warns(UserWarning, match="points and lines passed over: 1"):
        assert areas(asterism.Domain.from_geo(mixed)) == {1: 0.5}
    with pytest.warns(UserWarning, match="overlap, numbered as the first of them: 1, feature 1 and feature 2"):
        asterism.Domain.from_geo(collection([triangle, triangle]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        asterism.Domain.from_geo(collection([geometry.box(0, 0, 1, 1), geometry.box(1, 0, 2, 1)]))


@pytest.mark.parametrize("shape, message", [
    (geometry.Point(0, 0), "no polygon in it; points and lines: 1"),
    (geometry.Polygon(), "no polygon in it; empty geometries: 1"),
    (geometry.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)]), "Polygon: the side .* of polygon 1 crosses the side"),
    ({"type": "Polygon", "coordinates": [[(0, 0), (1, float("inf")), (1, 1)]]}, "dict: .*finite"),
    ({"type": "Polygon", "coordinates": [[(0, 0), (1, "x"), (1, 1)]]}, r"coordinates\[0\]\[1\]: two finite numbers"),
    ({"type": "Polygon"}, "there is no \"coordinates\""),
    ("POLYGON ((0 0, 1 0, 1 1))", "polygons are wanted, not str"),
])
def test_shapes_that_are_no_domain(shape, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.Domain.from_geo(shape)


def test_arrays_of_numpy_are_coordinates():
    corners = np.array([(0, 0), (2, 0), (2, 1), (0, 1)], dtype=np.float32)
    assert areas(asterism.Domain.from_geo({"type": "Polygon", "coordinates": [corners]})) == {1: 2}
