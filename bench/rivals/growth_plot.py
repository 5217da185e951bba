# SPDX-License-Identifier: MIT
"""Draws time per triangle against the number of triangles, a line for each program, as SVG."""
import math

SIZE, LEFT, TOP, GAP = (300, 220), 66, 34, 78
COLOURS = ["#c77f2a", "#4a6fa5", "#3d8b5f", "#8a4f9e"]
FEWEST, MOST = 500, 2e7  # triangles
LEAST, GREATEST = 3e-6, 1e-4  # seconds


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


def share(value, low, high):
    return math.log(min(max(value, low), high) / low) / math.log(high / low)


class Panel:
    """Draws one metric's diagram, with two logarithmic axes."""

    def __init__(self, left, top, title):
        self.left, self.top = left, top
        width, height = SIZE
        self.parts = [f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#888"/>',
                      text(left + width / 2, top - 10, title)]
        for k, label in ((5e-6, "5 us"), (1e-5, "10 us"), (2e-5, "20 us"), (5e-5, "50 us")):
            y = self.y(k)
            self.parts += [f'<line x1="{left}" x2="{left + width}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>',
                           text(left - 6, y + 4, label, "end")]
        for k in range(3, 8):
            self.parts.append(text(self.x(10 ** k), top + height + 17, f'10<tspan dy="-4" font-size="9">{k}</tspan>'))
        self.parts.append(text(left + width / 2, top + height + 34, "triangles"))

    def x(self, triangles):
        return self.left + SIZE[0] * share(triangles, FEWEST, MOST)

    def y(self, seconds):
        return self.top + SIZE[1] * (1 - share(seconds, LEAST, GREATEST))

    def draw(self, points, colour):
        places = [(self.x(n), self.y(t / n)) for n, t in sorted(points)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.8"/>')
        self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places]


def svg(curves):
    """Draws all diagrams; curves: metric -> program -> list of (triangles, seconds)."""
    programs = list(dict.fromkeys(name for lines in curves.values() for name in lines))
    parts, columns = [], 2
    for i, (metric, lines) in enumerate(curves.items()):
        panel = Panel(LEFT + i % columns * (SIZE[0] + GAP), TOP + i // columns * (SIZE[1] + GAP), metric)
        for name, points in lines.items():
            panel.draw(points, COLOURS[programs.index(name) % len(COLOURS)])
        parts += panel.parts
    rows = (len(curves) + columns - 1) // columns
    width, height = LEFT + columns * (SIZE[0] + GAP), TOP + rows * (SIZE[1] + GAP) + 10
    for i, name in enumerate(programs):
        parts.append(text(LEFT + 230 * i, height - 8, name, "start", f' fill="{COLOURS[i % len(COLOURS)]}"'))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif"'
            f' font-size="12"><rect width="100%" height="100%" fill="white"/>' + "\n".join(parts) + "</svg>\n")
