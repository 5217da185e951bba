# SPDX-License-Identifier: MIT
"""Draws wrong answers of plain doubles, and time, against closeness to degeneracy, as SVG."""
import math

WIDTH, HEIGHT, LEFT, TOP = 340, 230, 62, 40
COLOURS = {"compare_distance": "#4a6fa5", "edge_test, equal metrics": "#c77f2a", "edge_test": "#3d8b5f"}


def line(points, colour, dashed=False):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dash = ' stroke-dasharray="5 3"' if dashed else ""
    return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.8"{dash}/>'


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


class Panel:
    """Draws one diagram; `place` maps a value to 0 (bottom) .. 1 (top)."""

    def __init__(self, left, title, place, ticks):
        self.left, self.place, self.parts = left, place, []
        self.parts.append(f'<rect x="{left}" y="{TOP}" width="{WIDTH}" height="{HEIGHT}" fill="none"'
                          ' stroke="#888"/>')
        self.parts.append(text(left + WIDTH / 2, TOP - 12, title))
        for value, label in ticks:
            y = self.y(value)
            self.parts.append(f'<line x1="{left}" x2="{left + WIDTH}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>')
            self.parts.append(text(left - 6, y + 4, label, "end"))
        for bits in range(4, 53, 8):
            self.parts.append(text(self.x(bits), TOP + HEIGHT + 17,
                                   f'2<tspan dy="-4" font-size="9">-{bits}</tspan>'))
        self.parts.append(text(left + WIDTH / 2, TOP + HEIGHT + 36, "relative distance from the change of answer"))

    def x(self, bits):
        return self.left + WIDTH * (bits - 2) / 52

    def y(self, value):
        return TOP + HEIGHT * (1 - self.place(value))

    def draw(self, entries, value, colour, dashed=False):
        self.parts.append(line([(self.x(e["bits"]), self.y(value(e))) for e in entries], colour, dashed))


def error_panel(closeness):
    panel = Panel(LEFT, "wrong answers of plain doubles", lambda share: share / 0.6,
                  [(k / 10, f"{10 * k} %") for k in range(0, 7)])
    for name, entries in closeness.items():
        panel.draw(entries, lambda e: min(0.6, e["double wrong"] / e["questions"]), COLOURS[name])
    return panel


def time_panel(closeness):
    panel = Panel(2 * LEFT + WIDTH + 20, "time a question: filtered (solid), double (dashed)",
                  lambda ns: min(1.0, max(0.0, math.log10(ns) / 7)),
                  [(10 ** k, label) for k, label in
                   enumerate(("1 ns", "10 ns", "100 ns", "1 us", "10 us", "100 us", "1 ms", "10 ms"))])
    for name, entries in closeness.items():
        panel.draw(entries, lambda e: e["nanoseconds"]["filtered"], COLOURS[name])
        panel.draw(entries, lambda e: e["nanoseconds"]["double"], COLOURS[name], dashed=True)
    return panel


def legend():
    parts, x, y = [], LEFT, TOP + HEIGHT + 62
    for name, colour in COLOURS.items():
        parts.append(line([(x, y - 4), (x + 24, y - 4)], colour))
        parts.append(text(x + 30, y, name, "start"))
        x += 60 + 7 * len(name)
    return parts


def svg(closeness):
    closeness = {name: sorted(closeness[name], key=lambda e: e["bits"]) for name in COLOURS}
    width, height = 2 * (LEFT + WIDTH) + 40, TOP + HEIGHT + 76
    parts = error_panel(closeness).parts + time_panel(closeness).parts + legend()
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}"'
            f' height="{height}" font-family="sans-serif" font-size="12">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")
