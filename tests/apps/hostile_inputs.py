# SPDX-License-Identifier: MIT
"""Inputs of up to 5,000 vertices that have taken minutes, or were made to: domains, and meshes with metrics. Each is
made by a function that returns the same every time. `CASES` names them, with the jobs that are run on each."""
import math
import random


def poly_text(points, segments, holes=()):
    """Returns a .poly file; `segments` are pairs of indices from 0."""
    lines = [f"{len(points)} 2 0 0", *(f"{i + 1} {x!r} {y!r}" for i, (x, y) in enumerate(points)),
             f"{len(segments)} 1", *(f"{i + 1} {a + 1} {b + 1} 1" for i, (a, b) in enumerate(segments)),
             str(len(holes)), *(f"{i + 1} {x!r} {y!r}" for i, (x, y) in enumerate(holes)), ""]
    return "\n".join(lines)


def ring(first, count):
    return [(first + i, first + (i + 1) % count) for i in range(count)]


def mesh_texts(points, triangles, tensors):
    """Returns a .mesh file and its .sol; indices from 0."""
    head = ["MeshVersionFormatted 2", "Dimension 2"]
    mesh = [*head, "Vertices", str(len(points)), *(f"{x!r} {y!r} 0" for x, y in points),
            "Triangles", str(len(triangles)), *(f"{a + 1} {b + 1} {c + 1} 1" for a, b, c in triangles), "End", ""]
    solution = [*head, "SolAtVertices", str(len(points)), "1 3", *(" ".join(map(repr, t)) for t in tensors), "End", ""]
    return "\n".join(mesh), "\n".join(solution)


def grid(columns, rows, jitter=0.0, seed=1):
    """Returns points of the unit square and triangles between them. Inner points are moved by up to `jitter` of a
    cell."""
    rng = random.Random(seed)
    points, triangles = [], []
    for j in range(rows + 1):
        for i in range(columns + 1):
            inside = 0 < i < columns and 0 < j < rows
            move = [jitter * (2 * rng.random() - 1) if inside else 0.0 for _ in range(2)]
            points.append(((i + move[0]) / columns, (j + move[1]) / rows))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            triangles += [(a, a + 1, a + columns + 1), (a + 1, a + columns + 2, a + columns + 1)]
    return points, triangles


def tensor(along, across, angle):
    c, s = math.cos(angle), math.sin(angle)
    return (along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c)


def measured(points, triangles, tensor_at):
    return mesh_texts(points, triangles, [tensor_at(i, x, y) for i, (x, y) in enumerate(points)])


def random_tensors(cells, condition, seed=5):
    rng = random.Random(seed)

    def at(_index, _x, _y):
        size = float(cells * cells)
        return tensor(size * condition**rng.random(), size * condition**rng.random(), math.pi * rng.random())
    return measured(*grid(cells, cells, 0.3, seed), at)


def jump(cells, aspect):
    high = float(cells * cells)
    return measured(*grid(cells, cells), lambda _i, x, _y: tensor(high, high / aspect**2, math.pi / 2 * (x > 0.5)))


def checkerboard(cells, aspect, fields=8):
    high = float(cells * cells)
    return measured(*grid(cells, cells), lambda _i, x, y: tensor(
        high, high / aspect**2, math.pi / 2 * ((int(fields * x) + int(fields * y)) % 2)))


def turning(cells, aspect, turns):
    high = float(cells * cells)
    return measured(*grid(cells, cells, 0.2), lambda _i, x, y: tensor(high, high / aspect**2, turns * (x + y * y)))


def huge_and_tiny(cells):
    return measured(*grid(cells, cells, 0.2), lambda i, _x, _y: (10.0**(300 * (i % 2) - 150), 0.0, 1.0))


def big_tensor(cells):
    last = (cells + 1)**2 // 2
    return measured(*grid(cells, cells, 0.2),
                    lambda i, _x, _y: (1.6e308, 0.0, 1.0) if i == last else tensor(16.0, 9.0, 0.2))


def flat_rectangle(height):
    """Five vertices: a rectangle of length 1 with its centre."""
    points = [(0.0, 0.0), (1.0, 0.0), (1.0, height), (0.0, height), (0.5, height / 2)]
    return measured(points, [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)], lambda *_: (400.0, 0.0, 400.0))


SQUARE = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)]


def fan(count, degrees):
    """Returns a square with `count` segments from its middle, each `degrees` from the one before."""
    points = [*SQUARE, (0.0, 0.0)]
    points += [(math.cos(math.radians(degrees * i)), math.sin(math.radians(degrees * i))) for i in range(count)]
    return poly_text(points, ring(0, 4) + [(4, 5 + i) for i in range(count)])


