# SPDX-License-Identifier: MIT
"""Runs small FreeFEM scripts with asterism.idp in place of adaptmesh.
freefem_include.py FREEFEM ASTERISM FOLDER   (FREEFEM empty: skipped; FOLDER has asterism.idp)"""
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

FREEFEM, ASTERISM = sys.argv[1:3]
FOLDER = os.path.abspath(sys.argv[3])

TWO_MATERIALS = """
mesh Th = square(12, 12);
Th = change(Th, fregion = 1 + (x > 0.5));
fespace P2h(Th, P2);
fespace P0h(Th, P0);
P2h a = exp(-100 * (x - 0.3)^2);
P0h b = y * y;
asterismadapt(Th, [a, b], vertices = 700; ratio = 1.5; more = "--norm inf")
cout << "GOT " << Th.nv << " " << int2d(Th, 1)(1.) << " " << int2d(Th, 2)(1.) << " " << int1d(Th, 3)(1.)
     << endl;
"""

METRICS = """
mesh Th = square(20, 20);
fespace Vh(Th, P1);
Vh h = 0.05;
asterismadapt(Th, h, IsMetric = 1)
cout << "GOT " << Th.nv << endl;
Vh m11 = 400, m12 = 0, m22 = 100;
asterismadapt(Th, [m11, m12, m22], IsMetric = true; thetamax = 20)
cout << "GOT " << Th.nv << endl;
"""

LOOP = """
mesh Th = square(16, 16), Tb = Th;
fespace Vh(Th, P1);
fespace Wh(Tb, P1);
func wanted = 3 + tanh(10 * (x - y^2));
Vh u = wanted;
Wh w = wanted;
for (int i = 0; i < 3; ++i) {
  asterismadapt(Th, u, err = 0.004; abserror = 1; ratio = 0)
  Tb = adaptmesh(Tb, w, err = 0.004, abserror = 1, ratio = 0);
  u = wanted;
  w = 0;
  w = wanted;
}
cout << "GOT " << Th.nv << " " << Tb.nv << endl;
"""


# Two regions of this boundary are near each other, since the rectangle is slender.
BOUNDARY = """
mesh Th = square(12, 3, [x, y / 4]);
fespace Vh(Th, P1);
Vh h = 0.09;
asterismadapt(Th, h, IsMetric = 1; splitpbedge = 1)
int[int] outer(Th.nv);
outer = 0;
for (int k = 0; k < Th.nt; ++k)
  for (int e = 0; e < 3; ++e) {
    int ee = e;
    if (Th[k].adj(ee) == Th[k]) { outer[Th[k][(e + 1) % 3]] = 1; outer[Th[k][(e + 2) % 3]] = 1; }
  }
int across = 0;
for (int k = 0; k < Th.nt; ++k)
  for (int e = 0; e < 3; ++e) {
    int ee = e;
    if (Th[k].adj(ee) != Th[k] && outer[Th[k][(e + 1) % 3]] + outer[Th[k][(e + 2) % 3]] == 2) ++across;
  }
cout << "GOT " << Th.nv << " " << across << " " << outer.sum << endl;
"""

HESSIANS = """
mesh Th = square(16, 16);
fespace Wh(Th, P2);
fespace Vh(Th, P1);
Wh u = tanh(15 * (x - y^2));
Wh ux = dx(u), uy = dy(u);
Vh h11 = dx(ux), h12 = (dy(ux) + dx(uy)) / 2, h22 = dy(uy);
asterismadapt(Th, [h11, h12, h22], IsHessian = 1; vertices = 600)
cout << "GOT " << Th.nv << endl;
Vh a = 1, b = 3, c = -2;
Vh d = y * y;
asterismadapt(Th, [a, b, c, d, a, a], IsHessian = 1; vertices = 300)
cout << "GOT " << Th.nv << endl;
"""


