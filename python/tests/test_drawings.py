# SPDX-License-Identifier: MIT
"""Drawings as domains, through ezdxf, and XDMF meshes, through meshio."""
import math
import warnings

import numpy as np
import pytest

import asterism

ezdxf = pytest.importorskip("ezdxf", reason="Debian's python3-ezdxf is not there")


def drawing(tmp_path, fill, name="d.dxf"):
    document = ezdxf.new()
    fill(document.modelspace(), document)
    path = tmp_path / name
    document.saveas(path)
    return path


def area(domain, size=0.05):
    made = asterism.mesh(domain, size=size)
    p = np.asarray(made.points)[np.asarray(made.triangles)]
    d, e = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    return float(np.sum(d[:, 0] * e[:, 1] - d[:, 1] * e[:, 0]) / 2), made


def test_lines_and_layers(tmp_path):
    def fill(space, document):
        for layer in ("WALL", "7"):
            document.layers.add(layer)
        corners = [(0, 0), (2, 0), (2, 1), (0, 1)]
        for k in range(4):
            space.add_line(corners[k], corners[(k + 1) % 4], dxfattribs={"layer": "WALL" if k else "7"})
        space.add_text("a word", dxfattribs={"layer": "WALL"})
    path = drawing(tmp_path, fill)
    with pytest.warns(UserWarning, match="passed over: 1 TEXT"):
        domain = asterism.read_dxf(path)
    assert sorted(domain.markers) == [1, 1, 1, 7]
    assert area(domain, 0.5)[0] == pytest.approx(2)
    with pytest.raises(asterism.InputError, match="nothing is on layer 'DOOR'"):
        asterism.read_dxf(path, layers=["DOOR"])


def test_bulges_arcs_and_circles(tmp_path):
    def fill(space, _):
        # A stadium: the left half is a polyline with a bulge, the right half an arc. It has a round hole.
        space.add_lwpolyline([(1, 1, 0), (0, 1, 1), (0, -1, 0), (1, -1, 0)], format="xyb")
        space.add_arc((1, 0), 1, -90, 90)
        space.add_circle((0.5, 0), 0.25)
    domain_path = drawing(tmp_path, fill)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        domain = asterism.read_dxf(domain_path, holes=[(0.5, 0)])
    expected = 2 + math.pi - math.pi / 16
    assert area(domain)[0] == pytest.approx(expected, rel=2e-3)


def test_splines_and_ellipses(tmp_path):
    def fill(space, _):
        space.add_ellipse((0, 0), major_axis=(2, 0), ratio=0.5, start_param=0, end_param=math.pi)
        spline = space.add_open_spline([(-2, 0), (-1, -1), (1, -1), (2, 0)], degree=3)
        assert spline.dxf.degree == 3
    path = drawing(tmp_path, fill)
    with pytest.warns(UserWarning, match="near them: 1"):
        domain = asterism.read_dxf(path)
    # The lower side is a cubic; its area is that of its control points' formula.
    t = np.linspace(0, 1, 20001)
    y = -3 * t * (1 - t)
    x = -2 * (1 - t) ** 3 - 3 * t * (1 - t) ** 2 + 3 * t ** 2 * (1 - t) + 2 * t ** 3
    below = -float(np.sum((y[1:] + y[:-1]) / 2 * np.diff(x)))
    assert area(domain)[0] == pytest.approx(math.pi + below, rel=2e-3)


def test_blocks_and_refusals(tmp_path):
    def fill(space, document):
        block = document.blocks.new("plate")
        block.add_lwpolyline([(0, 0), (1, 0), (1, 1), (0, 1)], close=True)
        space.add_blockref("plate", (3, 4))
    assert area(asterism.read_dxf(drawing(tmp_path, fill)), 0.5)[0] == pytest.approx(1)
    with pytest.raises(asterism.InputError, match="there is no line"):
        asterism.read_dxf(drawing(tmp_path, lambda space, _: None, "empty.dxf"))
    with pytest.raises(asterism.InputError, match="none.dxf"):
        asterism.read_dxf(tmp_path / "none.dxf")
    with pytest.raises(asterism.InputError, match="only plane drawings"):
        asterism.read_dxf(drawing(tmp_path, lambda space, _: space.add_line((0, 0, 0), (1, 0, 5)), "up.dxf"))


def test_xdmf(tmp_path):
    meshio = pytest.importorskip("meshio")
    pytest.importorskip("h5py")  # the writer of XDMF imports h5py in any case
    points = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float)
    made = meshio.Mesh(points, [("triangle", np.array([(0, 1, 2), (0, 2, 3)]))],
                       cell_data={"region": [np.array([3, 4])]})
    path = tmp_path / "m.xdmf"
    made.write(path, data_format="XML")
    read = asterism.read(path)
    assert sorted(read.regions) == [3, 4]
    assert len(read.points) == 4
