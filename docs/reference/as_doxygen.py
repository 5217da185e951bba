#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints a header with its comments as Doxygen reads them, line by line: `//` becomes `///`, behind a
declaration `///<`, and the comment at the top describes the file. Headers keep to plain comments."""
import re
import sys

LICENCE = re.compile(r"SPDX-License-Identifier|\bNOLINT|IWYU pragma")


def escaped(text):
    """The words as words: none of these characters is a command here."""
    return re.sub(r"([@\\<>#])", r"\\\1", text).replace("&", "\\&")


def split_comment(line):
    """(code, comment text or None); a // within a string does not begin a comment."""
    found = re.match(r'((?:[^"/]|"(?:\\.|[^"\\])*"|/(?![/*]))*)//(.*)$', line)
    return (found.group(1), found.group(2)) if found else (line, None)


def lines_with_marks(lines):
    column, before_code = None, True  # where the comment behind the last declaration began
    started = False
    for line in lines:
        code, text = split_comment(line)
        if text is not None and LICENCE.search(text):
            yield code.rstrip()
            continue
        if text is None:
            column = None
            before_code = before_code and not line.strip()
            yield line
        elif code.strip():
            column, before_code = len(code), False
            yield f"{code}///<{escaped(text)}"
        elif column == len(code):
            yield f"{code}///<{escaped(text)}"
        else:
            column = None
            first = before_code and not started
            started = started or before_code
            yield f"{code}///{' @file' if first else ''}{escaped(text)}"


def of_c(text):
    """C comments: the one at the top describes the file."""
    count = 0

    def marked(found):
        nonlocal count
        count += 1
        body = found.group(1)
        if LICENCE.search(body):
            body = re.sub(r".*SPDX[^\n]*", "", body)
            if not body.replace("*", "").strip() or count > 1:
                return " " + "\n" * found.group().count("\n")
        return f"/**{' @file' if count == 1 else ''}{escaped(body)}*/"

    return re.sub(r"/\*(.*?)\*/", marked, text, flags=re.DOTALL)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    if sys.argv[1].endswith(".h"):
        print(of_c(text), end="")
    else:
        print("\n".join(lines_with_marks(text.splitlines())))


if __name__ == "__main__":
    main()
