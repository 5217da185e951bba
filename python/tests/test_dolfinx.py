# SPDX-License-Identifier: MIT
"""Meshes, tags and functions of dolfinx. Skipped where it is not installed."""
import numpy as np
import pytest

pytest.importorskip("dolfinx", reason="dolfinx is not installed (python3-dolfinx)")
import ufl  # noqa: E402
from dolfinx import fem  # noqa: E402
from dolfinx import mesh as dmesh  # noqa: E402
from mpi4py import MPI  # noqa: E402

import asterism  # noqa: E402
import asterism.dolfinx  # noqa: E402


@pytest.fixture(scope="module")
def square():
    """Returns a mesh of two materials with sides 1 to 4 and an inner line of tag 9. In `some`, only one material is
    tagged."""
    mesh = dmesh.create_unit_square(MPI.COMM_SELF, 12, 12)
    mesh.topology.create_connectivity(2, 0)
    cells = np.arange(mesh.topology.index_map(2).size_local, dtype=np.int32)
    middle = dmesh.compute_midpoints(mesh, 2, cells)
    tags = dmesh.meshtags(mesh, 2, cells, np.where(middle[:, 0] < 0.5, 3, 7).astype(np.int32))
    mesh.topology.create_connectivity(1, 2)
    parts = [dmesh.locate_entities(mesh, 1, where) for where in (
        lambda x: np.isclose(x[1], 0), lambda x: np.isclose(x[0], 1), lambda x: np.isclose(x[1], 1),
        lambda x: np.isclose(x[0], 0), lambda x: np.isclose(x[1], 0.5) & (x[0] <= 0.501))]
    facets = np.concatenate(parts).astype(np.int32)
    markers = np.repeat([1, 2, 3, 4, 9], [len(p) for p in parts]).astype(np.int32)
    order = np.argsort(facets)
    return mesh, tags, dmesh.meshtags(mesh, 1, facets[order], markers[order])


def lengths(mesh, facet_tags):
    facets = asterism.dolfinx._facets(mesh)[facet_tags.indices]
    ends = mesh.geometry.x[facets]
    sizes = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    return {int(tag): sizes[facet_tags.values == tag].sum() for tag in np.unique(facet_tags.values)}


def areas(mesh, cell_tags):
    corners = mesh.geometry.x[asterism.dolfinx._cells(mesh)]
    sizes = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]) / 2
    sizes = sizes[cell_tags.indices]
    return {int(tag): sizes[cell_tags.values == tag].sum() for tag in np.unique(cell_tags.values)}


WANTED_AREAS = {3: 0.5, 7: 0.5}
WANTED_LENGTHS = {1: 1, 2: 1, 3: 1, 4: 1, 9: 0.5}


def test_there_and_back(square):
    mesh, cell_tags, facet_tags = square
    ours = asterism.dolfinx.from_dolfinx(mesh, cell_tags, facet_tags)
    assert np.array_equal(ours.points, mesh.geometry.x[:, :2])
    assert set(ours.edge_markers) == {0, 1, 2, 3, 4, 9}  # 0 for edges between the materials
    back = asterism.dolfinx.to_dolfinx(ours)
    assert np.array_equal(back.mesh.geometry.x[:, :2], ours.points[back.points])
    assert areas(back.mesh, back.cell_tags) == pytest.approx(WANTED_AREAS)
    assert lengths(back.mesh, back.facet_tags) == pytest.approx(WANTED_LENGTHS)
    again = asterism.dolfinx.from_dolfinx(back.mesh, back.cell_tags, back.facet_tags)
    assert sorted(map(tuple, again.points.tolist())) == sorted(map(tuple, ours.points.tolist()))


def fill(space, function):
    made = fem.Function(space)
    made.interpolate(function)
    return made


def front(x):
    return np.tanh(20 * (x[0] - x[1] + 0.3 * np.sin(3 * x[1]) - 0.2))


