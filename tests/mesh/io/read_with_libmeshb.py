# SPDX-License-Identifier: MIT
"""Our .meshb and .solb, read by libMeshb, which finds the very numbers written; and what libMeshb writes
of them, in all its versions, read by our command.
read_with_libmeshb.py COMMAND PRELOADED HOST: PRELOADED is preloaded_libmeshb.c, compiled, and HOST a program
that contains libMeshb and exports it. Status 77, skipped, where it does not."""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

DOMAIN = """5 2 0 0
1 0 0
2 2 0.1
3 2 1
4 0 1
5 1 0
6 1
1 1 5 11
2 5 2 12
3 2 3 13
4 3 4 0
5 4 1 -5
6 3 5 6
0
2
1 0.5 0.25 1
2 1.9 0.4 -2
"""


def run(*command, **options):
    return subprocess.run([str(c) for c in command], text=True, capture_output=True, timeout=120, check=False,
                          **options)


def numbers_of(path, section, columns, convert):
    """Returns the rows of a section of one of the command's text files."""
    words = iter(path.read_text(encoding="ascii").split("\n"))
    for line in words:
        if line == section:
            count = int(next(words))
            if section == "SolAtVertices":
                next(words)
            return [[convert(x) for x in next(words).split()[:columns]] for _ in range(count)]
    return []


def rounded(rows):
    """Returns the numbers rounded to floats."""
    return [[struct.unpack("f", struct.pack("f", x))[0] for x in row] for row in rows]


def main():
    command, preloaded, host = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "d.poly").write_text(DOMAIN, encoding="ascii")
        made = run(command, "mesh", "d.poly", "--metric", "swirl:6", "--size", "0.4", "-o", "m.mesh", "-o", "m.meshb",
                   cwd=folder)
        assert made.returncode == 0, made.stderr
        for version in "1234":
            there = run(host, cwd=folder, env={**os.environ, "LD_PRELOAD": preloaded, "LIBMESHB_FROM": "m",
                                               "LIBMESHB_TO": "l" + version, "LIBMESHB_VERSION": version})
            if there.returncode == 77:
                print(there.stderr)
                return 77
            assert there.returncode == 0, there.stdout + there.stderr
            found = [line.split() for line in there.stdout.splitlines()]
            places = numbers_of(folder / "m.mesh", "Vertices", 2, float)
            tensors = numbers_of(folder / "m.sol", "SolAtVertices", 3, float)
            assert [[float.fromhex(x) for x in f[1:3]] for f in found if f[0] == "vertex"] == places
            assert [[float.fromhex(x) for x in f[1:]] for f in found if f[0] == "tensor"] == tensors
            for section, word, columns in (("Triangles", "triangle", 4), ("Edges", "edge", 3),
                                           ("RequiredVertices", "required", 1)):
                expected = numbers_of(folder / "m.mesh", section, columns, int)
                assert expected and [[int(x) for x in f[1:]] for f in found if f[0] == word] == expected, section
            again = run(command, "certify", f"l{version}.meshb", "-o", "again.mesh", "--all-edges", cwd=folder)
            assert again.returncode == 0, version + again.stdout + again.stderr
            read = [numbers_of(folder / "again.mesh", "Vertices", 2, float),
                    numbers_of(folder / "again.sol", "SolAtVertices", 3, float)]
            assert read == ([rounded(places), rounded(tensors)] if version == "1" else [places, tensors]), version
            assert numbers_of(folder / "again.mesh", "Triangles", 4, int) == \
                numbers_of(folder / "m.mesh", "Triangles", 4, int)
    print(f"libMeshb read {len(places)} vertices with their tensors as written, and wrote them back in 4 versions")
    return 0


sys.exit(main())
