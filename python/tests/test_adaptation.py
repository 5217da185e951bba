# SPDX-License-Identifier: MIT
"""asterism.adapt: metric, mesh and fields in one call, for meshes made here and from elsewhere."""
import warnings
from collections import defaultdict

import numpy as np
import pytest

import asterism


def two_materials(n=12):
    """Returns a square grid of two materials with numbered sides and no lines between the materials."""
    points = np.array([(i / n, j / n) for j in range(n + 1) for i in range(n + 1)])
    cells = [(j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i)
             for j in range(n) for i in range(n)]
    triangles = np.array([t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))])
    regions = np.where(points[triangles].mean(axis=1)[:, 0] < 1 / 3, 5, 8)
    at = lambda i, j: j * (n + 1) + i
    edges = [(at(k, 0), at(k + 1, 0)) for k in range(n)] + [(at(n, k), at(n, k + 1)) for k in range(n)]
    edges += [(at(n - k, n), at(n - k - 1, n)) for k in range(n)] + [(at(0, n - k), at(0, n - k - 1)) for k in range(n)]
    return asterism.Mesh(points, triangles, regions=regions, edges=edges, markers=np.repeat([1, 2, 3, 4], n))


def front(mesh):
    x, y = mesh.points.T
    return np.tanh(30 * (y - 0.5 - 0.2 * np.sin(5 * x)))


