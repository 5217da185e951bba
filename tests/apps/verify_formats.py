# SPDX-License-Identifier: MIT
"""Verifies a mesh from each format that it was written in, beside its certificate, and from a .mesh."""
import json
import unittest

import command

# Two regions, an inner segment between them, and a vertex in each.
PARTS = """8 2 0 0
1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 2 0\n6 2 3\n7 1 1\n8 3 1.5
7 1
1 1 5 1\n2 5 2 2\n3 2 3 3\n4 3 6 4\n5 6 4 5\n6 4 1 6\n7 5 6 7
0
2
1 1 1 3 0\n2 3 1 8 0
"""
# A spline of two segments, a cubic, and a circle for a hole. The circle is listed last and divided first.
CURVES = """9 2 0 0
1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 2 1\n6 4.5 1.2\n7 1 2.5\n8 0.7 1.2\n9 1.2 1.2
7 1
1 1 2 1\n2 2 6 2\n3 6 3 2\n4 3 4 3\n5 4 1 4\n6 8 9 6\n7 8 7 7
1
1 2.1 1.6
0
curves 3
1 circle 5  2.1 1.6 9
2 spline 2 3
3 bezier 5  -0.4 2 -0.3 1
"""
WHOLE = ("mesh", "meshb", "msh", "msh2", "vtu")  # formats that hold everything a mesh has
OF_SOLVERS = ("su2", "14", "grd", "2dm")  # formats without a metric and without segments


