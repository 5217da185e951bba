# SPDX-License-Identifier: MIT
"""Meshes to which the theorem on nets applies, through Python: guarantees that are kept, problems that are refused by
name, and options that exclude a guarantee."""
import numpy as np
import pytest

import asterism

PLATE = np.array([(0, 0), (3, 0), (3, 2), (0, 2)], dtype=float)


def test_a_guarantee_is_kept_and_verified():
    made = asterism.mesh(PLATE, "sink:1", size=0.5, guarantee=True)
    assert made.certified
    kept, theorem = made.certificate.data["guarantee"], made.certificate.data["theorem"]
    assert theorem["theorem_applies"] and theorem["proved_angle"] >= 20
    assert kept["eps"] == theorem["covering_radius"] and kept["eps"] * kept["size_factor"] <= 0.75001
    assert made.verify()["verified"]


def test_a_sharp_corner_is_named():
    with pytest.raises(asterism.InputError, match="at least 36 are needed"):
        asterism.mesh(np.array([(0, 0), (4, 0), (4, 1)], dtype=float), size=0.3, guarantee=True)


@pytest.mark.parametrize("other", [{"vertices": 100}, {"improve": 1}, {"metric_tolerance": 0.1}])
def test_what_does_not_go_with_it(other):
    with pytest.raises(asterism.InputError, match="guarantee"):
        asterism.mesh(PLATE, guarantee=True, **other)
