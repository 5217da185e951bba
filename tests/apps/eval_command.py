# SPDX-License-Identifier: MIT
"""The batch protocol through the real command."""
import os
import pty
import subprocess
import unittest

import command

ROUND = "1 0 1"  # the identity metric


def s(x, y, metric=ROUND):
    return f"{x} {y} {metric}"


# Answers found by hand. With identity metrics the bisector of (0,0) and (2,0) is the line x = 1; the
# sites (0,0) with I and (c) with 4I have a circle as bisector, centre 4c/3, radius 2|c|/3.
KNOWN = [
    ("orientation 0 0  1 0  0 1", "1"),
    ("orientation 0 0  0 1  1 0", "-1"),
    ("orientation 0 0  0.1 0.1  0.3 0.3", "0"),
    ("orientation 0 0  0.1 0.3  0.3 0.9", "1"),  # as doubles, not as decimals
    ("is_spd 1 0 1", "1"),
    ("is_spd 1 1 1", "0"),
    ("is_spd 1 2 1", "0"),
    ("is_spd -1 0 -1", "0"),
    ("is_spd 0 0 0", "0"),
    (f"compare_distance {s(0, 0)} {s(2, 0)} 0.5 9", "-1"),
    (f"compare_distance {s(0, 0)} {s(2, 0)} 1 9", "0"),
    (f"compare_distance {s(0, 0)} {s(2, 0)} 1.5 9", "1"),
    (f"in_wedge {s(0, 0)} {s(2, 0)} 1 5", "1"),
    (f"in_wedge {s(0, 0)} {s(2, 0)} 0 5", "0"),
    (f"in_wedge {s(0, 0)} {s(2, 0)} 3 0", "0"),
    (f"dominates {s(0, 0)} {s(2, 0)} 0.5 3", "1"),
    (f"dominates {s(0, 0)} {s(2, 0)} 1.5 3", "-1"),
    (f"dominates {s(0, 0)} {s(2, 0)} 1 3", "0"),
    (f"dominates {s(0, 0)} {s(2, 0)} 0 0", "1"),  # a point may be a site
    (f"voronoi_vertex_count {s(0, 0)} {s(2, 0)} {s(1, 2)}", "1"),
    (f"voronoi_vertex_count {s(0, 0)} {s(1, 0)} {s(2, 0)}", "0"),
    (f"voronoi_vertex_count {s(0, 0)} {s(3, 0, '4 0 4')} {s(3, 1.5, '4 0 4')}", "2"),
    (f"voronoi_vertex_count {s(0, 0)} {s(3, 0, '4 0 4')} {s(0, 3, '4 0 4')}", "0"),
    (f"voronoi_vertex_count {s(-1, 0)} {s(1, 0)} {s(2, 0, '0.25 0 1')}", "-1"),
    (f"arc_intersection_count {s(0, 0)} {s(2, 0)} {s(1, 2)}", "1"),
    (f"arc_intersection_count {s(0, 0)} {s(2, 0)} {s(1, 0)}", "0"),
    (f"arc_intersection_count {s(-1, 0)} {s(1, 0)} {s(2, 0, '0.25 0 1')}", "-1"),
    (f"encroaches {s(0, 0)} {s(2, 0)} {s(1, 0.5)}", "1"),
    (f"encroaches {s(0, 0)} {s(2, 0)} {s(1, 1)}", "0"),  # touches in the midpoint
    (f"encroaches {s(0, 0)} {s(2, 0)} {s(1, 3)}", "0"),
    (f"insertion_test {s(0, 0)} {s(2, 0)} {s(1, -1.5)} {s(1, 1.5)}", "1"),
    (f"insertion_test {s(0, 0)} {s(2, 0)} {s(1, -0.5)} {s(1, 0.5)}", "0"),
    (f"insertion_test {s(0, 0)} {s(1, 1)} {s(1, 0)} {s(0, 1)}", "0"),  # cocircular: touches
    (f"edge_test {s(0, 0)} {s(2, 0)} {s(1, -1.5)} {s(1, 1.5)}", "1"),
    (f"edge_test {s(0, 0)} {s(1, 1)} {s(1, 0)} {s(0, 1)}", "0"),  # the greatest is (1,1)
    (f"edge_test {s(1, 0)} {s(0, 1)} {s(1, 1)} {s(0, 0)}", "1"),
    ("orientation 0x0p0 -0x0p+0 0X1P0 0 0x1.8p-3 0x.8", "1"),
    ("orient2d 0 0  0 1  1 0", "-1"),
    ("incircle 0 0  1 0  0 1  0.5 0.5", "1"),
    ("incircle 0 0  1 0  0 1  1 1", "0"),
    ("\torientation  0 0\t1 0  0 1 \r", "1"),
    ("orientation 0 0 1e-300 0 0 4.9e-324", "1"),
    ("orientation 0 0 1 0 0 1e-400", "0"),  # rounds to zero
    ("orientation +0 -0 +1. 0 0 .5", "1"),
]