class VerifyFormats(command.CommandTest):
    def made(self, domain, ending, *options):
        done = self.run_command("mesh", domain, *options, "--quiet", "-o", "m." + ending)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def verdict(self, status, *arguments):
        done = self.run_command("verify", *arguments)
        self.assertEqual(done.returncode, status, " ".join(arguments) + "\n" + done.stdout + done.stderr)
        return done.stdout + done.stderr

    def edit(self, name, old, new, count=1):
        path = self.folder / name
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new, count))

    def forge_a_number(self):
        """Changes a number of the audit. It is compared only where the certificate's own question is asked."""
        path = self.folder / "m.certificate.json"
        claim = json.loads(path.read_text())
        claim["audit"]["largest_boundary_deviation"] = 0.25
        path.write_text(json.dumps(claim))

    def test_every_format_with_its_certificate(self):
        self.write("parts.poly", PARTS)
        self.write("curves.poly", CURVES)
        self.write("square.poly", "4 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        for domain, *options in (("parts.poly", "--metric", "swirl:3", "--size", "0.4", "--regions"),
                                 ("curves.poly", "--size", "0.3"), ("curves.poly", "--metric", "sink:3", "--size", "0.3")):
            for ending in WHOLE + OF_SOLVERS:
                with self.subTest(domain=domain, ending=ending, options=options):
                    self.made(domain, ending, *options)
                    said = self.verdict(0, "m." + ending)
                    taken = "not in the file and taken from the certificate: segments, markers"
                    self.assertEqual(taken in said, ending in OF_SOLVERS)
                    self.assertEqual("in which the mesh is judged, as its file has none" in said, ending in OF_SOLVERS)
                    self.assertIn("domain " + domain, self.verdict(0, "m." + ending, "--domain", domain))
                    self.verdict(1, "m." + ending, "--domain", "square.poly")
                    self.verdict(1, "m." + ending, "--angle-bound", "55")
                    self.forge_a_number()
                    for question in ((), ("--domain", domain)):
                        said = self.verdict(1, "m." + ending, *question)
                        self.assertIn('"audit.largest_boundary_deviation" is 0.25 in the certificate', said)

    def test_without_the_certificate(self):
        self.write("parts.poly", PARTS)
        question = ("--domain", "parts.poly", "--angle-bound", "20", "--metric", "swirl:3", "--size", "0.4")
        for ending in WHOLE + OF_SOLVERS:
            with self.subTest(ending=ending):
                self.made("parts.poly", ending, "--metric", "swirl:3", "--size", "0.4")
                (self.folder / "m.certificate.json").unlink()
                said = self.verdict(0, "m." + ending, *question)
                self.assertEqual("taken from the domain: segments, markers" in said, ending in OF_SOLVERS)
                if ending in OF_SOLVERS:
                    self.assertIn("there is no metric in the file; --metric names one",
                                  self.verdict(2, "m." + ending, *question[:4]))

    def test_what_was_changed_in_the_file_is_found(self):
        self.write("parts.poly", PARTS)
        for ending in ("msh", "msh2", "su2", "14", "2dm"):
            with self.subTest(ending=ending):
                self.made("parts.poly", ending, "--metric", "swirl:3", "--size", "0.4")
                text = (self.folder / ("m." + ending)).read_text()
                number = next(w for line in text.splitlines() for w in line.split()
                              if w.startswith("0.") and len(w) > 12 and line.count(".") > 1)
                changed = number[:-3] + ("4" if number[-3] != "4" else "5") + number[-2:]
                (self.folder / ("m." + ending)).write_text(text.replace(number, changed))
                self.assertIn("certificate: ", self.verdict(1, "m." + ending))

    def test_markers_that_are_on_other_segments(self):
        self.write("parts.poly", PARTS)
        self.made("parts.poly", "su2", "--size", "0.4")
        first = (self.folder / "m.su2").read_text().split("MARKER_ELEMS= ")[1].splitlines()[1]
        # Moves an edge of the first marker to the last marker.
        text = (self.folder / "m.su2").read_text()
        head, tail = text.split(first + "\n", 1)
        count = int(head.split("MARKER_ELEMS= ")[-1].split()[0])
        head = head.replace(f"MARKER_ELEMS= {count}\n", f"MARKER_ELEMS= {count - 1}\n")
        last = int(tail.split("MARKER_ELEMS= ")[-1].split()[0])
        start, end = tail.rsplit(f"MARKER_ELEMS= {last}\n", 1)
        (self.folder / "m.su2").write_text(head + start + f"MARKER_ELEMS= {last + 1}\n{first}\n" + end)
        self.assertIn("the mesh is not of the certificate's domain: edges of its marker", self.verdict(1, "m.su2"))

    def test_a_metric_of_its_own_is_in_the_file_or_nowhere(self):
        self.write("curves.poly", CURVES)
        self.made("curves.poly", "mesh", "--size", "0.3")
        sites = (self.folder / "m.mesh").read_text().split("Vertices\n")[1].split()
        values = [(float(sites[1 + 3 * i]) - float(sites[2 + 3 * i])) ** 3 for i in range(int(sites[0]))]
        self.write("u.sol", "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%d\n1 1\n%s\nEnd\n" %
                   (len(values), "\n".join(map(repr, values))))
        for ending in ("msh", "vtu", "su2"):
            with self.subTest(ending=ending):
                done = self.run_command("adapt", "m.mesh", "--solution", "u.sol", "--vertices", "400", "--domain",
                                        "curves.poly", "--keep", "never", "--quiet", "-o", "a." + ending)
                self.assertEqual(done.returncode, 0, done.stderr)
                if ending != "su2":
                    self.assertIn("domain curves.poly", self.verdict(0, "a." + ending, "--domain", "curves.poly"))
                else:
                    self.assertIn("and not the certificate's: the mesh has a metric of its own",
                                  self.verdict(2, "a.su2"))

    def test_what_is_written_and_not_read(self):
        self.write("parts.poly", PARTS)
        for ending in ("node", "svg", "html"):
            with self.subTest(ending=ending):
                self.made("parts.poly", ending, "--size", "0.5")
                self.assertIn("written and not read as meshes; verify the .mesh", self.verdict(2, "m." + ending))


if __name__ == "__main__":
    unittest.main()
