#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What others take along says what is so: the citation has the version, the image the packages of scripts/setup.sh,
and the forge's step every input of action.yml, with the exit statuses of the command.
check_take_along.py SOURCE ASTERISM FOLDER."""
import os
import pathlib
import re
import subprocess
import sys

TOP, COMMAND, FOLDER = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3])


def text(name):
    return (TOP / name).read_text(encoding="utf-8")


def check(holds, what):
    if not holds:
        sys.exit(what)


def check_citation():
    version = re.search(r'VERSION_TEXT "([^"]+)"', text("core/version.h"))[1]
    check(f"\nversion: {version}\n" in text("CITATION.cff"), f"CITATION.cff: the version is {version}")


def check_image():
    listed = re.search(r"command_packages=\(([^)]*)\)", text("scripts/setup.sh"))[1].split()
    image = text("Containerfile")
    installed = re.search(r"no-install-recommends \\\n(.*?)\nCOPY", image, re.S)[1].replace("\\", " ").split()
    check(sorted(listed) == sorted(installed), f"Containerfile: installs {installed}, scripts/setup.sh lists {listed}")
    copied = re.findall(r"^COPY (scripts/\S+)", image, re.M)
    check(copied and all((TOP / name).is_file() for name in copied), "Containerfile: copies what is not there")


def run_action(**inputs):
    """Runs the step as a forge would: inputs come from the environment, defaults from action.yml. Returns its
    status."""
    declared = dict(re.findall(r'^  (\w+):\n    description:.*\n(?:    required: true\n|    default: "?(.*?)"?\n)', text("action.yml"), re.M))
    check(set(inputs) <= set(declared), f"action.yml: has no {set(inputs) - set(declared)}")
    given = {f"INPUT_{name.upper()}": value for name, value in {**declared, **inputs}.items()}
    script = text("scripts/certify-action")
    check(all(name in script for name in given), "scripts/certify-action: reads not every input of action.yml")
    return subprocess.run(["bash", TOP / "scripts/certify-action"], cwd=FOLDER, capture_output=True, text=True,
                          env={**os.environ, **given, "ASTERISM_COMMAND": COMMAND}, check=False)


def check_action():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for old in FOLDER.glob("*"):
        old.unlink()
    for name in "a", "b c":
        subprocess.run([COMMAND, "mesh", "square", "--size", "0.5", "-o", f"{name}.mesh", "--quiet"], cwd=FOLDER, check=True)
    done = run_action(mesh="*.mesh")
    check(done.returncode == 0 and "b c.mesh" in done.stdout, f"certified meshes: {done}")
    done = run_action(mesh="a.mesh", metric="", voronoi="true")
    check(done.returncode == 0, f"the metric beside the mesh: {done}")
    done = run_action(mesh="a.mesh", angle_bound="59")
    check(done.returncode == 1, f"a bound that is not kept: {done}")
    (FOLDER / "broken.mesh").write_text("MeshVersionFormatted 2\nDimension\n", encoding="utf-8")
    done = run_action(mesh="*.mesh")
    check(done.returncode == 2 and "broken.mesh" in done.stderr, f"a file that cannot be read: {done}")
    done = run_action(mesh="none/*.mesh")
    check(done.returncode == 2 and "no file" in done.stderr, f"no file: {done}")


check_citation()
check_image()
check_action()
