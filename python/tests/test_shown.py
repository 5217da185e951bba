# SPDX-License-Identifier: MIT
"""Pages with fields and earlier meshes, and the polygons of a mesh for other packages."""
import json
import re
import zlib
from base64 import b64decode
from fractions import Fraction

import numpy as np
import pytest

import asterism


@pytest.fixture(scope="module")
def made() -> asterism.Mesh:
    return asterism.mesh("square", size=0.5)


def facts_of(page) -> dict:
    """Returns the data that the page's script reads first."""
    return json.loads(re.search(r'id="facts">(.*?)</script>', page.text, re.S).group(1))


def array_of(page, name: str) -> np.ndarray:
    """Returns the named array of the page's packed data, by another route than the page's script."""
    kinds = {"f64": np.float64, "f32": np.float32, "u32": np.uint32, "i32": np.int32, "u8": np.uint8}
    packed = zlib.decompress(b64decode(re.search(r'id="data">(.*?)</script>', page.text, re.S).group(1)))
    at = 0
    for entry in facts_of(page)["arrays"]:
        kind = np.dtype(kinds[entry["type"]])
        size = kind.itemsize * entry["length"]
        if entry["name"] == name:  # packed as planes: the first bytes of all numbers, then the second ones
            planes = np.frombuffer(packed, np.uint8, size, at).reshape(kind.itemsize, entry["length"])
            return np.ascontiguousarray(planes.T).view(kind).reshape(-1)
        at += size
    raise AssertionError(f"{name} is not on the page")


def test_fields_are_on_the_page_as_they_are(made):
    u, v = np.sin(made.points[:, 0]), made.points * 2
    page = made.show({"u": u, "v": v})
    fields = facts_of(page)["fields"]
    assert [(f["name"], f["components"]) for f in fields] == [("u", 1), ("v", 2)]
    assert np.array_equal(array_of(page, fields[0]["array"]), u)
    assert np.array_equal(array_of(page, fields[1]["array"]), v.reshape(-1))
    assert facts_of(made.show(u))["fields"][0]["name"] == "u" and facts_of(made.show())["fields"] == []
    holding = asterism.Mesh(made.points, made.triangles, values={"p": u})
    assert facts_of(holding.show())["fields"][0]["name"] == "p"
    with pytest.raises(asterism.InputError, match="p: .* rows of one, two or three numbers"):
        made.show({"p": u[1:]})


def test_what_came_before_has_a_button_or_a_place_on_the_slider(made):
    coarse, u = asterism.mesh("square", size=1.0), None
    u = coarse.points[:, 0] ** 2
    def labels(page):
        return [f["label"] for f in facts_of(page)["frames"]] + [facts_of(page)["label"]]
    assert labels(made.show()) == ["After"]
    assert labels(made.show(before=coarse)) == ["Before", "After"]
    assert labels(made.show(before=[coarse, made, coarse])) == ["Round 1", "Round 2", "Round 3", "Round 4"]
    assert labels(made.show(before=(coarse, made))) == ["Round 1", "Round 2", "Round 3"]
    assert labels(made.show(before={"old": coarse, "domain": made.domain}, label="new")) == ["old", "domain", "new"]
    page = made.show(before=(coarse, {"u": u}))
    frame = facts_of(page)["frames"][0]
    assert (frame["vertices"], frame["triangles"]) == (len(coarse.points), len(coarse.triangles))
    assert np.array_equal(array_of(page, frame["fields"][0]["array"]), u)
    assert np.array_equal(array_of(page, "frame0.positions").reshape(-1, 2), coarse.points)
    assert facts_of(made.show(before=made.domain))["frames"][0]["triangles"] == 0
    for wrong in (7, "square", [7], {"a": None}, (made, u)):
        with pytest.raises(asterism.InputError, match="before: a Mesh, a pair|rows of one, two or three"):
            made.show(before=wrong)


def test_the_metric_wanted_and_other_wishes(made):
    page = made.show(wanted=made.metric, title="<Plate>", height=99)
    assert not array_of(page, "distances").any() and "<Plate>" not in page.text and 'height="99"' in page._repr_html_()
    assert array_of(made.show(wanted=0.25), "distances").all()
    with pytest.raises(asterism.InputError, match="wanted: "):
        made.show(wanted=made.metric[1:])
    with pytest.raises(asterism.InputError, match="height"):
        made.show(height=0)


