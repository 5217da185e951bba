# SPDX-License-Identifier: MIT
"""Calls as people get them wrong: each is an InputError of one line that names the argument and what is wanted, and
never a list of overloads or a word of what is inside."""
import copy
import pickle
import warnings

import numpy as np
import pytest

import asterism

L_SHAPE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
SITE = (0, 0, 1, 0, 1)
INSIDE = ("incompatible function", "_asterism", "_made", "pybind", "inhomogeneous", "object at 0x", "Errno")


@pytest.fixture(scope="module")
def made():
    return asterism.mesh(L_SHAPE, size=0.7)


def flat(mesh):
    return np.zeros(len(mesh.points))


CALLS = [
    # Metrics that are none
    (lambda m: asterism.adapt(m, metric=(1, 0, -1)), "metric: row 0, 1 0 -1, is not positive definite"),
    (lambda m: asterism.adapt(m, metric=(1, 0, np.nan)), "metric: row 0 is not finite"),
    (lambda m: asterism.adapt(m, flat(m), intersect=[(1, 2, 1)]), "intersect: row 0, 1 2 1, is not positive"),
    (lambda m: asterism.metric(m, m.metric * [-1, 0, 1]), "values: row 0, -"),
    (lambda m: asterism.mesh(L_SHAPE, metric=lambda p: 0),
     r"the metric's answer at \(.*, .*\): .*, not 0; .*positive definite tensor"),
    (lambda m: asterism.mesh(L_SHAPE, metric=lambda p: np.where(p[:, 0] > 1, 0, 0.5)),
     r"the metric's answer at \(.*, .*\): a size is positive and finite, not 0; a callable"),
    (lambda m: asterism.mesh(L_SHAPE, metric=lambda p: [1, 2, 1]), "the metric at .* is 1 2 1, which is not positive"),
    (lambda m: asterism.adapt(m, flat(m), vertices=2.5), "vertices: a whole number of at least 1 is wanted, not 2.5"),
    (lambda m: asterism.metric(m, flat(m), vertices=0), "vertices: a whole number of at least 1"),
    (lambda m: asterism.adapt(m, flat(m), vertices=9, max_sites=9.5), "max_sites: a whole number"),
    (lambda m: asterism.adapt(m, flat(m), vertices=9, threads=1.5), "threads: a whole number"),
    (lambda m: asterism.mesh(L_SHAPE, vertices=9.5), "vertices: a whole number"),
    (lambda m: asterism.adapt(m, flat(m), intersect=0.1), "intersect: a list of metrics is wanted"),
    (lambda m: asterism.adapt(m, flat(m), error=0.1, relative=True, norm=1), "norm: a relative error is of no norm"),
    # Names and numbers of arguments
    (lambda m: asterism.mesh(), "domain is missing"),
    (lambda m: asterism.mesh(L_SHAPE, sizes=0.1), "no argument 'sizes'; did you mean size"),
    (lambda m: asterism.mesh(L_SHAPE, thread=2), "did you mean threads"),
    (lambda m: asterism.mesh(L_SHAPE, lc=0.1), "here it is size"),
    (lambda m: asterism.mesh(L_SHAPE, max_size=0.1), "here it is hmax"),
    (lambda m: asterism.mesh(L_SHAPE, min_angle=20), "here it is angle_bound"),
    (lambda m: asterism.mesh(L_SHAPE, timeout=2), "here it is max_seconds"),
    (lambda m: asterism.mesh(L_SHAPE, xyzzy=2), "there are domain, metric, size"),
    (lambda m: asterism.mesh(L_SHAPE, "identity", 0.1, 20, 5), "5 arguments without a name, and there are 4"),
    (lambda m: asterism.mesh(L_SHAPE, domain=L_SHAPE), "domain is given twice"),
    (lambda m: asterism.Domain(), "points is missing"),
    (lambda m: asterism.Domain(L_SHAPE, segment=[(0, 1)]), "did you mean segments"),
    (lambda m: asterism.Domain(L_SHAPE, edges=[(0, 1)]), "here it is segments"),
    (lambda m: asterism.Domain.read(), "path is missing"),
    (lambda m: asterism.Mesh(L_SHAPE), "triangles is missing"),
    (lambda m: asterism.Mesh(L_SHAPE, cells=[(0, 1, 2)]), "here it is triangles"),
    (lambda m: m.interpolate(flat(m)), "points is missing"),
    (lambda m: m.interpolate(flat(m), [(0.5, 0.5)], outsid=0), "did you mean outside"),
    (lambda m: m.interpolate(flat(m), [(0.5, 0.5)], outside="nearest"), "outside: .* not 'nearest'"),
    (lambda m: m.interpolate(flat(m), [(0.5, 0.5)], outside=[1, 2]), "outside: a number is wanted"),
    (lambda m: m.verify(angle=20), "here it is angle_bound"),
    (lambda m: asterism.adapt(m, flat(m), nv=100), "here it is vertices"),
    (lambda m: asterism.transfer(m, flat(m)), "to is missing"),
    (lambda m: asterism.orientation((0, 0), (1, 0)), "r is missing"),
    (lambda m: asterism.orientation((0, 0), (1, 0), (1, 1), count=True), "did you mean counts"),
    (lambda m: asterism.mesh_surface(asterism.Surface.named("torus")), "chord is missing"),
    # Domains
    (lambda m: asterism.mesh(object()), "a domain is wanted: .*not object"),
    (lambda m: asterism.mesh({1, 2, 3}), "a domain is wanted: .*not set"),
    (lambda m: asterism.mesh([]), r"points: the shape \(n, 2\) is wanted, not \(0,\)"),
    (lambda m: asterism.mesh([[0, 1, 1], [0, 0, 1]]), "points.T"),
    (lambda m: asterism.mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]), "third coordinate"),
    (lambda m: asterism.mesh([(0, 0), (1, 0), None]), "row 2 is None"),
    (lambda m: asterism.mesh([(0, 0), (1, 0), (float("nan"), 1)]), "not finite"),
    (lambda m: asterism.mesh(np.zeros((5, 2))), "encloses? nothing"),
    (lambda m: asterism.mesh("sqare"), "no such file; did you mean square"),
    (lambda m: asterism.mesh(""), "a file's name is wanted"),
    (lambda m: asterism.mesh("a\0b.poly"), "a file's name is wanted"),
    (lambda m: asterism.mesh("x" * 5000), "a file's name is wanted"),
    (lambda m: asterism.mesh(b"nothing.poly"), "nothing.poly: cannot be opened"),
    (lambda m: asterism.Domain.from_geo("POLYGON ((0 0, 1 0, 1 1, 0 0))"), "__geo_interface__"),
    (lambda m: asterism.Domain.from_geo({"type": "Polygon"}), 'there is no "coordinates"'),
    (lambda m: asterism.Domain(L_SHAPE, [(0, 1), (1, 6)]), "row 1 names point 6 of 6, which count from 0"),
    (lambda m: asterism.Domain(L_SHAPE, [(0, 1), (1, 2), (2, 0)], [1]), "one for each segment is wanted, 3, not 1"),
    # Sizes and metrics
    (lambda m: asterism.mesh(L_SHAPE, size=lambda p: 0.1), "sizes that differ from place to place are a metric"),
    (lambda m: asterism.mesh(L_SHAPE, size=[0.1, 0.2]), "sizes that differ from place to place are a metric"),
    (lambda m: asterism.mesh(L_SHAPE, size=1e-300), "from 1e-150 to 1e150 is wanted"),
    (lambda m: asterism.mesh(L_SHAPE, metric={}), "metric: a text, a size.*not dict"),
    (lambda m: asterism.mesh(L_SHAPE, metric=object()), "metric: a text, a size.*not object"),
    (lambda m: asterism.mesh(L_SHAPE, metric=lambda p: 0.1 + p[0]), "called with an array of points"),
    (lambda m: asterism.mesh(L_SHAPE, (m, np.zeros((len(m.points), 3)))), "metric: row 0, 0 0 0, is not positive"),
    (lambda m: asterism.mesh(L_SHAPE, size_at=(0.5, 0.5, 0.1, 0.1)), r"as \[\(x, y, radius, h\)\]"),
    (lambda m: asterism.mesh(L_SHAPE, size_near={7: 0.1}), "the markers there are: 0"),
    (lambda m: asterism.mesh(L_SHAPE, layers={0: 0.1}), "MARKER:H0,GROWTH"),
    (lambda m: asterism.mesh(L_SHAPE, periodic=5), "periodic: pairs of markers"),
    (lambda m: asterism.mesh(L_SHAPE, voronoi="yes"), "^voronoi: True or False is wanted"),
    # Meshes
    (lambda m: asterism.Mesh(L_SHAPE, [(0, 1, 9)]), "row 0 names point 9 of 6, which count from 0"),
    (lambda m: asterism.Mesh(L_SHAPE, [(0, 1, 1)]), "triangles: row 0 names point 1 twice"),
    (lambda m: asterism.Mesh(L_SHAPE, [(0, 1)]), r"\(n, 3\) is wanted, not \(1, 2\)"),
    (lambda m: asterism.Mesh(L_SHAPE, [(0, 1, 2)], regions=[1, 2]), "one for each triangle"),
    (lambda m: m.svg(width="x"), "width: a whole number"), (lambda m: m.svg(width=10**30), "width: a whole number"),
    (lambda m: m.plot(ax=3), "an Axes of matplotlib"), (lambda m: m.show(height="x"), "height: a whole number"),
    (lambda m: m.show().save("/nowhere/x.html"), "cannot be written"), (lambda m: m.save(""), "a file's name"),
    (lambda m: m.locate((0, 0, 0)), r"is wanted, not \(3,\)"),
    (lambda m: m.interpolate({"u": flat(m)}, [(0.5, 0.5)]), "each of its fields"),
    (lambda m: asterism.certify(m, metric="x"), "a Mesh has its own"),
    # Adaptation
    (lambda m: asterism.adapt("x.mesh", [1]), r"asterism.read\(\) makes one"),
    (lambda m: asterism.adapt(L_SHAPE, [1]), r"asterism.mesh\(\) makes one"),
    (lambda m: asterism.adapt(m, "u.sol", vertices=50), "whose `values` are the fields"),
    (lambda m: asterism.metric(m, flat(m), hmax=0), "hmax: a positive"),
    (lambda m: asterism.metric(m, flat(m), hessian="magic"), "'lsq' is wanted"),
    (lambda m: asterism.transfer(m, flat(m), m, how="magic"), "'project' or 'bounded'"),
    (lambda m: asterism.Mesh(np.c_[m.points, m.points[:, 0]], m.triangles), "points: third coordinates differ"),
    (lambda m: asterism.Mesh(m.points, []), r"triangles: the shape \(n, 3\)"),
    (lambda m: asterism.Mesh(m.points, m.triangles + 0.5), "triangles: number 0 is [0-9]+.5, and whole numbers"),
    (lambda m: asterism.Mesh(m.points, m.triangles, corners=flat(m) == 0), r"corners: .*np.flatnonzero\(mask\)"),
    (lambda m: asterism.Mesh(m.points[m.triangles].reshape(-1, 2), np.arange(3 * len(m.triangles)).reshape(-1, 3)),
     "each triangle has vertices of its own"),
    # Predicates
    (lambda m: asterism.orientation((0, 0), (1, 0), (0, np.nan)), "^r: "),
    (lambda m: asterism.orientation((0, 0), [(1, 0), (1, np.inf)], (0, 1)), "^q: row 1"),
    (lambda m: asterism.edge_test(SITE, SITE, SITE, 4), r"y: the shape \(n, 5\) or \(5,\) is wanted, not \(\)"),
    # Surfaces and drawings
    (lambda m: asterism.Surface(3), "a text of JSON"), (lambda m: asterism.Surface.read(None), "a file's name"),
    (lambda m: asterism.Surface.named(3), "name: a text"), (lambda m: asterism.mesh_surface(3, 0.1), "Surface.named"),
    (lambda m: asterism.mesh_surface("torus", 0.1), "Surface.named"),
    (lambda m: asterism.Surface.bezier("x"), "control: "), (lambda m: asterism.mesh_surface([], 0.1), "surfaces: "),
    (lambda m: asterism.read_dxf("nothing.dxf"), "no such file"),
]


