# SPDX-License-Identifier: MIT
"""Tries an installed package: a mesh, an adaptation, the predicates, files; the licences of what it brings along."""
import pathlib
import re
import tempfile

import numpy as np

import asterism

mesh = asterism.mesh([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], size=0.2)
assert mesh.certified and mesh.verify()["verified"]
made = asterism.adapt(mesh, np.tanh(9 * (mesh.points[:, 0] - mesh.points[:, 1])), vertices=500, threads=2)
assert made.mesh.certified and made.report["reached"], made.report
assert asterism.orientation((0, 0), (1, 0), (0, 1)) == 1
with tempfile.TemporaryDirectory() as folder:
    made.mesh.save(pathlib.Path(folder) / "m.mesh")
    made.mesh.save(pathlib.Path(folder) / "m.html")
    assert asterism.verify(pathlib.Path(folder) / "m.mesh")["triangles"] == len(made.mesh.triangles)
libraries = pathlib.Path(asterism.__file__).parents[1] / "asterism.libs"
bundled = sorted(libraries.glob("*.so*"))
assert bundled, f"{libraries}: there is no library, and the package is none of scripts/build-wheel"
for library in bundled:
    licence = libraries / "licences" / (re.sub(r"-[0-9a-f]{8}\.so.*", "", library.name) + ".txt")
    for named in re.findall(r"/usr/share/common-licenses/([\w.+-]*\w)", licence.read_text(encoding="utf-8")):
        assert (libraries / "licences" / named).stat().st_size > 1000, f"{library}: the text of {named} is missing"
print(f"asterism {asterism.__version__} works: {made.mesh!r}")
