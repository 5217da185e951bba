# SPDX-License-Identifier: MIT
#
# Our files, read by a program that is not ours: meshio must find the very numbers written.
# Usage: read_with_meshio.py PROGRAM, where PROGRAM is the write_sample executable.

import pathlib
import subprocess
import sys
import tempfile

import meshio
import numpy


def read_expected(path):
    numbers = {"site": [], "triangle": [], "region": [], "edge": []}
    for line in path.read_text().splitlines():
        kind, *words = line.split()
        convert = float.fromhex if kind == "site" else int
        numbers[kind].append([convert(word) for word in words])
    return {kind: numpy.array(rows) for kind, rows in numbers.items()}


def check_medit(directory, expected):
    mesh = meshio.read(directory / "sample.mesh")
    assert numpy.array_equal(mesh.points, expected["site"][:, :2])
    assert numpy.array_equal(mesh.cells_dict["triangle"], expected["triangle"])
    assert numpy.array_equal(mesh.cells_dict["line"], expected["edge"][:, :2])
    references = mesh.cell_data_dict["medit:ref"]
    assert numpy.array_equal(references["line"], expected["edge"][:, 2])
    assert numpy.array_equal(references["triangle"], expected["region"][:, 0])


def check_vtu(directory, expected):
    mesh = meshio.read(directory / "sample.vtu")
    sites, triangles = expected["site"], expected["triangle"]
    m11, m12, m22 = sites[:, 2:].T
    zero, one = numpy.zeros_like(m11), numpy.ones_like(m11)
    assert numpy.array_equal(mesh.points[:, :2], sites[:, :2])
    assert not mesh.points[:, 2].any()
    assert numpy.array_equal(mesh.cells_dict["triangle"], triangles)
    assert numpy.array_equal(mesh.point_data["metric"], sites[:, 2:])
    tensor = numpy.stack([m11, m12, zero, m12, m22, zero, zero, zero, one], axis=1)
    assert numpy.array_equal(mesh.point_data["metric_tensor"].reshape(-1, 9), tensor)
    star_size = numpy.bincount(triangles.ravel(), minlength=len(sites))
    assert numpy.array_equal(mesh.point_data["star_size"], star_size)
    assert mesh.point_data["given"].sum() == 4 and mesh.point_data["given"][:4].all()
    assert not mesh.cell_data_dict["disagreeing"]["triangle"].any()
    assert numpy.array_equal(mesh.cell_data_dict["region"]["triangle"], expected["region"][:, 0])
    angles = mesh.cell_data_dict["smallest_angle"]["triangle"]
    assert numpy.allclose(angles, [least_angle(sites, t) for t in triangles], rtol=1e-9)


def least_angle(sites, triangle):
    """Computes the angle by another route than the library: maps by a square root of the metric, then takes
    arccos."""
    least = 180.0
    for vertex in triangle:
        m11, m12, m22 = sites[vertex, 2:]
        root = numpy.linalg.cholesky(numpy.array([[m11, m12], [m12, m22]])).T
        corners = [root @ sites[v, :2] for v in triangle]
        for i in range(3):
            a, b = corners[i - 1] - corners[i], corners[i - 2] - corners[i]
            cosine = a @ b / (numpy.linalg.norm(a) * numpy.linalg.norm(b))
            least = min(least, numpy.degrees(numpy.arccos(cosine)))
    return least


def main():
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        subprocess.run([sys.argv[1], name], check=True)
        expected = read_expected(directory / "expected.txt")
        check_medit(directory, expected)
        check_vtu(directory, expected)


main()
