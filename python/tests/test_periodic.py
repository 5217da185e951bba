# SPDX-License-Identifier: MIT
"""Periodic sides from Python."""
import numpy as np
import pytest

import asterism


def side(mesh, marker):
    return {tuple(p) for p in mesh.points[mesh.edges[mesh.edge_markers == marker].ravel()]}


def test_a_mesh_has_the_same_points_on_both_sides():
    made = asterism.mesh("square", size=0.3, periodic=[(4, 2), (1, 3)])
    assert made.complete and made.certified
    assert [m["kind"] for m in made.certificate.periodic] == ["translated exactly"] * 2
    assert made.certificate.periodic[0]["shift"] == [2, 0]
    assert {(x + 2, y) for x, y in side(made, 4)} == side(made, 2)
    assert {(x, y + 2) for x, y in side(made, 1)} == side(made, 3)


def test_adapted_meshes_keep_them():
    made = asterism.mesh("square", size=0.2)
    x, y = made.points.T
    made, _ = asterism.adapt(made, np.tanh(4 * np.sin(np.pi * (x + y))), vertices=400, periodic=[(4, 2)])
    assert made.certified
    assert {(x + 2, y) for x, y in side(made, 4)} == side(made, 2)


@pytest.mark.parametrize("pairs, words", [
    ([4], "pairs of markers are wanted"), ([(4, 2, 1)], "pairs of markers"), ([(4, 2.5)], "pairs of markers"),
    ([(4, 9)], "markers 4 and 9 cannot be periodic: no segment has marker 9"), ([(4, 2), (2, 1)], "named twice")])
def test_refusals_name_what_is_wrong(pairs, words):
    with pytest.raises(asterism.InputError, match=words):
        asterism.mesh("square", size=0.5, periodic=pairs)
