# SPDX-License-Identifier: MIT
"""A limit on memory is kept within a tenth, whether the fill, the refinement, the audit or the writing takes the
memory. The system measures the greatest resident size."""
import json
import subprocess
import sys
import unittest

import command

SWIRL = ["--metric", "swirl:12", "--max-sites", "1000000"]
BIG = ["square", *SWIRL, "--size", "0.005"]  # a job of some 400 megabytes
SMALL = ["square", *SWIRL, "--size", "0.02"]  # 33,000 sites take 27 megabytes

# Starts the command from a small program: the system counts the memory of the parent at the start.
MEASURE = """
import os, sys
_, status, usage = os.wait4(os.spawnv(os.P_NOWAIT, sys.argv[1], sys.argv[1:]), 0)
print(os.waitstatus_to_exitcode(status), usage.ru_maxrss)
"""


class MemoryLimit(command.CommandTest):
    def run_within(self, megabytes, *arguments):
        """Returns status, standard error, and the greatest resident size in megabytes."""
        words = [command.PROGRAM, "mesh", *arguments, "--max-memory", str(megabytes), "--quiet"]
        done = subprocess.run([sys.executable, "-S", "-c", MEASURE, *words], cwd=self.folder, capture_output=True,
                              text=True, timeout=240, check=True)
        status, used = done.stdout.split()
        return int(status), done.stderr, int(used) * 1024 / 1e6

    def check_within(self, megabytes, *arguments):
        status, told, used = self.run_within(megabytes, *arguments)
        if "-v" in sys.argv:
            print(f"{megabytes} allowed, {used:.1f} used, status {status}: {told.strip()}")
        self.assertLess(used, 1.1 * megabytes, arguments)
        self.assertIn(status, (0, 1))
        self.assertEqual(status == 0, told == "")
        if status == 1:
            self.assertRegex(told, "not reached: stopped: more than|the audit did not end: .*more than|m.vtu: there is not enough memory")
        self.assertFalse([n for n in self.files() if n.endswith((".part", ".old"))])
        return status, told

    def test_runs_that_would_take_more_end_within_it(self):
        for megabytes in (25, 40, 80):
            status, told = self.check_within(megabytes, *BIG, "-o", "m.mesh")
            self.assertEqual(status, 1)
            self.assertIn(f"more than {megabytes} megabytes would be in use", told)
            self.assertEqual(self.files(), ["m.certificate.json", "m.mesh", "m.sol"])
            claim = json.loads((self.folder / "m.certificate.json").read_text(encoding="utf-8"))
            self.assertFalse(claim["outcome"]["complete"])

    def test_runs_that_take_less_are_not_disturbed(self):
        status, _ = self.check_within(60, *SMALL, "-o", "m.mesh")
        self.assertEqual(status, 0)

    def test_in_whichever_part_of_the_run_it_is_reached(self):
        for megabytes in (20, 22, 24, 26, 28, 30, 32):
            self.check_within(megabytes, *SMALL, "-o", "m.mesh", "-o", "m.vtu")

    def test_a_domain_that_alone_takes_more(self):
        corners = 60000
        lines = [f"{corners} 2 0 0"]
        lines += [f"{i + 1} {i} {(i * i) % 7 / 10}" for i in range(corners - 1)]
        lines += [f"{corners} {corners / 2} {corners}", f"{corners} 0"]
        lines += [f"{i + 1} {i + 1} {(i + 1) % corners + 1}" for i in range(corners)] + ["0"]
        self.write("in.poly", "\n".join(lines) + "\n")
        status, told = self.check_within(30, "in.poly", "-o", "m.mesh")
        self.assertEqual(status, 1, told)
        self.assertIn("nothing is written", told)
        self.assertEqual(self.files(), ["in.poly"])


if __name__ == "__main__":
    unittest.main(argv=[a for a in sys.argv if a != "-v"])
