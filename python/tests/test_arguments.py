# SPDX-License-Identifier: MIT
"""Forms in which domains and metrics are given, forms that are refused, and what pickle and copy keep."""
import concurrent.futures
import copy
import inspect
import multiprocessing
import pickle
import time
import warnings

import numpy as np
import pytest

import asterism

L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def quietly(call, *arguments, **more):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return call(*arguments, **more)


def area(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a).sum() / 2


@pytest.fixture(scope="module")
def made():
    return asterism.mesh("square", "swirl:12", 0.25)


def test_many_things_stand_for_a_domain(tmp_path):
    poly = tmp_path / "l.poly"
    poly.write_text("6 2 0 0\n" + "".join(f"{k + 1} {x} {y}\n" for k, (x, y) in enumerate(L_SHAPE))
                    + "6 0\n" + "".join(f"{k + 1} {k + 1} {(k + 1) % 6 + 1}\n" for k in range(6)) + "0\n")
    ring = {"type": "Polygon", "coordinates": [L_SHAPE + L_SHAPE[:1]]}
    base = asterism.mesh(L_SHAPE, size=0.3)
    base.save(tmp_path / "l.mesh")
    base.save(tmp_path / "l.msh")
    for domain in (poly, str(poly), np.array(L_SHAPE), L_SHAPE + L_SHAPE[:1], ring, asterism.Domain(L_SHAPE),
                   asterism.Domain.read(poly), base.domain, base, tmp_path / "l.mesh", tmp_path / "l.msh"):
        made = asterism.mesh(domain, size=0.3)
        assert made.certified and area(made) == pytest.approx(3, abs=1e-12)
    assert asterism.mesh("airfoil").certified
    assert np.array_equal(asterism.mesh(base, size=0.3).triangles, base.triangles)  # it is kept


def test_there_is_one_type_of_domain(tmp_path):
    geometry = {"type": "Polygon", "coordinates": [L_SHAPE + L_SHAPE[:1]]}
    base = asterism.mesh(L_SHAPE)
    base.save(tmp_path / "l.mesh")
    for domain in (asterism.Domain.square(), asterism.Domain(L_SHAPE), asterism.Domain.from_geo(geometry),
                   asterism.Domain.from_mesh(base), asterism.Domain.read(tmp_path / "l.mesh"), base.domain,
                   copy.copy(asterism.Domain.square())):
        assert type(domain) is asterism.Domain and repr(domain).startswith("<Domain: ")


def test_constant_metrics_in_every_form():
    by_text = asterism.mesh(L_SHAPE, "expr:9;2;4", 0.5)
    for tensor in ((9, 2, 4), [[9, 2], [2, 4]], np.array([9.0, 2, 4]), lambda p: (9, 2, 4),
                   lambda p: np.tile([[9.0, 2], [2, 4]], (len(p), 1, 1))):
        made = asterism.mesh(L_SHAPE, tensor, 0.5)
        assert np.array_equal(made.points, by_text.points) and np.array_equal(made.triangles, by_text.triangles)


def test_sizes_in_place_of_tensors():
    plain = asterism.mesh(L_SHAPE, "expr:100;0;100", 1)
    for sizes in (0.1, np.float32(0.1) * 0 + 0.1, lambda p: np.full(len(p), 0.1), lambda p: 0.1):
        made = asterism.mesh(L_SHAPE, sizes)
        assert made.certified and abs(len(made.points) / len(plain.points) - 1) < 0.1
    growing = asterism.mesh(L_SHAPE, lambda p: 0.05 + 0.1 * np.hypot(p[:, 0] - 1, p[:, 1] - 1))
    assert growing.certified
    at = np.hypot(*(growing.points - 1).T)
    sizes = growing.metric[:, 0] ** -0.5
    assert np.allclose(sizes, 0.05 + 0.1 * at)
    on = asterism.mesh(L_SHAPE, (growing, sizes))
    same = asterism.mesh(L_SHAPE, (growing, np.stack([np.diag([1 / (h * h)] * 2) for h in sizes])), 1)
    assert on.certified and np.array_equal(on.points, same.points)
    assert 0.8 < len(on.points) / len(growing.points) < 1.25


