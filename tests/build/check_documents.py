# SPDX-License-Identifier: MIT
"""What the documents name exists: relative links in every Markdown file, and the README's scripts,
of which the continuous integration runs the one that tests."""
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
    sources.finish(problems + list(readme_scripts(top)), len(paths))


if __name__ == "__main__":
    main()
