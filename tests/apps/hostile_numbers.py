# SPDX-License-Identifier: MIT
"""Numbers from 1e-300 to 1e300 in options, coordinates, tensors and values: every command ends with a known status
and bounded work, and nothing that it writes holds a number that is none.

hostile_numbers.py --rows WORD...: as a program of its own, the rows that have all the words, with what they said."""
import math
import re
import resource
import shlex
import subprocess
import sys
import unittest

import command

NUMBERS = ("1e-300", "1e-155", "1e-77", "1e-7", "1e7", "1e77", "1e155", "1e300")
EXTREMES = ("1e-300", "1e-77", "1e77", "1e300")  # fewer numbers, for commands that take longer
MOST_SECONDS = 30
CELLS = 6


def rows(name, entries):
    return [name, str(len(entries)), *(" ".join(map(repr, e)) for e in entries)]


def text(*sections):
    return "\n".join(["MeshVersionFormatted 2", "Dimension 2", *(line for s in sections for line in s), "End", ""])


def grid_points(side):
    return [(side * i / CELLS, side * j / CELLS) for j in range(CELLS + 1) for i in range(CELLS + 1)]


def grid(side):
    """Returns a square of this side: CELLS x CELLS cells, each cut in two."""
    n = CELLS + 1
    triangles = [t for j in range(CELLS) for i in range(CELLS) for a in [j * n + i + 1]
                 for t in ((a, a + 1, a + n, 1), (a + 1, a + n + 1, a + n, 1))]
    return text(rows("Vertices", [(x, y, 0) for x, y in grid_points(side)]), rows("Triangles", triangles))


def at_vertices(kind, entries):
    return text(["SolAtVertices", str(len(entries)), f"1 {kind}", *(" ".join(map(repr, e)) for e in entries)])


def poly(side):
    corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
    return "\n".join(["4 2 0 0", *(f"{i + 1} {x!r} {y!r}" for i, (x, y) in enumerate(corners)), "4 1",
                      *(f"{i + 1} {i + 1} {(i + 1) % 4 + 1} {i + 1}" for i in range(4)), "0", ""])


