#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shows naive stars (the thesis's section 3.1) that disagree. Sites c and d of four each map all four to the plane
in which their own metric is the identity, triangulate there, and keep their star. The edge cd is in one of these
stars only. The insertion test of section 3.3 gives the same answer from both sites.

naive_stars.py ASTERISM [PICTURE.svg]"""
import math
import subprocess
import sys

SITES = {  # position and metric tensor m11, m12, m22
    "a": ((-1.0, 0.1), (1, 0, 1)),
    "b": ((1.1, 0.0), (1, 0, 1)),
    "c": ((0.05, -0.95), (1, 0.2, 3)),
    "d": ((0.0, 1.0), (3, -0.3, 1)),
}
RING = "cbda"  # counter-clockwise


def ask(command, *questions):
    done = subprocess.run([command, "eval"], input="\n".join(questions), capture_output=True, text=True, check=True)
    return [int(line) for line in done.stdout.split()]


def words(*names):
    return " ".join(repr(float(n)) for name in names for part in SITES[name] for n in part)


def point_words(*names):
    return " ".join(repr(n) for name in names for n in SITES[name][0])


def naive_star(command, of):
    """Returns the neighbours of c or d in the Delaunay triangulation of the four sites in its own metric. The edge cd
    is in it if d is inside the circle of a, c, b, which are counter-clockwise, so that ab is not."""
    inside, = ask(command, f"in_circle {' '.join(map(str, SITES[of][1]))} {point_words('a', 'c', 'b', 'd')}")
    return {"a", "b"} | ({"c", "d"} - {of} if inside > 0 else set())


def tested_star(command, of):
    """Returns the neighbours by the insertion test: whether the opposite site belongs between the two beside `of`."""
    at = RING.index(of)
    before, across, after = (RING[(at + i) % 4] for i in (1, 2, 3))
    takes, = ask(command, f"edge_test {words(of, across, before, after)}")
    return {before, after} | ({across} if takes else set())


def has_edge(stars, v, w):
    return w in stars[v], v in stars[w]


def warped(point, metric):
    """Returns F p, where F^T F = M."""
    m11, m12, m22 = metric
    root = math.sqrt(m11)
    return root * point[0] + m12 / root * point[1], math.sqrt(m22 - m12 * m12 / m11) * point[1]


def panel(x, title, places, edges, colours, ellipses=()):
    scale, middle = 62, (x + 130, 160)
    at = {n: (middle[0] + scale * p[0], middle[1] - scale * p[1]) for n, p in places.items()}
    lines = [f'<text x="{middle[0]}" y="24" text-anchor="middle">{title}</text>']
    for path, colour in ellipses:
        text = " ".join(f"{middle[0] + scale * u:.1f},{middle[1] - scale * v:.1f}" for u, v in path)
        lines.append(f'<polygon points="{text}" fill="{colour}" fill-opacity="0.12" stroke="{colour}"/>')
    for v, w in edges:
        (x1, y1), (x2, y2) = at[v], at[w]
        heavy = ' stroke-width="2.5"' if {v, w} in ({"a", "b"}, {"c", "d"}) else ""
        lines.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="#222"{heavy}/>')
    for name, (u, v) in at.items():
        lines.append(f'<circle cx="{u:.1f}" cy="{v:.1f}" r="4" fill="{colours.get(name, "#222")}"/>')
        lines.append(f'<text x="{u + 8:.1f}" y="{v - 6:.1f}">{name}</text>')
    return lines


def circle(name):
    """Yields points of the site's unit ellipse at half its size."""
    (x, y), (m11, m12, m22) = SITES[name]
    root, low = math.sqrt(m11), math.sqrt(m22 - m12 * m12 / m11)
    for i in range(60):
        t = 2 * math.pi * i / 60
        v = math.sin(t) / low / 2
        yield x + (math.cos(t) / 2 - m12 / root * v) / root, y + v


def draw(path, naive, tested):
    colours = {"c": "#1f5fa8", "d": "#b3362b"}
    places = {n: p for n, (p, _) in SITES.items()}
    sides = [(RING[i], RING[(i + 1) % 4]) for i in range(4)]

    def edges(star, of):
        return [*sides, ("c", "d") if {"c", "d"} - {of} <= star else ("a", "b")]

    circles = [(list(circle(n)), colours[n]) for n in "cd"]
    parts = [panel(0, "four sites; circles of c and d", places, sides, colours, circles)]
    for i, of in enumerate("cd", 1):
        seen = {n: warped(p, SITES[of][1]) for n, (p, _) in SITES.items()}
        seen = {n: (0.8 * u, 0.8 * v) for n, (u, v) in seen.items()}
        parts.append(panel(260 * i, f"as {of} sees them", seen, edges(naive[of], of), colours))
    parts.append(panel(780, "by the insertion test", places, edges(tested["c"], "c"), colours))
    body = "\n".join(line for part in parts for line in part)
    with open(path, "w", encoding="utf-8") as out:
        out.write('<svg xmlns="http://www.w3.org/2000/svg" width="1040" height="310" viewBox="0 0 1040 310" '
                  f'font-family="sans-serif" font-size="14">\n<rect width="1040" height="310" fill="white"/>\n{body}\n'
                  "</svg>\n")


def main():
    command = sys.argv[1]
    naive = {n: naive_star(command, n) for n in "cd"}
    tested = {n: tested_star(command, n) for n in SITES}
    for how, stars in (("naive", naive), ("insertion test", tested)):
        in_c, in_d = has_edge(stars, "c", "d")
        print(f"{how}: cd is {'' if in_c else 'not '}in the star of c, and {'' if in_d else 'not '}in that of d"
              f": {'they agree' if in_c == in_d else 'inconsistent'}")
    if len(sys.argv) > 2:
        draw(sys.argv[2], naive, tested)
    one_edge = set(has_edge(tested, "c", "d")) | {not e for e in has_edge(tested, "a", "b")}
    return 0 if has_edge(naive, "c", "d") == (False, True) and len(one_edge) == 1 else 1


if __name__ == "__main__":
    sys.exit(main())