def closed_fan(count):
    """A square whose sides have `count` vertices, all joined to one beside its middle."""
    side = [-1 + 8 * i / count for i in range(count // 4)]
    points = [(t, -1.0) for t in side] + [(1.0, t) for t in side] + [(-t, 1.0) for t in side] + [(-1.0, -t) for t in side]
    return poly_text([*points, (0.1, -0.05)], ring(0, len(points)) + [(i, len(points)) for i in range(len(points))])


def crossing_segments(count, seed=1):
    """Segments between random points of a square, with its sides: nearly a quarter of all pairs cross."""
    rng = random.Random(seed)
    points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0),
              *((rng.uniform(0.01, 0.99), rng.uniform(0.01, 0.99)) for _ in range(2 * count))]
    return poly_text(points, [*ring(0, 4), *((4 + 2 * i, 5 + 2 * i) for i in range(count))])


def comb(teeth, depth=1.0):
    points = [(0.0, -0.1), (float(teeth), -0.1)]
    for i in reversed(range(teeth)):
        points += [(i + 0.51, depth), (i + 0.5, 0.0)]
    return poly_text(points, ring(0, len(points)))


def needles(count):
    """A star whose spikes are a thousand times as long as wide."""
    points = []
    for i in range(count):
        for radius, shift in ((1.0, 0.0), (0.2, 0.5)):
            angle = 2 * math.pi * (i + shift) / count
            points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return poly_text(points, ring(0, len(points)))


def nested_squares(levels, factor=0.1):
    points, segments = [], []
    for k in range(levels):
        segments += ring(len(points), 4)
        points += [(x * factor**k, y * factor**k) for x, y in SQUARE]
    return poly_text(points, segments)


def nearly_straight(count):
    """A rectangle whose lower side is that many points an ulp beside a line."""
    rng = random.Random(3)
    points = [(i / count, 1 + rng.choice((0.0, 2.0**-52))) for i in range(count)]
    points += [(1.0, 1.0), (1.0, 1.5), (0.0, 1.5)]
    return poly_text(points, ring(0, len(points)))


def two_clusters(count, distance):
    """A box with points in two small clouds at opposite corners."""
    rng = random.Random(4)
    points = [(-1.0, -1.0), (distance + 2, -1.0), (distance + 2, distance + 2), (-1.0, distance + 2)]
    for i in range(count):
        shift = distance * (i % 2)
        points.append((shift + rng.random(), shift + rng.random()))
    return poly_text(points, ring(0, 4))


def spiral(count, turns=12.0):
    """A corridor that winds inwards."""
    def side(offset):
        return [((1.2 - t + offset) * math.cos(2 * math.pi * turns * t), (1.2 - t + offset) * math.sin(2 * math.pi * turns * t))
                for t in (i / count for i in range(count))]
    points = side(0.0) + side(0.4 / turns)[::-1]
    return poly_text(points, ring(0, len(points)))


def circle(count):
    points = [(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count)) for i in range(count)]
    return poly_text(points, ring(0, count))


def perforated(rows):
    """A square with rows x rows square holes."""
    points = [(0.0, 0.0), (float(rows), 0.0), (float(rows), float(rows)), (0.0, float(rows))]
    segments, holes = ring(0, 4), []
    for i in range(rows):
        for j in range(rows):
            segments += ring(len(points), 4)
            points += [(i + a, j + b) for a, b in ((0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8))]
            holes.append((i + 0.5, j + 0.5))
    return poly_text(points, segments, holes)


def rectangle(width, height, low=0.0):
    points = [(low, low), (low + width, low), (low + width, low + height), (low, low + height)]
    return poly_text(points, ring(0, 4))


def parallel_slits():
    """Two segments an ulp apart."""
    points = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 2.0), (3.0, 2.0),
              (1.0, 2.0000000000000004), (3.0, 2.0000000000000004)]
    return poly_text(points, [*ring(0, 4), (4, 5), (6, 7)])


def hole_an_ulp_from_the_side():
    points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.1102230246251565e-16, 0.25),
              (0.5000000000000001, 0.25), (0.5000000000000001, 0.75), (1.1102230246251565e-16, 0.75)]
    return poly_text(points, [*ring(0, 4), *ring(4, 4)], [(0.3, 0.5)])


# Domains: the function that makes the .poly file, and the options with which it is meshed.
SWIRL = ("--metric", "swirl:12")
DOMAINS = {
    "fan360": (lambda: fan(360, 1), ((), SWIRL, (*SWIRL, "--size", "0.1"))),
    "fan_0.01": (lambda: fan(500, 0.01), ((), SWIRL)),
    "fan2500": (lambda: fan(2500, 360 / 2500), ((), ("--size", "0.05"))),
    "comb": (lambda: comb(1000), ((), SWIRL, ("--size", "1"))),
    "comb_flat": (lambda: comb(2000, 1e-6), ((), ("--size", "1"))),
    "needles": (lambda: needles(2000), ((), SWIRL)),
    "nested": (lambda: nested_squares(9), ((), SWIRL, ("--metric", "polar-1"))),
    "nearly_straight": (lambda: nearly_straight(2000), ((), SWIRL)),
    "two_clusters": (lambda: two_clusters(2000, 1e8), ((), SWIRL, ("--size", "1e6"))),
    "spiral": (lambda: spiral(2000), ((), SWIRL, ("--size", "0.02"))),
    "circle5000": (lambda: circle(5000), ((), SWIRL)),
    "perforated": (lambda: perforated(33), ((), SWIRL, ("--metric", "shock:50", "--size", "1"))),
    "mixed_scales": (lambda: rectangle(1e300, 1e-300), ((), SWIRL)),
    "denormal": (lambda: rectangle(5e-324, 5e-324), ((),)),
    "ulp_sliver": (lambda: rectangle(1.0, 2.220446049250313e-16, 1.0), ((), SWIRL)),
    "ulp_hole": (hole_an_ulp_from_the_side, ((), SWIRL)),
    "parallel_ulp": (parallel_slits, ((), SWIRL)),
}

