# SPDX-License-Identifier: MIT
"""Periodic spaces of dolfinx on meshes with periodic sides. Skipped where dolfinx or dolfinx_mpc, which makes the
spaces, is not installed."""
import numpy as np
import pytest

pytest.importorskip("dolfinx", reason="dolfinx is not installed (python3-dolfinx)")
mpc = pytest.importorskip("dolfinx_mpc", reason="dolfinx_mpc is not installed (python3-dolfinx-mpc)")
import ufl  # noqa: E402
from dolfinx import fem  # noqa: E402
from dolfinx import mesh as dmesh  # noqa: E402
from mpi4py import MPI  # noqa: E402

import asterism.dolfinx  # noqa: E402

LEFT, RIGHT = 4, 2


def strip(n):
    """The unit square, its left and right sides tagged."""
    mesh = dmesh.create_unit_square(MPI.COMM_SELF, n, n)
    mesh.topology.create_connectivity(1, 2)
    sides = [dmesh.locate_entities_boundary(mesh, 1, lambda x, at=at: np.isclose(x[0], at)) for at in (0, 1)]
    facets = np.concatenate(sides).astype(np.int32)
    tags = np.repeat([LEFT, RIGHT], [len(s) for s in sides]).astype(np.int32)
    order = np.argsort(facets)
    return mesh, dmesh.meshtags(mesh, 1, facets[order], tags[order])


def solved(mesh, facet_tags):
    """Solves -lap u = f, periodic in x, 0 above and below, for u = sin(2 pi x) sin(pi y). Returns also how many
    unknowns are tied to another."""
    space = fem.FunctionSpace(mesh, ("CG", 1))
    ends = fem.locate_dofs_geometrical(space, lambda x: np.isclose(x[1], 0) | np.isclose(x[1], 1))
    conditions = [fem.dirichletbc(0.0, ends, space)]
    constraint = mpc.MultiPointConstraint(space)

    def partner(x):
        return np.array([x[0] - 1, x[1], x[2]])
    constraint.create_periodic_constraint_topological(space, facet_tags, RIGHT, partner, conditions)
    constraint.finalize()
    u, v, x = ufl.TrialFunction(space), ufl.TestFunction(space), ufl.SpatialCoordinate(mesh)
    exact = ufl.sin(2 * ufl.pi * x[0]) * ufl.sin(ufl.pi * x[1])
    found = mpc.LinearProblem(ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx, 5 * ufl.pi ** 2 * exact * v * ufl.dx,
                              constraint, bcs=conditions,
                              petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
    error = np.sqrt(fem.assemble_scalar(fem.form((found - exact) ** 2 * ufl.dx)))
    return found, error, constraint.num_local_slaves


def test_a_periodic_space_takes_each_mesh_of_a_loop():
    mesh, facet_tags = strip(12)
    errors = []
    for _ in range(3):
        found, error, slaves = solved(mesh, facet_tags)
        errors.append(error)
        places = mesh.geometry.x[:, :2]
        right = np.sort(places[places[:, 0] == 1, 1])
        assert np.array_equal(np.sort(places[places[:, 0] == 0, 1]), right)  # equal to the last bit
        assert slaves == len(right) - 2  # all but the corners, where u is 0
        made = asterism.dolfinx.adapt(mesh, values_of(mesh, found), None, facet_tags, vertices=900,
                                      periodic=[(LEFT, RIGHT)])
        assert made.asterism.certificate.periodic[0]["kind"] == "translated exactly"
        mesh, facet_tags = made.mesh, made.facet_tags
    assert errors[-1] < errors[0] / 3


def values_of(mesh, found):
    """Returns the values at the nodes of the mesh, in a space without constraints."""
    plain = fem.Function(fem.FunctionSpace(mesh, ("CG", 1)))
    plain.interpolate(found)
    return plain
