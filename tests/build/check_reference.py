# SPDX-License-Identifier: MIT
"""The API reference is built without a warning, and every type, function, constant and header of it
is described. Members of a type may go without a comment.

  check_reference.py PROJECT DOXYGEN DOXYFILE WORK
"""
import pathlib
import re
import subprocess
import sys

import sources

MEMBER = re.compile(r"Member .* of (?:class|struct) \S+ is not documented")


def warnings(doxygen, doxyfile, work):
    changed = doxyfile.read_text(encoding="utf-8") + f"""
OUTPUT_DIRECTORY = {work}
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = NO
"""
    done = subprocess.run([doxygen, "-"], input=changed, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        yield f"{doxygen} ends with status {done.returncode}"
    for line in done.stderr.splitlines():
        if line.strip() and not MEMBER.search(line):
            yield line


def main():
    top = sources.root()
    doxygen, doxyfile, work = sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4])
    work.mkdir(parents=True, exist_ok=True)
    problems = list(warnings(doxygen, doxyfile, work))
    for header in sources.public_headers(top):
        page = header.rsplit("/", 1)[1].replace("_", "__").replace(".", "_8") + ".html"
        if not (work / "html" / page).is_file():
            problems.append(f"{header} is not in the reference")
    sources.finish(problems, len(sources.public_headers(top)))


if __name__ == "__main__":
    main()
