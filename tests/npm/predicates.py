# SPDX-License-Identifier: MIT
"""The package asterism-predicates, packed, installed and asked: by node (import and require), by the compiler of
TypeScript, as robust-predicates in delaunator and d3-delaunay, and by headless Chromium. The corpus of
questions is answered as its records say, and by the tiers that decide natively.
    predicates.py PROJECT WORK ASTERISM
Exit status 77: skipped, since Emscripten, node or npm is missing. What else is missing is said."""
import json
import lzma
import pathlib
import shutil
import subprocess
import sys

import served

BOUND = 150_000  # greatest size of the packed file in bytes
FROM_REGISTRY = ["typescript", "robust-predicates"]
SKIPPED = 77
NAMES = {"is_spd": "isPositiveDefinite"}


def run(command, folder):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def built(project):
    """Packs the package anew, and returns the file."""
    missing = [tool for tool in ("em++", "node", "npm") if shutil.which(tool) is None]
    if missing:
        print("skipped:", ", ".join(missing), "not installed")
        sys.exit(SKIPPED)
    run([project / "scripts/build-npm", "asterism-predicates"], project)
    packed, = (project / "build/npm").glob("asterism-predicates-*.tgz")
    size = packed.stat().st_size
    print(f"{packed.name}: {size} bytes")
    if size > BOUND:
        sys.exit(f"the package has more than {BOUND} bytes")
    return packed


def installed(packed, project, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    (work / "package.json").write_text('{"name": "tests", "version": "1.0.0", "private": true, "type": "module"}\n')
    run(["npm", "install", "--offline", "--silent", packed], work)
    for path in (project / "tests/npm").iterdir():
        if path.suffix in (".mjs", ".ts", ".html"):
            shutil.copy(path, work)
    corpus = lzma.decompress((project / "examples/challenge/corpus.txt.xz").read_bytes())
    (work / "corpus.txt").write_bytes(corpus)


def camel_case(name):
    first, *rest = name.split("_")
    return NAMES.get(name, first + "".join(word.capitalize() for word in rest))


def native_tiers(asterism, work):
    """Returns, from the command's statistics, for each predicate how many questions each tier decided."""
    done = subprocess.run([asterism, "eval", "--stats", work / "corpus.txt"], capture_output=True, text=True, check=True)
    rows = [line.split() for line in done.stderr.splitlines()[1:] if not line.startswith("answers")]
    return {camel_case(row[0]): dict(zip(("semiStatic", "interval", "exact"), map(int, row[1:4]))) for row in rows}


def judge(told, where, tiers):
    print(f"{where}: {told['records']} records, {told['wrong']} wrong, {told['wrongInTables']} wrong in tables")
    if told["records"] != 100310 or told["wrong"] or told["wrongInTables"]:
        sys.exit(f"{where}: the corpus is not answered alike")
    if told["tiers"] != tiers:
        sys.exit(f"{where}: other tiers decide than natively:\n{told['tiers']}\n{tiers}")


def in_place_of_robust_predicates(packed, work):
    """Installs delaunator and d3-delaunay in a host whose package.json replaces robust-predicates by this package."""
    folder = work / "override"
    folder.mkdir()
    told = {"name": "override", "version": "1.0.0", "private": True, "type": "module",
            "overrides": {"robust-predicates": f"file:{packed}"}}
    (folder / "package.json").write_text(json.dumps(told))
    run(["npm", "install", "--silent", "delaunator", "d3-delaunay@6.0.4"], folder)
    shutil.copy(work / "delaunator.mjs", folder)
    print(run(["node", "delaunator.mjs"], folder).strip())


def with_packages_of_others(packed, work):
    """Checks types, and both packages in place of robust-predicates. Needs a registry of npm."""
    fetched = subprocess.run(["npm", "install", "--silent", *FROM_REGISTRY], cwd=work, capture_output=True, text=True,
                             check=False)
    if fetched.returncode != 0:
        print("skipped: types and robust-predicates; the registry gave no", ", ".join(FROM_REGISTRY))
        return
    run(["npx", "tsc", "--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "types.ts"], work)
    print(run(["node", "robust_predicates.mjs"], work).strip())
    in_place_of_robust_predicates(packed, work)


def in_chromium(project, work, tiers):
    told = served.told_by("corpus.html", project, work, 120)
    if told is None:
        return
    judge(told, "Chromium", tiers)


def main():
    project, work, asterism = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    packed = built(project)
    installed(packed, project, work)
    tiers = native_tiers(asterism, work)
    print(run(["node", "--test", "interface.mjs"], work).splitlines()[-8:])
    judge(json.loads(run(["node", "corpus_in_node.mjs", "corpus.txt"], work)), "node", tiers)
    with_packages_of_others(packed, work)
    in_chromium(project, work, tiers)


if __name__ == "__main__":
    main()
