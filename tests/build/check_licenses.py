# SPDX-License-Identifier: MIT
"""Every source names its licence, and the library includes no CGAL header that would bind those who
embed it: each one included directly must be under the LGPL or a permissive licence."""
import pathlib
import re
import sys

import sources

OWN = "SPDX-License-Identifier: MIT"
FOLDERS = sources.FOLDERS + ["tests", "bench", "examples", "scripts", "docs"]
ALLOWED = ("LGPL-", "MIT", "BSL-1.0", "BSD-")


def own_licence_problems(top):
    for path in sources.files(top, FOLDERS, sources.CODE | {".py", ".sh"}):
        head = (top / path).read_text(encoding="utf-8").splitlines()[:2]
        lines = head if path.suffix in {".py", ".sh"} else head[:1]  # a script may start with #!
        if not any(OWN in line for line in lines):
            yield f"{path}: no '{OWN}' in its first line"


def licence_of(header, system):
    """What the header says of itself, or None if it is not found or says nothing."""
    for folder in system:
        path = pathlib.Path(folder) / header
        if path.is_file():
            text = path.read_text(encoding="utf-8", errors="replace")
            found = re.search(r"SPDX-License-Identifier:\s*(.+)", text)
            return found.group(1).strip() if found else None
    return None


def cgal_problems(top, paths, system):
    for path in paths:
        for header in sources.includes(top / path):
            if not header.startswith("CGAL/"):
                continue
            licence = licence_of(header, system)
            if licence is None or not licence.startswith(ALLOWED):
                yield f"{path}: {header} is under '{licence}'"


def main():
    top = sources.root()
    system = sys.argv[2:] or ["/usr/include", "/usr/local/include"]
    paths = sources.files(top, sources.FOLDERS, sources.CODE)
    problems = list(own_licence_problems(top)) + list(cgal_problems(top, paths, system))
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