@pytest.mark.parametrize("domain, options, message", [
    ("squares", {}, "squares: cannot be opened"), (7, {}, "a domain is wanted"), (None, {}, "a domain is wanted"),
    ([(0, 0), (1, 0)], {}, "a ring has three"), ([(0, 0), (1, 0), (1, 1, 1)], {}, "points: "),
    ([(0, 0), (1j, 0), (1, 1)], {}, "points: complex"), ([("a", "b"), ("c", "d"), ("e", "f")], {}, "points: an array"),
    (np.ma.masked_array([(0, 0), (1, 0), (1, 1)], [[1, 0], [0, 0], [0, 0]]), {}, "points: some of its entries"),
    (L_SHAPE, {"size": "0.1"}, "size: a number is wanted, not '0.1'"), (L_SHAPE, {"size": True}, "size: a number"),
    (L_SHAPE, {"vertices": 100.5}, "vertices: a whole number"), (L_SHAPE, {"max_sites": "many"}, "max_sites"),
    (L_SHAPE, {"threads": 0}, "threads: a whole number of at least 1"), (L_SHAPE, {"max_seconds": -1}, "max_seconds"),
    (L_SHAPE, {"progress": 7}, "progress: a callable"), (L_SHAPE, {"repair": "yes"}, "repair: a number"),
    (L_SHAPE, {"metric": [1, 2]}, "metric: tensors"), (L_SHAPE, {"metric": [[1, 2], [3, 4]]}, "metric: is not symmetric"),
    (L_SHAPE, {"metric": -0.1}, "metric: a size is positive"), (L_SHAPE, {"metric": None}, "metric: a text"),
    (L_SHAPE, {"metric": np.ones((6, 3))}, "want the mesh"), (L_SHAPE, {"metric": lambda p: "h"}, "the metric's answer"),
    (L_SHAPE, {"metric": lambda p: -np.ones(len(p))}, "a size is positive"), (L_SHAPE, {"on": 3}, "on: a Mesh"),
    (L_SHAPE, {"size_at": [(1, 1)]}, "size_at: 3 numbers"), (L_SHAPE, {"size_at": 3}, "size_at: a list of places"),
    (L_SHAPE, {"size_at": [("a", 0, 1, 1)]}, "size_at: "), (L_SHAPE, {"size_near": [(1, 0.1)]}, "size_near: sizes by"),
    (L_SHAPE, {"size_in": {1: "x"}}, "size_in: an array"), (L_SHAPE, {"hmax": "x"}, "hmax: an array"),
    (L_SHAPE, {"gradation": "some"}, "gradation"), (L_SHAPE, {"metric": "no-such.mesh"}, "no-such.mesh"),
])
def test_wrong_arguments_are_named(domain, options, message):
    with pytest.raises(asterism.InputError, match=message) as caught:
        asterism.mesh(domain, **options)
    assert "incompatible function arguments" not in str(caught.value) and "\n" not in str(caught.value)