def files(number):
    """Returns the inputs of a row: domain and mesh of this side, values and tensors of this size."""
    x = float(number)
    bump = [math.exp(-8 * ((a - 0.4)**2 + (b - 0.6)**2)) for a, b in grid_points(1.0)]
    count = len(bump)
    return {
        "big.poly": poly(x), "big.mesh": grid(x), "unit.mesh": grid(1.0),
        "u.sol": at_vertices(1, [(v,) for v in bump]),
        "scaled.sol": at_vertices(1, [(v * x,) for v in bump]),
        "spike.sol": at_vertices(1, [(x if i == count // 2 else v,) for i, v in enumerate(bump)]),
        "two.sol": text(["SolAtVertices", str(count), "2 1 1", *(f"{v!r} {v * x!r}" for v in bump)]),
        "tensor.sol": at_vertices(3, [(x, 0.0, x)] * count),
        "long.sol": at_vertices(3, [(x, 0.0, 1.0)] * count),
        "jump.sol": at_vertices(3, [(x, 0.0, x) if i % 2 else (1.0, 0.0, 1.0) for i in range(count)]),
    }


# Commands; {} is the number. Commands whose run would be long have a limit on sites.
MESH = ["mesh square --complexity {}", "mesh square --metric swirl:3 --complexity {}", "mesh square --size {}",
        "mesh square --metric swirl:3 --size {}", "mesh square --size 0.3 --gradation {}",
        "mesh square --metric swirl:{} --size 0.3", "mesh square --metric sink:{} --size 0.3",
        "mesh square --metric layer:{},0.3", "mesh square --metric layer:0.1,{}", "mesh square --metric shock:{}",
        "mesh square --metric 'expr:{};0;{}'", "mesh square --metric 'expr:{};0;1'",
        "mesh square --metric 'expr:x>0?{}:1;0;1'", "mesh square --metric 'expr:exp(x*{});0;1'",
        "mesh square --metric 'expr:{};0;1' --vertices 300", "mesh square --metric 'expr:x>0?{}:1;0;1' --vertices 300",
        "mesh square --size 0.3 --tol {}", "mesh square --metric swirl:3 --size 0.3 --metric-tolerance {}",
        "mesh airfoil --size 0.3 --chord-tolerance {}", "mesh square --size 0.3 --max-seconds {}",
        "mesh square --size 0.3 --max-memory {}", "mesh square --size 0.3 --angle-bound {}",
        "mesh big.poly --size 0.3", "mesh big.poly --size {}", "mesh big.poly --vertices 300",
        "mesh big.poly --complexity 100", "mesh big.poly --metric swirl:3 --vertices 300",
        "mesh big.poly --repair-domain --repair-distance {} --size {}", "mesh big.poly --repair-domain --vertices 300",
        "mesh big.mesh --size {}", "mesh unit.mesh --size {}"]
MESH = [words + " --max-sites 300 --threads 1 -o out.mesh -o out.vtu -o out.svg" for words in MESH]
METRIC = [f"metric {mesh}.mesh --solution {solution}.sol {more} -o out.mesh"
          for mesh, solution in (("unit", "scaled"), ("unit", "spike"), ("unit", "two"), ("big", "u"), ("big", "scaled"))
          for more in ("", "--norm 1", "--isotropic --gradation 1.5")]
METRIC += [f"metric unit.mesh --solution u.sol {more} -o out.mesh"
           for more in ("--complexity {}", "--error {}", "--hmin {}", "--hmax {}", "--aspect {}", "--gradation {}",
                        "--step {}", "--norm {}", "--hmin {} --hmax {}", "--vertices 100 --hmax {}")]
METRIC += [f"metric unit.mesh --metric {metric}.sol {more} -o out.mesh" for metric in ("tensor", "long", "jump")
           for more in ("", "--vertices 100", "--gradation 1.5")]
METRIC += ["metric big.mesh --implied -o out.mesh", "metric big.mesh --implied --vertices 100 -o out.mesh"]
TRANSFER = [f"transfer {old}.mesh {solution}.sol {new}.mesh --transfer {how} -o out.sol"
            for old, solution, new in (("unit", "scaled", "unit"), ("unit", "spike", "unit"), ("big", "u", "big"),
                                       ("big", "scaled", "big"), ("unit", "two", "unit"), ("big", "u", "unit"))
            for how in ("interpolate", "project", "bounded")]
CERTIFY = [f"certify {mesh}.mesh {metric} {more} --max-sites 300 -o out.mesh"
           for mesh, metric in (("unit", "tensor.sol"), ("unit", "long.sol"), ("unit", "jump.sol"),
                                ("big", "tensor.sol"), ("unit", "--metric identity --size {}"),
                                ("big", "--metric swirl:3 --size {}"), ("unit", "--metric 'expr:x>0.5?{}:1;0;1'"))
           for more in ("", "--repair")]
OTHERS = ["info big.poly", "info big.mesh", "info scaled.sol", "draw big.mesh -o out.svg", "draw big.poly -o out.svg",
          "mesh big.mesh --metric swirl:3 --vertices 100 --max-sites 300 -o out.html"]
ROWS = MESH + METRIC + TRANSFER + CERTIFY + OTHERS

# Spellings of infinity and NaN in any of the programs and formats, in a place for a number.
NO_NUMBER = re.compile(r"(?<![\w.-])[-+]?(nan|inf|infinity)(?![\w.:-])", re.IGNORECASE)
# Numbers beyond the range of doubles, which readers take for infinity.
HUGE = re.compile(r"(?<![\w.])\d(?:\.\d+)?e\+?(?:309|3[1-9]\d|[4-9]\d\d)(?!\w)", re.IGNORECASE)


class HostileNumbers(command.CommandTest):
    def check_row(self, row, number):
        for path in self.folder.iterdir():
            path.unlink()
        given = files(number)
        for name, content in given.items():
            self.write(name, content)
        words = shlex.split(row.replace("{}", number))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = self.run_command(*words, seconds=600)
        except subprocess.TimeoutExpired:
            return ["not ended after 600 s"], None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime - before.ru_utime
        problems = []
        if done.returncode not in (0, 1, 2):
            problems.append(f"status {done.returncode}")
        if seconds > MOST_SECONDS:
            problems.append(f"{seconds:.1f} s")
        if done.returncode == 2 and self.files() != sorted(given):
            problems.append("status 2, and files were written")
        if done.returncode != 0 and not done.stderr and "NOT certified" not in done.stdout:
            problems.append("no message")
        for name, content in [("stdout", done.stdout), ("stderr", done.stderr.replace("or inf", "")),
                              *((p.name, p.read_text(errors="replace")) for p in sorted(self.folder.iterdir())
                                if p.name not in given and p.suffix not in (".vtu", ".html"))]:
            for pattern in (NO_NUMBER, HUGE):
                if found := pattern.search(content):
                    near = content[max(0, found.start() - 40):found.end() + 20].replace("\n", " ")
                    problems.append(f"{name} has {found.group(0)}: {near}")
        return problems, (seconds, done)

    def check(self, all_rows, numbers=NUMBERS):
        for row in all_rows:
            for number in numbers:
                with self.subTest(row=row, number=number):
                    problems, _ = self.check_row(row, number)
                    self.assertEqual(problems, [], f"{number}: {row}")

    def test_mesh(self):
        self.check(MESH, EXTREMES)

    def test_metric(self):
        self.check(METRIC)

    def test_transfer(self):
        self.check(TRANSFER)

    def test_certify(self):
        self.check(CERTIFY, (EXTREMES[0], EXTREMES[-1]))

    def test_the_others(self):
        self.check(OTHERS)


def main():
    test = HostileNumbers()
    test.setUp()
    bad = 0
    for row in ROWS:
        if not all(word in row for word in sys.argv[2:]):
            continue
        for number in NUMBERS:
            problems, ended = test.check_row(row, number)
            bad += bool(problems)
            said = f"{ended[0]:.2f} s, status {ended[1].returncode}: {ended[1].stderr.strip()[-160:]}" if ended else ""
            print(f"{'BAD' if problems else 'ok '} {number} {row}: {problems or ''} {said}", flush=True)
    test.doCleanups()
    print(f"{bad} bad")
    return 1 if bad else 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["--rows"]:
        sys.exit(main())
    unittest.main()
