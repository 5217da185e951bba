# SPDX-License-Identifier: MIT
"""report.py RAW PAGE PLOT CMAKE_CACHE: writes the Markdown page and the plot from the benchmarks' JSON."""
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys

import closeness_plot
import tables
from measurements import measurements
from page import wrapped


def first_line(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")[0]
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def processor():
    text = pathlib.Path("/proc/cpuinfo").read_text() if os.path.exists("/proc/cpuinfo") else ""
    fields = dict(re.findall(r"^(.*?)\s*:\s*(.*)$", text, re.MULTILINE))
    name = fields.get("model name", platform.processor())
    family = f"family {fields.get('cpu family', '?')} model {fields.get('model', '?')}"
    vectors = [f for f in ("avx2", "avx512f") if f in fields.get("flags", "").split()]
    virtual = ", virtual machine" if "hypervisor" in fields.get("flags", "") else ""
    return f"{name} ({family}, {', '.join(vectors) or 'no AVX2'}), {os.cpu_count()} cores{virtual}"


def machine(raw, cache):
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE)
    benchmark = json.loads((raw / "predicates.json").read_text())["context"]
    cgal = pathlib.Path("/usr/include/CGAL/version.h")
    found = re.search(r"#define CGAL_VERSION (\S+)", cgal.read_text()) if cgal.exists() else None
    return [f"Processor: {processor()}.",
            f"Load when measured: {', '.join(f'{x:.1f}' for x in benchmark['load_avg'])}"
            " (1, 5 and 15 minutes; 0 is idle).",
            f"Compiler: {first_line(compiler.group(1) if compiler else 'c++', '--version')},"
            " release build (-O3, no -march).",
            f"Rivals: CGAL {found.group(1) if found else 'unknown'}."
            f" System: {platform.system()} {platform.machine()}.",
            f"Project at {first_line('git', '-C', str(pathlib.Path(__file__).parent), 'rev-parse', '--short', 'HEAD')},"
            f" {datetime.date.today().isoformat()}."]


def page(raw, cache, plot_link):
    timed = measurements(json.loads((raw / "predicates.json").read_text()))
    shares = json.loads((raw / "shares.json").read_text())
    whole = json.loads((raw / "whole_run.json").read_text())
    parts = [
        "# Performance\n",
        "Written by `scripts/bench docs`; [bench/README.md](../../bench/README.md) says what is measured and how."
        " Ratios compare contenders that took turns in one run; they carry over to other machines better than"
        " nanoseconds do.\n",
        "\n".join(f"- {line}" for line in machine(raw, cache)) + "\n",
        "## Against plain doubles and CGAL\n", tables.goals(timed),
        "## All times\n", tables.times(timed),
        "## Batches\n", tables.batches(timed),
        "## How often plain doubles are wrong\n", tables.wrong(shares),
        "## Which tier decides\n", tables.tiers(shares),
        "## Close to degeneracy\n",
        "Share of wrong answers of plain doubles, and time a question, against the relative distance from the place"
        " where the answer changes. All answers of the filtered kernel are right.\n",
        f"![error rate and time against closeness]({plot_link})\n",
        "## The whole job\n", tables.whole(whole)]
    return wrapped("\n".join(parts))


def main():
    raw, page_path, plot_path, cache_path = (pathlib.Path(p) for p in sys.argv[1:5])
    plot_link = os.path.relpath(plot_path, page_path.parent)
    page_path.write_text(page(raw, cache_path.read_text(), plot_link), encoding="utf-8")
    closeness = json.loads((raw / "shares.json").read_text())["closeness"]
    plot_path.write_text(closeness_plot.svg(closeness), encoding="utf-8")


if __name__ == "__main__":
    main()
