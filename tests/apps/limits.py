# SPDX-License-Identifier: MIT
"""Runs that limits or an interrupt end through the real command: what is certain is written and
says so."""
import json
import signal
import subprocess
import time
import unittest

import command


class Limits(command.CommandTest):
    LONG = ["mesh", "square", "--metric", "swirl:24", "--size", "0.004", "--max-sites", "5000000", "-o", "m.mesh"]

    def check_partial(self, returncode, stderr, reason):
        self.assertEqual(returncode, 1, stderr)
        self.assertIn(f"not reached: stopped: {reason}", stderr)
        self.assertEqual(self.files(), ["m.certificate.json", "m.mesh", "m.sol"])
        self.assertIn(reason, json.loads((self.folder / "m.certificate.json").read_text())["outcome"]["reason"])
        self.assertIn(f"# Incomplete, not certified: stopped: {reason}", (self.folder / "m.mesh").read_text())

    def test_seconds(self):
        done = self.run_command(*self.LONG, "--max-seconds", "0.5")
        self.check_partial(done.returncode, done.stderr, "0.5 seconds have passed")

    def test_memory(self):
        done = self.run_command(*self.LONG, "--max-memory", "30")
        self.check_partial(done.returncode, done.stderr, "more than 30 megabytes would be in use")

    def test_interrupt(self):
        with subprocess.Popen([command.PROGRAM, *self.LONG], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as run:
            time.sleep(0.5)
            run.send_signal(signal.SIGINT)
            _, told = run.communicate(timeout=240)
        self.check_partial(run.returncode, told.decode(), "interrupted")

    def test_an_interrupt_between_two_files_does_not_lose_the_second(self):
        names = ["m.certificate.json", "m.mesh", "m.pdf", "m.png", "m.sol", "m.svg", "m.vtu"]
        outputs = [word for name in names if name[2:] not in ("certificate.json", "sol") for word in ("-o", name)]
        with subprocess.Popen([command.PROGRAM, "mesh", "square", "--size", "0.03", *outputs], cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            while run.poll() is None and not any(name.endswith(".part") for name in self.files()):
                time.sleep(0.001)
            run.send_signal(signal.SIGINT)
            _, told = run.communicate(timeout=240)
        self.assertEqual(run.returncode, 0, told.decode())
        self.assertEqual(self.files(), names)

    def test_threads_change_nothing(self):
        made = []
        for threads in ("1", "3"):
            done = self.run_command("mesh", "square", "--metric", "swirl:12", "--size", "0.05", "--threads", threads,
                                    "-o", "m.mesh")
            self.assertEqual(done.returncode, 0, done.stderr)
            made.append([(self.folder / name).read_bytes() for name in ("m.mesh", "m.sol")])
        self.assertEqual(made[0], made[1])

    def test_what_is_no_limit_is_refused(self):
        for bad in (["--threads", "0"], ["--max-seconds", "-1"], ["--max-memory", "nan"], ["--max-seconds", "soon"]):
            done = self.run_command(*command.JOB, *bad, "-o", "m.mesh")
            self.assertEqual(done.returncode, 2, bad)
            self.assertIn(bad[0], done.stderr)
            self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