# Meshes with metrics: the function that makes the .mesh and the .sol.
MESHES = {
    "sliver_1e-8": lambda: flat_rectangle(1e-8),
    "random_1e4": lambda: random_tensors(9, 1e4),
    "random_30": lambda: random_tensors(16, 30.0),
    "random_30_4489": lambda: random_tensors(66, 30.0),
    "random_1e12": lambda: random_tensors(19, 1e12),
    "jump_1e3": lambda: jump(64, 1e3),
    "jump_100": lambda: jump(64, 100),
    "checkerboard_1e3": lambda: checkerboard(64, 1e3),
    "turning": lambda: turning(44, 100.0, 400.0),
    "huge_and_tiny": lambda: huge_and_tiny(12),
    "big_tensor": lambda: big_tensor(10),
}

# Metrics for built-in domains that take much work.
THIN = "expr:1e8;0;1"
TURNED = "expr:1e8;9999.9999999;1"
WAVES = "expr:1+1e6*sin(1000*x)^2;0;1+1e6*cos(1000*y)^2"
STEP = "expr:x<0.5?1e6:1;0;x<0.5?1:1e6"
FIELDS = {
    "shock_0.3": ("--metric", "shock:50", "--size", "0.3"),
    "shock_0.05": ("--metric", "shock:50", "--size", "0.05"),
    "polar-1_0.1": ("--metric", "polar-1", "--size", "0.1"),
    "polar-1_0.02": ("--metric", "polar-1", "--size", "0.02"),
    "circle-1_graded": ("--metric", "circle-1", "--size", "1", "--gradation", "1.5"),
    "thin_0.025": ("--metric", THIN, "--size", "0.025"),
    "thin_turned_0.025": ("--metric", TURNED, "--size", "0.025"),
    "thin_turned_100": ("--metric", TURNED, "--size", "100"),
    "waves": ("--metric", WAVES, "--size", "1"),
    "step": ("--metric", STEP, "--size", "10"),
    "swirl_1e8": ("--metric", "swirl:1e8", "--size", "10"),
}


def jobs_on_mesh(name, files):
    """Yields the jobs that are run on a mesh with a metric."""
    source = f"{name}.mesh"
    yield f"certify {name}", files, ("certify", source)
    yield f"certify --repair {name}", files, ("certify", source, "--repair", "-o", "out.mesh")
    yield f"verify {name}", files, ("verify", source)
    yield f"mesh {name}", files, ("mesh", source, "--metric", source, "-o", "out.mesh")
    yield f"mesh {name} --size 1", files, ("mesh", source, "--metric", source, "--size", "1", "-o", "out.mesh")
    yield f"adapt {name}", files, ("adapt", source, "--metric", f"{name}.sol", "-o", "out.mesh")


def jobs_on_folder(folder):
    """Yields the same jobs, and two metrics for each domain, for the files of a folder outside of the project."""
    for path in sorted(folder.glob("*.mesh")):
        metric = path.with_suffix(".sol")
        if metric.exists():
            yield from jobs_on_mesh(path.stem, {path.name: path.read_text(), metric.name: metric.read_text()})
    for path in sorted(folder.glob("*.poly")):
        for options in ((), SWIRL):
            yield (f"mesh {path.stem} {' '.join(options)}".strip(), {path.name: path.read_text()},
                   ("mesh", path.name, *options, "-o", "out.mesh"))


def jobs():
    """Yields all jobs: a name, the input files by their names, and the words of the command."""
    for name, (make, variants) in DOMAINS.items():
        text = make()
        for options in variants:
            yield (f"mesh {name} {' '.join(options)}".strip(), {f"{name}.poly": text},
                   ("mesh", f"{name}.poly", *options, "-o", "out.mesh"))
    for name, make in MESHES.items():
        mesh, solution = make()
        yield from jobs_on_mesh(name, {f"{name}.mesh": mesh, f"{name}.sol": solution})
    for name, options in FIELDS.items():
        yield f"mesh square {name}", {}, ("mesh", "square", *options, "-o", "out.mesh")
