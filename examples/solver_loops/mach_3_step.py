# SPDX-License-Identifier: MIT
"""A wind tunnel with a step at Mach 3, to its steady state, by finite volumes of the first order on meshes that
follow density and Mach number.

  mach_3_step.py [--adaptations N] [--vertices N] [--iterations N] [--picture OUT.png]

Unknowns are density, momentum and energy in the median dual cells around the vertices; fluxes by Harten, Lax, van
Leer and Einfeldt; local time steps. The four conserved fields are carried `bounded` from mesh to mesh: their
integrals stay, and density and pressure stay positive. In front of the step the flow comes to rest behind a normal
shock, where its pressure is known: 12.06 times that of the inflow.
"""
import argparse

import elements
import numpy as np

import asterism

HEAT_RATIO, MACH = 1.4, 3.0
WIDTH, HEIGHT, STEP_AT, STEP_HEIGHT = 3.0, 1.0, 0.6, 0.2
NAMES = ("density", "along", "up", "energy")


def inflow(count):
    """Returns the inflow: density 1.4 and pressure 1, with which the speed of sound is one."""
    density, pressure = 1.4, 1.0
    energy = pressure / (HEAT_RATIO - 1) + density * MACH ** 2 / 2
    return np.tile([density, density * MACH, 0.0, energy], (count, 1))


def pressure_of(state):
    return (HEAT_RATIO - 1) * (state[:, 3] - (state[:, 1] ** 2 + state[:, 2] ** 2) / (2 * state[:, 0]))


def mach_of(state):
    speed = np.sqrt(state[:, 1] ** 2 + state[:, 2] ** 2) / state[:, 0]
    return speed / np.sqrt(HEAT_RATIO * pressure_of(state) / state[:, 0])


def flux(state, normal):
    """Returns the fluxes through normals (n, 2) of any length."""
    pressure = pressure_of(state)
    through = (state[:, 1] * normal[:, 0] + state[:, 2] * normal[:, 1]) / state[:, 0]
    made = state * through[:, None]
    made[:, 1:3] += pressure[:, None] * normal
    made[:, 3] += pressure * through
    return made


def flux_between(left, right, normal):
    length = np.linalg.norm(normal, axis=1)
    unit = normal / length[:, None]
    ends = []
    for state in (left, right):
        speed = ((state[:, 1:3] * unit).sum(axis=1)) / state[:, 0]
        sound = np.sqrt(HEAT_RATIO * pressure_of(state) / state[:, 0])
        ends.append((speed - sound, speed + sound))
    low = np.minimum(0, np.minimum(ends[0][0], ends[1][0]))[:, None]
    high = np.maximum(0, np.maximum(ends[0][1], ends[1][1]))[:, None]
    between = (high * flux(left, unit) - low * flux(right, unit) + low * high * (right - left)) / (high - low)
    return between * length[:, None], np.maximum(-low, high)[:, 0] * length


