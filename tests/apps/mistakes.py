# SPDX-License-Identifier: MIT
"""Mistakes as people type them: each is answered by what is wrong and what to do about it, with exit status 2 and
nothing written. A few are no mistakes elsewhere and are understood (status 0), or are known after the run alone (1).

The patterns are of what to do: the option, the name, the range or the command that the answer must have. All are
searched for without regard to case.
"""
import re
import shlex
import unittest

import command
import more_mistakes
import newer_mistakes

PART = "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"
FILES = {
    "part.poly": PART,
    "two words.poly": PART,
    "open.poly": PART.replace("4 1\n1 1 2 1", "3 1\n1 1 2 1").replace("4 4 1 4\n", ""),
    "crossed.poly": PART.replace("2 2 3 2\n3 3 4 3\n4 4 1 4", "2 2 4 2\n3 4 3 3\n4 3 1 4"),
    "comma.poly": PART.replace("2 2 0\n", "2 2,0 0\n"),
    "index.poly": PART.replace("2 2 3 2", "2 2 7 2"),
    "short.poly": PART[:30],
    "points.poly": "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n0 0\n0\n",
    "space.poly": PART.replace("4 2 0 0", "4 3 0 0"),
    "empty.poly": "",
    "part.txt": PART,
    "part.dxf": "0\nSECTION\n",
    "part.stp": "ISO-10303-21;\n",
    "part.geo": "Point(1) = {0, 0, 0, 0.1};\n",
    "part.wkt": "POLYGON ((0 0, 2 0, 2 1, 0 1\n",
    "part.geojson": '{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1]]}',
    "tri.json": '{"type": "Triangle"}',
    "picture.png": "not a mesh",
    "notes.md": "# part\n",
    "tetra.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
    "patches.json": '{"patches": 3}',
    "not.proof": "not a proof",
    "hundred.txt": "left right\n" * 100,
}
NO_MESH = "MeshVersionFormatted 2\nDimension 2\n"

