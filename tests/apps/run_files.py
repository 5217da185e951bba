# SPDX-License-Identifier: MIT
"""The files of a run are one unit: after whatever happens they are all old or all new, and no
temporary file is left behind."""
import json
import os
import pathlib
import random
import resource
import signal
import shutil
import subprocess
import tempfile
import time
import unittest

import command

OUTPUTS = ["m.mesh", "m.vtu", "m.svg"]
NAMES = sorted([*OUTPUTS, "m.sol", "m.certificate.json"])


def job(size):
    """Returns a job that writes all files. Two sizes make the old files and the new ones."""
    return [command.PROGRAM, "mesh", "square", "--metric", "swirl:3", "--size", size, "--quiet",
            *(word for name in OUTPUTS for word in ("-o", name))]


def ticks_of(process):
    """Returns the processor time of a process in hundredths of a second."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return int(fields[11]) + int(fields[12])


class RunFiles(command.CommandTest):
    def setUp(self):
        super().setUp()
        self.new = self.made_by("0.1")
        self.old = self.made_by("0.3")
        self.assertFalse(any(self.old[name] == self.new[name] for name in NAMES))

    def contents(self):
        return {name: (self.folder / name).read_bytes() for name in self.files() if (self.folder / name).is_file()}

    def made_by(self, size):
        done = subprocess.run(job(size), cwd=self.folder, capture_output=True, timeout=240, check=True)
        self.assertEqual(done.stderr, b"")
        made = self.contents()
        self.assertEqual(sorted(made), NAMES)
        return made

    def put_old(self):
        for name, data in self.old.items():
            (self.folder / name).write_bytes(data)

    def check_unit(self, where):
        """Returns whether the files are the new ones, and checks that they are all old or all new."""
        found = self.contents()
        self.assertEqual(sorted(found), NAMES, where)
        certificate = "m.certificate.json"
        said, new = json.loads(found[certificate]), json.loads(self.new[certificate])
        if (said["theorem"] or {}).get("reason") == "not all was measured: interrupted":
            # A signal between the audit and the hypotheses of the theorem on nets leaves those open. All other fields
            # have their final values.
            self.assertEqual({**said, "theorem": None}, {**new, "theorem": None}, where)
            found[certificate] = self.new[certificate]
        is_new = found == self.new
        self.assertTrue(is_new or found == self.old, f"{where}: old and new files are mixed")
        return is_new

    def test_no_limit_on_the_size_of_files_mixes_them(self):
        sizes = sorted(len(data) for data in self.new.values())
        limits = {0, 1, 4095, 4096, *sizes, *(size - 1 for size in sizes)}
        for limit in sorted(limits):
            self.put_old()
            done = subprocess.run(job("0.1"), cwd=self.folder, capture_output=True, timeout=240, check=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            is_new = self.check_unit(limit)
            self.assertEqual((done.returncode, is_new), (0, True) if limit >= sizes[-1] else (1, False), limit)
            if not is_new:
                self.assertRegex(done.stderr.decode(), r"asterism: m\.\S+: cannot be written: File too large")

    def test_no_limit_on_the_size_of_files_leaves_some_where_there_were_none(self):
        for name in NAMES:
            (self.folder / name).unlink()
        subprocess.run(job("0.1"), cwd=self.folder, capture_output=True, timeout=240, check=False,
                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000)))
        self.assertEqual(self.files(), [])

    def test_a_full_disk(self):
        """Fills disks of some kilobytes. Such a disk needs root, outside of a container."""
        if shutil.which("mount") is None:
            self.skipTest("there is no mount here")
        needed = sum(map(len, [*self.old.values(), *self.new.values()]))
        with tempfile.TemporaryDirectory() as place:
            for part in (0.55, 0.7, 0.85, 1.5):
                size = f"size={int(part * needed) // 4096 * 4096}"
                mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", size, "tmpfs", place], capture_output=True,
                                         check=False)
                if mounted.returncode != 0:
                    self.skipTest("nothing can be mounted here")
                kept, self.folder = self.folder, type(self.folder)(place)
                try:
                    self.put_old()
                    done = subprocess.run(job("0.1"), cwd=place, capture_output=True, timeout=240, check=False)
                    is_new = self.check_unit(part)
                    self.assertEqual((done.returncode, is_new), (0, True) if part > 1 else (1, False), done.stderr)
                finally:
                    self.folder = kept
                    subprocess.run(["umount", place], check=True)

    def test_no_signal_mixes_them(self):
        """Ends runs at moments spread over the whole run, and close together during the writing. The seed replays
        them."""
        moments = random.Random(14)
        ended = {True: 0, False: 0}
        for turn in range(45):
            self.put_old()
            number = (signal.SIGHUP, signal.SIGTERM, signal.SIGINT, signal.SIGQUIT, signal.SIGXCPU)[turn % 5]
            with subprocess.Popen(job("0.1"), cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
                if turn % 3 == 0:
                    time.sleep(moments.uniform(0, 0.3))
                else:
                    while run.poll() is None and not any(n.endswith((".part", ".old")) for n in os.listdir(self.folder)):
                        pass
                    time.sleep(moments.uniform(0, 0.01))
                run.send_signal(number)
                run.communicate(timeout=240)
            found = self.contents()
            if number in (signal.SIGINT, signal.SIGTERM) and run.returncode == 1:
                # A signal noted before the writing began: all files are written, with what was certain then.
                self.assertEqual(sorted(found), NAMES)
                self.assertNotEqual([name for name in NAMES if found[name] == self.old[name]], NAMES)
                self.assertIn(b"interrupted", found["m.certificate.json"])
                continue
            ended[self.check_unit((turn, number))] += 1
            self.assertIn(run.returncode, (0, -number))
        self.assertGreater(ended[True], 10)

    def test_a_directory_that_comes_where_a_file_is_to_be(self):
        """A place becomes unwritable after it was checked: the renamings before it are undone, and the old files
        stay."""
        for blocked in ("m.sol", "m.svg", "m.certificate.json"):
            self.put_old()
            line = job("0.02")
            with subprocess.Popen(line, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
                while run.poll() is None and ticks_of(run.pid) < 10:  # the check of places takes one or two
                    time.sleep(0.001)
                (self.folder / blocked).unlink()
                (self.folder / blocked).mkdir()
                _, told = run.communicate(timeout=240)
            self.assertEqual(run.returncode, 1, told)
            self.assertRegex(told.decode(), f"{blocked}: (Is a directory|exists and is not a regular file|not a regular file)")
            self.assertEqual(self.files(), NAMES)
            (self.folder / blocked).rmdir()
            self.assertEqual(self.contents(), {n: data for n, data in self.old.items() if n != blocked})

    def test_a_picture_alone(self):
        self.put_old()
        limit = len(self.new["m.svg"]) // 4
        done = subprocess.run([command.PROGRAM, "draw", "m.mesh", "-o", "m.svg", "--ellipses"], cwd=self.folder,
                              capture_output=True, timeout=240, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertFalse(self.check_unit("draw"))


if __name__ == "__main__":
    unittest.main()
