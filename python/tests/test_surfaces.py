# SPDX-License-Identifier: MIT
"""Surfaces and their meshes, as Python has them."""
import json

import numpy as np
import pytest

import asterism
from asterism import InputError, NotReachedWarning, Surface


def bump():
    z = np.zeros((4, 4))
    z[1:3, 1:3] = 0.4
    x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    return np.stack([x, y, z], -1)


def test_a_patch_is_meshed_and_certified():
    made = asterism.mesh_surface(Surface.bezier(bump(), name="bump"), chord=0.02)
    assert made.certified and made.reason == "" and made.certificate.distance <= 0.02
    assert made.points.shape == (made.certificate.vertices, 3)
    assert made.triangles.shape == (made.certificate.triangles, 3) and not made.points.flags.writeable
    assert set(made.patches) == {0}
    # Each corner is the surface's point at the corner's parameters, by cubic Bernstein polynomials.
    u, v = made.uv[..., 0], made.uv[..., 1]
    basis = lambda t: np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3], -1)
    lifted = np.einsum("tki,tkj,ijn->tkn", basis(u), basis(v), bump())
    assert np.abs(lifted - made.points[made.triangles]).max() < 1e-14


def test_patches_given_one_by_one_share_their_side():
    left, right = bump(), bump()
    right[..., 0] += 1
    made = asterism.mesh_surface([Surface.bezier(left), Surface.bezier(right)], chord=0.05, no_crossings=True)
    assert made.certified and set(made.patches) == {0, 1} and made.certificate.euler == 1
    assert made.certificate.no_crossings


def test_a_spline_is_its_bezier_patch():
    knots = [0, 0, 0, 0, 1, 1, 1, 1]
    spline = Surface.bspline(bump(), knots, knots, weights=np.ones((4, 4)))
    assert spline.patches[0]["degree"] == [3, 3] and len(spline) == 1
    a = asterism.mesh_surface(spline, chord=0.05)
    b = asterism.mesh_surface(Surface.bezier(bump()), chord=0.05)
    assert np.array_equal(a.points, b.points) and np.array_equal(a.triangles, b.triangles)


def test_units_of_parameters_change_nothing_but_uv():
    plain = asterism.mesh_surface(Surface.bezier(bump()), chord=0.02)
    knots = [2, 2, 2, 2, 30002, 30002, 30002, 30002]
    with pytest.warns(UserWarning, match="u, from 2 to 30002 without knots between, is taken from 0 to 1"):
        made = asterism.mesh_surface(Surface.bspline(bump(), knots, [0] * 4 + [1] * 4), chord=0.02)
    assert np.array_equal(plain.points, made.points) and np.array_equal(plain.triangles, made.triangles)
    assert np.allclose(made.uv[..., 0], 2 + 30000 * plain.uv[..., 0]) and made.uv[..., 0].max() == 30002
    assert np.array_equal(made.uv[..., 1], plain.uv[..., 1])


def test_files(tmp_path):
    made = asterism.mesh_surface(Surface.named("octant"), chord=0.05)
    names = made.save(tmp_path / "o.mesh")
    assert [n.rsplit("/", 1)[1] for n in names] == ["o.mesh", "o.certificate.json"]
    assert json.loads((tmp_path / "o.certificate.json").read_text())["certified"]
    made.save(tmp_path / "o.obj")
    assert (tmp_path / "o.obj").read_text().count("\nf ") == len(made.triangles)
    (tmp_path / "s.json").write_text(Surface.named("octant").text)
    again = asterism.mesh_surface(Surface.read(tmp_path / "s.json"), chord=0.05, threads=1)
    assert np.array_equal(again.points, made.points)


def test_what_is_wrong_is_said():
    for wrong, said in ((lambda: Surface.bezier(np.zeros((2, 2, 3))), "one point"),
                        (lambda: Surface.bezier(bump(), weights=-np.ones((4, 4))), "weight is -1"),
                        (lambda: Surface.bezier(bump(), weights=np.ones(4)), "weights"),
                        (lambda: Surface.bezier(bump() * np.nan), "finite"),
                        (lambda: Surface.bezier(np.zeros((4, 4))), "control"),
                        (lambda: Surface.bspline(bump(), [0, 1], [0, 1]), "degree"),
                        (lambda: Surface.bspline(bump(), [0] * 4 + [1] * 4, [0] * 4 + [1] * 4, trims=[1]), "trims"),
                        (lambda: Surface.named("cone"), "cone"),
                        (lambda: asterism.mesh_surface(Surface.named("saddle"), chord=0), "chord"),
                        (lambda: asterism.mesh_surface("saddle", chord=1), "Surface")):
        with pytest.raises(InputError, match=said):
            wrong()


def test_what_is_not_reached_warns():
    with pytest.warns(NotReachedWarning):
        made = asterism.mesh_surface(Surface.named("saddle"), chord=1e-3, vertices=20)
    assert not made.certified and made.reason
