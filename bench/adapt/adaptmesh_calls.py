# SPDX-License-Identifier: MIT
"""Rewrites the calls of adaptmesh in a script of FreeFEM as calls of asterism.idp, as the manual's page freefem.md
says: all fields in one pair of brackets, how many are a vector each in "vectors", options separated by semicolons.

  adaptmesh_calls.py SCRIPT.edp > NEW.edp
"""
import pathlib
import re
import sys

CALL = re.compile(r"(?:(\w+)\s*=\s*)?\badaptmesh\s*\(")
OPTION = re.compile(r"(\w+)\s*=(?!=)\s*(.*)", re.DOTALL)


class CannotRewrite(Exception):
    """A call without a counterpart in asterism.idp."""


def without_comments(text):
    """Returns the text with comments replaced by as many blanks, so that positions stay."""
    def blanks(found):
        return re.sub(r"[^\n]", " ", found.group())
    return re.sub(r"//[^\n]*|/\*.*?\*/", blanks, text, flags=re.DOTALL)


def end_of_call(text, start):
    """Returns the position of the bracket that closes the one before start."""
    depth = 1
    for at in range(start, len(text)):
        depth += (text[at] in "([") - (text[at] in ")]")
        if depth == 0:
            return at
    raise CannotRewrite("a call of adaptmesh does not end")


def parts_of(text):
    """Returns the parts between the commas that are outside of all brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def fields_of(parts):
    """Returns the expressions of all fields, each component of a vector by itself."""
    fields = []
    for part in parts:
        fields += parts_of(part[1:-1]) if part.startswith("[") else [part]
    return fields


def sizes_of_vectors(parts):
    """Returns the numbers of components of the fields as asterism.idp takes them, "2 1"; "" where all are scalars."""
    sizes = [len(fields_of([part])) for part in parts]
    return '"' + " ".join(map(str, sizes)) + '"' if max(sizes, default=1) > 1 else ""


def pairs_of_sides(text, value):
    """Returns the labels of adaptmesh's periodic as "4,2 1,3". The argument is an array or the name of one."""
    named = re.search(r"\bfunc\s+" + re.escape(value) + r"\s*=\s*(\[.*?\]\s*\])\s*;", text)
    labels = re.findall(r"\[\s*(\d+)\s*,", named.group(1) if named else value)
    if not labels or len(labels) % 2:
        raise CannotRewrite(f"no pairs of labels in periodic = {value}")
    return '"' + " ".join(f"{a},{b}" for a, b in zip(labels[::2], labels[1::2])) + '"'


def rewritten(text, target, arguments):
    """Returns the line for one call, and the names of variables that are equal to their option's name."""
    mesh, *rest = parts_of(arguments)
    options = [found for found in map(OPTION.fullmatch, rest) if found]
    given = [part for part in rest if not OPTION.fullmatch(part)]
    fields, vectors = fields_of(given), sizes_of_vectors(given)
    if target != mesh:
        raise CannotRewrite(f"adaptmesh of {mesh} is not assigned to {mesh}")
    words, taken, measured = [], set(), ""
    for name, value in (found.groups() for found in options):
        if name == "periodic":
            value = pairs_of_sides(text, value)
        if name == "metric":
            measured = f"adaptmesh({arguments}, nomeshgeneration = true); "
            fields = [part.removesuffix("[]") for part in fields_of([value])]
            words, vectors = ["IsMetric = 1"], ""
            break
        if re.search(rf"\b{name}\b", value):
            taken.add(name)
        words.append(f"{name} = {value}")
    if vectors and not any(word.startswith("IsMetric") for word in words):
        words.append(f"vectors = {vectors}")
    listed = fields[0] if len(fields) == 1 else f"[{', '.join(fields)}]"
    return f"{measured}asterismadapt({mesh}, {listed}, {'; '.join(words)})", taken


def rewrite(text):
    """Returns the script with asterism.idp, and how many calls were rewritten."""
    plain, made, done, calls, renamed = without_comments(text), "", 0, 0, set()
    for found in CALL.finditer(plain):
        end = end_of_call(plain, found.end())
        arguments = plain[found.end():end]
        if "nomeshgeneration" in arguments:
            continue
        line, taken = rewritten(plain, found.group(1), arguments)
        semicolon = re.compile(r"\s*;?").match(plain, end + 1).end()
        made += text[done:found.start()] + line
        done, calls, renamed = semicolon, calls + 1, renamed | taken
    made += text[done:]
    for name in sorted(renamed):
        made = re.sub(rf"\b{name}\b(?!\s*=\s*{name}\b)", "my" + name, made)
        made = re.sub(rf"\b{name}(\s*=\s*){name}\b", rf"{name}\1my{name}", made)
    return 'include "asterism.idp"\n' + made, calls


if __name__ == "__main__":
    print(rewrite(pathlib.Path(sys.argv[1]).read_text(encoding="latin-1"))[0], end="")