def test_each_is_told_what_is_wanted(made):
    assert len(CALLS) >= 60
    wrong = []
    for number, (call, message) in enumerate(CALLS):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                wrong.append(f"call {number}, {message}: no error, but {call(made)!r}")
        except asterism.InputError as told:
            with pytest.raises(asterism.InputError, match=message):
                raise told
            if "\n" in str(told) or any(word in str(told) for word in INSIDE):
                wrong.append(f"call {number}: {told}")
        except Exception as other:  # pylint: disable=broad-except
            wrong.append(f"call {number}, {message}: {type(other).__name__}: {other}")
    assert not wrong, "\n".join(wrong)


def test_everything_public_is_described():
    for name in asterism.__all__:
        assert name == "__version__" or (getattr(asterism, name).__doc__ or "").strip(), name


def test_wrong_names_are_type_errors_too():
    for call in (lambda: asterism.mesh(L_SHAPE, sizes=1), asterism.Domain):
        with pytest.raises(TypeError) as caught:
            call()
        for again in (copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))):
            assert isinstance(again, asterism.InputError) and str(again) == str(caught.value)


def test_errors_of_a_callers_function_stay_its_own():
    with pytest.raises(TypeError, match="takes 0 positional") as caught:
        asterism.mesh(L_SHAPE, metric=lambda: 1)
    assert not isinstance(caught.value, asterism.InputError)