def areas(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    sums = defaultdict(float)
    for region, area in zip(mesh.regions.tolist(), np.cross(b - a, c - a) / 2):
        sums[region] += area
    return dict(sums)


def integral(mesh, values):
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return (np.cross(b - a, c - a) / 6 * values[mesh.triangles].sum(axis=1)).sum()


@pytest.fixture(scope="module")
def old():
    return two_materials()


@pytest.fixture(scope="module")
def quiet_adapt():
    def adapt(*arguments, **more):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            return asterism.adapt(*arguments, **more)
    return adapt


def test_a_loop_on_a_mesh_from_elsewhere(old, quiet_adapt):
    mesh = old
    for _ in range(3):
        u = front(mesh)
        before = integral(mesh, u)
        made = quiet_adapt(mesh, u, vertices=600, how="conservative")
        new, moved = made
        assert made.report["reached"] and new.certified and abs(len(new.points) / 600 - 1) < 0.03
        assert integral(new, moved) == pytest.approx(before, abs=1e-13)
        assert np.array_equal(new.values["u"], moved) and moved.report["area_after"] == pytest.approx(1)
        mesh = new
    assert areas(mesh) == pytest.approx({5: 1 / 3, 8: 2 / 3}, abs=1e-12)
    assert {1, 2, 3, 4} <= set(mesh.edge_markers)
    for marker, axis, value in ((1, 1, 0), (2, 0, 1), (3, 1, 1), (4, 0, 0)):
        ends = mesh.points[mesh.edges[mesh.edge_markers == marker]][:, :, axis]
        assert (ends == value).all()
    assert mesh.verify()["verified"]


def test_the_steps_alone_come_to_the_same(old, quiet_adapt):
    u = front(old)
    made = quiet_adapt(old, u, complexity=500)
    wanted = asterism.metric(old, u, complexity=500)
    assert np.array_equal(made.metric, wanted) and made.metric.report["complexity_delivered"] > 480
    assert np.array_equal(made.values, asterism.transfer(old, u, made.mesh, "interpolate"))
    by_metric = quiet_adapt(old, metric=wanted)
    assert np.array_equal(by_metric.mesh.points, made.mesh.points) and by_metric.values is None


def test_fields_of_every_kind_in_one_call(old, quiet_adapt):
    x, y = old.points.T
    v = np.column_stack([np.tanh(20 * (x - 0.4)), y])
    made = quiet_adapt(old, {"v": v, "p": front(old)}, vertices=400,
                       carry={"t": np.column_stack([x, y, x + y]), "s": x - 2 * y, "w": np.column_stack([y, x])})
    assert made.report["metric"]["fields"] == ["p", "v.x", "v.y"]
    new = made.mesh.points
    assert made.values["v"].shape == new.shape and set(made.values) == {"v", "p"} and set(made.mesh.values) == {"v", "p"}
    assert np.allclose(made.carried["t"], np.column_stack([new, new.sum(axis=1)]), atol=1e-13)
    assert np.allclose(made.carried["s"], new @ (1, -2), atol=1e-13) and made.carried["w"].shape == new.shape
    of_p = quiet_adapt(old, front(old), vertices=400)
    with_carry = quiet_adapt(old, front(old), vertices=400, carry=x)
    assert np.array_equal(of_p.mesh.sites, with_carry.mesh.sites) and with_carry.carried.shape == (len(new) * 0 + len(with_carry.mesh.points),)


def test_values_of_the_mesh_itself(old, quiet_adapt):
    held = asterism.Mesh(old.points, old.triangles, regions=old.regions, edges=old.edges, markers=old.edge_markers,
                         values={"u": front(old)})
    made = quiet_adapt(held, vertices=400)
    assert np.array_equal(made.mesh.points, quiet_adapt(old, front(old), vertices=400).mesh.points)
    again = quiet_adapt(made.mesh, vertices=400)
    assert set(again.values) == {"u"} and again.mesh.certified


def test_what_is_required_stays(old, quiet_adapt):
    middle = 6 * 13 + 6
    held = asterism.Mesh(old.points, old.triangles, regions=old.regions, edges=old.edges, markers=old.edge_markers,
                         required_points=[middle], required_edges=[(middle + 2, middle + 3)])
    new = quiet_adapt(held, front(held), vertices=300, keep="never").mesh
    places = {tuple(p) for p in new.points.tolist()}
    assert {tuple(held.points[k].tolist()) for k in (middle, middle + 2, middle + 3)} <= places


def test_a_domain_in_place_of_what_the_mesh_covers():
    domain = asterism.Domain.read(__file__.rsplit("/", 3)[0] + "/examples/fillets.poly")
    mesh = asterism.mesh(domain, size=0.1)
    u = np.tanh(10 * (mesh.points[:, 0] - 1))
    made = asterism.adapt(mesh, u, vertices=800, domain=domain, chord_tolerance=1e-3)
    told = made.mesh.certificate.audit["curves"]
    assert made.mesh.certified and told["curves"] == 5 and told["largest_distance"] <= 1.01e-3


def test_the_mesh_that_is_good_enough_is_kept(old, quiet_adapt):
    once = quiet_adapt(old, front(old), vertices=500)
    again = quiet_adapt(once.mesh, metric=np.array(once.mesh.metric))
    assert again.report["kept"] and np.array_equal(again.mesh.triangles, once.mesh.triangles)
    other = quiet_adapt(once.mesh, metric=np.array(once.mesh.metric), keep="never")
    assert not other.report["kept"]
    implied = quiet_adapt(once.mesh, implied=True)
    assert implied.mesh.certified


def test_threads_change_nothing(old, quiet_adapt):
    one, two = (quiet_adapt(old, front(old), vertices=3000, threads=n) for n in (1, 2))
    assert np.array_equal(one.mesh.sites, two.mesh.sites) and np.array_equal(one.values, two.values)


def test_a_part_of_the_size_says_how_closely_the_boundary_follows():
    turn = np.linspace(0, 2 * np.pi, 256, endpoint=False)
    disk = asterism.mesh(np.column_stack([np.cos(turn), np.sin(turn)]), size=0.3)
    coarse, usual, fine = (len(asterism.adapt(disk, metric=2.0, boundary_part=part).mesh.edges)
                           for part in (0.125, None, 0.01))
    assert coarse < usual < fine and fine >= 79  # a piece of the circle turns by 0.08 at most


def test_what_is_not_reached_is_told(old):
    with pytest.warns(asterism.NotReachedWarning):
        made = asterism.adapt(old, front(old), vertices=5000, hmin=0.1)
    assert not made.report["reached"] and made.report["reason"]


@pytest.mark.parametrize("values, options, message", [
    (None, {}, "one of the three says which metric is wanted, not none"),
    ("u", {"implied": True}, "not several"), ("u", {"metric": (1, 0, 1)}, "not several"),
    ("u", {"carry": {"u": 0}}, "carry: 'u' is among the values"), ("u", {"carry": [1, 2]}, "carried: 169 rows"),
    ("u", {"how": "guess"}, "how: "), ("u", {"keep": "maybe"}, "keep: "), ("u", {"hausd": -1}, "hausd: a positive"),
    ("u", {"corner_angle": 200}, "corner_angle"), ("u", {"domain": "square", "hausd": 1}, "hausd: it is of the boundary"),
    ("u", {"boundary_part": 0.2}, "boundary_part: above 0 and at most 0.125"),
    ("u", {"domain": "square", "boundary_part": 0.1}, "boundary_part: it is of the boundary"),
    ("u", {"chord_tolerance": 1}, "chord_tolerance"), ("u", {"domain": "square", "chord_tolerance": 1}, "no curves"),
    ("u", {"vertices": 1e9}, "max_sites names a greater limit"), ("u", {"vertices": 9, "error": 1}, "one of"),
    ("u", {"hmin": 2, "hmax": 1}, "hmin"), ("u", {"angle_bound": 60}, "angle_bound"), ("u", {"norm": 0.5}, "norm"),
])
def test_what_is_refused(old, values, options, message):
    with pytest.raises(asterism.InputError, match=message):
        asterism.adapt(old, front(old) if values == "u" else values, **options)
    with pytest.raises(asterism.InputError, match="mesh: a Mesh is wanted"):
        asterism.adapt("old.mesh", [1])


def test_a_sick_mesh_is_refused():
    mesh = asterism.Mesh([(0, 0), (1, 0), (0, 1), (1, 1)], [(0, 1, 2), (0, 3, 1)])
    with pytest.raises(asterism.InputError, match="triang"):
        asterism.adapt(mesh, [0, 1, 4, 9])
