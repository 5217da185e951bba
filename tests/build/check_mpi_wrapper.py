# SPDX-License-Identifier: MIT
"""A wrapper of the compiler without MPI's headers, as FreeFEM's package brings it, is no MPI, and no
error: FindMPI of CMake ends the configuration there.

    check_mpi_wrapper.py SOURCE BINARY CMAKE
"""
import os
import pathlib
import shutil
import subprocess
import sys

source, binary, cmake = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
shutil.rmtree(binary, ignore_errors=True)
(binary / "programs").mkdir(parents=True)
wrapper = binary / "programs" / "mpicxx"
# Answers where MPI's headers would be: in a folder that does not exist.
wrapper.write_text('#!/bin/sh\ncase "$1" in -show*) echo "-I/nowhere/include -L/nowhere/lib -lmpi";; *) exit 1;; esac\n')
wrapper.chmod(0o755)
(binary / "CMakeLists.txt").write_text(
    "cmake_minimum_required(VERSION 3.16)\nproject(host CXX)\n"
    f'list(PREPEND CMAKE_MODULE_PATH "{source}/cmake")\ninclude(AsterismMpi)\nasterism_find_mpi()\n'
    'message(STATUS "MPI_CXX_FOUND: ${MPI_CXX_FOUND}")\n')
done = subprocess.run([cmake, "-G", "Ninja", "-S", binary, "-B", binary / "build"], capture_output=True, text=True, check=False,
                      env={**os.environ, "PATH": f"{binary / 'programs'}:{os.environ['PATH']}"})
said = done.stdout + done.stderr
if done.returncode != 0 or f"No MPI: {wrapper} does not find mpi.h" not in said or "MPI_CXX_FOUND: \n" not in said:
    sys.exit(said)
