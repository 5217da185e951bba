# SPDX-License-Identifier: MIT
"""compare.py: this project's mesher beside BAMG. Prints a Markdown page; see bench/README.md."""
import argparse
import datetime
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import sys

import growth_plot
from contenders import Asterism, Bamg, Case, Failed

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from page import table, wrapped  # noqa: E402

COST = ["wanted", "program", "lengths", "triangles", "wall", "processor", "peak memory", "triangles/s",
        "/ processor s"]
QUALITY = ["wanted", "program", "unit edges", "worst angle", "below 20", "turned over"]


def seconds(x):
    return f"{x:.3g} s"


class Measured:
    """Measures calls of one contender on one case."""

    def __init__(self, contender):
        self.contender, self.runs, self.failure, self.triangles = contender, [], "", 0

    def attempt(self, what):
        if self.failure:
            return
        try:
            what()
        except Failed as failure:
            self.failure = str(failure)

    def once(self):
        self.attempt(lambda: self.runs.append(self.contender.call()))

    def wall(self):
        return statistics.median(r.seconds for r in self.runs)

    def judged(self):
        case = self.contender.case
        return json.loads(case.ask("judge", str(self.contender.folder / self.contender.mesh),
                                   case.metric, repr(case.size)))

    def rows(self):
        """Returns a row of times and sizes, and one of measures of quality."""
        start = [str(self.contender.case.triangles), self.contender.name]
        if self.failure:
            told = [self.failure.replace("\n", " ")]
            return [start + told + ["-"] * (len(head) - len(start) - 1) for head in (COST, QUALITY)]
        found = self.judged()
        processor = statistics.median(r.processor for r in self.runs)
        verdict = "" if all(r.status == 0 for r in self.runs) else " (not certified)"
        cost = [f"x {self.contender.factor:.2f}", str(found["triangles"]) + verdict, seconds(self.wall()),
                seconds(processor), f"{max(r.megabytes for r in self.runs):.0f} MB",
                f"{found['triangles'] / self.wall():.3g}", f"{found['triangles'] / processor:.3g}"]
        quality = [f"{100 * found['unit edges']:.1f} %",
                   f"{found['worst angle']:.1f} ({found['worst angle unforced']:.1f})", str(found["low"]),
                   str(found["turned over"])]
        return [start + cost, start + quality]


def repetitions(measured):
    """Repeats short calls more often. All contenders of a case take turns."""
    longest = max((m.runs[0].seconds for m in measured if m.runs), default=0)
    return 5 if longest < 2 else 3 if longest < 20 else 1


def compare(case, contenders):
    measured = [Measured(c) for c in contenders]
    for m in measured:
        m.attempt(m.contender.prepare)
        m.once()
    for _ in range(repetitions(measured) - 1):
        for m in measured:
            m.once()
    for m in measured:
        print(case.metric, *m.rows()[0], file=sys.stderr, flush=True)
    return measured


def chosen(text, options):
    """Parses OPTIONS, or OPTIONS@N, which stands for up to N triangles only."""
    found = []
    for entry in options:
        words, _, most = entry.partition("@")
        found.append((words.split(), int(most) if most else None))
    return [(words, most) for words, most in found if "--refine" not in words or words[1] in text]


