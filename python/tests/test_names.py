# SPDX-License-Identifier: MIT
"""One name for one thing: other spellings do the same (docs/manual/names.md)."""
import inspect
import math

import asterism
import numpy as np
import pytest


@pytest.fixture(scope="module")
def made() -> asterism.Mesh:
    return asterism.mesh("square", size=0.3)


def values(mesh: asterism.Mesh) -> np.ndarray:
    return np.tanh(5 * mesh.points[:, 0])


def test_ways_of_transfer_and_of_hessians(made: asterism.Mesh) -> None:
    finer, u = asterism.mesh("square", size=0.2), values(made)
    assert np.array_equal(asterism.transfer(made, u, finer, "project"), asterism.transfer(made, u, finer, "conservative"))
    assert inspect.signature(asterism.transfer).parameters["how"].default == "project"
    assert np.array_equal(asterism.metric(made, u, hessian="lsq"), asterism.metric(made, u, hessian="least_squares"))


def test_the_maximum_norm_and_no_gradation(made: asterism.Mesh) -> None:
    u = values(made)
    assert np.array_equal(asterism.metric(made, u, norm="inf"), asterism.metric(made, u, norm=math.inf))
    assert np.array_equal(asterism.metric(made, u, gradation="none"), asterism.metric(made, u, gradation=None))
    assert np.array_equal(asterism.mesh("square", size=0.5, gradation="none").points, asterism.mesh("square", size=0.5).points)


def test_the_dual_of_the_voronoi_diagram() -> None:
    ours, older = asterism.mesh("square", size=0.5, voronoi=True), asterism.mesh("square", size=0.5, prove_voronoi=True)
    assert ours.certificate.data["audit"]["voronoi"] == older.certificate.data["audit"]["voronoi"] == "proved"
    assert asterism.certify(ours, voronoi=True)["voronoi"] == asterism.certify(ours, prove_voronoi=True)["voronoi"] == "proved"


@pytest.mark.parametrize("name", ["size", "vertices", "complexity", "hmin", "hmax", "aspect", "gradation", "angle_bound",
                                  "metric_tolerance", "chord_tolerance", "max_sites", "max_seconds", "threads", "voronoi"])
def test_arguments_are_called_as_options_of_the_command(name: str) -> None:
    assert name in inspect.signature(asterism.mesh).parameters
