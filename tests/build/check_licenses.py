# SPDX-License-Identifier: MIT
"""Every source names its licence, and the library includes no header of CGAL, most of which is under
the GPL and would bind those who embed it."""
import sources

OWN = "SPDX-License-Identifier: MIT"
FOLDERS = sources.FOLDERS + ["tests", "bench", "examples", "scripts", "docs", "formal"]


def own_licence_problems(top):
    for path in sources.files(top, FOLDERS, sources.CODE | {".py", ".sh", ".v"}):
        head = (top / path).read_text(encoding="utf-8").splitlines()[:2]
        lines = head if path.suffix in {".py", ".sh"} else head[:1]  # a script may start with #!
        if not any(OWN in line for line in lines):
            yield f"{path}: no '{OWN}' in its first line"


def cgal_problems(top, paths):
    for path in paths:
        for header in sources.includes(top / path):
            if header.startswith("CGAL/"):
                yield f"{path}: {header}; CGAL is for tests and benchmarks alone"


def main():
    top = sources.root()
    paths = sources.files(top, sources.FOLDERS, sources.CODE)
    problems = list(own_licence_problems(top)) + list(cgal_problems(top, paths))
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