def test_warnings_name_the_callers_line():
    crossed = [(0, 0), (4, 0), (0, 3), (4, 3)]
    for call in (lambda: asterism.Domain(crossed, repair=True), lambda: asterism.mesh(crossed, size=2, repair=True),
                 lambda: asterism.mesh("square", "swirl:400", 0.01, max_seconds=0.05)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            call()
        assert caught and {one.filename for one in caught} == {__file__}


def test_names_of_certificates_are_suggested(made):
    with pytest.raises(AttributeError, match="did you mean worst_angle"):
        _ = made.certificate.worst_angl


def test_meshio_writes_what_gmsh_reads(made, tmp_path):
    meshio = pytest.importorskip("meshio")
    made.to_meshio().write(tmp_path / "x.msh")
    pickle.loads(pickle.dumps(made.to_meshio())).write(str(tmp_path / "named.msh"), file_format="gmsh")
    assert (tmp_path / "x.msh").read_bytes() == (tmp_path / "named.msh").read_bytes()
    made.to_meshio().write(tmp_path / "x.vtu")
    assert len(meshio.read(tmp_path / "x.vtu").points) == len(made.points)
    again = meshio.read(tmp_path / "x.msh", file_format="gmsh")
    assert len(again.points) == len(made.points)
    assert sum(len(cells.data) for cells in again.cells if cells.type == "triangle") == len(made.triangles)


def test_names_reach_a_terminal_as_one_line():
    for name, shown in (("a\x1b[31m\nb\u202e.mesh", "a?[31m?b?.mesh"), ("y" * 3000, "y" * 100 + "..." + "y" * 59 + ":")):
        with pytest.raises(asterism.InputError) as told:
            asterism.read(name)
        assert shown in str(told.value)
        assert str(told.value).isprintable() and len(str(told.value)) < 300


def test_messages_are_whole_whatever_bytes_are_in_them():
    long = "\u00e9" * 200  # cut for the message, in the middle of a character
    for call, shown in ((lambda: asterism.mesh("square", metric="expr:1;0;x\u00b2"), "unexpected '\u00b2' (pos"),
                        (lambda: asterism.mesh("square", metric="expr:1;0;9\0+"), "9?+': unexpected '?' (position 2)"),
                        (lambda: asterism.mesh("square", size=long), "\u00e9?...")):
        with pytest.raises(asterism.InputError) as told:
            call()
        assert shown in str(told.value)
        assert str(told.value).isprintable()


def test_a_surface_of_a_name_is_told_how_it_is_made():
    for name in ("torus", "hull.json"):
        with pytest.raises(asterism.InputError, match=r"Surface\.named\(\).*Surface\.read\(\)"):
            asterism.Surface(name)