# A hundred times the second derivatives of tanh(10 (x - y^2)), with either sign.
INDEFINITE = """
mesh Th = square(12, 12);
fespace Vh(Th, P1);
macro u() tanh(10 * (x - y^2)) //
for (int i = 0; i < 4; ++i) {
  Vh m11 = 20000 * u * (u^2 - 1), m12 = -2 * y * m11, m22 = 4 * y^2 * m11 - 2000 * (1 - u^2);
  asterismadapt(Th, [m11, m12, m22], IsMetric = 1; hmax = 0.2)
}
cout << "GOT " << Th.nv << endl;
mesh Tb = square(12, 12);
fespace Wh(Tb, P1);
for (int i = 0; i < 4; ++i) {
  Wh m11 = 20000 * u * (u^2 - 1), m12 = -2 * y * m11, m22 = 4 * y^2 * m11 - 2000 * (1 - u^2);
  Tb = adaptmesh(Tb, m11, m12, m22, IsMetric = 1, hmax = 0.2);
}
cout << "GOT " << Tb.nv << endl;
"""

# Tensors of second derivatives that a script takes from P1 gradients: each is of one triangle, and they differ from
# vertex to vertex. Printed are numbers of vertices, and errors in the mean square times them, of both programs.
RECOVERED = """
mesh Th = square(15, 15), Tb = Th;
func wanted = tanh(20 * (x - 0.3 - 0.4 * y));
macro recovered(on) {
  u = 0; m11 = 0; m12 = 0; m22 = 0;
  u = wanted;
  V ux = dx(u), uy = dy(u);
  V h11 = dx(ux), h12 = dy(ux), h22 = dy(uy);
  for (int i = 0; i < on.nv; ++i) {
    real mean = (h11[][i] + h22[][i]) / 2, half = sqrt((h11[][i] - h22[][i]) ^ 2 / 4 + h12[][i] ^ 2);
    real first = min(max(20 * abs(mean + half), 4.), 1e4), second = min(max(20 * abs(mean - half), 4.), 1e4);
    real angle = atan2(2 * h12[][i], h11[][i] - h22[][i]) / 2;
    m11[][i] = first * cos(angle)^2 + second * sin(angle)^2;
    m12[][i] = (first - second) * cos(angle) * sin(angle);
    m22[][i] = first * sin(angle)^2 + second * cos(angle)^2;
  }
  cout << "GOT " << on.nv << " " << sqrt(int2d(on, qforder = 9)((u - wanted)^2)) * on.nv << endl;
} //
for (int i = 0; i < 9; ++i) {
  { fespace V(Th, P1); V u, m11, m12, m22; recovered(Th)
    asterismadapt(Th, [m11, m12, m22], IsMetric = 1) }
  { fespace V(Tb, P1); V u, m11, m12, m22; recovered(Tb)
    Tb = adaptmesh(Tb, m11, m12, m22, IsMetric = 1); }
}
"""

# A vortex and a scalar. adaptmesh measures errors relative to values by the length of a vector. The length vanishes
# in the middle alone; each component vanishes on a line.
VECTORS = """
mesh Th = square(16, 16), Tb = Th;
fespace Vh(Th, P1);
fespace Wh(Tb, P1);
func a = (y - 0.5) * exp(-30 * ((x - 0.5)^2 + (y - 0.5)^2));
func b = (0.5 - x) * exp(-30 * ((x - 0.5)^2 + (y - 0.5)^2));
Vh u1 = a, u2 = b, p = x * y;
Wh w1 = a, w2 = b, q = x * y;
for (int i = 0; i < 3; ++i) {
  asterismadapt(Th, [u1, u2, p], err = 0.08; abserror = 0; cutoff = 0.01; hmin = 0.01; vectors = "2 1")
  Tb = adaptmesh(Tb, [w1, w2], q, err = 0.08, abserror = 0, cutoff = 0.01, hmin = 0.01);
  u1 = a; u2 = b; p = x * y;
  w1 = a; w2 = b; q = x * y;
}
cout << "GOT " << Th.nv << " " << Tb.nv << endl;
asterismadapt(Th, [u1, u2, p], err = 0.08; abserror = 0; cutoff = 0.01; hmin = 0.01)
cout << "GOT " << Th.nv << endl;
"""

