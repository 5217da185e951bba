# SPDX-License-Identifier: MIT
"""Runs a program and measures it by the system's counts of that child alone."""
import json
import pathlib
import subprocess


class Run:
    """seconds: from start to end; processor: user and system seconds; megabytes: greatest resident size."""

    def __init__(self, found, output):
        self.status, self.timed_out, self.output = found["status"], found["late"], output
        self.seconds, self.processor, self.megabytes = (
            found["seconds"], found["processor"], found["megabytes"])


def run(measure, arguments, folder, limit):
    """`measure` is the program measure.cpp; the child is ended after `limit` whole seconds."""
    done = subprocess.run([str(measure), str(limit), *arguments], cwd=folder, check=True, capture_output=True,
                          text=True)
    output = (pathlib.Path(folder) / "output.txt").read_text(encoding="utf-8", errors="replace")
    return Run(json.loads(done.stdout), output)