class Cells:
    """The median dual cells of a mesh: edges with the normals of their faces, and sides of the boundary with
    theirs."""

    def __init__(self, points, triangles):
        self.areas = elements.nodal_areas(points, triangles)
        middle = points[triangles].mean(axis=1)
        ends, normals, owners = [], [], []
        for i, j in ((0, 1), (1, 2), (2, 0)):
            a, b = triangles[:, i], triangles[:, j]
            piece = middle - (points[a] + points[b]) / 2  # from the edge's middle to the centroid of the triangle
            turned = np.stack([piece[:, 1], -piece[:, 0]], axis=1)
            ends.append(np.stack([a, b], axis=1))
            normals.append(turned)
        ends, normals = np.concatenate(ends), np.concatenate(normals)
        swapped = ends[:, 0] > ends[:, 1]
        ends[swapped], normals[swapped] = ends[swapped][:, ::-1], -normals[swapped]
        self.edges, owners, uses = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
        owners = owners.ravel()
        self.normals = np.stack([np.bincount(owners, normals[:, d]) for d in range(2)], axis=1)
        self._take_sides(points, self.edges[uses == 1], triangles)

    def _take_sides(self, points, sides, triangles):
        directed = {(int(a), int(b)) for t in triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
        sides = np.array([(a, b) if (a, b) in directed else (b, a) for a, b in sides.tolist()])
        along = points[sides[:, 1]] - points[sides[:, 0]]
        middle = (points[sides[:, 0]] + points[sides[:, 1]]) / 2
        outward = np.stack([along[:, 1], -along[:, 0]], axis=1) / 2  # half of the side for each end
        kind = np.where(middle[:, 0] < 1e-9, 0, np.where(middle[:, 0] > WIDTH - 1e-9, 1, 2))
        self.side_ends, self.side_normals = sides.T.reshape(-1), np.tile(outward, (2, 1))
        self.side_kinds = np.tile(kind, 2)

    def change(self, state):
        """Returns the flow out of each cell, and the sum over its faces of greatest speed times length."""
        a, b = self.edges.T
        between, speeds = flux_between(state[a], state[b], self.normals)
        at, normal = self.side_ends, self.side_normals
        outer = state[at]
        wall = np.zeros_like(outer)
        wall[:, 1:3] = pressure_of(outer)[:, None] * normal
        through = np.select([self.side_kinds[:, None] == 0, self.side_kinds[:, None] == 1],
                            [flux(inflow(len(at)), normal), flux(outer, normal)], wall)
        out = np.stack([np.bincount(a, between[:, k], len(state)) - np.bincount(b, between[:, k], len(state))
                        + np.bincount(at, through[:, k], len(state)) for k in range(4)], axis=1)
        length = np.linalg.norm(normal, axis=1)
        fastest = (np.linalg.norm(outer[:, 1:3], axis=1) / outer[:, 0]
                   + np.sqrt(HEAT_RATIO * pressure_of(outer) / outer[:, 0])) * length
        around = (np.bincount(a, speeds, len(state)) + np.bincount(b, speeds, len(state))
                  + np.bincount(at, fastest, len(state)))
        return out, around


def settle(cells, state, iterations):
    """Takes steps as long as each cell allows. Returns the state, and the last step's change divided by the
    first's."""
    changes = []
    for _ in range(iterations):
        out, around = cells.change(state)
        step = 0.8 * out / around[:, None]
        changes.append(np.abs(step[:, 0]).mean())
        state = state - step
    return state, changes[-1] / max(changes)


def run(adaptations, vertices, iterations):
    points, triangles = elements.grid(60, 20, WIDTH, HEIGHT, lambda x, y: x < STEP_AT or y > STEP_HEIGHT)
    mesh, state, drift = asterism.Mesh(points, triangles), inflow(len(points)), 0.0
    for number in range(adaptations + 1):
        cells = Cells(mesh.points, mesh.triangles)
        state, left = settle(cells, state, iterations)
        print(f"{len(mesh.points)} vertices, greatest pressure {pressure_of(state).max():.3f}, "
              f"change {left:.1e}", flush=True)
        if number == adaptations:
            break
        before = cells.areas @ state
        made = asterism.adapt(mesh, {"density": state[:, 0], "mach": mach_of(state)}, vertices=vertices,
                              carry={f"carried_{k}": state[:, i] for i, k in enumerate(NAMES)}, how="bounded")
        mesh, state = made.mesh, np.stack([made.carried[f"carried_{k}"] for k in NAMES], axis=1)
        after = elements.nodal_areas(mesh.points, mesh.triangles) @ state
        drift = max(drift, float(np.abs(after - before).max() / np.abs(before).max()))
        if not mesh.certified or not (state[:, 0].min() > 0 and pressure_of(state).min() > 0):
            raise SystemExit("a mesh that is not certified, or a pressure that is not positive")
    return mesh, state, drift


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--adaptations", type=int, default=10)
    parser.add_argument("--vertices", type=int, default=3000)
    parser.add_argument("--iterations", type=int, default=600)
    parser.add_argument("--picture")
    options = parser.parse_args()
    mesh, state, drift = run(options.adaptations, options.vertices, options.iterations)
    # Points at rest behind the shock: on the floor, up to the step.
    floor = (mesh.points[:, 1] < STEP_HEIGHT) & (mesh.points[:, 0] > STEP_AT - 0.05)
    print(f"vertices {len(mesh.points)} drift {drift:.2e} rest {pressure_of(state)[floor].max():.3f} "
          f"least {pressure_of(state).min():.3f}")
    if options.picture:
        elements.picture(options.picture, mesh.points, mesh.triangles, state[:, 0],
                         f"density at Mach 3, {len(mesh.points)} vertices")


if __name__ == "__main__":
    main()
