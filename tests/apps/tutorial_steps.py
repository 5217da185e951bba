# SPDX-License-Identifier: MIT
"""The steps of a tutorial: files in fences that are named after them, and shell commands in fences, in order. A
fence named `cpp PATH` or `c PATH` quotes that file of the project."""
import os
import pathlib
import re
import shutil
import subprocess

TOP = pathlib.Path(__file__).resolve().parents[2]
TUTORIALS = TOP / "docs/tutorial"
FENCE = re.compile(r"^```(\S+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)


def text_of(name):
    return (TUTORIALS / name).read_text(encoding="utf-8")


def commands_that_work_here(body):
    """Returns the lines; None if they need a program that is not installed."""
    missing = [name for name in ("FreeFem++-nw",) if name in body and shutil.which(name) is None]
    return None if missing else body


def run(body, folder, program):
    """Raises AssertionError, with the output, unless the commands end as the tutorial says."""
    path = os.pathsep.join([str(pathlib.Path(program).resolve().parent), os.environ["PATH"]])
    # Runs the lines together, so that loops work. -e ends the script at the first failing command; lines that end in
    # a test of $? are excepted.
    script = re.sub(r"^(.*); (test \$\? -eq \d)$", r"set +e; \1; \2 || exit 99; set -e", body, flags=re.M)
    done = subprocess.run(["bash", "-ec", script], cwd=folder, capture_output=True, text=True, timeout=600,
                          check=False, env={**os.environ, "PATH": path})
    assert done.returncode == 0, f"{body}\n{done.stdout}{done.stderr}"


def quoted(path, body):
    """True if the lines stand in the file, in a row, up to their indentation."""
    def lines(text):
        return [line.strip() for line in text.splitlines() if line.strip()]

    wanted, there = lines(body), lines((TOP / path).read_text(encoding="utf-8"))
    return any(there[i:i + len(wanted)] == wanted for i in range(len(there)))


def follow(name, folder, program):
    """Does all steps. Returns the pictures that the page shows, and the names of the steps."""
    text, skipped = text_of(name), False
    for kind, path, body in FENCE.findall(text):
        if path:
            assert quoted(path, body), f"{name}: what it quotes is not in {path}"
        elif kind == "sh":
            here = commands_that_work_here(body)
            skipped = skipped or here is None
            run(here or "", folder, program)
        else:
            (folder / kind).write_text(body, encoding="utf-8")
    shown = re.findall(r"\]\(figures/([\w.-]+)\)", text)
    made = [picture for picture in shown if (folder / picture).is_file()]
    assert skipped or made == shown, f"{name}: the steps do not make {set(shown) - set(made)}"
    return made