def test_other_functions_name_wrong_arguments(made, tmp_path):
    for call, message in (
            (lambda: asterism.Domain(L_SHAPE, [(0, 1.5)]), "segments: number 1 is 1.5"),
            (lambda: asterism.Domain(L_SHAPE, "ab"), "segments: an array of whole numbers"),
            (lambda: asterism.Domain(L_SHAPE, [(0, 1)], [2**31]), "markers: number 0"),
            (lambda: asterism.Domain(L_SHAPE, [(0, 1)], [0.5]), "markers: number 0 is 0.5"),
            (lambda: asterism.Domain.read(7), "a file's name"), (lambda: asterism.Domain.from_mesh(7), "a Mesh is wanted"),
            (lambda: asterism.Domain.from_mesh(made, "x"), "corner_angle: a number"),
            (lambda: asterism.Mesh(L_SHAPE, [(0, 1, 2.5)]), "triangles: number 2 is 2.5"),
            (lambda: asterism.Mesh(L_SHAPE, "x"), "triangles: an array"), (lambda: asterism.read(7), "a file's name"),
            (lambda: asterism.verify(7), "a file's name"), (lambda: made.verify(7), "certificate: a text"),
            (lambda: made.verify(angle_bound="x"), "angle_bound: a number"),
            (lambda: asterism.certify(L_SHAPE), "triangles: "), (lambda: made.save(7), "a file's name"),
            (lambda: asterism.metric(7, [1]), "mesh: a Mesh is wanted"), (lambda: asterism.transfer(made, [1], 7), "to: a Mesh"),
            (lambda: asterism.metric(made, np.zeros(len(made.points)), norm="max"), "norm: a number"),
            (lambda: asterism.orientation("abc", (0, 0), (1, 1)), "p: an array"),
            (lambda: asterism.orientation((0, 1j), (0, 0), (1, 1)), "p: complex"),
            (lambda: asterism.orientation(np.zeros((3, 2)), np.zeros((4, 2)), (1, 1)), "arguments of"),
            (lambda: asterism.orientation(np.zeros((3, 2, 2)), np.zeros((4, 2)), (1, 1)), "do not go together")):
        with pytest.raises(asterism.InputError, match=message):
            call()


def test_a_domain_is_repaired():
    crossed = [(0, 0), (4, 0), (0, 3), (4, 3)]
    with pytest.raises(asterism.InputError, match="repair=True mends it"):
        asterism.Domain(crossed)
    with pytest.warns(UserWarning):
        domain = asterism.Domain(crossed, repair=True)
    assert [place.what for place in domain.repairs] == ["crossing"]
    made = quietly(asterism.mesh, crossed, size=0.5, repair=True)
    assert made.certified and area(made) == pytest.approx(6)
    assert made.certificate.options["repair-distance"] != "none"
    assert quietly(asterism.Domain, crossed, repair=0.01).repairs
    assert not asterism.Domain(L_SHAPE, repair=True).repairs


def test_limits_on_time_and_threads():
    start = time.perf_counter()
    with pytest.warns(asterism.NotReachedWarning, match="0.2 seconds have passed"):
        stopped = asterism.mesh("square", "swirl:400", 0.01, max_seconds=0.2)
    assert not stopped.complete and time.perf_counter() - start < 20
    one, three = (asterism.mesh("square", "swirl:12", 0.08, threads=n) for n in (1, 3))
    assert np.array_equal(one.sites, three.sites) and np.array_equal(one.triangles, three.triangles)


def same(a, b):
    return all(np.array_equal(getattr(a, name), getattr(b, name)) for name in (
        "sites", "triangles", "regions", "edges", "edge_markers")) and all(
            getattr(a, name) == getattr(b, name) for name in ("given", "complete", "certified", "reason"))


@pytest.mark.parametrize("pass_on", [copy.copy, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])
def test_meshes_domains_and_reports_are_passed_on(made, pass_on):
    again = pass_on(made)
    assert same(made, again) and again.certificate.text == made.certificate.text and again.verify()["verified"]
    old = asterism.Mesh(made.points, made.triangles, values={"u": made.points[:, 0]}, edges=made.edges,
                        markers=made.edge_markers, required_points=[5], required_edges=made.edges[:1])
    assert same(old, pass_on(old)) and np.array_equal(pass_on(old).values["u"], made.points[:, 0])
    holed = asterism.Domain(np.array(L_SHAPE + [(0.2, 0.2), (0.4, 0.2), (0.2, 0.4), (1.5, 0.5)]),
                            [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (6, 7), (7, 8), (8, 6)],
                            range(9), [(0.25, 0.25)], [(1.2, 0.3)], [7])
    for domain in (holed, asterism.Domain.square()):
        other = pass_on(domain)
        assert type(other) is asterism.Domain
        for name in ("points", "segments", "markers"):
            assert np.array_equal(getattr(domain, name), getattr(other, name))
        assert same(asterism.mesh(domain, size=0.2), asterism.mesh(other, size=0.2))
    wanted = asterism.metric(made, made.points[:, 0] ** 2)
    assert pass_on(wanted).report == wanted.report and (wanted + 1).report is None


