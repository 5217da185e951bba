# SPDX-License-Identifier: MIT
"""Follows the advice that runs print, and checks that the advised run ends with the status promised: for each row of
the table of causes in docs/manual/statuses.md, and for polygons with vertices one rounding apart."""
import math
import pathlib
import random
import re
import shlex
import shutil
import unittest

import command

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/manual/statuses.md"


def rows(page):
    """Command, advice and status of each row of the table of causes."""
    table = page[page.index("## What to try"):].split("\n## ")[0]
    for line in table.splitlines():
        row = re.fullmatch(r"\| .* \| `asterism (.*)` \| `(.*)` \| (\d) \|", line)
        if row:
            yield shlex.split(row[1].replace("\\|", "|")), row[2], int(row[3])


def advice_in(message):
    """Returns the first option that a message advises."""
    found = re.search(r"asterism: try (.*)|; (--repair-domain) mends it", message)
    return re.split(r", (?:or|which|a) ", found[1] or found[2])[0] if found else None


def followed(arguments, advice):
    """Returns the arguments with the advised option in place of its earlier value."""
    option, *values = shlex.split(advice)
    changed = list(arguments)
    if option in changed:
        at = changed.index(option)
        changed[at:at + 1 + len(values)] = []
    if changed[0] == "certify":
        values = []
        changed += ["-o", "repaired.mesh"]
    return changed + [option, *values]


def nearly_repeated(seed):
    """Returns a polygon with coordinates of one decimal. Some vertices occur twice, one rounding apart."""
    draw = random.Random(seed)
    corners, middle, ring = draw.randint(4, 10), draw.choice([0, 100, 1e4]), []
    for i in range(corners):
        turn, far = 2 * math.pi * (i + 0.8 * draw.random()) / corners, draw.uniform(1, 10)
        ring.append((round(middle + far * math.cos(turn), 1), round(middle + far * math.sin(turn), 1)))
    for _ in range(draw.randint(1, 3)):
        at, aim = draw.randrange(len(ring)), draw.choice([-math.inf, math.inf])
        x, y = ring[at]
        ring.insert(at + 1, draw.choice([(math.nextafter(x, aim), y), (x, math.nextafter(y, aim))]))
    return ring


def poly_text(ring):
    count = len(ring)
    lines = [f"{count} 2 0 0", *(f"{i + 1} {x!r} {y!r}" for i, (x, y) in enumerate(ring)), f"{count} 0",
             *(f"{i + 1} {i + 1} {(i + 1) % count + 1}" for i in range(count)), "0\n"]
    return "\n".join(lines)


class Advice(command.CommandTest):
    def test_each_advice_of_the_table_is_given_and_followed(self):
        listed = list(rows(PAGE.read_text(encoding="utf-8")))
        self.assertGreaterEqual(len(listed), 10)
        self.assertGreaterEqual(10 * sum(status == 0 for _, _, status in listed), 9 * len(listed))
        for name in ("wedge.poly", "rounding.poly", "crossing.poly"):
            shutil.copy(pathlib.Path(__file__).with_name(name), self.folder)
        self.run_command("mesh", "square", "--metric", "swirl:3", "--size", "0.4", "-o", "ok.mesh")
        for arguments, advice, status in listed:
            with self.subTest(arguments):
                output = [] if arguments[0] == "certify" else ["-o", "m.mesh"]
                first = self.run_command(*arguments, *output)
                self.assertNotEqual(first.returncode, 0)
                self.assertEqual(advice_in(first.stderr), advice)
                then = self.run_command(*followed(arguments, advice), *output)
                self.assertEqual(then.returncode, status, then.stderr)

    def test_vertices_a_rounding_apart_are_meshed_or_the_message_names_them_and_the_repair(self):
        repaired = 0
        for seed in range(60):
            with self.subTest(f"replay: nearly_repeated({seed})"):
                self.write("p.poly", poly_text(nearly_repeated(seed)))
                done = self.run_command("mesh", "p.poly", "-o", "p.mesh")
                if done.returncode == 0:
                    continue
                self.assertEqual(advice_in(done.stderr), "--repair-domain")
                if done.returncode == 1:
                    self.assertRegex(done.stderr, r"joins vertices \d+ and \d+, [0-9.e-]+ apart")
                done = self.run_command("mesh", "p.poly", "--repair-domain", "-o", "p.mesh")
                self.assertEqual(done.returncode, 0, done.stderr)
                repaired += 1
        self.assertGreater(repaired, 20)


if __name__ == "__main__":
    unittest.main()