# A record, and the pattern that its error matches.
MALFORMED = [
    ("oreintation 0 0 1 0 0 1", "field 1: unknown predicate 'oreintation'"),
    ("Orientation 0 0 1 0 0 1", "unknown predicate"),
    ("orientation 0 0 1 0 0", "orientation takes 6 numbers, got 5"),
    ("orientation", "orientation takes 6 numbers, got 0"),
    ("orientation 0 0 1 0 0 1 7", "field 8: orientation takes 6 numbers, found another: '7'"),
    ("incircle 0 0 1 0 0 1 1", "incircle takes 8 numbers, got 7"),
    ("incircle 0 0 1 0 0 1 1 one", "field 9: 'one' is not a number"),
    ("orient2d 0 0 1 0 0 1 1", "field 8: orient2d takes 6 numbers, found another: '1'"),
    ("orientation 0 0 one 0 0 1", "field 4: 'one' is not a number"),
    ("orientation 0 0 1,5 0 0 1", "field 4: '1,5' is not a number"),
    ("orientation 0 0 0x 0 0 1", "field 4: '0x' is not a number"),
    ("orientation 0 0 --1 0 0 1", "field 4: '--1' is not a number"),
    ("orientation 0 0 1e 0 0 1", "field 4: '1e' is not a number"),
    ("orientation nan 0 1 0 0 1", "field 2: 'nan' is not finite"),
    ("orientation 0 -inf 1 0 0 1", "field 3: '-inf' is not finite"),
    ("orientation 0 0 1e400 0 0 1", "field 4: '1e400' is not finite"),
    ("orientation 0 0 0x1p1024 0 0 1", "field 4: '0x1p1024' is not finite"),
    ("is_spd inf 0 1", "field 2: 'inf' is not finite"),
    (f"in_wedge {s(0, 0, '1 2 1')} {s(2, 0)} 1 1",
     "fields 4-6: the metric of site 1 is not positive definite"),
    (f"encroaches {s(0, 0)} {s(2, 0)} {s(1, 0, '1 1 1')}",
     "fields 14-16: the metric of site 3 is not positive definite"),
    (f"edge_test {s(0, 0)} {s(1, 0)} {s(0, 1)} {s(1, 0, '2 0 2')}",
     "field 17: sites 2 and 4 are at the same position"),
    (f"compare_distance {s(0, 0)} {s('-0', 0)} 1 1", "sites 1 and 2 are at the same position"),
    ("orientation 0 0 1 0 0 1 # no comment here", "field 8"),
    ("orientation 0 0 1 0 \x00 1", "'?' is not a number"),
]


