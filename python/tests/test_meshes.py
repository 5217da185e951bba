# SPDX-License-Identifier: MIT
"""Domains, meshes and certificates: results, refusals, interrupts."""
import gc
import json
import os
import pickle
import signal
import threading
import warnings

import numpy as np
import pytest

import asterism

CORNERS = [(0, 0), (2, 0), (2, 1), (0, 1)]
SIDES = [(0, 1), (1, 2), (2, 3), (3, 0)]


@pytest.fixture(scope="module")
def made():
    return asterism.mesh(asterism.Domain.square(), metric="swirl:12", size=0.25)


def areas(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def test_the_curves_of_a_domain_file_are_kept():
    domain = asterism.Domain.read(os.path.join(os.path.dirname(__file__), "../../examples/fillets.poly"))
    made = asterism.mesh(domain, size=0.2)
    assert made.certified, made.reason
    told = json.loads(made.certificate.text)["audit"]["curves"]
    assert told["curves"] == 5 and 0 < told["largest_distance"] < 0.01


def test_a_chord_tolerance_is_kept():
    domain = asterism.Domain.read(os.path.join(os.path.dirname(__file__), "../../examples/fillets.poly"))
    for size, tolerance in ((0.2, 1e-4), (None, 2e-3)):
        made = asterism.mesh(domain, size=size, chord_tolerance=tolerance)
        assert made.certified, made.reason
        told = json.loads(made.certificate.text)
        assert told["audit"]["curves"]["largest_distance"] <= 1.01 * tolerance
        assert float(told["asked"]["options"]["chord-tolerance"]) == tolerance
        assert made.verify()["verified"]
    with pytest.raises(asterism.InputError, match="no curves"):
        asterism.mesh(asterism.Domain.square(), chord_tolerance=0.1)
    with pytest.raises(asterism.InputError, match="positive"):
        asterism.mesh(domain, chord_tolerance=0)


def test_a_mesh_is_certified_and_covers_its_domain(made):
    assert made.complete and made.certified and made.reason
    assert made.certificate.worst_angle >= 20
    assert (areas(made) > 0).all() and abs(areas(made).sum() - 4) < 1e-12
    assert made.verify()["verified"] and not made.verify()["contradictions"]
    assert asterism.certify(made)["certified"]
    assert made.statistics()["mean_quality"] > 0.5
    assert "certified" in repr(made)


def test_arrays_are_views_that_live_as_long_as_needed():
    mesh = asterism.mesh(asterism.Domain.square())
    points, metric, triangles = mesh.points, mesh.metric, mesh.triangles
    assert points.shape[1:] == (2,) and metric.shape[1:] == (3,) and triangles.dtype == np.int32
    assert points.strides == (40, 8) and not points.flags.owndata
    with pytest.raises(ValueError):
        points[0, 0] = 9
    copy = np.array(points)
    del mesh
    gc.collect()
    assert (points == copy).all()


def test_the_metric_in_every_form_gives_the_same_mesh(made):
    def swirl(p):
        x, y = p[:, 0], p[:, 1]
        return np.column_stack([1 + 12 * y * y, -12 * x * y, 1 + 12 * x * x])

    formula = asterism.mesh(asterism.Domain.square(), "expr:1+12*y*y;-12*x*y;1+12*x*x", 0.25)
    called = asterism.mesh(asterism.Domain.square(), swirl, 0.25)
    assert np.array_equal(formula.points, called.points)
    assert np.array_equal(formula.triangles, called.triangles)
    on = asterism.mesh(asterism.Domain.square(), (made, made.metric), 0.3)
    same = asterism.mesh(asterism.Domain.square(), np.array(made.metric), 0.3, on=made)
    assert on.certified and np.array_equal(on.points, same.points)


def test_a_callable_is_asked_for_many_points_at_a_time():
    calls = []

    def swirl(p):
        calls.append(len(p))
        x, y = p[:, 0], p[:, 1]
        return np.column_stack([1 + 12 * y * y, -12 * x * y, 1 + 12 * x * x])

    made = asterism.mesh(asterism.Domain.square(), swirl, 0.08)
    alone = sum(n == 1 for n in calls)
    assert made.certified and max(calls) > 1000 and sum(calls) > 2 * len(made.points)
    assert len(calls) < sum(calls) / 5, (len(calls), alone, sum(calls))


@pytest.mark.parametrize("one_by_one", [
    lambda p: [1 + 12 * p[0, 1] ** 2, -12 * p[0, 0] * p[0, 1], 1 + 12 * p[0, 0] ** 2],
    lambda p: (lambda x, y: [[1 + 12 * y * y, -12 * x * y, 1 + 12 * x * x]])(*map(float, p.ravel())),
    lambda p: [1 + 12 * p.item(1) ** 2, -12 * p.item(0) * p.item(1), 1 + 12 * p.item(0) ** 2],
], ids=["of the first row", "fails for many", "one tensor for all"])
def test_a_callable_for_one_point_is_asked_for_one(made, one_by_one):
    formula = asterism.mesh(asterism.Domain.square(), "expr:1+12*y*y;-12*x*y;1+12*x*x", 0.4)
    called = asterism.mesh(asterism.Domain.square(), one_by_one, 0.4)
    assert np.allclose(formula.points, called.points) and called.certified


def test_a_metric_may_be_a_file_of_a_mesh_or_of_numbers_on_one(made, tmp_path):
    made.save(tmp_path / "m.mesh")
    ours, other = (asterism.mesh("square", metric=tmp_path / name, size=1.0) for name in ("m.mesh", "m.sol"))
    assert len(ours.points) > 20 and np.array_equal(ours.points, other.points)
    (tmp_path / "m.mesh").unlink()
    with pytest.raises(asterism.InputError, match="m.sol: numbers at the vertices of a mesh, which is missing"):
        asterism.mesh("square", metric=tmp_path / "m.sol")


def test_a_constant_may_be_one_tensor():
    made = asterism.mesh(asterism.Domain.square(), lambda p: (4, 0, 1), 0.5)
    assert made.certified and (made.metric == made.metric[0]).all()


def test_vertices_and_complexity_in_place_of_a_size():
    back = asterism.mesh(asterism.Domain.square(), "swirl:3", 0.2)
    made = asterism.mesh(asterism.Domain.square(), np.array(back.metric), vertices=500, on=back)
    assert made.certified and abs(len(made.points) / 500 - 1) < 0.05
    called = asterism.mesh(asterism.Domain.square(), lambda p: np.tile([4.0, 0, 1], (len(p), 1)), complexity=80)
    assert called.certified and abs(len(called.points) / (80 * 2 / 3**0.5) - 1) < 0.4


def test_vertices_are_met_where_the_boundary_takes_many():
    strip = asterism.Domain([(0, 0), (1, 0), (1, 0.01), (0, 0.01)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    made = asterism.mesh(strip, "identity", vertices=150)
    assert made.certified and abs(len(made.points) / 150 - 1) <= 0.05


def test_chords_of_curves_follow_the_number_of_vertices():
    domain = asterism.Domain.read(os.path.join(os.path.dirname(__file__), "../../examples/fillets.poly"))
    edges = []
    for wanted in (400, 1600):
        made = asterism.mesh(domain, vertices=wanted)
        assert made.certified and abs(len(made.points) / wanted - 1) <= 0.05, (wanted, made.reason)
        edges.append(len(made.edges))
    assert edges[1] > 1.3 * edges[0], edges


def test_domains_from_arrays_and_shapes():
    hole = [(0.5, 0.25), (1.5, 0.25), (1.0, 0.75)]
    by_arrays = asterism.Domain(CORNERS + hole, SIDES + [(4, 5), (5, 6), (6, 4)],
                                markers=[1, 1, 1, 1, 2, 2, 2], holes=[(1, 0.5)])
    by_shape = asterism.Domain.from_geo({"type": "Polygon", "coordinates": [
        CORNERS + [CORNERS[0]], hole + [hole[0]]]})
    assert len(by_arrays.points) == 7 and by_arrays.box == (0, 0, 2, 1)
    assert sorted(by_arrays.markers) == [1] * 4 + [2] * 3
    for domain in (by_arrays, by_shape):
        mesh = asterism.mesh(domain)
        assert mesh.certified and abs(areas(mesh).sum() - 1.75) < 1e-12
    assert set(asterism.mesh(by_arrays).edge_markers) == {1, 2}


def test_polygons_that_touch_share_an_edge_inside():
    pair = {"type": "MultiPolygon", "coordinates": [
        [[(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]], [[(1, 0), (2, 0), (2, 1), (1, 1), (1, 0)]]]}
    mesh = asterism.mesh(asterism.Domain.from_geo(pair))
    assert mesh.certified and abs(areas(mesh).sum() - 2) < 1e-12


def test_shapely_polygons():
    geometry = pytest.importorskip("shapely.geometry")
    disc = geometry.Point(0, 0).buffer(1).difference(geometry.Point(0, 0).buffer(0.3))
    mesh = asterism.mesh(asterism.Domain.from_shapely(disc))
    assert mesh.certified and abs(areas(mesh).sum() - disc.area) < 1e-9


@pytest.mark.parametrize("arguments, message", [
    ((CORNERS, [(0, 1), (1, 2), (2, 3), (3, 4)]), "row 3 names point 4 of 4"),
    ((CORNERS, [(0, 1), (1, 2), (2, 3)]), "."),
    ((CORNERS, [(0, 2), (1, 3)]), "cross"),
    (([(0, 0), (1, 0), (np.inf, 1)], [(0, 1), (1, 2), (2, 0)]), "finite"),
    ((CORNERS, SIDES, [1, 2]), "markers"),
])
def test_domains_that_cannot_be_meant(arguments, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.Domain(*arguments)


@pytest.mark.parametrize("options, message", [
    ({"metric": "whirl"}, "whirl"), ({"size": -1}, "size"), ({"angle_bound": 60}, "angle_bound"),
    ({"metric": [7, 8]}, "metric"), ({"metric": lambda p: [1, 5, 1]}, "not positive definite"),
    ({"metric": lambda p: [1, 1]}, "the metric's answer"), ({"max_sites": 3}, "max_sites"),
    ({"metric_tolerance": -1}, "metric_tolerance"), ({"metric_tolerance": float("nan")}, "metric_tolerance"),
    ({"gradation": 0.5}, "gradation"), ({"vertices": 100, "size": 1}, "one of them"),
    ({"vertices": 2}, "vertices"), ({"complexity": -1}, "complexity"),
])
def test_meshes_that_cannot_be_meant(options, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.mesh(asterism.Domain.square(), **options)
    with pytest.raises(asterism.InputError, match="no-such-file"):
        asterism.Domain.read("/no-such-file.poly")


def test_what_a_callback_raises_comes_back():
    def broken(points):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        asterism.mesh(asterism.Domain.square(), broken)
    with pytest.raises(ZeroDivisionError, match="mine"):
        asterism.mesh(asterism.Domain.square(), "swirl:40", 0.05, progress=broken)


def test_not_reached_is_a_warning_and_a_reason():
    with pytest.warns(asterism.NotReachedWarning, match="sites"):
        mesh = asterism.mesh(asterism.Domain.square(), "swirl:40", 0.05, max_sites=50)
    assert not mesh.complete and not mesh.certified and "sites" in mesh.reason


def test_ctrl_c_ends_a_run():
    # A shell's background job ignores the interrupt until something handles it.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    try:
        with pytest.raises(KeyboardInterrupt):
            while True:
                asterism.mesh(asterism.Domain.square(), "swirl:400", 0.02)
    finally:
        signal.signal(signal.SIGINT, before)


def test_other_threads_run_meanwhile():
    ticks, done = [0], threading.Event()

    def count():
        while not done.is_set():
            ticks[0] += 1
            done.wait(0.001)

    other = threading.Thread(target=count)
    other.start()
    states = []
    asterism.mesh(asterism.Domain.square(), "swirl:40", 0.06, progress=states.append)
    done.set()
    other.join()
    assert ticks[0] > 3
    assert all(s["sites"] >= 0 and s["phase"] in ("filling", "refining", "auditing") for s in states)


def test_files_come_back_and_verify(made, tmp_path):
    files = made.save(tmp_path / "swirl.mesh")
    assert [os.path.basename(f) for f in files] == ["swirl.mesh", "swirl.sol", "swirl.certificate.json"]
    again = asterism.read(tmp_path / "swirl.mesh")
    assert np.array_equal(again.sites, made.sites) and np.array_equal(again.triangles, made.triangles)
    assert asterism.verify(tmp_path / "swirl.mesh")["verified"]
    forged = made.certificate.text.replace(f'"triangles": {len(made.triangles)}', '"triangles": 3')
    judged = made.verify(forged)
    assert not judged["verified"] and judged["contradictions"]
    with pytest.raises(asterism.InputError):
        made.save(tmp_path / "swirl.unknown")


def test_points_from_elsewhere_may_go_when_the_file_is_adapted(tmp_path):
    at = np.linspace(0, 1, 11)
    points = np.stack(np.meshgrid(at, at), -1).reshape(-1, 2)
    corner = (11 * np.arange(10)[:, None] + np.arange(10)).ravel()
    triangles = np.concatenate([np.stack([corner, corner + 1, corner + 12], 1), np.stack([corner, corner + 12, corner + 11], 1)])
    for ending in ("mesh", "meshb", "msh", "vtu"):
        asterism.Mesh(points, triangles).save(tmp_path / f"a.{ending}")
        assert len(asterism.adapt(asterism.read(tmp_path / f"a.{ending}"), points[:, 0] ** 2, vertices=40).mesh.points) < 50
    asterism.Mesh(points, triangles, required_points=[38], corners=[60]).save(tmp_path / "b.mesh")
    made = asterism.adapt(asterism.read(tmp_path / "b.mesh"), points[:, 0] ** 2, vertices=40).mesh
    assert len(made.points) < 50 and all((made.points == points[k]).all(1).any() for k in (38, 60))


def test_a_mesh_from_elsewhere():
    crossed = asterism.certify([(0, 0), (4, 0), (2, 0.5), (2, -0.5)], [(0, 1, 2), (1, 0, 3)])
    assert not crossed["certified"]  # the long diagonal
    right = asterism.certify([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], angle_bound=40)
    assert right["certified"] and abs(right["worst_angle"] - 45) < 1e-9
    with pytest.raises(asterism.InputError, match="row 0 names point 7"):
        asterism.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 7)])


PAIR = ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2), (0, 2, 3)])


