# SPDX-License-Identifier: MIT
"""check_one_thread.py PROJECT WORK CMAKE COMPILER: without ASTERISM_THREADS nothing is linked for threads, the source
that begins them elsewhere begins none, and what depends on the definition compiles."""
import json
import pathlib
import subprocess
import sys

import sources

TOP = sources.root()
POOL = pathlib.Path("mesh/support/thread_pool.cpp")
DEFINITION = "ASTERISM_ONE_THREAD"


def main():
    work, cmake, compiler = pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
    build = work / "build"
    configure = [cmake, "-S", TOP, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", "-DASTERISM_THREADS=OFF",
                 "-DASTERISM_BUILD_TESTS=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_Threads=ON",
                 "-DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    if "pthread" in (build / "build.ninja").read_text():
        sys.exit("build.ninja names pthread")
    commands = {pathlib.Path(entry["file"]): entry for entry in json.loads((build / "compile_commands.json").read_text())}
    users = [file for file in commands if file.is_relative_to(TOP) and DEFINITION in file.read_text()]
    if TOP / POOL not in users:
        sys.exit(f"{POOL} does not depend on {DEFINITION}: is the pattern right?")
    for file in users:
        entry, made = commands[file], work / f"{file.stem}.o"
        words = entry["command"].split()
        words = words[:words.index("-o")] + ["-o", str(made), "-c", entry["file"]]
        subprocess.run(words, cwd=entry["directory"], check=True)
        names = subprocess.run(["nm", "-u", made], check=True, capture_output=True, text=True).stdout
        if "pthread_create" in names or "_M_start_thread" in names:
            sys.exit(f"{file.relative_to(TOP)} begins a thread")
    print(f"{len(users)} sources, no problem")


if __name__ == "__main__":
    main()
