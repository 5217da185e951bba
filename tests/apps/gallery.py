# SPDX-License-Identifier: MIT
"""The gallery's commands work as they stand, and its page shows them: scripts/make-gallery writes it again, but
for the counts.  gallery.py ASTERISM FOLDER.  Exit status 77: skipped, no Pillow."""
import importlib.util
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
COUNTS = re.compile(r"^> .*$", re.MULTILINE)


def main():
    command, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    if importlib.util.find_spec("PIL") is None:
        print("skipped: no Pillow (Debian: python3-pil)")
        sys.exit(77)
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, TOP / "scripts/make-gallery", command, folder], check=True, timeout=600)
    pages = [(place / "README.md").read_text(encoding="utf-8") for place in (TOP / "docs/gallery", folder)]
    if COUNTS.sub("", pages[0]) != COUNTS.sub("", pages[1]):
        sys.exit("docs/gallery is not what scripts/make-gallery makes")
    if pages[1].count("> certified: ") != pages[1].count("!["):
        sys.exit("a mesh of the gallery is not certified")
    for name in re.findall(r"\]\((\w+\.png)\)", pages[1]):
        if not (TOP / "docs/gallery" / name).is_file() or not (folder / name).is_file():
            sys.exit(f"{name} is missing")


if __name__ == "__main__":
    main()