def test_a_loop_with_tags_and_both_degrees(square):
    mesh, cell_tags, facet_tags = square
    for step in range(3):
        u = fill(fem.FunctionSpace(mesh, ("CG", 1)), front)
        q = fill(fem.FunctionSpace(mesh, ("CG", 2)), lambda x: x[0] ** 2 - 3 * x[0] * x[1] + x[1])
        v = fill(fem.VectorFunctionSpace(mesh, ("CG", 1)), lambda x: np.vstack([x[0] + 2 * x[1], 1 - x[0]]))
        w = fill(fem.VectorFunctionSpace(mesh, ("CG", 2)), lambda x: np.vstack([x[0] * x[1], x[1] ** 2]))
        u.name = "front"
        made = asterism.dolfinx.adapt(mesh, u, cell_tags, facet_tags, vertices=700,
                                      carry={"q": q, "v": v, "w": w, "array": mesh.geometry.x[:, 0]})
        mesh, new_u, cell_tags, facet_tags = made
        assert made.asterism.certified and made.report["reached"]
        assert areas(mesh, cell_tags) == pytest.approx(WANTED_AREAS)
        assert lengths(mesh, facet_tags) == pytest.approx(WANTED_LENGTHS)
        assert new_u.name == "front" and new_u.function_space.mesh is mesh
        exact = fill(made.carried["q"].function_space, lambda x: x[0] ** 2 - 3 * x[0] * x[1] + x[1])
        assert np.allclose(made.carried["q"].x.array, exact.x.array, atol=1e-13)
        exact = fill(made.carried["v"].function_space, lambda x: np.vstack([x[0] + 2 * x[1], 1 - x[0]]))
        assert np.allclose(made.carried["v"].x.array, exact.x.array, atol=1e-13)
        exact = fill(made.carried["w"].function_space, lambda x: np.vstack([x[0] * x[1], x[1] ** 2]))
        assert np.allclose(made.carried["w"].x.array, exact.x.array, atol=1e-13)
        assert np.allclose(made.carried["array"], mesh.geometry.x[:, 0], atol=1e-13)
    error = fill(fem.FunctionSpace(mesh, ("CG", 1)), front).x.array
    assert abs(asterism.dolfinx._at_nodes(new_u)).max() <= 1 and len(error) == len(mesh.geometry.x)


def test_a_function_of_degree_two_makes_the_metric(square):
    mesh, cell_tags, _ = square
    u = fill(fem.FunctionSpace(mesh, ("CG", 2)), front)
    made = asterism.dolfinx.adapt(mesh, u, vertices=500)
    of_arrays = asterism.dolfinx.adapt(mesh, asterism.dolfinx._at_nodes(u), vertices=500)
    assert np.array_equal(made.asterism.points, of_arrays.asterism.points)
    assert made.cell_tags is None and made.facet_tags is None
    assert made.values.function_space.ufl_element().degree() == 2
    several = asterism.dolfinx.adapt(mesh, [u, fill(fem.FunctionSpace(mesh, ("CG", 1)), front)], vertices=500)
    assert len(several.values) == 2
    by_metric = asterism.dolfinx.adapt(mesh, metric=asterism.metric(asterism.dolfinx.from_dolfinx(mesh),
                                                                    asterism.dolfinx._at_nodes(u), vertices=500))
    assert by_metric.values is None and by_metric.asterism.certified


def test_functions_are_metrics(square):
    mesh, _, _ = square
    size = fill(fem.FunctionSpace(mesh, ("CG", 2)), lambda x: 0.05 + 0.1 * x[0])
    rows = fill(fem.VectorFunctionSpace(mesh, ("CG", 1), dim=3),
                lambda x: np.vstack([400 + x[0], 0 * x[0], 100 + x[1]]))
    matrix = fill(fem.TensorFunctionSpace(mesh, ("CG", 1)),
                  lambda x: np.vstack([400 + x[0], 0 * x[0], 0 * x[0], 100 + x[1]]))
    sizes = asterism.dolfinx._at_nodes(size)[:, None]
    for one, same in ((size, sizes), (rows, matrix)):
        by_one, by_same = (asterism.dolfinx.adapt(mesh, metric=of).asterism for of in (one, same))
        assert np.array_equal(by_one.sites, by_same.sites)


def test_functions_are_second_derivatives_and_metrics_to_intersect_with(square):
    mesh, _, _ = square
    at = mesh.geometry.x
    rows = np.column_stack([400 + 100 * at[:, 0], 0 * at[:, 0], 100 - 50 * at[:, 1]])
    tensors = fem.Function(fem.TensorFunctionSpace(mesh, ("CG", 1)))
    tensors.interpolate(lambda x: np.vstack([400 + 100 * x[0], 0 * x[0], 0 * x[0], 100 - 50 * x[1]]))
    for by in (lambda of: {"hessian": of}, lambda of: {"hessian": {"a": of}}, lambda of: {"metric": 0.1, "intersect": [of]},
               lambda of: {"metric": 0.1, "intersect": of}):
        one, same = (asterism.dolfinx.adapt(mesh, vertices=300, **by(of)).metric for of in (tensors, rows))
        assert np.allclose(one, same, rtol=1e-12, atol=1e-9)


