# SPDX-License-Identifier: MIT
"""Every command is ended by a signal, and by --max-seconds where it has that, soon and with nothing half written."""
import os
import resource
import signal
import subprocess
import time
import unittest

import command
import hostile_inputs


def grid_files(cells):
    """Returns a grid in the identity metric and a solution on it, as texts."""
    points, triangles = hostile_inputs.grid(cells, cells, 0.3)
    mesh, metric = hostile_inputs.mesh_texts(points, triangles, [(float(cells**2), 0.0, float(cells**2))] * len(points))
    values = ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(points)), "1 1",
              *(repr(x * x * y + y) for x, y in points), "End", ""]
    return mesh, metric, "\n".join(values)


# An insertion test whose exact answer takes long: metrics with many digits, no two alike.
SLOW_RECORD = " ".join(["insertion_test", "0.1 0.2 1.7 0.3 2.9", "0.9000000000000001 0.3 3.3 -0.7 1.9",
                        "0.4 1.1000000000000001 2.2 0.1 1.3", "1.3 0.7 1.1 0.9 2.7"])

# Commands that conclude when a signal comes, say so, and end with status 1.
CONCLUDING = {
    "mesh": ("mesh", "square", "--metric", "swirl:24", "--size", "0.001", "--max-sites", "5000000", "-o", "out.mesh"),
    "mesh, one vertex": ("mesh", "fan.poly", "--metric", "swirl:12", "-o", "out.mesh"),
    "mesh, metric of a file": ("mesh", "wild.mesh", "--metric", "wild.mesh", "-o", "out.mesh"),
    "mesh, a count": ("mesh", "square", "--metric", "expr:1+9*x^2;0;1", "--vertices", "90000", "-o", "out.mesh"),
    "certify": ("certify", "wild.mesh"),
    "certify --repair": ("certify", "wild.mesh", "--repair", "-o", "out.mesh"),
    "verify": ("verify", "wild.mesh", "--angle-bound", "1"),
    "adapt": ("adapt", "grid.mesh", "--solution", "u.sol", "--vertices", "80000", "-o", "out.mesh"),
}
# Commands without a conclusion: the signal ends them at once.
PLAIN = {
    "metric": ("metric", "grid.mesh", "--solution", "u.sol", "--vertices", "5000", "--gradation", "1.01", "-o", "out.mesh"),
    "transfer": ("transfer", "grid.mesh", "u.sol", "grid.mesh", "--transfer", "project", "-o", "out.sol"),
    "draw": ("draw", "grid.mesh", "-o", "out.html"),
    "info": ("info", "grid.mesh"),
    "eval": ("eval", "--kernel", "exact", "slow.txt"),
    "challenge": ("challenge", "--count", "1000000", command.PROGRAM, "eval"),
}


def processor_seconds(pid):
    """Returns the processor seconds that a process has used so far."""
    with open(f"/proc/{pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Interrupts(command.CommandTest):
    # Seconds after the signal: of the processor, over both threads, and of the clock, on a machine with other work.
    MOST_WORKED, MOST_WAITED = 3.0, 20.0

    def setUp(self):
        super().setUp()
        self.write("fan.poly", hostile_inputs.fan(360, 1))
        mesh, metric, values = grid_files(150)
        self.write("grid.mesh", mesh)
        self.write("grid.sol", metric)
        self.write("u.sol", values)
        mesh, metric = hostile_inputs.MESHES["random_30_4489"]()
        self.write("wild.mesh", mesh)
        self.write("wild.sol", metric)
        self.write("slow.txt", (SLOW_RECORD + "\n") * 20000)
        self.inputs = self.files()

    def end_by_signal(self, words, which, after):
        """Returns the status and what was said, or None if the command was faster than `after` processor seconds."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with subprocess.Popen([command.PROGRAM, *words], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE) as run:
            while run.poll() is None and processor_seconds(run.pid) < after:
                time.sleep(0.005)
            if run.poll() is not None:
                return None
            worked, told = processor_seconds(run.pid), time.monotonic()
            run.send_signal(which)
            _, said = run.communicate(timeout=self.MOST_WAITED)
            waited = time.monotonic() - told
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        in_all = used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime
        self.assertLess(in_all - worked, self.MOST_WORKED, (words, which, after))
        self.assertLess(waited, self.MOST_WAITED)
        self.assertEqual([n for n in self.files() if n.endswith((".part", ".old"))], [])
        return run.returncode, said.decode()

    def remove_outputs(self):
        for name in set(self.files()) - set(self.inputs):
            (self.folder / name).unlink()

    def test_commands_that_conclude_end_with_status_1_after_a_signal(self):
        for name, words in CONCLUDING.items():
            for which, after in ((signal.SIGINT, 0.05), (signal.SIGTERM, 0.6), (signal.SIGINT, 2.0)):
                with self.subTest(name, after=after):
                    ended = self.end_by_signal(words, which, after)
                    if ended is not None:
                        self.assertIn(ended[0], (-which,) if after < 0.1 and ended[0] < 0 else (0, 1), ended[1])
                    self.remove_outputs()

    def test_commands_without_a_conclusion_are_ended_by_the_signal_and_leave_nothing(self):
        for name, words in PLAIN.items():
            for which, after in ((signal.SIGTERM, 0.05), (signal.SIGINT, 0.5)):
                with self.subTest(name, after=after):
                    ended = self.end_by_signal(words, which, after)
                    if ended is not None:
                        # Status 0 means that the command had finished before the signal came.
                        self.assertIn(ended[0], (-which, 0), ended[1])
                        # If the signal came during the writing, all files of the command are there, whole.
                        all_files = {"transfer": {"out.sol"}, "draw": {"out.html"}}.get(name, {"out.mesh", "out.sol"})
                        self.assertIn(set(self.files()) - set(self.inputs), (set(), all_files))
                    self.remove_outputs()

    def test_seconds_are_kept(self):
        for name, words in CONCLUDING.items():
            with self.subTest(name):
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                done = self.run_command(*words, "--max-seconds", "0.5", seconds=self.MOST_WAITED)
                used = resource.getrusage(resource.RUSAGE_CHILDREN)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertLess(used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime, self.MOST_WORKED + 1)
                self.remove_outputs()


if __name__ == "__main__":
    unittest.main()