def first_line(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return (done.stdout + done.stderr).strip().split("\n")[0] if done.returncode == 0 else "unknown"


def growth(done):
    """Returns the ratio of times for ten times more triangles, and the points of the plot."""
    rows, curves = [], {}
    for m in done:
        if m.runs and not m.failure:
            curves.setdefault(m.contender.case.metric, {}).setdefault(m.contender.name, []).append(
                (m.triangles, m.wall()))
    for metric, lines in curves.items():
        for name, points in lines.items():
            steps = [f"{(t / s) / (n / k) * 10:.1f}" for (k, s), (n, t) in zip(points, points[1:])]
            if steps:
                rows.append([metric, name, ", ".join(f"{n:.3g}" for n, _ in points), ", ".join(steps)])
    return table(["metric", "program", "triangles", "ten times more cost"], rows), curves


def phases(build, metric, size, wall):
    """Returns the table of phases, and the gain of a second thread, in one process. `wall` is the command's time, if
    known."""
    done = subprocess.run([build / "bench" / "phases_bench", metric, repr(size), "3"], capture_output=True,
                          text=True, check=False)
    if done.returncode != 0:
        return f"phases_bench failed: {done.stderr.strip()}\n"
    found = json.loads(done.stdout)
    t = found["seconds"]
    rows = [[what, seconds(t[f"{what}, one thread"]), seconds(t[f"{what}, all threads"]),
             f"{t[f'{what}, one thread'] / t[f'{what}, all threads']:.2f}x"]
            for what in ("refinement", "audit", "bulk building", "refinement in doubles")]
    both, audit = "refinement, all threads", "audit, all threads"
    return "\n".join([
        f"`{metric}`, {found['triangles']} triangles, {found['threads']} threads, medians of {found['rounds']} rounds"
        " that took turns. Refinement is fill, stars, queue of bad triangles and mending; bulk building makes all stars at once from"
        " the sites and boundary of the mesh that came out, and holds each against all sites.\n",
        table(["phase", "one thread", "all threads", "speed-up"], rows),
        f"The audit is {100 * t[audit] / (t[audit] + t[both]):.1f} % of refinement and audit together, files left out"
        + (f", and {100 * t[audit] / wall:.1f} % of the {wall:.3g} s of the whole command" if wall else "") + ";"
        f" refinement with filtered predicates takes {t[both] / t['refinement in doubles, all threads']:.2f} times as"
        " long as with plain doubles, whose stars disagree more often.\n"])


def compared(rows):
    """Returns a section for each metric: {metric: [rows of times, rows of quality]}."""
    parts = []
    for metric, (cost, quality) in rows.items():
        parts += [f"## {metric}\n", table(COST, cost), table(QUALITY, quality)]
    return "\n".join(parts)


def introduction(bamg):
    here = pathlib.Path(__file__).parent
    package = first_line("dpkg-query", "-W", "-f", "${Package} ${Version}", "freefem++")
    return "\n".join([
        "# Comparison with BAMG\n",
        "Written by `scripts/bench-rivals`; [bench/README.md](../../bench/README.md) says how. The square [-1,1]^2, the"
        " same metric for both, scaled so that unit edges give the number of triangles wanted; lengths are multiplied by"
        " the factor in the table where a program's count would be off by more than 20 percent. Files are read and"
        " written in both. Times are medians of 1 to 5 calls that took turns.\n",
        "BAMG reads its metric on a background mesh. It was run on its own result, with the metric evaluated there,"
        " until the count changed by less than 2 percent; *only the last of these calls is measured*, and neither the"
        " calls before it nor the evaluation of the metric. The time of Asterism is that of the whole command: exact"
        " predicates, metric by formula, audit and certificate.\n",
        "Unit edges: share with length from 1/sqrt 2 to sqrt 2. Worst angle: in the metrics of all three vertices,"
        " in brackets away from corners that no mesh can give 20 degrees; below 20: triangles away from them."
        " Both meshes are judged with the metric as given at their vertices.\n",
        f"- BAMG: `{bamg}` of Debian's {package}. Asterism at"
        f" {first_line('git', '-C', str(here), 'rev-parse', '--short', 'HEAD')}, {datetime.date.today().isoformat()}.",
        f"- {platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start.\n"])


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--metrics", nargs="*", default=["identity", "swirl:24", "sink:24", "layer:0.001,0.1"])
    parser.add_argument("--triangles", nargs="*", type=int, default=[1000, 10000, 100000, 1000000])
    parser.add_argument("--ours", nargs="*", default=["--refine fill", "--refine voronoi@1000"])
    parser.add_argument("--alone", nargs="*", default=["swirl:24@4000000", "swirl:24@10000000"],
                        help="METRIC@N: without the rival")
    parser.add_argument("--phases", type=int, default=1000000, help="triangles; 0: none")
    parser.add_argument("--plot", type=pathlib.Path, help="the plot's file")
    parser.add_argument("--limit", type=int, default=600, help="seconds a call")
    return parser.parse_args()


def main():
    asked = arguments()
    bamg = shutil.which("ffbamg")
    if bamg is None:
        sys.exit("bench-rivals: ffbamg not found (Debian: freefem++)")
    build, command = asked.build.resolve(), str(asked.build.resolve() / "apps" / "asterism")
    ours = chosen(subprocess.run([command, "mesh", "--help"], capture_output=True, text=True, check=True).stdout,
                  asked.ours)
    opening, done = introduction(bamg), []
    sizes = [(metric, triangles, True) for metric in asked.metrics for triangles in asked.triangles]
    sizes += [(metric, int(n), False) for metric, _, n in (entry.partition("@") for entry in asked.alone)]
    rows = {}
    for metric, triangles, beside in sizes:
        folder = asked.work.resolve() / f"{metric.replace(':', '_')}-{triangles}"
        shutil.rmtree(folder, ignore_errors=True)
        case = Case(build / "bench", metric, triangles, folder, asked.limit)
        contenders = [Bamg(case, bamg)] if beside else []
        contenders += [Asterism(case, command, words) for words, most in ours
                       if most is None or triangles <= most]
        measured = compare(case, contenders)
        for m in measured:
            for column, row in zip(rows.setdefault(metric, ([], [])), m.rows()):
                column.append(row)
        done += measured
        for m in measured:
            m.triangles = m.contender.count() if m.runs else 0
        shutil.rmtree(folder)
    text, curves = growth(done)
    page = [opening, compared(rows), "## Growth\n", "Time is wall time; 10 would be linear.\n", text]
    if asked.plot:
        asked.plot.write_text(growth_plot.svg(curves), encoding="utf-8")
        page.append("![time a triangle against triangles](../figures/growth.svg)\n")
    if asked.phases:
        size = float(subprocess.run([build / "bench" / "mesh_statistics", "size", "swirl:24", str(asked.phases)],
                                    capture_output=True, text=True, check=True).stdout)
        wall = next((m.wall() for m in done if isinstance(m.contender, Asterism) and m.runs and
                     (m.contender.case.metric, m.contender.case.triangles) == ("swirl:24", asked.phases)), None)
        page += ["## Threads, and the audit's share\n", phases(build, "swirl:24", size, wall)]
    print(wrapped("\n".join(page)), end="")


if __name__ == "__main__":
    main()
