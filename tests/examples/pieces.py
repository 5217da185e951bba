# SPDX-License-Identifier: MIT
"""Poisson on eight pieces, and a DMPlex of them: pieces.py PYTHON MPIRUN COMMAND EXAMPLES FOLDER. Skipped without PETSc."""
import pathlib
import re
import shutil
import subprocess
import sys

python, mpirun, command, examples, folder = sys.argv[1:]
there = subprocess.run([python, "-c", "import petsc4py, mpi4py, numpy"], check=False,
                       capture_output=True)
if there.returncode:
    print("skipped: petsc4py, mpi4py or numpy are missing")
    sys.exit(77)
folder = pathlib.Path(folder)
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
subprocess.run([command, "mesh", "square", "--metric", "swirl:12", "--size", "0.08", "--pieces", "8",
                "-o", f"{folder}/pieces/"], check=True)


def told_by(example, ranks):
    told = subprocess.run(
        [mpirun, "--allow-run-as-root", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-n",
         str(ranks), python, f"{examples}/{example}", f"{folder}/pieces"],
        check=True, capture_output=True, text=True, timeout=400).stdout
    print(told, end="")
    return told


for ranks in (8, 3):
    told = told_by("poisson_petsc.py", ranks)
    found = re.search(r"(\d+) vertices \((\d+) in the index\), (\d+) triangles, area ([\d.]+), "
                      r"error ([\d.e+-]+)", told)
    if not found or found[1] != found[2] or abs(float(found[4]) - 4) > 1e-9:
        sys.exit("the pieces are not one mesh of the square")
    if not float(found[5]) < 1e-2:
        sys.exit("the error is too large")
for ranks in (1, 4):
    told = told_by("plex_of_pieces.py", ranks)
    found = re.search(r"(\d+) vertices \((\d+) in the index\), (\d+) edges, (\d+) triangles", told)
    vertices, index, edges, triangles = (int(word) for word in found.groups())
    if vertices != index or vertices - edges + triangles != 1:
        sys.exit("the plex is not a disk")
    lengths = re.findall(r"marker (\d): ([\d.]+)", told)
    if [float(length) for marker, length in lengths if int(marker) <= 4] != [2] * 4:
        sys.exit("the plex has not the sides of the square")