@pytest.mark.parametrize("options, message", [
    ({"markers": {(1, 3): 2}}, r"edges: row 0, \(1, 3\), is a side of no triangle"),
    ({"edges": [(0, 1), (1, 0)], "markers": [3, 4]}, r"edges: row 1, \(1, 0\), is row 0 again, with the marker 4 in place"),
    ({"required_edges": [(0, 1), (1, 3)]}, r"required_edges: row 1, \(1, 3\), is a side of no triangle"),
    ({"values": {1: np.zeros(4), "1": np.zeros(4)}}, "1: 2 fields have this name"),
])
def test_meshes_from_elsewhere_that_cannot_be_meant(options, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.Mesh(*PAIR, **options)
    with pytest.raises(asterism.InputError, match="points: row 2 is not finite"):
        asterism.Mesh([(0, 0), (1, 0), (1, np.inf), (0, 1)], PAIR[1])


def test_edges_that_are_listed_again_are_left_out():
    sides = [(0, 1), (1, 2), (2, 3), (1, 0), (3, 0), (0, 1)]
    with pytest.warns(UserWarning, match="2 edges are listed again and left out"):
        mesh = asterism.Mesh(*PAIR, edges=sides, markers=[5, 6, 7, 5, 8, 5])
    assert sorted(mesh.edge_markers) == [5, 6, 7, 8]
    assert asterism.adapt(mesh, implied=True).mesh.certified


def test_what_meshio_has_and_a_mesh_has_not_is_named():
    meshio = pytest.importorskip("meshio")
    points, triangles = [*PAIR[0], (5, 5), (6, 6)], np.array(PAIR[1])
    other = meshio.Mesh(np.array(points, dtype=float), [("triangle", triangles), ("line", np.array([(0, 1), (4, 5)]))],
                        cell_data={"medit:ref": [np.array([3, 4]), np.array([7, 8])],
                                   "kappa": [np.array([1.5, 2]), np.zeros(2)]}, cell_sets={"wall": [[], [0]]})
    with pytest.warns(UserWarning) as told:
        mesh = asterism.Mesh.from_meshio(other)
    said = [str(one.message) for one in told]
    for words in ("data of cells have no place in a Mesh, and are left out: kappa", "sets of cells have no place",
                  "1 of 2 lines have points in no triangle"):
        assert any(words in one for one in said), words
    assert list(mesh.regions) == [3, 4] and 7 in mesh.edge_markers and 8 not in mesh.edge_markers


def test_points_with_a_height_are_points_of_the_plane(made):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        flat = asterism.Mesh(np.c_[made.points, 0 * made.points[:, 0]], made.triangles, edges=made.edges)
    assert np.array_equal(flat.points, made.points)
    with pytest.warns(UserWarning, match="at the height z = 2, which is left out"):
        asterism.Mesh(np.c_[made.points, 0 * made.points[:, 0] + 2], made.triangles, edges=made.edges)


def test_clockwise_triangles_are_turned_over_and_told():
    points = [(0, 0), (1, 0), (1, 1), (0, 1)]
    with pytest.warns(UserWarning, match="1 of 2 triangles are clockwise and turned over, the first: row 1"):
        one = asterism.Mesh(points, [(0, 1, 2), (0, 3, 2)], regions=[5, 7])
    assert one.triangles.tolist() == [[0, 1, 2], [0, 2, 3]] and one.regions.tolist() == [5, 7]
    with pytest.warns(UserWarning, match="the triangles are clockwise and turned over: 2"):
        both = asterism.Mesh(points, [(0, 2, 1), (0, 3, 2)])
    assert asterism.adapt(both, [0, 1, 1, 0], vertices=60).mesh.certified


def test_clockwise_triangles_that_are_judged_stay_as_they_are():
    points = [(0, 0), (1, 0), (0.9, 0.9), (0, 1)]
    judged = asterism.certify(points, [(0, 1, 2), (0, 3, 2)], angle_bound=0)
    assert not judged["certified"] and judged["findings"][0].kind == "orientation"
    assert asterism.certify(points, [(0, 1, 2), (0, 2, 3)], angle_bound=0)["certified"]


def test_pictures_and_other_packages(made):
    assert made._repr_svg_().lstrip().startswith("<?xml") and "<svg" in made.svg(ellipses=True)
    meshio = pytest.importorskip("meshio")
    outside = made.to_meshio()
    assert isinstance(outside, meshio.Mesh) and len(outside.cells[0].data) == len(made.triangles)
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    axes = made.plot(plt.figure().gca())
    assert axes.lines


def test_sizes_at_places_are_those_of_the_command():
    domain = asterism.Domain.square()
    made = asterism.mesh(domain, size=0.4, size_at=[(0.5, 0.5, 0.1, 0.05)], size_box=[(-1, -1, -0.8, -0.8, 0.1, 1.5)],
                         size_near={3: (0.1, 1.4)}, size_in={1: 0.35}, layers={1: (0.01, 1.2, 8)}, hmin=0.005)
    asked = made.certificate.data["asked"]["options"]["sizes"]
    assert asked == ("at 0.5,0.5,0.1:0.05,1.3; box -1,-1,-0.8,-0.8:0.1,1.5; in 1:0.35,1.3; near 3:0.1,1.4; "
                     "layers 1:0.01,1.2,8; hmin 0.005")
    assert made.certified and made.verify()["verified"]
    below = made.points[:, 1] + 1
    assert np.isclose(below[below > 1e-9].min(), 0.01)
    assert asterism.mesh(domain, hmax=0.3).certificate.data["asked"]["options"]["size"] == "0.3"
    for wrong, words in [({"size_near": {9: 0.1}}, "no segment has the marker 9"), ({"hmin": 1, "hmax": 0.5}, "hmin 1"),
                         ({"metric": "swirl:3", "hmax": 1}, "size says how long")]:
        with pytest.raises(asterism.InputError, match=words):
            asterism.mesh(domain, **wrong)


def test_points_in_no_triangle_are_named():
    with pytest.warns(UserWarning, match=r"1 point is in no triangle, the first: row 3 at \(2, 2\)"):
        asterism.Mesh([[0, 0], [1, 0], [0, 1], [2, 2]], [[0, 1, 2]])


def test_fields_in_files_are_the_values_of_what_is_read(made, tmp_path):
    fields = {"u": made.points[:, 0], "v": made.points ** 2}
    whole = asterism.Mesh(made.points, made.triangles, made.metric, values=fields)
    for ending in ("msh", "vtu", "mesh"):
        whole.save(tmp_path / f"w.{ending}")
        again = asterism.read(tmp_path / f"w.{ending}").values
        assert list(again) == (["1", "2"] if ending == "mesh" else ["u", "v"])
        for of, wanted in zip(again.values(), fields.values()):
            assert np.array_equal(of, wanted)
    text = (tmp_path / "w.msh").read_text()
    first = text.index('$NodeData\n1\n"u"')
    data = text[first:text.index("$EndNodeData", first)]
    (tmp_path / "w.msh").write_text(text + data.replace("\n3\n0\n", "\n3\n7\n") + "$EndNodeData\n")
    with pytest.warns(UserWarning, match="the field 'u' is there 2 times, and the last one is taken: step 7"):
        assert np.array_equal(asterism.read(tmp_path / "w.msh").values["u"], fields["u"])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert asterism.verify(tmp_path / "w.msh", angle_bound=0)["sites"] == len(made.points)


def test_names_of_files_need_not_be_utf_8(made, tmp_path):
    odd = os.fsencode(tmp_path) + b"/n\xff\xe9"
    name = os.fsdecode(odd)
    files = made.save(odd + b".mesh")
    assert files == [name + ending for ending in (".mesh", ".sol", ".certificate.json")]
    assert all(os.path.exists(file) for file in files)
    again = asterism.read(name + ".mesh")
    assert np.array_equal(again.sites, made.sites) and asterism.verify(odd + b".mesh")["verified"]
    os.remove(files[2])
    again = asterism.read(odd + b".mesh")
    assert again.reason == "it was read from " + files[0]
    assert pickle.loads(pickle.dumps(again)).reason == again.reason
    wanted = asterism.mesh(name + ".mesh", name + ".mesh", size=1)
    assert wanted.certified and wanted.verify(wanted.certificate.text)["verified"]
    with open(odd + b".poly", "w", encoding="ascii") as out:
        out.write("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n")
    domain = asterism.Domain.read(odd + b".poly")
    assert len(pickle.loads(pickle.dumps(domain)).points) == 3
    run = asterism.mesh(domain, size=0.5)
    assert run.certified and pickle.loads(pickle.dumps(run)).certified
    with pytest.raises(asterism.InputError, match=r"n\?\?\.none: "):
        asterism.read(odd + b".none")


def test_a_lone_surrogate_is_named(made, tmp_path):
    for call, what in ((lambda: asterism.mesh("square", "swirl:\ud800"), "metric: 'swirl:"),
                       (lambda: asterism.read("a\ud800.mesh"), "a file's name: 'a"),
                       (lambda: made.save(tmp_path / "a\ud800.mesh"), "a file's name: "),
                       (lambda: asterism.metric(made, {"\ud800": made.points[:, 0]}, vertices=50), "a field's name: ")):
        with pytest.raises(asterism.InputError, match=r"has at \d+ the lone surrogate '.ud800'") as told:
            call()
        assert what in str(told.value)
