# SPDX-License-Identifier: MIT
"""Adaptation loops, BAMG and this project side by side, on metrics as simulations make them."""
import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import functions  # noqa: E402
import meshes  # noqa: E402


def timed(command, folder, limit):
    """Returns exit status (None: ended by the limit), user seconds and output. A run shorter than a tenth of a second
    is repeated, and the mean is returned: clocks of processes count hundredths."""
    enough, most = 0.1, 10
    before, status, output, runs = resource.getrusage(resource.RUSAGE_CHILDREN), None, "", 0
    spent = 0.0
    while runs == 0 or (spent < enough and runs < most and status is not None):
        try:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=limit, check=False)
            status, output = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired as late:
            status, output = None, str(late.stdout or "")
        runs += 1
        spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before.ru_utime
    return status, spent / runs, output


class Bamg:
    name = "BAMG"

    def __init__(self, options):
        self.options = options

    def command(self, vertices):
        return [self.options.bamg, "-b", "background.mesh", "-M", "background.mtr", "-o",
                "made.mesh", "-nbv", str(3 * vertices + 2000), "-v", "1"]

    def details(self, folder, row):
        del folder, row


class Asterism:
    name = "Asterism"

    def __init__(self, options):
        self.options = options

    def command(self, vertices):
        del vertices
        words = self.options.with_options.split()
        return [self.options.asterism, "mesh", "square", "--metric", "background.mesh", "--size",
                "1", "--threads", "1", "-o", "made.mesh", *words]

    def details(self, folder, row):
        certificate = folder / "made.certificate.json"
        if not certificate.exists():
            return
        text = json.loads(certificate.read_text(encoding="utf-8"))
        row["reason"] = text["outcome"].get("reason", "")
        row["worst"] = text["audit"]["worst_angle"]
        delivered = text["outcome"].get("delivered")
        if delivered:
            row["changed"] = delivered.get("beyond_tenth")
            row["distance"] = delivered.get("greatest")
            row["median"] = delivered.get("median")


def hessians_of(name, mesh):
    """Returns the Hessian at the vertices: exact, or for NAME~ recovered from the values, or for NAME~~ recovered
    from values with noise."""
    plain = name.rstrip("~")
    if name == plain:
        return functions.hessians(plain, mesh.points)
    values = functions.values(plain, mesh.points)
    if name.endswith("~~"):
        values = values + np.random.default_rng(1).normal(0, 1e-4, len(values))
    return meshes.recovered_hessians(mesh, values)


def one_pass(contender, name, mesh, vertices, folder, options):
    tensors = meshes.l2_metric(mesh, hessians_of(name, mesh), vertices)
    meshes.write(folder / "background.mesh", mesh)
    meshes.write_mtr(folder / "background.mtr", tensors)
    meshes.write_sol(folder / "background.sol", tensors)
    for old in folder.glob("made*"):
        old.unlink()
    status, seconds, output = timed(contender.command(vertices), folder, options.limit)
    row = {"status": status, "seconds": seconds}
    (folder / "output.txt").write_text(output, encoding="utf-8")
    if status not in (0, 1) or not (folder / "made.mesh").exists():
        return row, None
    made = meshes.read(folder / "made.mesh")
    if made.triangles is None or not len(made.triangles):
        return row, None
    row["v"] = len(made.points) / vertices
    covered = made.areas().sum()
    plain = name.rstrip("~")
    error = meshes.l2_error(made, lambda p: functions.values(plain, p))
    row["error"] = error * len(made.points) if abs(covered - 4) < 1e-6 else float("nan")
    contender.details(folder, row)
    if status == 1:
        row["reason"] = output.strip().splitlines()[-1].removeprefix("asterism: ")
    return row, made


def loop(contender, name, vertices, options):
    folder = pathlib.Path(options.work) / name.replace("~", "_r") / str(vertices) / contender.name
    folder.mkdir(parents=True, exist_ok=True)
    mesh, rows = meshes.grid(max(10, int(np.sqrt(vertices / 2)))), []
    for _ in range(options.passes):
        row, made = one_pass(contender, name, mesh, vertices, folder, options)
        rows.append(row)
        if made is None:
            break
        mesh = made
    return rows