def test_parts_of_functions(square):
    mesh, _, _ = square
    u = fill(fem.FunctionSpace(mesh, ("CG", 1)), front)
    v = fill(fem.VectorFunctionSpace(mesh, ("CG", 1)), lambda x: np.vstack([x[0], 5 + x[1]]))
    elements = [ufl.VectorElement("CG", mesh.ufl_cell(), 2), ufl.FiniteElement("CG", mesh.ufl_cell(), 1)]
    flow = fem.Function(fem.FunctionSpace(mesh, ufl.MixedElement(elements)))
    flow.sub(0).interpolate(lambda x: np.vstack([x[0] * x[1], x[1] ** 2]))
    flow.sub(1).interpolate(lambda x: 3 + x[0])
    carried = asterism.dolfinx.adapt(mesh, u, vertices=300, carry=[v.sub(1), flow.sub(0), flow.sub(1)]).carried
    wanted = (lambda x: 5 + x[1], lambda x: np.vstack([x[0] * x[1], x[1] ** 2]), lambda x: 3 + x[0])
    for of, exact in zip(carried, wanted):
        assert np.allclose(of.x.array, fill(of.function_space, exact).x.array, atol=1e-13)
    with pytest.raises(asterism.InputError, match="degree 1 or 2 is wanted"):
        asterism.dolfinx.adapt(mesh, u, vertices=300, carry=flow)


def cut_square(n):
    """Returns a mesh of the unit square, cut from (0, 0.5) to its middle: vertices of the cut are there twice."""
    whole = dmesh.create_unit_square(MPI.COMM_SELF, n, n)
    points, cells = whole.geometry.x[:, :2].copy(), asterism.dolfinx._cells(whole).copy()
    on_cut = np.flatnonzero((points[:, 1] == 0.5) & (points[:, 0] < 0.49))
    above = np.arange(len(points))
    above[on_cut] = len(points) + np.arange(len(on_cut))
    is_above = points[cells].mean(axis=1)[:, 1] > 0.5
    cells[is_above] = above[cells[is_above]]
    domain = ufl.Mesh(ufl.VectorElement("CG", "triangle", 1))
    return dmesh.create_mesh(MPI.COMM_SELF, cells, np.concatenate([points, points[on_cut]]), domain)


def jump(mesh, degree):
    """Returns a function that is the distance from x = 0.5 on the left, its sign that of the side of the cut."""
    made = fem.Function(fem.FunctionSpace(mesh, ("CG", degree)))
    places = made.function_space.tabulate_dof_coordinates()
    for cell, nodes in enumerate(asterism.dolfinx._cells(mesh)):
        sign = 1 if mesh.geometry.x[nodes].mean(axis=0)[1] > 0.5 else -1
        dofs = made.function_space.dofmap.cell_dofs(cell)
        made.x.array[dofs] = sign * np.maximum(0.5 - places[dofs, 0], 0)
    return made


def test_values_on_a_cut_stay_on_their_side():
    mesh = cut_square(12)
    made = asterism.dolfinx.adapt(mesh, jump(mesh, 1), vertices=300, carry=jump(mesh, 2))
    for of, degree in ((made.values, 1), (made.carried, 2)):
        at = of.function_space.tabulate_dof_coordinates()
        on_cut = (at[:, 1] == 0.5) & (at[:, 0] < 0.5)
        assert on_cut.sum() >= 10
        assert np.allclose(of.x.array[on_cut], jump(made.mesh, degree).x.array[on_cut], atol=1e-13)


def test_a_height_is_left_out_with_a_warning():
    places = np.array([[0, 0, 2], [1, 0, 2], [0, 1, 2], [1, 1, 2.0]])
    domain = ufl.Mesh(ufl.VectorElement("CG", "triangle", 1, dim=3))
    flat = dmesh.create_mesh(MPI.COMM_SELF, np.array([[0, 1, 2], [1, 3, 2]]), places, domain)
    with pytest.warns(UserWarning, match="height z = 2"):
        assert asterism.dolfinx.from_dolfinx(flat).points.shape == (4, 2)


def test_cells_without_a_tag_stay_so(square):
    mesh, cell_tags, _ = square
    some = cell_tags.indices[cell_tags.values == 3]
    tags = dmesh.meshtags(mesh, 2, some, np.full(len(some), 3, dtype=np.int32))
    u = fill(fem.FunctionSpace(mesh, ("CG", 1)), front)
    made = asterism.dolfinx.adapt(mesh, u, tags, vertices=400)
    assert areas(made.mesh, made.cell_tags) == pytest.approx({3: 0.5})


