# SPDX-License-Identifier: MIT
"""Compares what a shared library exports with the list kept for it: nothing of the library may
vanish or appear unnoticed.  check_symbols.py LIBRARY LIST [--write]"""
import pathlib
import subprocess
import sys


def exported(library):
    table = subprocess.run(["nm", "-D", "-C", "--defined-only", library], check=True, text=True,
                           stdout=subprocess.PIPE).stdout
    for line in table.splitlines():
        kind, name = line.split(" ", 2)[1:]
        if kind != "A":  # the name of the version itself
            yield name


def main():
    library, kept = sys.argv[1], pathlib.Path(sys.argv[2])
    found = sorted(set(exported(library)))
    if sys.argv[3:] == ["--write"]:
        kept.write_text("\n".join(found) + "\n", encoding="utf-8")
        return 0
    wanted = kept.read_text(encoding="utf-8").splitlines()
    for name in sorted(set(wanted) - set(found)):
        print(f"missing: {name}")
    for name in sorted(set(found) - set(wanted)):
        print(f"not in {kept.name}: {name}")
    return int(found != wanted)


if __name__ == "__main__":
    sys.exit(main())