def text_of(row):
    parts = [f"end {row['status']}", f"{row['seconds']:6.3f} s"]
    if "v" in row:
        parts += [f"v {row['v']:.3f}", f"err {row['error']:.4g}"]
    if row.get("worst") is not None:
        parts.append(f"worst {row['worst']:.1f}")
    if row.get("changed") is not None:
        parts.append(f"changed {100 * row['changed']:.0f} %")
    if row["status"] == 1:
        parts.append(row.get("reason", "")[:150])
    return "  ".join(parts)


def median_of_last(rows, key):
    found = [row[key] for row in rows[-3:] if key in row and np.isfinite(row[key])]
    return float(np.median(found)) if found else float("nan")


def already_measured(path):
    """Returns the functions and counts that a file of --json has, so that an interrupted run goes on."""
    if not path or not os.path.exists(path):
        return set()
    with open(path, encoding="utf-8") as lines:
        rows = [json.loads(line) for line in lines]
    return {(row["function"], row["vertices"]) for row in rows}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--bamg", default="ffbamg")
    parser.add_argument("--work", default="/tmp/bench-adapt")
    parser.add_argument("--functions", nargs="+", default=[*functions.FUNCTIONS, "shock~",
                                                           "front~~"])
    parser.add_argument("--vertices", nargs="+", type=int, default=[500, 2000])
    parser.add_argument("--passes", type=int, default=5)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--with-options", default="")
    parser.add_argument("--only", choices=["BAMG", "Asterism"])
    parser.add_argument("--json", help="append what was measured to this file; what it has is not measured again")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    started, measured = time.time(), already_measured(options.json)
    for vertices in options.vertices:
        ratios = []
        for name in options.functions:
            if (name, vertices) in measured:
                continue
            stored = pathlib.Path(options.work) / f"bamg_{name.replace('~', '_r')}_{vertices}.json"
            results = {}
            for contender in (Bamg(options), Asterism(options)):
                if contender.name == "BAMG" and stored.exists() and options.only == "Asterism":
                    results["BAMG"] = json.loads(stored.read_text(encoding="utf-8"))
                    continue
                if contender.name == "Asterism" and options.only == "BAMG":
                    continue
                rows = results[contender.name] = loop(contender, name, vertices, options)
                if contender.name == "BAMG":
                    stored.write_text(json.dumps(rows), encoding="utf-8")
                for i, row in enumerate(rows):
                    print(f"{name:9} {vertices:6} {contender.name:8} {i + 1}  {text_of(row)}",
                          flush=True)
            if len(results) == 2:
                b, a = results["BAMG"], results["Asterism"]
                error = median_of_last(a, "error") / median_of_last(b, "error")
                seconds = median_of_last(a, "seconds") / median_of_last(b, "seconds")
                ended = sum(row["status"] == 0 for row in a)
                v = [row.get("v", float("nan")) for row in a]
                ratios.append((error, seconds, ended == options.passes))
                print(f"{name:9} {vertices:6} SUMMARY  error/BAMG {error:.3f}  time/BAMG "
                      f"{seconds:.1f}  status 0 {ended}/{options.passes}  v {min(v):.3f}-"
                      f"{max(v):.3f}  (BAMG v {median_of_last(b, 'v'):.3f})", flush=True)
            if options.json:
                with open(options.json, "a", encoding="utf-8") as out:
                    out.write(json.dumps({"function": name, "vertices": vertices, **results}) + "\n")
        if ratios:
            table = np.array([(e, s) for e, s, _ in ratios])
            good = np.isfinite(table[:, 0])
            if not good.any():
                continue
            print(f"ALL {vertices}: error/BAMG mean {table[good, 0].mean():.3f} worst "
                  f"{table[good, 0].max():.3f}, time/BAMG median {np.median(table[:, 1]):.1f} "
                  f"worst {table[:, 1].max():.1f}, all passes status 0: "
                  f"{sum(ok for *_, ok in ratios)}/{len(ratios)}", flush=True)
    print(f"{time.time() - started:.0f} s in all")


if __name__ == "__main__":
    main()
