# SPDX-License-Identifier: MIT
"""Distributed meshes of PETSc, under mpirun. Skipped where petsc4py, mpi4py or mpirun are not installed."""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

for needed, package in (("petsc4py", "python3-petsc4py"), ("mpi4py", "python3-mpi4py")):
    if importlib.util.find_spec(needed) is None:
        pytest.skip(f"{needed} is not installed ({package})", allow_module_level=True)
if shutil.which("mpirun") is None:
    pytest.skip("mpirun is not installed (openmpi-bin)", allow_module_level=True)

RUN = pathlib.Path(__file__).parent / "plex_run.py"


def ended(processes, *job):
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
    return subprocess.run(["mpirun", "-n", str(processes), "--bind-to", "none", sys.executable, "-W", "ignore", str(RUN),
                           *job], env=environment, capture_output=True, text=True, timeout=600)


def run(processes, *job):
    done = ended(processes, *job)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(done.stdout.strip().splitlines()[-1])


def on_square(places):
    return all(0 in p or 1 in p for p in places)


def test_the_same_mesh_on_any_number_of_processes():
    alone = run(1, "adapt")
    assert alone["reached"] and abs(alone["vertices"] / 700 - 1) < 0.03
    assert alone["areas"] == pytest.approx({"Cell Sets 5": 0.5, "Cell Sets 6": 0.5})
    assert alone["lengths"] == pytest.approx({"Face Sets 1": 1, "Face Sets 2": 1, "Face Sets 3": 1, "Face Sets 4": 1,
                                              "Face Sets 9": 0.5, "marker 1": 4})
    assert alone["probe"] == [[3 / 14, 4 / 14]] and len(alone["marked"]) > 20 and on_square(alone["marked"])
    for processes in (2, 3, 4):
        several = run(processes, "adapt")
        share = several.pop("share")
        assert {**several, "share": alone["share"]} == alone, processes
        assert max(share) - min(share) <= 1 and sum(share) == alone["share"][0]
    overlapped = run(3, "adapt", "overlap")
    assert overlapped["digest"] == alone["digest"]


def test_the_same_mesh_in_blocks_for_any_number_of_threads():
    alone = run(1, "blocks", "1")
    assert alone["certified"] and alone["vertices"] > 5000
    for processes, threads in ((1, "7"), (2, "2"), (3, "7"), (4, "2")):
        assert run(processes, "blocks", threads) == alone


def test_a_mesh_that_is_on_one_process_alone():
    assert run(3, "undistributed")["digest"] == run(1, "adapt")["digest"]


def test_a_metric_as_rows_and_as_a_vector():
    alone, several = run(1, "metric"), run(3, "metric")
    assert alone["digest"] == alone["same"] == several["digest"] == several["same"]
    assert alone["isotropic"] == alone["by tensors"] == several["isotropic"] == several["by tensors"]


def test_tensors_at_the_vertices_are_gathered_too():
    alone, several = run(1, "tensors"), run(3, "tensors")
    assert alone == several
    assert alone["hessian"] == alone["named"] and alone["intersect"] == alone["array"] == alone["callables"]
    assert alone["tensors"] == alone["texts"] and alone["list"] == alone["stack"]
    assert abs(alone["sizes"] / 300 - 1) < 0.03 and alone["left"] == alone["right"] and len(alone["left"]) > 5


def test_edges_are_numbered_as_petsc_numbers_them():
    for processes in (1, 2):
        assert run(processes, "built") == {"points": 76, "same": True}


def test_an_error_on_one_process_is_one_on_all():
    told = run(3, "errors")["told"]
    assert told[0] == told[1] == told[2]
    first, indefinite, second, third, fourth, named, wide, fifth = told[0]
    assert indefinite.startswith("InputError: metric: row 0, 1 2 1, is not") and "(process 2)" in indefinite
    assert "a: process 2 and process 0 give different fields" in named
    assert "values: process 2 and process 0 give different fields" in wide
    assert first.startswith("InputError: metric") and "(process 2)" in first
    assert second.startswith("InputError: vertices") and "several values" in third
    assert fourth.startswith("InputError: T: row ") and "is not finite (process 2)" in fourth
    assert fifth.startswith("ZeroDivisionError")


def test_an_exception_of_the_program_ends_all():
    for how, status in (("raise", 1), ("exit", 3)):
        done = ended(2, "fails", how)
        assert done.returncode == status, done.stdout + done.stderr
    assert "ZeroDivisionError" in ended(2, "fails", "raise").stderr
    alone = ended(1, "fails", "raise")
    assert alone.returncode != 0 and "ABORT" not in alone.stderr


def test_the_page_of_the_manual_runs():
    assert run(1, "page")["reached"] and run(2, "page")["reached"]
