# SPDX-License-Identifier: MIT
"""check_cmake_version.py PROJECT WORK CMAKE: what is configured of the predicates alone uses nothing that CMake 3.16 has not.

Configures them, with a trace of the commands as they are carried out, and looks for what came later in those of our
own files. The list has what such files are likely to use; a configuration by CMake 3.16 itself would prove it.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

OLDEST = (3, 16)
# Command, one of its arguments (or none), and the version of CMake that introduced it.
LATER = [
    ("block", None, (3, 25)), ("cmake_language", None, (3, 18)), ("cmake_path", None, (3, 20)),
    ("file", r"ARCHIVE_CREATE|ARCHIVE_EXTRACT|CONFIGURE", (3, 18)), ("file", r"REAL_PATH|CHMOD", (3, 19)),
    ("file", r"COPY_FILE", (3, 21)), ("string", r"HEX", (3, 18)), ("string", r"JSON", (3, 19)),
    ("foreach", r"ZIP_LISTS", (3, 17)), ("set_source_files_properties", r"DIRECTORY|TARGET_DIRECTORY", (3, 18)),
    ("set_property", r"TARGET_DIRECTORY", (3, 18)), ("target_sources", r"FILE_SET", (3, 23)),
    ("install", r"FILE_SET|CXX_MODULES_BMI", (3, 23)), ("install", r"RUNTIME_DEPENDENCY_SET", (3, 21)),
    ("find_library", r"REQUIRED", (3, 18)), ("find_path", r"REQUIRED", (3, 18)), ("find_file", r"REQUIRED", (3, 18)),
    ("find_program", r"REQUIRED", (3, 18)), ("find_package", r"GLOBAL", (3, 24)),
    ("execute_process", r"COMMAND_ERROR_IS_FATAL", (3, 19)), ("execute_process", r"COMMAND_ECHO", (3, 15)),
    ("configure_file", r"USE_SOURCE_PERMISSIONS|NO_SOURCE_PERMISSIONS", (3, 19)),
    ("if", r"PATH_EQUAL", (3, 24)), ("elseif", r"PATH_EQUAL", (3, 24)), ("return", r"PROPAGATE", (3, 25)),
    ("set_tests_properties", r"ENVIRONMENT_MODIFICATION", (3, 22)),
]
# Variables and generator expressions, in any argument, with the version that introduced them.
LATER_WORDS = [(r"PROJECT_IS_TOP_LEVEL", (3, 21)), (r"\$<PATH", (3, 24)), (r"\$<TARGET_RUNTIME_DLLS", (3, 21)),
               (r"\$<(HOST_LINK|DEVICE_LINK)", (3, 18)), (r"\$<LINK_(LIBRARY|GROUP)", (3, 24)),
               (r"CMAKE_CURRENT_FUNCTION", (3, 17)),
               (r"CMAKE_MESSAGE_(CONTEXT|INDENT)", (3, 17)), (r"CMAKE_FIND_PACKAGE_TARGETS_GLOBAL", (3, 24))]


def problems_of(entry):
    words, name = entry["args"], entry["cmd"].lower()
    for command, pattern, version in LATER:
        if name == command and version > OLDEST and (pattern is None or any(re.fullmatch(pattern, w) for w in words)):
            yield f"{command}({pattern or ''}) is CMake {version[0]}.{version[1]}'s"
    for pattern, version in LATER_WORDS:
        if version > OLDEST and any(re.search(pattern, w) for w in words):
            yield f"{pattern} is CMake {version[0]}.{version[1]}'s"


def main():
    top, work, cmake = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    trace = work / "trace.json"
    subprocess.run([cmake, "-G", "Ninja", "-S", top, "-B", work / "build", "-DASTERISM_BUILD_MESHER=OFF", "-DASTERISM_BUILD_TESTS=OFF",
                    "-DBUILD_SHARED_LIBS=ON", "--trace", "--trace-format=json-v1", f"--trace-redirect={trace}"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    found, files = set(), set()
    for line in trace.read_text(encoding="utf-8").splitlines()[1:]:
        entry = json.loads(line)
        path = pathlib.Path(entry["file"])
        if not path.is_relative_to(top) or path.is_relative_to(work.resolve()):
            continue
        files.add(path)
        found |= {f"{path.relative_to(top)}:{entry['line']}: {problem}" for problem in problems_of(entry)}
    if top / "kernels/CMakeLists.txt" not in files:
        found.add("the trace does not show kernels/CMakeLists.txt")
    for problem in sorted(found):
        print(problem)
    print(f"{len(files)} files, {len(found) or 'no'} problem{'' if len(found) == 1 else 's'}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
