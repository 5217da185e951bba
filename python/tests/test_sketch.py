# SPDX-License-Identifier: MIT
"""The loop of the manual runs as it is written there, and arrays that it calls views are views."""
import pathlib
import re
import sys
import tracemalloc
import types

import numpy as np
import pytest

import asterism

MANUAL = pathlib.Path(__file__).resolve().parents[2] / "docs/manual/python.md"


def shown_pyvista():
    """Stands in for the part of pyvista that to_pyvista() uses: Debian has no package of pyvista."""
    class PolyData:
        def __init__(self, points, faces):
            assert points.shape[1] == 3 and len(faces) % 4 == 0 and (faces[::4] == 3).all()
            self.point_data, self.cell_data = {}, {}
    return types.SimpleNamespace(PolyData=PolyData)


@pytest.fixture
def pyvista(monkeypatch):
    try:
        import pyvista  # noqa: F401
    except ImportError:
        monkeypatch.setitem(sys.modules, "pyvista", shown_pyvista())


def test_the_loop_of_the_manual(tmp_path, monkeypatch, pyvista, capsys):
    geometry = pytest.importorskip("shapely.geometry")
    pytest.importorskip("meshio")
    blocks = re.findall(r"```python\n(.*?)```", MANUAL.read_text(encoding="utf-8"), flags=re.DOTALL)
    loop, = (block for block in blocks if "asterism.transfer" in block)
    solved = []

    def solve(points, triangles):
        solved.append((len(points), len(triangles)))
        assert not points.flags.owndata and not triangles.flags.owndata
        return np.tanh(12 * (points[:, 0] ** 2 + points[:, 1] ** 2 - 0.6))

    names = {"polygon": geometry.box(-1, -1, 1, 1).difference(geometry.Point(0.2, 0.1).buffer(0.3, 8)),
             "solve": solve}
    names.update((name, np.array([[*place, 2, 0.5, 1]]))
                 for name, place in zip("vwxy", [(0, 0), (1, 0), (1, -1), (1, 1)]))
    monkeypatch.chdir(tmp_path)
    exec(compile(loop, str(MANUAL), "exec"), names)  # pylint: disable=exec-used
    mesh = names["mesh"]
    assert len(solved) == 6 and solved[-1][0] > 3000
    assert mesh.complete and mesh.certified and mesh.certificate.worst_angle >= 20
    assert names["u"].shape == (len(mesh.points),)
    assert {"out.msh", "out.certificate.json"} <= {path.name for path in tmp_path.iterdir()}
    assert mesh.reason in capsys.readouterr().out


def test_views_share_the_memory_of_the_mesh():
    mesh = asterism.mesh(asterism.Domain.square(), "swirl:3", 0.2)
    for view in (mesh.points, mesh.metric):
        assert np.shares_memory(view, mesh.sites) and not view.flags.owndata and not view.flags.writeable
    for name in ("points", "metric", "sites", "triangles"):
        address = getattr(mesh, name).__array_interface__["data"][0]
        assert address == getattr(mesh, name).__array_interface__["data"][0], name
    assert mesh.points.__array_interface__["data"] == mesh.sites.__array_interface__["data"]


def peak_of(ask):
    """Returns the most bytes that numpy and Python held at once during a call, beyond those before it."""
    tracemalloc.start()
    try:
        ask()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_predicates_use_rows_where_they_lie():
    random = np.random.default_rng(3)
    rows = 50000
    sites = np.column_stack([random.uniform(-1, 1, (rows, 2)), np.ones(rows), np.zeros(rows), np.ones(rows)])
    others = sites[::-1].copy()
    answers = rows  # one byte for each
    slack = 20000
    assert peak_of(lambda: asterism.compare_distance(sites, others, sites[:, :2])) < answers + slack
    assert peak_of(lambda: asterism.orientation(sites[:, :2], others[:, :2], (3, 4))) < answers + slack
    assert peak_of(lambda: asterism.in_circle(sites[:, :2], others[:, :2], (3, 4), (0, 5),
                                              metric=sites[:, 2:])) < answers + slack
    # An array of another layout is copied.
    assert peak_of(lambda: asterism.compare_distance(np.asfortranarray(sites), others, (0, 0))) > 40 * rows