# What the options of adaptmesh are without a word: the least value of relative errors, the height of arcs, and the
# greatest size of a metric.
DEFAULTS = """
mesh Th = square(12, 12), Tb = Th;
fespace Vh(Th, P1);
fespace Wh(Tb, P1);
func steep = exp(-14 * x);
Vh u = steep;
Wh w = steep;
for (int i = 0; i < 3; ++i) {
  asterismadapt(Th, u, err = 0.02; abserror = 0; hmin = 0.004)
  Tb = adaptmesh(Tb, w, err = 0.02, abserror = 0, hmin = 0.004);
  u = steep;
  w = 0;
  w = steep;
}
cout << "GOT " << Th.nv << " " << Tb.nv << endl;
border circle(t = 0, 2 * pi) { x = cos(t); y = sin(t); }
Th = buildmesh(circle(70));
Tb = Th;
u = x * y;
w = x * y;
asterismadapt(Th, u, err = 0.5; errg = 0.1)
Tb = adaptmesh(Tb, w, err = 0.5, errg = 0.1);
cout << "GOT " << Th.nbe << " " << Tb.nbe << endl;
Th = square(12, 12);
Vh h = 5;
asterismadapt(Th, h, IsMetric = 1)
cout << "GOT " << Th.nv << endl;
"""

# A tensor 100 times as great at the middle of a square, and one at a vertex of its side.
PEAKS = """
mesh Th = square(4, 4);
asterismbegin(Th);
real nothing = int2d(Th, qft = qf1pTlump)(asterismtake((asterismvalue = [1., 0., 1.])[0]));
asterismend("PEAKS");
int[int] peaks = [12, 2];
for (int k = 0; k < 2; ++k)
  for (int part = 0; part < 3; part += 2) asterismvalues[part * Th.nv + peaks[k]] = 100;
int changed = asterismpeaks(Th, 30);
cout << "GOT " << changed << " " << asterismvalues[12] << " " << asterismvalues[2] << " " << asterismvalues.sum << endl;
"""

# Densities that fall by a power of the distance from the re-entrant corner of an L, level in the two rows around it.
CORNER = """
mesh Th = trunc(square(12, 12), x < 0.51 | y < 0.51);
func int cornerdensity(real power) {
  asterismbegin(Th);
  real nothing = int2d(Th, qft = qf1pTlump)(asterismtake(
    (asterismvalue = [max(0.084, max(abs(x - 0.5), abs(y - 0.5))) ^ (-power), 0.,
                      max(0.084, max(abs(x - 0.5), abs(y - 0.5))) ^ (-power)])[0]));
  asterismend("CORNER");
  real[int] before(asterismvalues.n);
  before = asterismvalues;
  int changed = asterismpeaks(Th, 30);
  before = asterismvalues ./ before;
  cout << "GOT " << changed << " " << before.max << " " << before.min << endl;
  return changed;
}
cornerdensity(0);
cornerdensity(1);
cornerdensity(4);
"""

# Sizes that are the mesh's own, all times one number, and times and by a number at every other vertex of 36.
NEARER = """
mesh Th = square(5, 5);
asterismbegin(Th);
real nothing = int2d(Th, qft = qf1pTlump)(asterismtake((asterismvalue = [1.])[0]));
real[int] lengths(Th.nv), sizes(Th.nv);
asterismlengths(Th, lengths);
func int nearer(real common, real alternate) {
  for (int i = 0; i < lengths.n; ++i) sizes[i] = lengths[i] * common * alternate ^ (1 - 2 * (i % 2));
  asterismvalues = sizes;
  asterismnearer(Th, 100);
  cout << "GOT " << asterismvalues[0] / sizes[0] << " " << asterismvalues[1] / sizes[1] << endl;
  return 0;
}
cout << "GOT " << lengths[0] << " " << lengths[5] << " " << lengths[7] << endl;
nearer(3, 1);
nearer(3, exp(0.1));
nearer(0.5, exp(1.));
"""

