# SPDX-License-Identifier: MIT
"""Runs ended by a limit or an interrupt, through the real command: the part that is certain is written, and the
output says how far the run came."""
import json
import resource
import signal
import subprocess
import time
import unittest

import command
import hostile_inputs


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


class HostileJobs(command.CommandTest):
    """Limits and interrupts on jobs of which one star, or one question, takes long."""

    def setUp(self):
        super().setUp()
        self.write("fan.poly", hostile_inputs.fan(360, 1))
        for name in ("random_1e4", "random_30"):
            mesh, solution = hostile_inputs.MESHES[name]()
            self.write(f"{name}.mesh", mesh)
            self.write(f"{name}.sol", solution)

    JOBS = [["mesh", "fan.poly", "--metric", "swirl:12", "-o", "out.mesh"],
            ["mesh", "random_30.mesh", "--metric", "random_30.mesh", "-o", "out.mesh"],
            ["certify", "random_1e4.mesh", "--repair", "-o", "out.mesh"]]

    def test_seconds_are_kept_inside_one_star(self):
        for words in self.JOBS:
            with self.subTest(words):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                done = self.run_command(*words, "--max-seconds", "1")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                # The limit of one second counts two threads; what follows it runs on one.
                spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                self.assertLess(spent, 5)
                if "1 seconds have passed" in done.stderr:
                    self.assertEqual(done.returncode, 1)

    def test_an_interrupt_is_heeded_while_a_mesh_is_repaired(self):
        with subprocess.Popen([command.PROGRAM, *self.JOBS[2]], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as run:
            time.sleep(1)
            run.send_signal(signal.SIGINT)
            _, told = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 1, told.decode())


if __name__ == "__main__":
    unittest.main()