# Words after `asterism`, and the pattern that the answer matches.
MISTAKES = [
    # Commands
    ("mehs square -o x.mesh", "did you mean mesh"),
    ("mseh square -o x.mesh", "did you mean mesh"),
    ("verfy a.mesh", "did you mean verify"),
    ("certifiy a.mesh", "did you mean certify"),
    ("addapt a.mesh", "did you mean adapt"),
    ("plot a.mesh -o x.png", "here it is draw"),
    ("generate square", "here it is mesh"),
    ("refine a.mesh", "here it is adapt"),
    ("square -o x.mesh", "asterism mesh square"),
    ("part.poly", "asterism info part.poly"),
    ("-o x.mesh square", "--help"),
    ("--mesh square", "--help"),
    ("help mehs", "mesh|--help"),
    ("--verison", "version|--help"),
    # Options of other commands, and misspelt ones
    ("mesh square -hmax 0.1 -o x.mesh", "--size|--hmax"),
    ("mesh square --min-angle 30 -o x.mesh", "--angle-bound"),
    ("mesh square --minangle 30 -o x.mesh", "--angle-bound"),
    ("mesh part.poly -q30 -o x.mesh", "--angle-bound"),
    ("mesh part.poly -q -o x.mesh", "--quiet"),
    ("mesh part.poly -a0.1 -o x.mesh", "--size"),
    ("mesh part.poly -a.1 -o x.mesh", "--size"),
    ("mesh part.poly -pq30a0.1 -o x.mesh", "--help"),
    ("mesh square -hsiz 0.1 -o x.mesh", "--size"),
    ("mesh square --clmax 0.1 -o x.mesh", "--size"),
    ("mesh square --lc 0.1 -o x.mesh", "--size"),
    ("mesh square -hgrad 1.3 -o x.mesh", "--gradation"),
    ("mesh square -ar 30 -o x.mesh", "--help|--corner-angle"),
    ("mesh square -nt 2 -o x.mesh", "--threads"),
    ("mesh square -j 2 -o x.mesh", "--threads"),
    ("mesh square --out x.mesh", "-o"),
    ("mesh square --ouput x.mesh", "did you mean --output"),
    ("mesh square --sise 0.1 -o x.mesh", "did you mean --size"),
    ("mesh square --metrik swirl -o x.mesh", "did you mean --metric"),
    ("mesh square --thraeds 2 -o x.mesh", "did you mean --threads"),
    ("mesh square --angel-bound 20 -o x.mesh", "did you mean --angle-bound"),
    ("mesh square -size 0.1 -o x.mesh", "--size"),
    ("mesh square -o x.mesh --force", "is replaced"),
    ("mesh square -o x.mesh --overwrite", "is replaced"),
    ("mesh square -v -o x.mesh", "--json"),
    ("mesh square -V -o x.mesh", "--version"),
    ("mesh square -f vtu -o x.vtu", "names the format"),
    ("mesh square --format vtu -o x", "names the format"),
    ("mesh square -optim -o x.mesh", "ptim: unknown kind of file.*\\.mesh"),
    ("mesh square -nosurf -o x.mesh", "are kept"),
    ("mesh square -Y -o x.mesh", "are kept"),
    ("adapt a.mesh --solution u.sol --err 0.01 -o x.mesh", "--error"),
    ("adapt a.mesh --solution u.sol --nbvx 500 -o x.mesh", "--max-sites|--vertices"),
    ("adapt a.mesh --solution u.sol --vertexes 500 -o x.mesh", "did you mean --vertices"),
    ("adapt a.mesh u.sol --vertices 500 -o x.mesh", "--solution|--help"),
    # Missing
    ("mesh", "DOMAIN"),
    ("mesh square", "-o|--output"),
    ("mesh -o x.mesh", "DOMAIN"),
    ("mesh square --size -o x.mesh", "--size"),
    ("mesh square -o", "-o|--output"),
    ("mesh square -o x.mesh --metric", "--metric"),
    ("adapt a.mesh -o x.mesh", "--solution|--metric"),
    ("transfer a.mesh u.sol", "NEW|-o|--output"),
    ("verify", "MESH"),
    ("certify", "MESH"),
    ("draw a.mesh", "-o|--output"),
    ("info", "FILE"),
    ("metric a.mesh -o x.sol", "--solution"),
    ("convert a.mesh", "OUT"),
    ("challenge", "PROGRAM|COMMAND|--help"),
    # A required argument is named, and so is one too many
    ("check a.mesh", "usage: asterism check MESH PROOF --angle-bound B --metric SOL"),
    ("check a.mesh not.proof", "usage: asterism check MESH PROOF --angle-bound B --metric SOL"),
    ("deviation tetra.obj", "usage: asterism deviation MESH SURFACE"),
    ("surface torus -o x.obj", "usage: asterism surface SURFACE --chord D -o OUT"),
    ("surface torus --chord 0.1", "usage: asterism surface SURFACE --chord D -o OUT"),
    ("draw a.mesh x.png", "usage: asterism draw THING -o PICTURE"),
    ("convert a.mesh -o x.vtu", "usage: asterism convert IN OUT"),
    ("adapt a.mesh u.sol -o x.mesh", "no place for u\\.sol: adapt takes MESH alone.*usage: asterism adapt MESH -o OUT"),
    ("info a.mesh plain.mesh", "no place for plain\\.mesh: info takes FILE alone.*usage: asterism info FILE"),
    ("completion", "usage: asterism completion SHELL"),
    ("completion powershell", "bash,zsh,fish"),
    ("man nosuch", "mesh,verify"),
    # Beginnings of names, and names that other programs use
    ("adapt a.mesh --sol u.sol -o x.mesh", "did you mean --solution"),
    ("adapt a.mesh --solution u.sol --nv 100 -o x.mesh", "here it is --vertices"),
    ("adapt a.mesh --solution u.sol --target 100 -o x.mesh", "here it is --vertices"),
    ("transfer a.mesh u.sol plain.mesh --method nearest -o x.sol", "here it is --transfer"),
    ("surface torus --size 0.1 -o x.obj", "here it is --hmax.*--chord"),
    ("surface torus --tolerance 0.1 -o x.obj", "here it is --chord"),
    ("deviation tetra.obj torus --chord 0.1", "here it is --at-most"),
    # Surfaces
    ("surface torus --chord 0 -o x.obj", "must be positive"),
    ("surface sphere --chord 0.1 -o x.obj", "torus.*\\.json"),
    ("surface part.stp --chord 0.1 -o x.obj", "\\.json"),
    ("surface patches.json --chord 0.1 -o x.obj", 'a list "patches"'),
    ("surface torus --chord 0.1 -o x.off", "\\.obj.*\\.html"),
    ("deviation torus tetra.obj", "the surface comes last"),
    ("deviation a.mesh torus", "a mesh in space is wanted"),
    ("deviation tetra.obj torus --at-most -1", "must be positive"),
    ("draw tetra.obj -o x.png", "is a mesh in space, which `asterism deviation`"),
    ("info tetra.obj", "is a mesh in space"),
    ("convert tetra.obj x.vtu", "is a mesh in space"),
    ("certify tetra.obj", "is a mesh in space"),
    # Proofs
    ("check a.mesh not.proof --angle-bound 20 --metric swirl:3", "asterism convert MESH ASKED\\.mesh"),
    ("check not.proof a.mesh --angle-bound 20 --metric a.sol", "only \\.mesh"),
    # Files of another kind
    ("eval hundred.txt", "none of its first 20 lines is a record.*asterism help eval"),
    ("info nosuch", "no such file"),
    ("info folder", "directory"),
    ("draw u.sol -o x.png", "holds values.*the mesh itself is wanted"),
    ("transfer u.sol a.mesh plain.mesh -o x.sol", "holds values.*the mesh itself is wanted"),
    ("transfer a.mesh u.sol part.poly -o x.sol", "is a domain.*`asterism mesh` makes one"),
    ("adapt square --solution u.sol --vertices 100 -o x.mesh", "is a domain.*`asterism mesh` makes one"),
    ("verify -", "standard input.*convert"),
    ("frobnicate -", "there is no command 'frobnicate'"),
    ("help -", "there is no command '-'"),
    ("transfer a.mesh u.sol naca0012 -o x.sol", "is a domain.*`asterism mesh` makes one"),
    ("draw a.mesh -o -", "standard input.*convert"),
    # Numbers
    ("mesh square --size 0 -o x.mesh", "positive"),
    ("mesh square --size -1 -o x.mesh", "positive"),
    ("mesh square --size 0,1 -o x.mesh", "did you mean 0\\.1"),
    ("mesh square --size 3cm -o x.mesh", "not a number; it must be positive"),
    ("mesh square --size nan -o x.mesh", "finite|nan"),
    ("mesh square --size 1e-200 -o x.mesh", "from 1e-150"),
    ("mesh square --size 10% -o x.mesh", "not a number"),
    ("mesh square --angle-bound 80 -o x.mesh", "below 60"),
    ("mesh square --angle-bound 60 -o x.mesh", "below 60"),
    ("mesh square --angle-bound -5 -o x.mesh", "at least 0"),
    ("mesh square --angle-bound 0.5rad -o x.mesh", "not a number"),
    ("mesh square --max-sites 3 -o x.mesh", "4 vertices"),
    ("mesh square --max-sites 1e6 -o x.mesh", "1e6"),
    ("mesh square --threads 0 -o x.mesh", "1"),
    ("mesh square --threads -1 -o x.mesh", "1"),
    ("mesh square --threads many -o x.mesh", "--threads"),
    ("mesh square --gradation 1 -o x.mesh", "above 1"),
    ("mesh square --gradation 0.3 -o x.mesh", "above 1"),
    ("mesh square --tol 0 -o x.mesh", "--tol"),
    ("mesh square --max-seconds 0 -o x.mesh", "positive"),
    ("mesh square --random-points 1e3 -o x.mesh", "1e3"),
    ("mesh square --seed x -o x.mesh", "--seed"),
    ("mesh square --vertices 2 -o x.mesh", "from 3"),
    ("draw a.mesh -o x.png --width 5", "16"),
    ("adapt a.mesh --solution u.sol --vertices 0 -o x.mesh", "--vertices"),
    ("adapt a.mesh --solution u.sol --error 0 -o x.mesh", "positive"),
    ("adapt a.mesh --solution u.sol --vertices 100 --norm two -o x.mesh", "from 1 to 1e6, or inf"),
    ("adapt a.mesh --solution u.sol --vertices 100 --hmin 2 --hmax 1 -o x.mesh", "hmin|hmax"),
    ("adapt a.mesh --solution u.sol --vertices 100 --aspect 0.5 -o x.mesh", "aspect"),
    # Domains and their files
    ("mesh sqaure -o x.mesh", "square"),
    ("mesh circle -o x.mesh", "square.*airfoil|airfoil.*square"),
    ("mesh prat.poly -o x.mesh", "no such file|does not exist|part\\.poly"),
    ("mesh part -o x.mesh", "part\\.poly|ends in \\.poly"),
    ("mesh part.txt -o x.mesh", "\\.poly"),
    ("mesh part.dxf -o x.mesh", "read_dxf|\\.poly"),
    ("mesh part.stp -o x.mesh", "\\.poly"),
    ("mesh part.geo -o x.mesh", "\\.msh|\\.poly"),
    ("mesh folder -o x.mesh", "director|\\.poly"),
    ("mesh folder.poly -o x.mesh", "director|regular file"),
    ("mesh open.poly -o x.mesh", "--repair-domain|--convex-hull"),
    ("mesh crossed.poly -o x.mesh", "--repair-domain"),
    ("mesh points.poly -o x.mesh", "--convex-hull"),
    ("mesh comma.poly -o x.mesh", "comma\\.poly:3.*2,0"),
    ("mesh index.poly -o x.mesh", "index\\.poly:8.*7"),
    ("mesh short.poly -o x.mesh", "short\\.poly"),
    ("mesh space.poly -o x.mesh", "space\\.poly:1.*dimension"),
    ("mesh empty.poly -o x.mesh", "empty\\.poly"),
    ("mesh part.wkt -o x.mesh", "part\\.wkt:2"),
    ("mesh part.geojson -o x.mesh", "part\\.geojson:1"),
    ("mesh tri.json -o x.mesh", "tri\\.json"),
    ("mesh picture.png -o x.mesh", "\\.poly"),
    ("mesh - -o x.mesh", "standard input.*convert"),
    ("mesh /dev/stdin -o x.mesh", "standard input.*convert"),
    # Metrics
    ("mesh square --metric swrl:3 -o x.mesh", "swirl"),
    ("mesh square --metric swirl:x -o x.mesh", "number"),
    ("mesh square --metric swirl:-3 -o x.mesh", "-3"),
    ("mesh square --metric nothere.sol -o x.mesh", "nothere\\.sol"),
    ("mesh square --metric 'expr:1;1' -o x.mesh", "three"),
    ("mesh square --metric 'expr:1+;0;1' -o x.mesh", "expr"),
    ("mesh square --metric 'expr:1;2;1' -o x.mesh", "definite"),
    ("mesh square --metric 'expr:1+z;0;1' -o x.mesh", "z"),
    ("mesh square --metric '' -o x.mesh", "identity"),
    ("mesh square --metric layer:0.1 -o x.mesh", "H0,H1"),
    # Outputs
    ("mesh square -o mesh", "\\.mesh"),
    ("mesh square -o x.stl", "\\.mesh"),
    ("mesh square -o x.vtk", "\\.vtu"),
    ("mesh square -o -", "standard input.*convert"),
    ("mesh square -o /dev/stdout", "standard input.*convert"),
    ("mesh square -o nowhere/x.mesh", "nowhere"),
    ("mesh square -o /proc/x.mesh", "/proc"),
    ("mesh square -o folder", "\\.mesh|director"),
    ("mesh square -o x.mesh -o x.mesh", "twice"),
    ("mesh part.poly -o part.poly", "\\.mesh"),
    ("draw a.mesh -o a.jpg", "not a picture.*\\.png"),
    ("draw a.mesh -o a.vtu", "\\.png"),
    ("draw part.poly -o x.svg --colour-by angle", "marker"),
    ("draw a.mesh -o x.svg --colour-by pressure", "angle, aspect, size"),
    ("draw a.mesh a.mesh -o x.png", "\\.html"),
    ("draw plain.mesh -o x.png --ellipses", "no metric"),
    ("draw a.mesh -o x.html --solution u.sol --solution u.sol", "one for each"),
    # Meshes where domains are wanted, and the reverse
    ("verify part.poly", "a mesh of it is wanted"),
    ("certify part.poly", "mesh"),
    ("certify notes.md", "ends in none of.*\\.msh"),
    ("verify a.mesh --domain crossed.poly", "cross|--repair-domain"),
    ("verify plain.mesh", "asterism certify plain\\.mesh"),
    ("certify a.mesh nothere.sol", "nothere\\.sol"),
    ("certify a.mesh --size 0.1", "--metric"),
    ("certify a.mesh --repair", "-o"),
    ("convert part.poly x.msh", "\\.msh|mesh"),
    ("convert a.mesh x.stl", "\\.mesh"),
    ("convert a.mesh a.mesh", "is the file to read; name another one"),
    ("convert - x.msh", "--format"),
    ("transfer a.mesh short.sol plain.mesh -o x.sol", "short\\.sol"),
    ("adapt part.poly --solution u.sol --vertices 100 -o x.mesh", "part\\.poly"),
    ("adapt a.mesh --solution a.sol --vertices 100 -o x.mesh", "--metric"),
    ("adapt a.mesh --solution u.sol --vertices 100 --error 0.1 -o x.mesh", "--error|--vertices"),
    ("adapt a.mesh --solution u.sol --vertices 100 --complexity 50 -o x.mesh", "--complexity|--vertices"),
]
MISTAKES += more_mistakes.MISTAKES + newer_mistakes.MISTAKES
MOST_UNANSWERED = 0