def test_an_adaptation_shows_both_meshes(made):
    u = np.tanh(8 * made.points[:, 0])
    next_mesh = asterism.adapt(made, u, vertices=60, carry={"p": u})
    facts = facts_of(next_mesh.show())
    assert [f["name"] for f in facts["fields"]] == ["u", "p"]
    assert [f["name"] for f in facts["frames"][0]["fields"]] == ["u", "p"]
    assert facts["frames"][0]["vertices"] == len(made.points)


def test_values_are_saved_or_told_to_be_left_out(made, tmp_path):
    holding = asterism.Mesh(made.points, made.triangles, values={"p": made.points[:, 0]}, edges=made.edges,
                            edge_markers=made.edge_markers)
    assert [name.rpartition("a.")[2] for name in holding.save(tmp_path / "a.mesh")] == ["mesh", "sol", "fields.sol"]
    holding.save(tmp_path / "a.vtu")
    assert 'Name="p"' in (tmp_path / "a.vtu").read_text(encoding="latin-1")
    with pytest.warns(UserWarning, match="su2: values have no place in it and are left out"):
        holding.save(tmp_path / "a.su2")


def area(ring) -> Fraction:
    xs = [(Fraction(x), Fraction(y)) for x, y in ring]
    return sum((a[0] * b[1] - a[1] * b[0] for a, b in zip(xs, xs[1:])), Fraction(0)) / 2


RING = [(0, 0), (4, 0), (4, 4), (0, 4)]


@pytest.mark.parametrize("points, segments, holes, rings", [
    (RING, None, [], [1]),
    # Has a hole with an island in it.
    (RING + [(1, 1), (3, 1), (3, 3), (1, 3), (2, 1.5), (2.5, 2.5), (1.5, 2.5)],
     [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (8, 9), (9, 10), (10, 8)],
     [(1.1, 1.1)], [2, 1]),
    # Has a hole that touches the outer ring in one of its corners.
    ([(0, 0), (4, 0), (4, 4), (0, 4), (1, 2), (2, 1)],
     [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 5), (5, 0)], [(1, 1)], [2]),
    # Has two parts that touch in one point.
    ([(0, 0), (1, 0), (1, 1), (2, 1), (2, 2)],
     [(0, 1), (1, 2), (2, 0), (2, 3), (3, 4), (4, 2)], [], [1, 1]),
    # Has two holes that touch each other, and a segment inside.
    (RING + [(1, 1), (2, 2), (1, 3), (3, 1), (3, 3), (0.5, 0.5)],
     [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 4), (5, 7), (7, 8), (8, 5), (0, 9)],
     [(1.2, 2), (2.8, 2)], [3]),
    # Has two parts that close a ring by meeting in a point. The region they enclose is a hole.
    ([(0, 0), (4, 0), (4, 4), (0, 4), (2, 4), (1, 1), (3, 1)],
     [(0, 1), (1, 2), (2, 4), (4, 3), (3, 0), (4, 5), (5, 6), (6, 4)], [(2, 2)], [2]),
])
def test_a_domain_is_the_polygons_that_it_covers(points, segments, holes, rings):
    domain = asterism.Domain(points, segments, holes=holes)
    told = domain.__geo_interface__
    polygons = [told["coordinates"]] if told["type"] == "Polygon" else list(told["coordinates"])
    assert sorted(map(len, polygons)) == sorted(rings)
    for polygon in polygons:
        for k, ring in enumerate(polygon):
            assert ring[0] == ring[-1] and len(set(ring)) == len(ring) - 1
            assert (area(ring) > 0) == (k == 0)
    mesh = asterism.mesh(domain, size=0.7, angle_bound=0)
    corners = mesh.points[mesh.triangles]
    covered = sum(area([tuple(p) for p in (*t, t[0])]) for t in corners)
    assert float(covered) == pytest.approx(float(sum(area(ring) for polygon in polygons for ring in polygon)), rel=1e-12)
    again = asterism.Domain.from_geo(domain)
    assert {frozenset(map(tuple, e)) for e in again.points[again.segments].tolist()} <= {
        frozenset(map(tuple, e)) for e in domain.points[domain.segments].tolist()}
    shapely = pytest.importorskip("shapely.geometry")
    for of in (domain, mesh):
        shape = shapely.shape(of)
        assert shape.is_valid and shape.area == pytest.approx(float(covered), rel=1e-12)