def test_transfer_keeps_integrals(square):
    mesh, _, _ = square
    u = fill(fem.FunctionSpace(mesh, ("CG", 1)), front)
    to = dmesh.create_unit_square(MPI.COMM_SELF, 9, 17)
    moved = asterism.dolfinx.transfer(u, to)
    integral = lambda f: fem.assemble_scalar(fem.form(f * __import__("ufl").dx))
    assert integral(moved) == pytest.approx(integral(u), abs=1e-14)
    q = fill(fem.FunctionSpace(mesh, ("CG", 2)), lambda x: x[0] * x[1])
    exact = fill(fem.FunctionSpace(to, ("CG", 2)), lambda x: x[0] * x[1])
    assert np.allclose(asterism.dolfinx.transfer(q, to, "interpolate").x.array, exact.x.array, atol=1e-14)
    assert np.allclose(asterism.dolfinx.transfer(mesh.geometry.x[:, 1], to, mesh=mesh), to.geometry.x[:, 1])


def test_what_is_refused(square):
    mesh, cell_tags, facet_tags = square
    u = fill(fem.FunctionSpace(mesh, ("CG", 1)), front)
    q = fill(fem.FunctionSpace(mesh, ("CG", 2)), front)
    flow = fem.Function(fem.VectorFunctionSpace(mesh, ("CG", 1)))
    nowhere = fill(q.function_space, lambda x: np.nan * x[0])
    other = dmesh.create_unit_square(MPI.COMM_SELF, 5, 5)
    zero = dmesh.meshtags(mesh, 1, facet_tags.indices, facet_tags.values * 0)
    ones = np.arange(4, dtype=np.int32), np.ones(4, dtype=np.int32)
    for call, message in (
            (lambda: asterism.dolfinx.adapt(mesh, q, vertices=9, how="conservative"), "of degree 2"),
            (lambda: asterism.dolfinx.adapt(mesh, fem.Function(fem.FunctionSpace(mesh, ("CG", 3)))), "degree 1 or 2"),
            (lambda: asterism.dolfinx.adapt(mesh, fem.Function(fem.FunctionSpace(mesh, ("DG", 1)))), "degree 1 or 2"),
            (lambda: asterism.dolfinx.adapt(mesh, fem.Function(fem.FunctionSpace(mesh, ("DG", 0)))), "projection onto"),
            (lambda: asterism.dolfinx.adapt(mesh, fem.Function(fem.FunctionSpace(other, ("CG", 1)))), "another mesh"),
            (lambda: asterism.dolfinx.adapt(mesh, u, facet_tags, cell_tags), "cell_tags: MeshTags"),
            (lambda: asterism.dolfinx.adapt(mesh, u, cell_tags, dmesh.meshtags(other, 1, *ones)), "facet_tags: it is"),
            (lambda: asterism.dolfinx.adapt(mesh, u, cell_tags, zero), "0 is the marker"),
            (lambda: asterism.dolfinx.adapt(mesh, u, dmesh.meshtags(mesh, 2, ones[0], 0 * ones[1])), "0 is the region"),
            (lambda: asterism.dolfinx.adapt(mesh, u, dmesh.meshtags(mesh, 2, ones[0], 1.5 * ones[1])), "whole numbers"),
            (lambda: asterism.dolfinx.adapt(mesh, u * 2), "a Function is wanted, not an expression"),
            (lambda: asterism.dolfinx.adapt(mesh, metric=u * 2), "a Function is wanted, not an expression"),
            (lambda: asterism.dolfinx.adapt(mesh, metric=flow), "3 .m11"),
            (lambda: asterism.dolfinx.adapt(mesh, u, carry=nowhere), "not finite"),
            (lambda: asterism.dolfinx.adapt(mesh), "which metric is wanted"),
            (lambda: asterism.dolfinx.from_dolfinx(7), "a dolfinx mesh is wanted"),
            (lambda: asterism.dolfinx.to_dolfinx(mesh), "an asterism.Mesh is wanted"),
            (lambda: asterism.dolfinx.from_dolfinx(dmesh.create_unit_cube(MPI.COMM_SELF, 2, 2, 2)), "triangles of degree"),
            (lambda: asterism.dolfinx.from_dolfinx(dmesh.create_unit_square(
                MPI.COMM_SELF, 2, 2, dmesh.CellType.quadrilateral)), "triangles of degree")):
        with pytest.raises(asterism.InputError, match=message):
            call()


def test_the_page_of_the_manual_runs():
    page = (__import__("pathlib").Path(__file__).parents[2] / "docs/manual/solvers.md").read_text()
    names: dict = {}
    exec(page.split("```python\n")[1].split("```")[0], names)
    assert names["made"].asterism.certified and names["made"].report["reached"]
    assert len(names["uh"].x.array) == len(names["mesh"].geometry.x)
