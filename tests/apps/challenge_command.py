# SPDX-License-Identifier: MIT
"""asterism challenge, with programs that answer rightly, wrongly, too little, too much, or never."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

import command

# A program that answers orient2d of whole numbers, and executes {at} at record number {k}.
PROGRAM = """#!{python} -S
import os, signal, sys, time
BUFFERED = {buffered}
def orient2d(n):
    a, b, c, d, e, f = n
    value = (c - a) * (f - b) - (d - b) * (e - a)
    return (value > 0) - (value < 0)
lines = iter(sys.stdin.readline, "")
for k, line in enumerate(lines):
    name, *numbers = line.split()
    if name != "orient2d":
        print("error: unknown", flush=True)
        continue
    numbers = [int(float.fromhex(x) if "x" in x else float(x)) for x in numbers]
    answer = orient2d(numbers)
    if numbers == [7, 7, 8, 8, 9, 10]:
        {at}
    if answer is not None:
        print(answer, flush=not BUFFERED)
"""
# Ten records, of which the sixth is the record above.
RECORDS = [f"orient2d 0 0 1 0 {k} {k}" for k in range(5)] + ["orient2d 7 7 8 8 9 10"] + [
    f"orient2d 0 0 1 0 {k} -{k}" for k in range(4)]
ANSWERS = [0, 1, 1, 1, 1, 1, 0, -1, -1, -1]


class Challenge(command.CommandTest):
    def program(self, text):
        path = self.write("program", text)
        path.chmod(0o755)
        return "./program"

    def faulty(self, at, buffered=False):
        return self.program(PROGRAM.format(python=sys.executable, at=at, buffered=buffered))

    def challenge(self, *arguments, seconds=60):
        return self.run_command("challenge", *arguments, seconds=seconds)

    def ask_ten(self, program, *options):
        self.write("ten.txt", "".join(r + "\n" for r in RECORDS))
        return self.challenge("--predicate", "orient2d", "--classes", "ten.txt", "--timeout", "0.5",
                              *options, program)

    def counts(self, done, name="all"):
        """Returns the row of the first table as a dictionary."""
        lines = done.stdout.splitlines()
        head = re.split(r"  +", lines[0].strip())
        row = next(line for line in lines if line.startswith(name))
        return dict(zip(head[1:], row.split()[1:]))

    def expect(self, done, **expected):
        self.assertEqual(done.returncode, 1, done.stderr + done.stdout)
        counts = self.counts(done)
        for verdict in ("wrong", "undecided", "refused", "garbage", "too few", "too many", "crashed",
                        "hung", "not asked"):
            self.assertEqual(counts.get(verdict, "0"), str(expected.get(verdict, 0)),
                             f"{verdict}\n{done.stdout}")

    def test_the_exact_predicates_pass(self):
        done = self.challenge("--count", "5", command.PROGRAM, "eval")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertEqual(self.counts(done)["right"], str(15 * 13 * 5))
        self.assertNotIn("The first of each kind", done.stdout)

    def test_doubles_are_wrong_and_every_witness_replays(self):
        done = self.challenge("--count", "20", "--classes", "one-ulp,kettner,scaled,subnormal,tangent",
                              command.PROGRAM, "eval", "--kernel", "double")
        self.assertEqual(done.returncode, 1)
        self.assertGreater(int(self.counts(done, "scaled")["wrong"]), 20)
        found = re.findall(r"wrong: '(.*)', exactly (.*)\n  (.*)\n", done.stdout)
        self.assertGreater(len(found), 3)
        for given, exact, record in found:
            for kernel, answer in (("double", given), ("exact", exact)):
                again = self.run_command("eval", "--kernel", kernel, text=record)
                self.assertEqual(again.stdout.strip(), answer, record)

    def test_undecided_passes_only_if_allowed(self):
        asked = ("--count", "20", "--classes", "kettner")
        interval = (command.PROGRAM, "eval", "--kernel", "interval")
        done = self.challenge(*asked, *interval)
        self.assertEqual(done.returncode, 1)
        self.assertGreater(int(self.counts(done)["undecided"]), 10)
        self.assertEqual(self.counts(done)["wrong"], "0")
        self.assertEqual(self.challenge(*asked, "--allow-undecided", *interval).returncode, 0)

    def test_a_right_program_without_metrics_is_asked_what_it_knows(self):
        done = self.challenge("--classes", "grid,collinear", self.faulty("pass"))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Not asked, since a simple question got no answer: incircle, orientation,",
                      done.stdout)

    def test_a_program_that_knows_nothing_is_told_so(self):
        done = self.challenge(self.program("#!/bin/sh\necho no such library >&2\nexit 3\n"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("(orient2d: ended with status 3 before it had answered: no such library).",
                      done.stdout)
        self.assertIn("The program answered none of them.", done.stdout)

    def test_a_crash_is_told_by_its_record(self):
        for buffered in (False, True):
            done = self.ask_ten(self.faulty("os.kill(os.getpid(), signal.SIGSEGV)", buffered))
            self.expect(done, crashed=1)
            self.assertEqual(self.counts(done)["right"], "9")
            self.assertIn("ten, crashed: ended by signal 11 (Segmentation fault), exactly 1\n"
                          "  orient2d 7 7 8 8 9 10\n", done.stdout)

    def test_a_program_that_ends_early_says_why(self):
        for buffered in (False, True):
            done = self.ask_ten(self.faulty("sys.exit('I <can> not')", buffered))
            self.expect(done, **{"too few": 1})
            self.assertIn("ten, too few: ended with status 1 before it had answered: I <can> not",
                          done.stdout)

    def test_a_hang_is_ended_and_told(self):
        for buffered in (False, True):
            done = self.ask_ten(self.faulty("time.sleep(1000)", buffered))
            self.expect(done, hung=1, **{"not asked": 4})
            self.assertIn("ten, hung: gave no answer in time and was killed, exactly 1\n"
                          "  orient2d 7 7 8 8 9 10\n", done.stdout)

    def test_an_answer_left_out_or_given_twice_is_found(self):
        done = self.ask_ten(self.faulty("answer = None"))
        self.expect(done, **{"too few": 1})
        self.assertIn("\n  orient2d 7 7 8 8 9 10\n", done.stdout)
        done = self.ask_ten(self.faulty("print(answer)"))
        self.expect(done, **{"too many": 1})
        self.assertIn("\n  orient2d 7 7 8 8 9 10\n", done.stdout)

    def test_garbage_is_told(self):
        for said in ("left", "1.0", "", "1 1", "0x1", "--1", "999999999999999999999"):
            done = self.ask_ten(self.faulty(f"answer = {said!r}"))
            self.expect(done, garbage=1)
        done = self.ask_ten(self.faulty("answer = 'error: too near'"))
        self.expect(done, refused=1)
        done = self.ask_ten(self.faulty("answer = '2'"))
        self.expect(done, wrong=1)
        done = self.ask_ten(self.faulty("answer = '?'"))
        self.expect(done, undecided=1)

    def test_blanks_and_a_plus_are_read(self):
        self.assertEqual(self.ask_ten(self.faulty("answer = ' +1 \\r'")).returncode, 0)

    def test_a_line_without_an_end_and_answers_without_number(self):
        endless = "while True: sys.stdout.write('1' * 4096)"
        self.expect(self.ask_ten(self.faulty(endless)), garbage=1)
        done = self.ask_ten(self.faulty("while True: print(1)"))
        self.expect(done, **{"too many": 1})

    def test_a_slow_answer_is_counted_and_taken(self):
        done = self.ask_ten(self.faulty("time.sleep(0.3)"), "--slow", "0.2")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(self.counts(done)["slow"], "1")
        self.assertIn("ten, slow: '1', exactly 1\n  orient2d 7 7 8 8 9 10\n", done.stdout)

    def test_a_program_that_does_not_end_is_told(self):
        program = self.program(f"#!{sys.executable} -S\nimport sys, time\n"
                               "for line in iter(sys.stdin.readline, ''): print(1, flush=True)\n"
                               "time.sleep(1000)\n")
        self.write("one.txt", "orient2d 0 0 1 0 0 1\n")
        done = self.challenge("--classes", "one.txt", "--timeout", "0.5", program)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.counts(done)["right"], "1")
        self.assertIn("did not end after its last answer", done.stdout)

    def test_programs_that_read_nothing(self):
        for text, verdict in (("exit 0", "too few"), ("exec 0<&-; exec 1>&-; sleep 1000", "hung"),
                              ("exec 0<&-; while :; do echo 1; done", "too many")):
            program = self.program(f"#!/bin/sh\n{text}\n")
            done = self.challenge("--predicate", "orient2d", "--classes", "random", "--count", "3000",
                                  "--timeout", "0.3", program)
            self.assertEqual(done.returncode, 1)
            self.assertGreater(int(self.counts(done)[verdict]), 0, done.stdout)

    def test_a_program_that_always_fails_is_given_up(self):
        program = self.program("#!/bin/sh\nkill -ABRT $$\n")
        done = self.challenge("--predicate", "orient2d", "--classes", "grid,offset", program)
        self.assertEqual(self.counts(done)["crashed"], str(2 * 5))
        program = self.program("#!/bin/sh\nsleep 1000\n")
        done = self.challenge("--predicate", "orient2d", "--count", "9", "--timeout", "0.2", program)
        self.assertEqual(self.counts(done)["hung"], "8")
        self.assertIn("Given up after 8 questions", done.stdout)

    def test_nothing_is_left_running(self):
        program = self.program("#!/bin/sh\nsleep 98765 & sleep 98765\n")
        self.write("one.txt", "orient2d 0 0 1 0 0 1\n")
        self.challenge("--classes", "one.txt", "--timeout", "0.2", program)
        asked = subprocess.Popen([command.PROGRAM, "challenge", program], cwd=self.folder,
                                 stdout=subprocess.DEVNULL)
        time.sleep(0.5)
        asked.send_signal(signal.SIGINT)
        asked.wait(10)
        time.sleep(0.2)
        left = [p for p in pathlib.Path("/proc").glob("[0-9]*")
                if os.path.exists(p) and self.runs(p, str(self.folder))]
        self.assertEqual(left, [])

    # Each program leaves a process in a session of its own, and then ends or goes on.
    DAEMONS = {
        "a child in a session of its own": "setsid sleep 98765 & sleep 98765",
        "a daemon of two forks": "(setsid sh -c 'sleep 98765 & exit' &) ; exit 0",
        "daemons of daemons": "for i in 1 2 3; do setsid sh -c 'setsid sh -c \"setsid sleep 98765 & "
                              "sleep 98765\" & exit' & done; sleep 98765",
        "one that ignores signals": "setsid sh -c 'trap \"\" TERM HUP INT; while :; do sleep 1; done' & "
                                    "exit 0",
        "one without its standard output": "setsid sleep 98765 </dev/null >/dev/null 2>&1 & exit 0",
    }

    def left_in_folder(self):
        """Returns the processes whose folder is this test's, with their commands."""
        left = []
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(process / "cwd") == str(self.folder):
                    left.append((process.name, (process / "cmdline").read_bytes()))
            except OSError:
                continue  # ended meanwhile, or another user's
        return left

    def test_what_calls_setsid_is_ended_too(self):
        self.write("one.txt", "orient2d 0 0 1 0 0 1\n")
        for what, script in self.DAEMONS.items():
            with self.subTest(what):
                program = self.program(f"#!/bin/sh\n{script}\n")
                done = self.challenge("--classes", "one.txt", "--predicate", "orient2d", "--timeout", "0.2",
                                      program)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertNotIn("could not be ended", done.stdout)
                self.assertEqual(self.left_in_folder(), [])

    def test_what_calls_setsid_is_ended_when_the_command_is_killed(self):
        self.write("one.txt", "orient2d 0 0 1 0 0 1\n")
        program = self.program("#!/bin/sh\nsetsid sleep 98765 &\nsleep 98765\n")
        for signal_sent in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            asked = subprocess.Popen([command.PROGRAM, "challenge", "--classes", "one.txt", program],
                                     cwd=self.folder, stdout=subprocess.DEVNULL)
            until = time.monotonic() + 20
            while sum(b"sleep" in words for _, words in self.left_in_folder()) < 2:
                self.assertLess(time.monotonic(), until, "the program was not started")
                time.sleep(0.02)
            asked.send_signal(signal_sent)
            asked.wait(20)
            while self.left_in_folder():
                self.assertLess(time.monotonic(), until, self.left_in_folder())
                time.sleep(0.02)

    def test_the_whole_run_has_a_limit(self):
        # The program answers every 50 ms, so it never exceeds the limit for one answer, and does not finish.
        program = self.program(f"#!{sys.executable} -S\nimport sys, time\n"
                               "for line in iter(sys.stdin.readline, ''):\n"
                               "    print(1, flush=True)\n    time.sleep(0.05)\n")
        self.write("many.txt", "orient2d 0 0 1 0 0 1\n" * 1000)
        done = self.challenge("--classes", "many.txt", "--predicate", "orient2d", "--max-seconds", "2", program,
                              seconds=30)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        counts = self.counts(done)
        self.assertGreater(int(counts["right"]), 0)
        self.assertEqual(int(counts["right"]) + int(counts["not asked"]), 1000)
        self.assertIn("The time for the whole run is over: the rest was not asked.", done.stdout)
        self.assertEqual(self.left_in_folder(), [])

    @staticmethod
    def runs(process, folder):
        try:
            return os.readlink(process / "cwd") == folder and \
                b"sleep" not in (process / "cmdline").read_bytes()[:6]
        except OSError:
            return False

    def test_records_are_written_with_their_answers_and_read_again(self):
        asked = ("--count", "7", "--classes", "tangent,mirror", "--predicate", "dominates")
        for name in ("a.txt", "b.txt"):
            self.assertEqual(self.challenge(*asked, "--records", name).returncode, 0)
        text = (self.folder / "a.txt").read_text()
        self.assertEqual(text, (self.folder / "b.txt").read_text())
        answers = re.findall(r"^#= (.*)$", text, flags=re.MULTILINE)
        self.assertEqual(self.run_command("eval", "a.txt").stdout.split(), answers)
        done = self.challenge("--classes", "a.txt", command.PROGRAM, "eval")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.counts(done, "mirror")["records"], "7")
        # Smaller counts, fewer classes and decimal output select the same records.
        self.challenge("--count", "3", "--classes", "mirror", "--records", "c.txt", "--decimal")
        decimal = [r for r in (self.folder / "c.txt").read_text().splitlines() if "dominates" in r]
        same = text.split("# class mirror")[1].splitlines()[1:7:2]
        self.assertEqual([[float(x) for x in r.split()[1:]] for r in decimal],
                         [[float.fromhex(x) for x in r.split()[1:]] for r in same])
        self.challenge(*asked, "--seed", "2", "--records", "d.txt")
        self.assertNotEqual(text, (self.folder / "d.txt").read_text())

    def test_a_class_goes_on_where_its_name_comes_again(self):
        one, two = "orient2d 0 0 1 0 0 1\n", "orient2d 0 0 1 0 0 -1\n"
        self.write("two.txt", f"# class one\n{one}# class two\n{two}# class one\n{two}")
        done = self.challenge("--classes", "two.txt", command.PROGRAM, "eval")
        rows = [line.split()[:2] for line in done.stdout.splitlines()[1:4]]
        self.assertEqual(rows, [["one", "2"], ["two", "1"], ["all", "3"]])

    def test_a_file_that_contradicts_is_refused(self):
        for text, message in (("orient2d 0 0 1 0 0 1\n#= -1\n", "bad.txt:2: says '-1', the exact"),
                              ("\norient2d 0 0 1 0 0\n", "bad.txt:2: orient2d takes 6 numbers, got 5"),
                              ("#= 1\n", "bad.txt:1: an answer without a record"),
                              ("is_left 1\n", "bad.txt:1: field 1: unknown predicate 'is_left'")):
            self.write("bad.txt", text)
            done = self.challenge("--classes", "bad.txt", command.PROGRAM, "eval")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(message, done.stderr)

    def test_reports(self):
        double = ("--classes", "kettner,tangent", command.PROGRAM, "eval", "--kernel", "double")
        for name in ("report.md", "report.html"):
            done = self.challenge("--count", "10", "-o", name, *double)
            self.assertEqual(done.returncode, 1)
            text = (self.folder / name).read_text()
            for word in ("kettner", "By predicate", "edge_test", "wrong", "exactly", "0x1"):
                self.assertIn(word, text)
            for tag in ("table", "h2", "pre", "td", "ul"):
                self.assertEqual(text.count(f"<{tag}>") + text.count(f"<{tag} "),
                                 text.count(f"</{tag}>"))
        done = self.ask_ten(self.faulty("sys.exit('I <can> not')"), "-o", "report.html")
        self.assertIn("I &lt;can&gt; not", (self.folder / "report.html").read_text())

    def test_bad_usage_is_refused_and_nothing_is_written(self):
        program = self.faulty("pass")
        before = self.files()
        for arguments, message in (
                ((), "no COMMAND"), (("--cuont", "3", program), "unknown option '--cuont'"),
                (("./missing",), "'./missing' cannot be run: No such file"),
                ((".",), "cannot be run: "),
                (("--predicate", "orient3d", program), "unknown predicate 'orient3d'"),
                (("--classes", "grids", program), "'grids' is neither a class (--list) nor a file"),
                (("--classes", ".", program), ".: is a directory"),
                (("--count", "0", program), "--count"), (("--timeout", "0", program), "--timeout"),
                (("-o", "report.pdf", program), "report.pdf: a report ends in .md or .html"),
                (("-o", "no/report.md", program), "no/report.md"),
                (("--records", "r.txt", program), "leave './program' out")):
            done = self.challenge(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertIn(message, done.stderr)
        self.assertEqual(self.files(), before)

    def test_options_after_the_command_are_its_own(self):
        program = self.program('#!/bin/sh\n[ "$1 $2" = "--count -o" ] && exec ' + command.PROGRAM +
                               " eval\n")
        done = self.challenge("--count", "3", "--classes", "grid", program, "--count", "-o")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(self.counts(done)["records"], "39")
        self.assertIn(f"note: --count goes to '{program}', since it is behind it", done.stderr)
        done = self.ask_ten(self.faulty("pass"), "-o", "report.md")
        self.assertEqual(done.stderr, "")

    def test_the_classes_are_listed(self):
        names = [line.split(":")[0] for line in self.challenge("--list").stdout.splitlines()]
        for name in ("random", "one-ulp", "grid", "cocircular", "collinear", "tangent",
                     "common-roots", "ill-conditioned", "scaled", "subnormal", "offset"):
            self.assertIn(name, names)


if __name__ == "__main__":
    unittest.main()
