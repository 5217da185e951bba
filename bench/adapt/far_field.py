#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Adapts the mesh of a viscous flow past a wing section, with the far field at 500 chords: far_field.py --asterism PROGRAM.

The section is the image of a circle (von Karman and Trefftz, tail of 15 degrees); the mesh is the image of rings that
grow from 5e-6 of the chord at the wall, 182 by 80 vertices, of which the first row is at about y+ = 1 for a Reynolds
number of several millions. The values are the speed of the potential flow with circulation, times a law at the wall and
a wake behind it. Prints the processor time of `asterism adapt` and what it says; files stay in --folder."""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy as np

AROUND, OUTWARD = 182, 80
TAIL = 15 * np.pi / 180
CENTRE = complex(-0.08, 0.06)
FAR, FIRST = 500.0, 5e-6  # chords
ATTACK = 3 * np.pi / 180
WALL, WAKE = 2e-3, 0.01  # thickness, chords


def section(zeta):
    """The point of the plane and the derivative of the map."""
    power = 2 - TAIL / np.pi
    plus, minus = (zeta + 1) ** power, (zeta - 1) ** power
    derivative = 4 * power ** 2 * ((zeta + 1) * (zeta - 1)) ** (power - 1) / (plus - minus) ** 2
    return power * (plus + minus) / (plus - minus), derivative


def growth(first, far, count):
    """The ratio with which `count` lengths from `first` on reach `far`."""
    low, high = 1 + 1e-9, 2.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if first * (middle ** count - 1) / (middle - 1) < far else (low, middle)
    return low


def rings():
    """Points of the circle's plane, by ring and angle, and the chord of the section."""
    radius = abs(1 - CENTRE)
    angles = np.angle(1 - CENTRE) + 2 * np.pi * np.arange(AROUND) / AROUND
    wall = section(CENTRE + radius * np.exp(1j * angles[1:]))[0]
    chord = max(wall.real) - min(wall.real)
    ratio = growth(FIRST, FAR, OUTWARD - 1)
    out = chord * FIRST * (ratio ** np.arange(OUTWARD) - 1) / (ratio - 1)
    return CENTRE + (radius + out[:, None]) * np.exp(1j * angles[None, :]), chord, radius


def flow():
    """Points of the plane, in chords, and the values there."""
    zeta, chord, radius = rings()
    at, derivative = section(zeta)
    at[0, 0] = 2 - TAIL / np.pi  # the tail, where the map has no derivative
    away = zeta - CENTRE
    circulation = 4 * np.pi * radius * np.sin(ATTACK - np.angle(1 - CENTRE))
    speed = np.exp(-1j * ATTACK) - radius ** 2 * np.exp(1j * ATTACK) / away ** 2 \
        + 1j * circulation / (2 * np.pi * away)
    with np.errstate(divide="ignore", invalid="ignore"):
        speed = np.minimum(np.nan_to_num(np.abs(speed / derivative), nan=0.0, posinf=0.0), 4)
    at /= chord
    tail = at[0, 0]
    behind = np.maximum(at.real - tail.real, 0)
    width = np.sqrt(WAKE ** 2 + WAKE * behind)
    off = (at.imag - tail.imag) * np.cos(ATTACK) - (at.real - tail.real) * np.sin(ATTACK)
    wake = 1 - 0.5 * WAKE / width * np.exp(-(off / width) ** 2) * np.tanh(behind / WAKE)
    return at, speed * np.tanh(np.abs(at - at[0]) / WALL) * wake


def write(folder):
    at, values = flow()
    number = lambda ring, k: ring * AROUND + k % AROUND + 1  # noqa: E731
    triangles, edges = [], []
    for ring in range(OUTWARD - 1):
        for k in range(AROUND):
            a, b, c, d = number(ring, k), number(ring, k + 1), number(ring + 1, k + 1), number(ring + 1, k)
            triangles += [(a, c, b, 1), (a, d, c, 1)]
    for k in range(AROUND):
        edges += [(number(0, k + 1), number(0, k), 1), (number(OUTWARD - 1, k), number(OUTWARD - 1, k + 1), 2)]
    rows = lambda name, table: [name, str(len(table)), *(" ".join(map(repr, row)) for row in table)]  # noqa: E731
    points = [(float(z.real), float(z.imag), 0) for z in at.ravel()]
    (folder / "section.mesh").write_text("\n".join(
        ["MeshVersionFormatted 2", "Dimension 2", *rows("Vertices", points), *rows("Triangles", triangles),
         *rows("Edges", edges), "End", ""]))
    (folder / "section.u.sol").write_text("\n".join(
        ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(values.size), "1 1",
         *map(repr, map(float, values.ravel())), "End", ""]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--asterism", default="asterism")
    parser.add_argument("--vertices", default="3000")
    parser.add_argument("--threads", default="1")
    parser.add_argument("--passes", type=int, default=1, help="times that the same is done, each from the first mesh")
    parser.add_argument("--folder")
    asked = parser.parse_args()
    folder = pathlib.Path(asked.folder or tempfile.mkdtemp())
    write(folder)
    for _ in range(asked.passes):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([asked.asterism, "adapt", "section.mesh", "--solution", "section.u.sol", "--vertices",
                               asked.vertices, "--threads", asked.threads, "-o", "next.mesh"],
                              cwd=folder, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(f"{after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime:.2f} s of processor, status "
              f"{done.returncode}")
        print(done.stdout + done.stderr, end="")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