class Eval(command.CommandTest):
    def test_known_answers_from_every_kernel_that_is_never_wrong(self):
        text = "".join(record + "\n" for record, _ in KNOWN)
        for kernel in ("filtered", "exact"):
            done = self.run_command("eval", "--kernel", kernel, text=text)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            found = done.stdout.splitlines()
            self.assertEqual(len(found), len(KNOWN))
            for (record, answer), got in zip(KNOWN, found):
                self.assertEqual(got, answer, f"{kernel}: {record}")

    def test_interval_answers_right_or_with_a_question_mark(self):
        text = "".join(record + "\n" for record, _ in KNOWN)
        done = self.run_command("eval", "--kernel", "interval", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        for (record, answer), got in zip(KNOWN, done.stdout.splitlines(), strict=True):
            self.assertIn(got, (answer, "?"), record)
        self.assertIn("1", done.stdout.splitlines())

    def test_double_answers_every_record(self):
        text = "".join(record + "\n" for record, _ in KNOWN)
        done = self.run_command("eval", "--kernel", "double", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, rf"\A(-?\d\n){{{len(KNOWN)}}}\Z")

    def test_malformed_records_are_answered_in_their_place(self):
        text = "".join(f"{record}\norientation 0 0 1 0 0 1\n" for record, _ in MALFORMED)
        done = self.run_command("eval", text=text)
        self.assertEqual(done.returncode, 1)
        answers = done.stdout.splitlines()
        self.assertEqual(len(answers), 2 * len(MALFORMED))
        for i, (record, message) in enumerate(MALFORMED):
            self.assertTrue(answers[2 * i].startswith("error: "), record)
            self.assertIn(message, answers[2 * i], record)
            self.assertEqual(answers[2 * i + 1], "1", record)

    def test_comments_and_blank_lines_have_no_answer(self):
        text = "# one\n\n   # two\n \t\nis_spd 1 0 1\n\r\n#orientation\n"
        self.assertEqual(self.run_command("eval", text=text).stdout, "1\n")

    def test_windows_line_endings_and_no_final_newline(self):
        done = self.run_command("eval", text="# dos\r\nis_spd 1 0 1\r\n\r\nis_spd 1 2 1")
        self.assertEqual((done.stdout, done.returncode), ("1\n0\n", 0))

    def test_nothing_in_nothing_out(self):
        done = self.run_command("eval")
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))

    def test_files_in_order_and_standard_input_among_them(self):
        self.write("a", "is_spd 1 0 1")
        self.write("b", "is_spd 1 2 1\n")
        done = self.run_command("eval", "a", "-", "b", text="orientation 0 0 0 1 1 0\n")
        self.assertEqual((done.stdout, done.returncode), ("1\n-1\n0\n", 0))

    def test_a_file_that_cannot_be_read_stops_everything(self):
        self.write("a", "is_spd 1 0 1\n")
        for name in ("missing", "."):
            done = self.run_command("eval", "a", name)
            self.assertEqual((done.stdout, done.returncode), ("", 2))
            self.assertIn(f"asterism: {name}: ", done.stderr)

    def test_wrong_options_are_refused(self):
        for wrong in (["--kernel", "magic"], ["--kernel"], ["--statistics"]):
            done = self.run_command("eval", *wrong, text="is_spd 1 0 1\n")
            self.assertEqual((done.stdout, done.returncode), ("", 2), wrong)
            self.assertIn("asterism: ", done.stderr)

    def test_statistics_count_each_record_once(self):
        text = "orientation 0 0 1 0 0 1\norientation 0 0 0.1 0.1 0.3 0.3\nis_spd 1 0 1\nwhat\n"
        for kernel in ("filtered", "exact", "interval", "double"):
            done = self.run_command("eval", "--stats", "--kernel", kernel, text=text)
            self.assertEqual(done.returncode, 1)
            lines = [line.split() for line in done.stderr.splitlines()]
            self.assertEqual(
                lines[0],
                ["predicate", "semi-static", "interval", "exact", "double", "undecided"],
            )
            counts = {line[0]: list(map(int, line[1:])) for line in lines[1:-1]}
            self.assertEqual(sum(counts["orientation"]), 2, kernel)
            self.assertEqual(sum(counts["is_spd"]), 1, kernel)
            self.assertEqual(" ".join(lines[-1]), "answers 3, errors 1")
            if kernel == "exact":
                self.assertEqual(counts["orientation"], [0, 0, 2, 0, 0])
            if kernel == "filtered":
                self.assertEqual(counts["orientation"], [1, 0, 1, 0, 0])

    def test_the_locale_changes_nothing(self):
        os.environ["LC_ALL"] = "de_DE.UTF-8"
        self.addCleanup(os.environ.pop, "LC_ALL")
        done = self.run_command("eval", text="orientation 0 0 1.5 0 0 0.5\n")
        self.assertEqual(done.stdout, "1\n")

    def test_long_lines_and_many_lines(self):
        text = "#" + "x" * 1000000 + "\n" + "is_spd 1 0 " + "0" * 100000 + "1\n"
        text += "orientation 0 0 1 0 0 1\n" * 200000
        done = self.run_command("eval", text=text)
        self.assertEqual((done.stdout, done.returncode), ("1\n" * 200001, 0))
        done = self.run_command("eval", text="y" * 1000000)
        self.assertEqual(done.returncode, 1)
        self.assertLess(len(done.stdout), 200)

    def test_each_answer_comes_before_the_next_question(self):
        ends = [subprocess.PIPE]
        try:
            master, slave = pty.openpty()
            ends.append(slave)
        except OSError:  # no terminal can be had here; the pipe is tested all the same
            slave = None
        for end in ends:
            asked = subprocess.Popen([command.PROGRAM, "eval"], stdin=end, stdout=subprocess.PIPE)
            write = os.dup(master) if end is slave else asked.stdin.fileno()
            for record, answer in KNOWN[:3]:
                os.write(write, (record + "\n").encode())
                self.assertEqual(asked.stdout.readline().decode().strip(), answer)
            os.write(write, b"\x04") if end is slave else asked.stdin.close()
            self.assertEqual(asked.wait(10), 0)
            asked.stdout.close()


if __name__ == "__main__":
    unittest.main()
