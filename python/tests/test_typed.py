# SPDX-License-Identifier: MIT
"""What mypy says of a script that uses the package: no error, and the types that a user counts on."""
import pathlib
import re
import subprocess
import sys

import pytest

import asterism

SCRIPT = '''
import numpy as np
import numpy.typing as npt
import asterism
from asterism import Adapted, Domain, Mesh, Page, Surface, SurfaceMesh

square = Domain.square()
ring = Domain([[0, 0], [2, 0], [2, 1], [0, 1]])
mesh: Mesh = asterism.mesh(ring, "swirl:3", size=0.3, angle_bound=20, threads=2, max_seconds=5.0, repair=True)
u: npt.NDArray[np.float64] = np.tanh(5 * mesh.points[:, 0])
made: Adapted = asterism.adapt(mesh, u, vertices=300)
new, v = asterism.adapt(mesh, u, vertices=300)
page: Page = made.show()
shell: SurfaceMesh = asterism.mesh_surface(Surface.named("torus"), chord=0.2)
called = asterism.mesh(square, lambda p: np.tile([4.0, 0.0, 9.0], (len(p), 1)), size=0.2)
tensor = asterism.mesh(square, np.diag([4.0, 9.0]), size=0.2)
scalar = asterism.mesh([(0, 0), (1, 0), (0, 1)], 4.0, size=0.2)
on_mesh = asterism.mesh(square, (mesh, mesh.metric), size=0.2, size_at=[(0.0, 0.0, 0.1, 0.05)])
reveal_type(mesh.points)
reveal_type(mesh.triangles)
reveal_type(mesh.angles)
reveal_type(mesh.neighbors)
reveal_type(mesh.locate([[0.5, 0.5]]))
reveal_type(mesh.certificate.worst_angle)
reveal_type(mesh.save("x.mesh"))
reveal_type(made.mesh)
reveal_type(new)
reveal_type(asterism.transfer(mesh, u, made.mesh))
reveal_type(asterism.transfer(mesh, {"u": u}, made.mesh))
reveal_type(Domain.read("part.poly", repair=True))
reveal_type(shell.points)
'''
TYPES = ["ndarray.*floating", "ndarray.*signedinteger", "ndarray.*floating", "ndarray.*signedinteger", "ndarray.*signedinteger",
         "float", r"list\[builtins\.str\]", r"asterism\._mesh\.Mesh", r"asterism\._mesh\.Mesh", r"asterism\._reported\.ReportedArray",
         r"dict\[builtins\.str, asterism\._reported\.ReportedArray\]", r"asterism\._domain\.Domain", "ndarray.*floating"]


def test_a_script_is_typed(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "script.py").write_text(SCRIPT)
    here = str(pathlib.Path(asterism.__file__).parents[1])  # a folder of installed packages, for mypy
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "script.py"],
                          cwd=tmp_path, capture_output=True, text=True, env={"PYTHONPATH": here, "PATH": ""}, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    revealed = re.findall(r'Revealed type is "(.*)"', done.stdout)
    assert len(revealed) == len(TYPES)
    for found, wanted in zip(revealed, TYPES):
        assert re.search(wanted, found), found
