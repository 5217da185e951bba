# SPDX-License-Identifier: MIT
"""The gallery's commands work as they stand, and its page shows them and what they say: scripts/make-gallery writes it
again, to the byte.  gallery.py ASTERISM FOLDER."""
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]


def main():
    command, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, TOP / "scripts/make-gallery", command, folder], check=True, timeout=600)
    pages = [(place / "README.md").read_text(encoding="utf-8") for place in (TOP / "docs/gallery", folder)]
    if pages[0] != pages[1]:
        sys.exit("docs/gallery is not what scripts/make-gallery makes")
    if pages[1].count("> certified: ") != pages[1].count("!["):
        sys.exit("a mesh of the gallery is not certified")
    for name in re.findall(r"\]\((\w+\.png)\)", pages[1]):
        if not (TOP / "docs/gallery" / name).is_file():
            sys.exit(f"{name} is missing")


if __name__ == "__main__":
    main()