class Mistakes(command.CommandTest):
    def prepare(self):
        for name, text in FILES.items():
            self.write(name, text)
        for name in ("folder", "folder.poly"):
            (self.folder / name).mkdir()
        done = self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "-o", "a.mesh")
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "a.certificate.json").unlink()
        text = (self.folder / "a.mesh").read_text()
        self.write("plain.mesh", text)
        count = command.section(text.split("\n"), "Vertices")[1]
        self.write("u.sol", f"{NO_MESH}SolAtVertices {count}\n1 1\n" + "0.5\n1.5\n" * (count // 2) + "1\n" * (count % 2) + "End\n")
        self.write("none.sol", f"{NO_MESH}SolAtVertices {count}\n0\n\nEnd\n")
        self.write("nan.sol", f"{NO_MESH}SolAtVertices {count}\n1 1\n" + "nan\n" * count + "End\n")
        self.write("key.mesh", text.replace("Triangles", "Trianglez"))
        self.write("cut.mesh", text[:300])
        self.write("short.sol", f"{NO_MESH}SolAtVertices 3\n1 1\n1\n2\n3\nEnd\n")

    def test_each_is_told_what_to_do(self):
        self.assertGreaterEqual(len(MISTAKES), 390)
        self.assertEqual(len({line for line, _ in MISTAKES}), len(MISTAKES))
        self.prepare()
        before, wrong = self.files(), []
        for line, pattern in MISTAKES:
            done = self.run_command(*shlex.split(line), seconds=60)
            said = " ".join((done.stderr + done.stdout).split())
            if done.returncode != 2:
                wrong.append(f"asterism {line}\n  status {done.returncode}: {said[:300]}")
            elif re.search(pattern, said, re.IGNORECASE) is None:
                wrong.append(f"asterism {line}\n  does not say {pattern}: {said[:300]}")
            if self.files() != before:
                wrong.append(f"asterism {line}\n  wrote {sorted(set(self.files()) - set(before))}")
                before = self.files()
        print(f"{len(MISTAKES) - len(wrong)} of {len(MISTAKES)} mistakes are answered by what to do")
        self.assertLessEqual(len(wrong), MOST_UNANSWERED, "\n".join(wrong))


if __name__ == "__main__":
    unittest.main()
