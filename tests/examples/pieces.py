# SPDX-License-Identifier: MIT
"""Poisson on eight pieces: pieces.py PYTHON MPIRUN COMMAND EXAMPLES FOLDER. Skipped without PETSc."""
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
for ranks in (8, 3):
    told = subprocess.run(
        [mpirun, "--allow-run-as-root", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-n",
         str(ranks), python, f"{examples}/poisson_petsc.py", f"{folder}/pieces"],
        check=True, capture_output=True, text=True, timeout=400).stdout
    print(told, end="")
    found = re.search(r"(\d+) vertices \((\d+) in the index\), (\d+) triangles, area ([\d.]+), "
                      r"error ([\d.e+-]+)", told)
    if not found or found[1] != found[2] or abs(float(found[4]) - 4) > 1e-9:
        sys.exit("the pieces are not one mesh of the square")
    if not float(found[5]) < 1e-2:
        sys.exit("the error is too large")