def test_curves_are_passed_on():
    domain = asterism.Domain.read(__file__.rsplit("/", 3)[0] + "/examples/fillets.poly")
    again = pickle.loads(pickle.dumps(domain))
    assert same(asterism.mesh(domain, size=0.3), asterism.mesh(again, size=0.3))


def work(mesh):
    return asterism.mesh(mesh.domain, size=0.4).triangles.shape


NAMED = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 4 "inlet pipe"
2 7 "steel"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
6
1 1 2 4 1 1 2
2 1 2 5 1 2 3
3 1 2 5 1 3 4
4 1 2 5 1 4 1
5 2 2 7 1 1 2 3
6 2 2 7 1 1 3 4
$EndElements
"""


def test_names_of_a_file_go_with_its_mesh(tmp_path):
    (tmp_path / "named.msh").write_text(NAMED)
    mesh = asterism.read(tmp_path / "named.msh")
    adapted = asterism.adapt(mesh, metric=0.2).mesh
    assert adapted.certified and set(adapted.edge_markers) == {4, 5} and set(adapted.regions) == {7}
    for k, of in enumerate((mesh, adapted, pickle.loads(pickle.dumps(adapted)), copy.deepcopy(mesh))):
        of.save(tmp_path / f"{k}.msh")
        assert '"inlet pipe"' in (tmp_path / f"{k}.msh").read_text() and '"steel"' in (tmp_path / f"{k}.msh").read_text()


def test_other_processes_get_meshes(made):
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(1, context) as pool:
        assert pool.submit(work, made).result() == work(made)


def test_a_spoiled_pickle_is_refused(made):
    state = list(made._made.__getstate__())
    state[3] = state[3] + len(made.points)
    with pytest.raises(asterism.InputError, match="out of range"):
        made._made.__class__.__new__(made._made.__class__).__setstate__(tuple(state))


def test_batches_of_any_shape_and_size():
    rng = np.random.default_rng(3)
    p, q, r = (rng.integers(0, 3, (40000, 2)).astype(float) for _ in range(3))
    answers, tiers = asterism.orientation(p, q, r, counts=True)
    assert sum(tiers.values()) == 40000
    assert np.array_equal(answers, np.sign(np.cross(q - p, r - p)))
    cube = asterism.orientation(p.reshape(200, 20, 10, 2), q[:10], (0.5, 0.5))
    assert cube.shape == (200, 20, 10)
    assert np.array_equal(cube[7, 3], asterism.orientation(p.reshape(200, 20, 10, 2)[7, 3], q[:10], (0.5, 0.5)))
    q[33000] = np.nan
    with pytest.raises(asterism.InputError, match="^row 33000: "):
        asterism.orientation(p, q, r)


def test_signatures_and_names_can_be_looked_up(made):
    assert list(inspect.signature(asterism.orientation).parameters) == ["p", "q", "r", "counts"]
    assert {"worst_angle", "options", "audit"} <= set(dir(made.certificate))
    with pytest.raises(AttributeError, match="no 'worst_angel'"):
        made.certificate.worst_angel
    finding = asterism.certify([(0, 0), (4, 0), (2, 0.5), (2, -0.5)], [(0, 1, 2), (1, 0, 3)])["findings"][0]
    assert finding.kind and finding.witness and tuple(finding) == (finding.kind, finding.witness)
