# SPDX-License-Identifier: MIT
"""The package asterism-mesh, packed, installed and asked, by node and by headless Chromium. The recorded jobs
(tests/runs) that need no file give the command's files: .mesh and .sol byte for byte, the certificate but for how
many orientations were asked.
    mesh.py PROJECT WORK ASTERISM
Exit status 77: skipped, since Emscripten, node or npm is missing. What else is missing is said."""
import json
import pathlib
import shlex
import shutil
import subprocess
import sys

import served

SKIPPED = 77
NUMBERS = {"--size": "size", "--gradation": "gradation", "--angle-bound": "angleBound", "--metric-tolerance": "metricTolerance",
           "--tol": "tol", "--chord-tolerance": "chordTolerance", "--repair-distance": "repairDistance"}
WHOLE = {"--random-points": "randomPoints", "--seed": "seed", "--max-sites": "maxSites", "--improve": "improve"}
FLAGS = {"--regions": "regions", "--repair-domain": "repairDomain", "--strict": "strict"}
OF_THE_RUN = {"--threads", "-o", "--certificate"}
SILENT = {"--quiet", "--json", "--ellipses"}


def run(command, folder, expected=0):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    if expected is not None and done.returncode != expected:
        sys.exit(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done


def translated(words):
    """Returns the job as the package takes it, or the word that it does not take."""
    options, metric, at = {}, "identity", 2
    if words[0] != "mesh" or words[1] not in ("square", "airfoil"):
        return None, words[1]
    while at < len(words):
        word = words[at]
        value = words[at + 1] if at + 1 < len(words) else ""
        if word in SILENT:
            at += 1
            continue
        if word in FLAGS:
            options[FLAGS[word]] = True
            at += 1
            continue
        if word in NUMBERS:
            options[NUMBERS[word]] = float(value)
        elif word in WHOLE:
            options[WHOLE[word]] = int(value)
        elif word == "--refine":
            options["refine"] = value
        elif word == "--certify":
            options["proveVoronoi"] = value == "voronoi"
        elif word == "--metric":
            metric = value
        elif word not in OF_THE_RUN:
            return None, word
        at += 2
    return {"domain": words[1], "metric": metric, "options": options}, None


def recorded_jobs(project, asterism, work):
    """Yields for each recorded command that meshes a built-in domain the job and the files of the command."""
    sys.path.insert(0, str(project / "tests/runs"))
    import jobs  # pylint: disable=import-outside-toplevel
    taken, passed_over = [], []
    folder = work / "native"
    folder.mkdir()
    for job in jobs.all_jobs():
        for step in job.steps:
            words = shlex.split(step) if isinstance(step, str) else ["", ""]
            if job.files or words[0] != "mesh" or words[1] not in ("square", "airfoil"):
                continue
            if run([asterism, *remade(words)], folder, None).returncode == 2:
                continue
            asked, reason = translated(words)
            if asked is None:
                passed_over.append(f"{job.name} ({reason})")
                continue
            taken.append((f"{job.name}: {step}", asked, [(folder / f"out.{ending}").read_text() for ending in ("mesh", "sol", "certificate.json")]))
    return taken, passed_over


def remade(words):
    """Returns the words of the command with one output only."""
    kept, at = [], 0
    while at < len(words):
        if words[at] in ("-o", "--certificate"):
            at += 2
        else:
            kept.append(words[at])
            at += 1
    return [*kept, "-o", "out.mesh"]


def built(project):
    missing = [tool for tool in ("em++", "node", "npm") if shutil.which(tool) is None]
    if missing:
        print("skipped:", ", ".join(missing), "not installed")
        sys.exit(SKIPPED)
    run([project / "scripts/build-npm", "asterism-mesh"], project)
    packed, = (project / "build/npm").glob("asterism-mesh-*.tgz")
    print(f"{packed.name}: {packed.stat().st_size} bytes")
    return packed


def installed(packed, project, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    (work / "package.json").write_text('{"name": "tests", "version": "1.0.0", "private": true, "type": "module"}\n')
    run(["npm", "install", "--offline", "--silent", packed], work)
    for name in ("mesh.mjs", "mesh.html"):
        shutil.copy(project / "tests/npm" / name, work)


def claims(text):
    """Returns the certificate without counts of orientations. Sorting in another standard library compares in another
    order."""
    def stripped(part):
        if isinstance(part, list):
            return [stripped(one) for one in part]
        return {name: stripped(one) for name, one in part.items() if name != "orientation"} if isinstance(part, dict) else part
    return stripped(json.loads(text))


def compare(taken, answers):
    wrong = 0
    for (name, _, (mesh, solution, certificate)), answer in zip(taken, answers, strict=True):
        others = [what for what, text in (("mesh", mesh), ("solution", solution)) if answer[what] != text]
        if claims(answer["certificate"]) != claims(certificate):
            others.append("certificate")
        if others:
            wrong += 1
            print(f"other bytes: {name}: {', '.join(others)}")
    print(f"{len(taken)} recorded commands, {len(taken) - wrong} with the command's files")
    if wrong or len(taken) < 20:
        sys.exit("not the command's files")


def in_chromium(project, work, asterism):
    told = served.told_by("mesh.html", project, work, 240)
    if told is None:
        return
    print(f"Chromium: {told['triangles']} triangles in {told['seconds']:.2f} s")
    if not (told["certified"] and told["again"]):
        sys.exit("Chromium: not certified")
    run([asterism, "mesh", "square", "--metric", "swirl:12", "--size", "0.0437", "-o", "large.mesh", "--quiet"], work)
    for ending, name in (("mesh", "mesh"), ("sol", "solution")):
        if (work / f"large.{ending}").read_text() != told["files"][name]:
            sys.exit(f"Chromium: another {name} than the command's")


def main():
    project, work, asterism = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    packed = built(project)
    installed(packed, project, work)
    taken, passed_over = recorded_jobs(project, asterism, work)
    (work / "jobs.json").write_text(json.dumps([asked for _, asked, _ in taken]))
    print(run(["node", "mesh.mjs", "jobs.json", "answers.json"], work).stdout.strip())
    compare(taken, json.loads((work / "answers.json").read_text()))
    print("passed over, since the package does not take them:", ", ".join(passed_over) or "none")
    in_chromium(project, work, asterism)


if __name__ == "__main__":
    main()
