# SPDX-License-Identifier: MIT
#
# Our .mesh and .sol, read by FreeFEM: it must find the very numbers written.
# Usage: read_with_freefem.py PROGRAM FREEFEM, where PROGRAM is the write_sample executable.

import pathlib
import subprocess
import sys
import tempfile

SCRIPT = """
mesh Th = readmesh("sample.mesh");
cout.precision(17);
for (int i = 0; i < Th.nv; i++) cout << "SITE " << Th(i).x << " " << Th(i).y << endl;
for (int t = 0; t < Th.nt; t++)
  cout << "TRIANGLE " << Th[t][0] << " " << Th[t][1] << " " << Th[t][2] << endl;
for (int e = 0; e < Th.nbe; e++) cout << "MARKER " << Th.be(e).label << endl;
ifstream sol("sample.sol");
string word;
int number, count;
sol >> word; sol >> number; sol >> word; sol >> number; sol >> word; sol >> count;
sol >> number; sol >> number;
for (int i = 0; i < count; i++) {
  real a, b, c;
  sol >> a; sol >> b; sol >> c;
  cout << "TENSOR " << a << " " << b << " " << c << endl;
}
"""


def rows(text, kind, convert):
    found = [line.split()[1:] for line in text.splitlines() if line.startswith(kind + " ")]
    return [[convert(word) for word in row] for row in found]


def main():
    program, freefem = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        subprocess.run([program, directory], check=True)
        (directory / "read.edp").write_text(SCRIPT)
        done = subprocess.run(
            [freefem, "-nw", "-v", "0", "read.edp"],
            cwd=directory,
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        expected = (directory / "expected.txt").read_text()
    sites = rows(expected, "site", float.fromhex)
    assert rows(done.stdout, "SITE", float) == [s[:2] for s in sites]
    assert rows(done.stdout, "TENSOR", float) == [s[2:] for s in sites]
    assert rows(done.stdout, "TRIANGLE", int) == rows(expected, "triangle", int)
    markers = [row[2:] for row in rows(expected, "edge", int)]
    assert sorted(rows(done.stdout, "MARKER", int)) == sorted(markers)
    print(f"FreeFEM found {len(sites)} vertices with their tensors, triangles and edges as written")


main()
