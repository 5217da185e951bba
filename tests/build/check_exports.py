# SPDX-License-Identifier: MIT
"""Checks that what the public headers declare is marked ASTERISM_EXPORT, or the shared libraries would hide it:
functions outside classes, and classes with functions that are defined elsewhere."""
import re

import sources

INLINE = r"(?:inline|constexpr|template|using|namespace|typedef|struct|enum|static|extern \"C\"|friend)\b"
FUNCTION = re.compile(rf"^(?!{INLINE}|ASTERISM_|#|//| |\}}|/\*)[\w:<>,&*\[\] ]+\(")
# Matches a class. A class is marked as a whole; the functions of a struct are marked one by one.
CLASS = re.compile(r"^class (?!ASTERISM_EXPORT)(\w+)(?!.*;)")


# True if the class that begins here has a function without a body, which a source file defines.
def has_function_elsewhere(after):
    body = after[:after.index("};")]
    return any(re.search(r"\)( const)?( noexcept)?;$", line) for line in body)


def problems_of(top, header):
    lines = (top / header).read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        before = lines[number - 2] if number > 1 else ""
        template = before.startswith("template") or line.startswith("class [[nodiscard]]")
        if template or (FUNCTION.match(before) and not before.rstrip().endswith((";", "}"))):
            continue
        if FUNCTION.match(line) or (CLASS.match(line) and has_function_elsewhere(lines[number:])):
            yield f"{header}:{number}: not marked ASTERISM_EXPORT: {line.strip()}"


def main():
    top = sources.root()
    listed = (top / "cmake/public_headers.txt").read_text(encoding="utf-8").splitlines()
    headers = [line for line in listed if line and not line.startswith("#")]
    sources.finish([p for h in headers for p in problems_of(top, h)], len(headers))


if __name__ == "__main__":
    main()
