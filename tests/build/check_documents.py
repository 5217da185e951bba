# SPDX-License-Identifier: MIT
"""Checks that what the documents name exists: relative links and files of the project in every Markdown file,
files in comments, and the README's scripts, of which the continuous integration runs the one that
tests. A page of docs/math that speaks of wedges, arcs, gaps or fans shows one. The table of the
angle theorem is the one that is proved."""
import os
import re

import sources


def documents(top):
    found = list(top.glob("*.md"))
    for folder in sources.FOLDERS + ["docs", "bench", "tests", "examples"]:
        found += (top / folder).rglob("*.md")
    return sorted(found)


def broken_links(top, document):
    text = re.sub(r"```.*?```", "", document.read_text(encoding="utf-8"), flags=re.DOTALL)
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", text):
        if "://" not in target and not (document.parent / target).exists():
            yield f"{document.relative_to(top)}: no {target}"


def is_there(top, name):
    """`name` is a path in the project, or below mesh/; with or without its ending, `*` and {a,b} allowed."""
    listed = re.fullmatch(r"(.*)\{(.*)\}(.*)", name)
    names = [f"{listed[1]}{one}{listed[3]}" for one in listed[2].split(",")] if listed else [name]
    places = [(folder, ending) for folder in ("", "mesh/") for ending in ("", ".hpp", ".cpp")]
    return all(any(any(top.glob(folder + one + ending)) for folder, ending in places) for one in names)


def missing_files(top, document):
    if document.name == "files_of_others.md":  # names files of other projects
        return
    first = {f.split("/")[0] for f in sources.FOLDERS} | {"tests", "scripts", "docs", "bench", "examples"}
    text = re.sub(r"```.*?```", "", document.read_text(encoding="utf-8"), flags=re.DOTALL)
    for name in re.findall(r"`([a-z_]+/[\w./{},*-]+)`", text):
        if name.split("/")[0] in first and not is_there(top, name.rstrip("/")):
            yield f"{document.relative_to(top)}: names {name}, which does not exist"


def files_in_comments(top, path):
    code = (top / path).read_text(encoding="utf-8")
    comments = " ".join(re.findall(r"//[^\n]*|/\*.*?\*/", code, flags=re.DOTALL))
    for name in re.findall(r"(?<![\w/])(?:[a-z_]+/)+[a-z_0-9-]+\.(?:hpp|cpp|md|h)\b", comments):
        if not is_there(top, name.removeprefix("asterism/")):
            yield f"{path}: a comment names {name}, which does not exist"


def pages_without_figure(top):
    words = re.compile(r"\b(wedged?|wedges|arcs?|gaps?|fans?)\b", re.IGNORECASE)
    for page in sorted((top / "docs/math").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        if words.search(text) and "](../figures/math/" not in text:
            yield f"{page.relative_to(top)}: no figure"


def numbers(text):
    return [float(n) for n in re.findall(r"\d+(?:\.\d+)?", text)]


def differences_of_angle_tables(top):
    """The page's table, as header, rows and entries, against theorem_table.hpp, which a test proves."""
    page = (top / "docs/math/angle-theorem.md").read_text(encoding="utf-8")
    code = (top / "mesh/audit/theorem_table.hpp").read_text(encoding="utf-8")
    rows = [numbers(row) for row in re.findall(r"^\| (?:sigma R \| R/lambda|0\.\d+ \|).*", page, re.MULTILINE)]
    ratios = numbers(re.search(r"ratios = \{([^}]*)\}", code)[1])
    variations = numbers(re.search(r"variations = \{([^}]*)\}", code)[1])
    angles = [numbers(row) for row in re.findall(r"^ +\{([\d., ]+)\},$", code, re.MULTILINE)]
    if rows != [ratios, *([v, *a] for v, a in zip(variations, angles))]:
        yield "docs/math/angle-theorem.md: the table is not that of mesh/audit/theorem_table.hpp"


def readme_scripts(top):
    named = re.findall(r"^    (scripts/\S+)", (top / "README.md").read_text(), flags=re.MULTILINE)
    for script in named:
        if not os.access(top / script, os.X_OK):
            yield f"README.md: {script} cannot be run"
    if "scripts/test" not in named or "scripts/test" not in (top / ".ci/run").read_text():
        yield "the README's test command is not what .ci/run runs"


def main():
    top = sources.root()
    paths = documents(top)
    problems = [p for document in paths for p in broken_links(top, document)]
    problems += [p for document in paths if document.name != "CHANGELOG.md"
                 for p in missing_files(top, document)]
    problems += [*pages_without_figure(top), *differences_of_angle_tables(top),
                 *readme_scripts(top)]
    code = sources.files(top, sources.FOLDERS, sources.CODE)
    problems += [p for path in code for p in files_in_comments(top, path)]
    sources.finish(problems, len(paths) + len(code))


if __name__ == "__main__":
    main()
