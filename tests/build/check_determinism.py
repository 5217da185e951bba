# SPDX-License-Identifier: MIT
"""No elementary function of the C library and no long double: their last places differ from machine
to machine. core/elementary.hpp has what is needed instead."""
import re

import sources

# Matches functions whose results differ between machines. sqrt, fma, ldexp, frexp and rounding are exact or correctly
# rounded everywhere, and allowed.
DIFFERS = re.compile(r"\b(?:std::)(a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p)?|pow|cbrt|hypot|"
                     r"erfc?|[lt]gamma|beta)\s*\(|\blong double\b")


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)


def main():
    top = sources.root()
    paths = sources.files(top, sources.FOLDERS, sources.CODE)
    problems = []
    for path in paths:
        for match in DIFFERS.finditer(without_comments((top / path).read_text(encoding="utf-8"))):
            problems.append(f"{path}: {match.group(0)}: not the same bits on every machine; "
                            "use core/elementary.hpp")
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
