# SPDX-License-Identifier: MIT
"""The project's own files, for the tests that read them: build trees are left out."""
import pathlib
import re
import sys

# Folders from bottom to top: each may include itself and those before it.
LAYERS = ["core", "predicates", "kernels", "challenge", "mesh/support", "mesh/data", "mesh/search",
          "mesh/numerics", "mesh/gradation", "mesh/domain", "mesh/metric", "mesh/stars", "mesh/fill", "mesh/refine",
          "mesh/adapt", "mesh/solution", "mesh/transfer",
          "mesh/audit", "mesh/surface_audit", "mesh/proof", "mesh/draw", "mesh/io", "mesh/surface_io", "mesh/delivery",
          "mesh/pipeline", "mesh/claims",
          "mesh/surface", "mesh/pieces", "mesh/c_interface", "mesh",
          "apps/base", "apps/help", "apps/options", "apps/run", "apps/text", "apps/job", "apps/pieces", "apps/verify",
          "apps/adapt", "apps/commands",
          "apps"]
FOLDERS = ["core", "predicates", "kernels", "challenge", "mesh", "apps"]  # with all subfolders
CODE = {".hpp", ".cpp", ".h", ".c"}


def root():
    """Returns the project's folder: the first argument, or else the folder above this file's."""
    given = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]
    return pathlib.Path(given).resolve()


def files(top, folders, suffixes):
    """Returns paths relative to `top`, sorted, of the files below `folders` with one of `suffixes`."""
    found = []
    for folder in folders:
        found += [p for p in (top / folder).rglob("*") if p.suffix in suffixes and p.is_file()]
    return sorted(p.relative_to(top) for p in found)


def includes(path):
    """Returns the names in the file's #include lines, as written, without quotes or brackets."""
    pattern = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
    return pattern.findall(path.read_text(encoding="utf-8"))


def own_includes(top, path):
    """Yields paths relative to `top` of the project's files that this file includes itself."""
    for name in includes(top / path):
        if name.startswith("asterism/"):
            name = name.removeprefix("asterism/")
        else:
            name = (path.parent / name).as_posix()
        if (top / name).is_file():
            yield name


def public_headers(top):
    """Returns the headers that are installed, listed in cmake/public_headers.txt."""
    lines = (top / "cmake/public_headers.txt").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def finish(problems, checked):
    """Ends the test: prints each problem on a line of its own, or else how many files were checked."""
    for problem in problems:
        print(problem)
    if not checked:
        sys.exit("no files found: is the folder right?")
    sys.exit(1 if problems else print(f"{checked} files, no problem"))
