# SPDX-License-Identifier: MIT
"""check_one_thread.py PROJECT WORK CMAKE COMPILER: without ASTERISM_THREADS nothing looks for oneTBB or links it, and the
sources that use it compile with what stands in for it. oneTBB's own headers are kept from being found."""
import json
import pathlib
import subprocess
import sys


def uses_threads(path):
    text = path.read_text(encoding="utf-8")
    return "#include <tbb/" in text or "/support/parallel_for.hpp" in text


def main():
    top, work, cmake, compiler = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
    build = work / "build"
    configure = [cmake, "-S", top, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", "-DASTERISM_THREADS=OFF",
                 "-DASTERISM_BUILD_TESTS=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    if "tbb" in (build / "build.ninja").read_text().replace("one_thread/tbb", ""):
        sys.exit("build.ninja names oneTBB")
    commands = json.loads((build / "compile_commands.json").read_text())
    users = [entry for entry in commands if uses_threads(pathlib.Path(entry["file"]))]
    if len(users) < 5:
        sys.exit(f"{len(users)} sources include oneTBB's headers: is the pattern right?")
    for entry in users:  # -M lists the headers that are read
        words = entry["command"].split()
        words = words[:words.index("-o")] + ["-fsyntax-only", "-M", "-MF", str(work / "read.d"), "-c", entry["file"]]
        subprocess.run(words, cwd=entry["directory"], check=True)
        read = (work / "read.d").read_text()
        if "one_thread/tbb/serial.h" not in read or "/include/tbb" in read or "oneapi" in read:
            sys.exit(f"{entry['file']}: not what stands in for oneTBB was read")
    print(f"{len(users)} sources, no problem")


if __name__ == "__main__":
    main()
