# SPDX-License-Identifier: MIT
"""vary.py SOURCE BUILD [NAME ...]: what other values of the chosen constants would do.

Copies the source, changes one constant after the other, builds the command and runs the constant's
jobs; NAME chooses constants by a part of their name. What was measured is kept in measured.json
beside this file, with the commit, and the page docs/results/constants.md is written from all of it.
"""
import json
import pathlib
import subprocess
import sys

from constants import CONSTANTS, DOMAINS, GROUPS

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from page import table, wrapped  # noqa: E402

LIMIT = 120  # seconds of one job


def copy(source, to):
    """Updates the copy. Leaves unchanged files untouched, so that they are not compiled again."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z"], capture_output=True, check=True).stdout
    for name in listed.decode().split("\0"):
        path = pathlib.Path(source, name)
        if name and path.is_file() and not name.startswith(("docs/figures/", "tests/")):
            write(to / name, path.read_bytes())


def write(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != content:
        path.write_bytes(content)


def build(copied, folder):
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "release", "-B", folder, "-DASTERISM_BUILD_TESTS=OFF",
                        "-DASTERISM_BUILD_PYTHON=OFF", "-DBUILD_SHARED_LIBS=OFF"], cwd=copied, check=True,
                       stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "apps/asterism"], check=True,
                   stdout=subprocess.DEVNULL)
    return (folder / "apps" / "asterism").resolve()


def measure(command, job, folder):
    """Runs a job on one thread. Returns a summary of its certificate."""
    out = folder / "mesh.mesh"
    for old in folder.glob("mesh.*"):
        old.unlink()
    try:
        done = subprocess.run([command, "mesh", *job.split(), "--threads", "1", "--quiet", "-o", out],
                              cwd=folder, capture_output=True, text=True, timeout=LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return f"more than {LIMIT} s"
    file = folder / "mesh.certificate.json"
    if not file.exists():
        return f"status {done.returncode}"
    certificate = json.loads(file.read_text())
    decided = certificate["outcome"]["decided"]
    questions = sum(decided["edge_test"].values())
    measured, audit = certificate["measured"], certificate["audit"]
    text = (f"{certificate['mesh']['vertices']}, {audit['worst_angle']:.1f}, {measured['mean_quality']:.3f},"
            f" {questions / 1000:.0f}k")
    if certificate["outcome"]["delivered"]:
        text += f", {100 * certificate['outcome']['delivered']['beyond_tenth']:.0f} %"
    return text + (" *" if done.returncode else "")


def results_of(constant, source, copied, folder):
    """Returns [[a value, a cell for each job ...] ...], the value kept first."""
    path, original = copied / constant.file, (source / constant.file).read_text()
    placed = constant.text.replace("@", constant.kept)
    if original.count(placed) != 1:
        sys.exit(f"vary: {constant.file} has not one '{placed}'")
    rows = []
    for value in [constant.kept, *constant.tried]:
        write(path, original.replace(placed, constant.text.replace("@", value)).encode())
        command = build(copied, folder)
        rows.append([value] + [measure(command, job, folder / "jobs") for job in GROUPS[constant.group]])
        print(constant.name, *rows[-1], sep=" | ", file=sys.stderr, flush=True)
    write(path, original.encode())
    return rows


def section(group, measured):
    jobs = "\n".join(f"{number}. `{job}`" for number, job in enumerate(GROUPS[group], 1))
    parts = [f"## {group}\n", jobs + "\n"]
    for constant in CONSTANTS:
        if constant.group != group or constant.name not in measured:
            continue
        found = measured[constant.name]
        head = ["value"] + [f"job {i}" for i in range(1, len(GROUPS[group]) + 1)]
        rows = [[f"**{row[0]}**", *row[1:]] if row[0] == constant.kept else row for row in found["rows"]]
        parts += [f"*{constant.name.capitalize()}*, `{constant.file}` (at {found['commit']}):\n", table(head, rows)]
    return "\n".join(parts)


def page(measured):
    intro = ("# Constants that experiments chose\n\nWritten by `scripts/vary-constants`, which changes one constant"
             " at a time, builds the command and runs the jobs. Bold is the value kept. In a cell: sites, worst angle"
             " in degrees away from sharp corners, mean quality, and thousands of edge tests; where another metric was"
             " delivered, how many tensors differ by more than a tenth; a star where the run did not end complete."
             " `bench/constants/constants.py` lists constants, values and jobs.\n\n"
             "A value is kept where none of the others is better on all of its jobs by more than a fiftieth in sites"
             " or quality, or by a degree, and worse in none of these. (Sites are not compared in jobs with a number of"
             " vertices.) Where rows are nearly equal the constant only bounds the work, and any of the values is"
             " suitable.\n")
    groups = [g for g in GROUPS if any(c.group == g and c.name in measured for c in CONSTANTS)]
    return wrapped("\n".join([intro] + [section(g, measured) for g in groups]))


def main():
    source, folder = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    chosen = [c for c in CONSTANTS if not sys.argv[3:] or any(n in c.name for n in sys.argv[3:])]
    (folder / "jobs").mkdir(parents=True, exist_ok=True)
    for name, text in DOMAINS.items():
        (folder / "jobs" / name).write_text(text)
    kept = source / "bench/constants/measured.json"
    measured = json.loads(kept.read_text()) if kept.exists() else {}
    commit = subprocess.run(["git", "-C", source, "rev-parse", "--short", "HEAD"], capture_output=True, text=True,
                            check=True).stdout.strip()
    copied = folder / "source"
    copy(source, copied)
    for constant in chosen:
        measured[constant.name] = {"commit": commit, "rows": results_of(constant, source, copied, folder)}
        kept.write_text(json.dumps(measured, indent=1) + "\n")
        (source / "docs/results/constants.md").write_text(page(measured), encoding="utf-8")


if __name__ == "__main__":
    main()
