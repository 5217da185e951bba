# SPDX-License-Identifier: MIT
"""check_one_thread.py PROJECT WORK CMAKE COMPILER: without ASTERISM_THREADS nothing looks for oneTBB or links it, and
what uses it compiles with what stands in for it. Compiled are as few sources as reach each file that includes
oneTBB's headers, by includes of the project's own. oneTBB's own headers are kept from being found."""
import functools
import json
import pathlib
import subprocess
import sys

import sources

TOP = sources.root()


@functools.cache
def reached(path):
    """Returns the file and all of the project's own files that it includes, directly or not."""
    return {path}.union(*(reached(pathlib.Path(name)) for name in sources.own_includes(TOP, path)))


def uses_threads(path):
    return any(name.startswith("tbb/") for name in sources.includes(TOP / path))


def sources_of_users(paths):
    """Chooses sources one by one, each time the source that reaches the most files not yet reached."""
    left = {user for user in set().union(*map(reached, paths)) if uses_threads(user)}
    if not left:
        sys.exit("no source reaches oneTBB's headers: is the pattern right?")
    chosen = []
    while left:
        chosen.append(max(paths, key=lambda path: (len(reached(path) & left), -len(reached(path)))))
        left -= reached(chosen[-1])
    return chosen


def main():
    work, cmake, compiler = pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
    build = work / "build"
    configure = [cmake, "-S", TOP, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", "-DASTERISM_THREADS=OFF",
                 "-DASTERISM_BUILD_TESTS=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    if "tbb" in (build / "build.ninja").read_text().replace("one_thread/tbb", ""):
        sys.exit("build.ninja names oneTBB")
    commands = {pathlib.Path(entry["file"]): entry for entry in json.loads((build / "compile_commands.json").read_text())}
    chosen = sources_of_users([file.relative_to(TOP) for file in commands if file.is_relative_to(TOP)])
    for entry in (commands[TOP / path] for path in chosen):  # -MD lists the headers that are read; -M would not compile
        words = entry["command"].split()
        words = words[:words.index("-o")] + ["-fsyntax-only", "-MD", "-MF", str(work / "read.d"), "-c", entry["file"]]
        subprocess.run(words, cwd=entry["directory"], check=True)
        read = (work / "read.d").read_text()
        if "one_thread/tbb/serial.h" not in read or "/include/tbb" in read or "oneapi" in read:
            sys.exit(f"{entry['file']}: not what stands in for oneTBB was read")
    print(f"{len(chosen)} sources, no problem")


if __name__ == "__main__":
    main()
