#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What others take along says what is so: the citation has the version, the image the packages of scripts/setup.sh,
the forge's step every input of action.yml, with the exit statuses of the command, a source distribution every file,
the Debian packages every file that is installed, and the wheel the licences of what is in it.
check_take_along.py SOURCE ASTERISM FOLDER."""
import fnmatch
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Prints the files of standard input, one a line, that MANIFEST.in leaves out, by what makes source distributions.
LEFT_OUT = """
import sys
from setuptools.command.egg_info import FileList
listed = sys.stdin.read().split("\\0")
chosen = FileList()
chosen.allfiles = listed
for line in open("MANIFEST.in"):
    rule = line.split("#")[0].strip()
    if rule:
        chosen.process_template_line(rule)
print(*sorted(set(listed) - set(chosen.files)), sep="\\n")
"""

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


def check_image_of_action():
    """GitHub's runner takes an image for a file by the end of its name (ActionManager.cs), and refuses all others."""
    image = re.search(r"^  image: (\S+)$", text("action.yml"), re.M)[1]
    check(image.endswith("Dockerfile") and text(image) == text("Containerfile"), f"action.yml: image {image}")


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
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    for name in "a", "b c":
        subprocess.run([COMMAND, "mesh", "square", "--size", "0.5", "-o", f"{name}.mesh", "--quiet"], cwd=FOLDER, check=True)
    done = run_action(mesh="*.mesh")
    check(done.returncode == 0 and "b c.mesh" in done.stdout, f"certified meshes: {done}")
    (FOLDER / "in ner/most").mkdir(parents=True)
    shutil.copy(FOLDER / "a.mesh", FOLDER / "in ner/most/c.mesh")
    done = run_action(mesh="a.mesh\n**/c.mesh")
    check(done.returncode == 0 and "a.mesh\n" in done.stdout and "in ner/most/c.mesh" in done.stdout, f"two patterns: {done}")
    done = run_action(mesh="a.mesh", metric="", voronoi="true")
    check(done.returncode == 0, f"the metric beside the mesh: {done}")
    done = run_action(mesh="a.mesh", angle_bound="59")
    check(done.returncode == 1, f"a bound that is not kept: {done}")
    (FOLDER / "broken.mesh").write_text("MeshVersionFormatted 2\nDimension\n", encoding="utf-8")
    done = run_action(mesh="*.mesh")
    check(done.returncode == 2 and "broken.mesh" in done.stderr, f"a file that cannot be read: {done}")
    done = run_action(mesh="none/*.mesh")
    check(done.returncode == 2 and "no file" in done.stderr, f"no file: {done}")


def check_source_distribution():
    found = subprocess.run(["git", "-C", TOP, "ls-files", "-z"], capture_output=True, text=True, check=False)
    if found.returncode != 0:
        print("skipped: the source distribution; without git the files of the project are not known")
        return
    check(found.stdout, f"{TOP}: git lists no file")
    left_out = subprocess.run(["/usr/bin/python3", "-W", "ignore", "-c", LEFT_OUT], cwd=TOP, input=found.stdout.strip("\0"),
                              capture_output=True, text=True, check=True).stdout.split()
    check(not left_out, f"MANIFEST.in: leaves out {left_out[:9]}")


def check_packages():
    """Whatever the build tree installs is in some Debian package, but for what debian/rules leaves out."""
    patterns = [line for path in (TOP / "debian").glob("*.install") for line in path.read_text(encoding="utf-8").split()]
    prefix = FOLDER / "usr"
    built = pathlib.Path(COMMAND).resolve().parents[1]
    subprocess.run(["cmake", "--install", built, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
    installed = sorted(prefix.rglob("*"))
    check(prefix / "bin/asterism" in installed, f"cmake --install {built}: no command was installed")
    for path in installed:
        name = path.relative_to(FOLDER)
        if path.is_dir() or name.name in ("asterism-mpi", "asterism-occt", "LICENSE"):
            continue
        # In a Debian package the libraries are below the machine's name.
        spellings = [str(name), re.sub("^usr/lib/", "usr/lib/machine/", str(name))]
        packed = any(fnmatch.fnmatch(spelling, pattern) or spelling.startswith(pattern + "/") or
                     fnmatch.fnmatch(spelling, pattern + "/*")
                     for spelling in spellings for pattern in patterns)
        check(packed, f"debian/*.install: no package has {name}")
    shutil.rmtree(prefix)


def check_licences():
    sys.path.insert(0, str(TOP / "scripts"))
    import bundle_libraries

    included = set()
    for folder in "core", "predicates", "kernels", "mesh", "python/src":
        for path in (TOP / folder).rglob("*.[ch]pp"):
            included |= set(re.findall(r"^#include <(boost|nlohmann|pybind11)/", path.read_text(encoding="utf-8"), re.M))
    check(included == {"boost", "nlohmann", "pybind11"}, f"libraries of headers: {included}")
    places = [pathlib.Path(place) for place in bundle_libraries.COMPILED_IN.values()]
    check({place.parts[3] for place in places} == included, f"bundle_libraries.COMPILED_IN: {places}, not {included}")
    gmp = next(pathlib.Path("/usr/lib").rglob("libgmp.so.10")).resolve()
    written = FOLDER / "licences"
    bundle_libraries.write_licences({"libgmp": gmp, "nlohmann-json": places[1]}, written)
    check({"LGPL-3", "GPL-3", "libgmp.txt", "nlohmann-json.txt"} <= {path.name for path in written.iterdir()},
          f"licences of GMP: {sorted(written.iterdir())}")
    check("GNU LESSER GENERAL PUBLIC LICENSE" in (written / "LGPL-3").read_text(encoding="utf-8"), "LGPL-3: another text")


check_citation()
check_image()
check_image_of_action()
check_action()
check_source_distribution()
check_packages()
check_licences()