def run(body):
    with tempfile.TemporaryDirectory(prefix="asterism-idp-") as folder:
        with open(os.path.join(folder, "script.edp"), "w", encoding="ascii") as file:
            file.write('include "asterism.idp"\n' + body)
        done = subprocess.run([FREEFEM, "-v", "0", "-nw", "script.edp"], cwd=folder, text=True,
                              capture_output=True, timeout=200, check=False,
                              env={**os.environ, "ASTERISM": ASTERISM, "FF_INCLUDEPATH": FOLDER})
        numbers = [[float(word) for word in line.split()]
                   for line in re.findall(r"GOT (.*)", done.stdout)]
        return done.returncode, numbers, done.stdout + done.stderr, os.listdir(folder)


def call(field, options):
    return run(f"mesh Th = square(5, 5);\nreal err = 0.1;\nasterismadapt(Th, {field}, {options})\n"
               'cout << "GOT " << Th.nv << endl;\n')


class IncludeTest(unittest.TestCase):
    def test_p2_and_p0_on_two_materials(self):
        status, numbers, text, files = run(TWO_MATERIALS)
        self.assertEqual(status, 0, text)
        vertices, left, right, top = numbers[0]
        self.assertLess(abs(vertices / 700 - 1), 0.1)
        self.assertAlmostEqual(left, 0.5, 12)
        self.assertAlmostEqual(right, 0.5, 12)
        self.assertAlmostEqual(top, 1, 12)
        self.assertEqual(files, ["script.edp"])

    def test_sizes_and_tensors(self):
        """A mesh of unit edges has 1.155 vertices for each unit of its area in the metric, and half a vertex for each
        unit of its boundary's length."""
        status, numbers, text, _ = run(METRICS)
        self.assertEqual(status, 0, text)
        self.assertLess(abs(numbers[0][0] / (1.155 * 400 + 40) - 1), 0.15)
        self.assertLess(abs(numbers[1][0] / (1.155 * 200 + 30) - 1), 0.15)
        self.assertNotIn("note: ", text)

    def test_greater_sizes_are_moved_toward_those_of_the_mesh(self):
        """By a quarter of the logarithm of the quotient, without the mean quotient, and by 0.075 at most. Diagonals of
        the squares go from bottom left to top right, and count twice, as sides of two triangles."""
        status, numbers, text, _ = run(NEARER)
        self.assertEqual(status, 0, text)
        for found, wanted in zip(numbers[0], (0.1 * (1 + 2**0.5), 0.2, 0.2 * (4 + 2 * 2**0.5) / 6)):
            self.assertAlmostEqual(found, wanted, 5)
        for found, logarithm in zip(numbers[1:], (0, 0.025, 0.075)):
            self.assertAlmostEqual(found[0], math.exp(-logarithm), 5)
            self.assertEqual(found[1], 1)
        self.assertEqual(re.findall(r"note: (\d+) of 36 sizes are reduced, by up to (\S+) %", text),
                         [("18", "2.46901"), ("18", "7.22565")], text)

    def test_keepbackvertices_is_of_sizes(self):
        status, numbers, text, _ = call("0.03 + 0.2 * x", "IsMetric = 1")
        self.assertEqual((status, len(numbers)), (0, 1), text)
        self.assertEqual(text.count("note: "), 1, text)
        self.assertIn("keepbackvertices = 0 takes sizes as given", text)
        status, given, text, _ = call("0.03 + 0.2 * x", "IsMetric = 1; keepbackvertices = 0")
        self.assertEqual((status, len(given)), (0, 1), text)
        self.assertNotIn("note: ", text)
        self.assertNotEqual(given, numbers)
        status, kept, text, _ = call("0.03 + 0.2 * x", "IsMetric = 1; keepbackvertices = 1")
        self.assertEqual((status, kept), (0, numbers), text)
        self.assertNotIn("passed over", text)
        status, numbers, text, _ = call("x * x", "keepbackvertices = 1")
        self.assertEqual((status, len(numbers)), (0, 1), text)
        self.assertIn("keepbackvertices has no counterpart and is passed over", text)

    def test_err_means_what_it_does_to_adaptmesh(self):
        status, numbers, text, _ = run(LOOP)
        self.assertEqual(status, 0, text)
        ours, theirs = numbers[0]
        self.assertLess(abs(ours / theirs - 1), 0.1, text)

    def test_defaults_are_those_of_adaptmesh(self):
        status, numbers, text, _ = run(DEFAULTS)
        self.assertEqual(status, 0, text)
        ours, theirs = numbers[0]
        self.assertLess(abs(ours / theirs - 1), 0.04, text)
        ours, theirs = numbers[1]
        self.assertLess(abs(ours - theirs), 4, text)
        self.assertGreater(numbers[2][0], 15)

    def test_a_peak_of_one_inner_vertex_is_limited_by_its_neighbours(self):
        status, numbers, text, _ = run(PEAKS)
        self.assertEqual((status, numbers), (0, [[1, 1.75, 100, 23 + 23 + 3.5 + 200]]), text)

    def test_densities_at_a_re_entrant_corner_go_on(self):
        """Densities do not change where they are level, nor where they fall steeply."""
        status, numbers, text, _ = run(CORNER)
        self.assertEqual(status, 0, text)
        level, flat, steep = numbers
        self.assertEqual(level, [0, 1, 1], text)
        self.assertEqual((flat[0], flat[2]), (1, 1), text)
        self.assertGreater(flat[1], 1.2, text)
        self.assertLess(flat[1], 2, text)
        self.assertEqual(steep[1], 1, text)

    def test_no_inner_edge_joins_two_vertices_of_the_boundary(self):
        status, numbers, text, files = run(BOUNDARY)
        self.assertEqual(status, 0, text)
        self.assertNotIn("splitpbedge", text)
        vertices, across, outer = numbers[0]
        self.assertEqual(across, 0, text)
        self.assertLess(outer, vertices)
        self.assertEqual(files, ["script.edp"])

    def test_second_derivatives_of_a_script(self):
        status, numbers, text, _ = run(HESSIANS)
        self.assertEqual(status, 0, text)
        self.assertLess(abs(numbers[0][0] / 600 - 1), 0.1)
        self.assertLess(abs(numbers[1][0] / 300 - 1), 0.1)
        status, numbers, text, _ = call("[x, y, x]", "IsHessian = 1; IsMetric = 1")
        self.assertEqual((status, numbers), (2, []), text)
        status, numbers, text, _ = call("[x, y]", "IsHessian = 1")
        self.assertEqual((status, numbers), (2, []), text)
        self.assertIn("not 2 fields", text)

    def test_indefinite_tensors_have_the_moduli_that_adaptmesh_takes(self):
        status, numbers, text, _ = run(INDEFINITE)
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r"note: \d+ of \d+ tensors are not positive definite")
        (ours,), (theirs,) = numbers
        self.assertLess(abs(ours / theirs - 1), 0.15, text)

    def test_tensors_are_graded_as_adaptmesh_does(self):
        """In the geometric mean of the last four rounds errors times vertices are 1.26 of adaptmesh's, and vertices
        1.16. They were 1.65 and 1.61 while the command graded these tensors."""
        status, numbers, text, _ = run(RECOVERED)
        self.assertEqual((status, len(numbers)), (0, 18), text)
        ours, theirs = ([math.prod(values) ** 0.25 for values in zip(*numbers[first::2][-4:])] for first in (0, 1))
        self.assertLess(ours[0], 1.4 * theirs[0], text)
        self.assertLess(ours[1], 1.45 * theirs[1], text)

    def test_vectors_are_measured_as_adaptmesh_does(self):
        status, numbers, text, _ = run(VECTORS)
        self.assertEqual(status, 0, text)
        ours, theirs = numbers[0]
        self.assertLess(abs(ours / theirs - 1), 0.1, text)
        self.assertGreater(numbers[1][0], 1.3 * ours)
        for options, words in (('vectors = "2 2"', "more components than there are fields: 3"),
                               ('vectors = "5"', "from 1 to 4"),
                               ('vertices = 100; vectors = "2"', "err has no part in this call")):
            status, numbers, text, _ = call("[x, y, x]", options)
            self.assertEqual((status, numbers), (2, []), text)
            self.assertIn(words, text)

    def test_an_error_that_no_mesh_has_is_refused(self):
        for error in ("-1", "0"):
            status, numbers, text, _ = call("x * x", f"err = {error}")
            self.assertEqual((status, numbers), (2, []), text)
            self.assertIn("err is greater than 0", text)

    def test_counts_are_whole_and_no_least_size_is_zero(self):
        for options in ("vertices = 200.5", "nbvx = 1000.5"):
            status, numbers, text, _ = call("x * x", options)
            self.assertEqual((status, numbers), (2, []), text)
            self.assertIn("is a whole number, and here it is " + options.split()[-1], text)
        status, numbers, text, _ = call("x * x + y * y", "vertices = 100; hmin = 0")
        self.assertEqual((status, len(numbers)), (0, 1), text)

    def test_included_twice(self):
        status, numbers, text, _ = run('include "asterism.idp"\nmesh Th = square(5, 5);\n'
                                       'asterismadapt(Th, x * x + y * y, vertices = 300)\ncout << "GOT " << Th.nv << endl;\n')
        self.assertEqual((status, len(numbers)), (0, 1), text)

    def test_failure_stops_the_script_with_the_message_of_the_command(self):
        status, numbers, text, _ = call("x * x", "hmin = 1; hmax = 0.1")
        self.assertEqual((status, numbers), (2, []), text)
        self.assertIn("--hmin 1 is not less than --hmax 0.1", text)
        self.assertNotIn("asterism.idp: there", text)
        status, numbers, text, _ = call("x * x + y * y", "err = 1e-4; nbvx = 50; maxsubdiv = 20")
        self.assertEqual((status, numbers), (1, []), text)
        self.assertIn("the limit of 50 sites was reached", text)
        self.assertIn("asterism.idp: there nbvx is --max-sites, maxsubdiv is --step", text)

    def test_a_variable_with_the_name_of_an_option_is_refused(self):
        status, numbers, text, _ = call("x * x", "err = err")
        self.assertEqual((status, numbers), (2, []), text)
        self.assertIn("err has no value in 'err = err'", text.replace("' err", "'err"))

    def test_options_without_counterpart(self):
        status, numbers, text, _ = call("[x * x, y]", "omega = 1.8")
        self.assertEqual((status, len(numbers)), (0, 1), text)
        self.assertIn("omega has no counterpart and is passed over", text)
        status, numbers, text, _ = call("x * x", "splitin2 = 1")
        self.assertEqual((status, numbers), (2, []), text)

    def test_two_fields_are_no_metric(self):
        status, _, text, files = call("[x, y]", "IsMetric = 1")
        self.assertEqual((status, files), (2, ["script.edp"]), text)  # no run failed, so no file is kept
        self.assertIn("not 2 fields", text)


if __name__ == "__main__":
    if not FREEFEM or "NOTFOUND" in FREEFEM:
        print("skipped: FreeFem++ is not installed")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
