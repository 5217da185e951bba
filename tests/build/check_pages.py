# SPDX-License-Identifier: MIT
"""Every page of docs can be reached from the README by links, every file that a page names without
its folder exists, and so does every folder of the layer list, with a line in CONTRIBUTING."""
import re

import sources

ENDINGS = "hpp|cpp|py|md|h|js|sh|idp"


def prose(page):
    return re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def pages_linked_from(page):
    for target in re.findall(r"\]\(([^)#\s]+\.md)[^)]*\)", prose(page)):
        linked = (page.parent / target).resolve()
        if "://" not in target and linked.exists():
            yield linked


def reachable_from(start):
    found, waiting = {start}, [start]
    while waiting:
        new = set(pages_linked_from(waiting.pop())) - found
        found |= new
        waiting += new
    return found


def unreachable_pages(top):
    # The main page of the API reference is Doxygen's.
    pages = set((top / "docs").rglob("*.md")) - {top / "docs/reference/main_page.md"}
    for page in sorted(pages - reachable_from(top / "README.md")):
        yield f"{page.relative_to(top)} cannot be reached from README.md by links"


def names_of_no_file(top, pages):
    files = sources.files(top, [*sources.FOLDERS, "tests", "docs", "bench", "examples", "python"],
                          {"." + ending for ending in ENDINGS.split("|")})
    names = {path.name for path in files} | {path.name for path in top.glob("*")}
    for page in pages:
        # A name with a colon after it introduces a file that the page itself holds.
        for name in re.findall(rf"`([\w-]+\.(?:{ENDINGS}))`(?!:)", prose(page)):
            if name not in names:
                yield f"{page.relative_to(top)}: names {name}, which does not exist"


def missing_folders(top):
    contributing = (top / "CONTRIBUTING.md").read_text(encoding="utf-8")
    for folder in sources.LAYERS:
        if not (top / folder).is_dir():
            yield f"tests/build/sources.py: no folder {folder}"
        if f"    {folder}/" not in contributing:
            yield f"CONTRIBUTING.md: no line for {folder}/"
    for folder in re.findall(r"^    ([a-z_/]+)/ ", contributing, flags=re.MULTILINE):
        if not (top / folder).is_dir():
            yield f"CONTRIBUTING.md: no folder {folder}"


def main():
    top = sources.root()
    pages = [page for page in [*sorted(top.glob("*.md")), *sorted((top / "docs").rglob("*.md"))]
             if page.name != "CHANGELOG.md"]
    problems = [*unreachable_pages(top), *names_of_no_file(top, pages), *missing_folders(top)]
    sources.finish(problems, len(pages))


if __name__ == "__main__":
    main()
