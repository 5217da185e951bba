# SPDX-License-Identifier: MIT
"""Lists the constants that experiments chose, other values to try, and the jobs that show a difference."""
import math


class Constant:
    """A constant. `text` is its place in `file`, with @ for the value; `kept` is the value there."""

    def __init__(self, name, file, text, kept, tried, group):
        self.name, self.file, self.text, self.kept, self.tried, self.group = name, file, text, kept, tried, group


def poly(points, rings):
    """Returns the text of a .poly file; `rings` are the numbers of points of each ring."""
    segments = [(ring[i], ring[(i + 1) % len(ring)]) for ring in rings for i in range(len(ring))]
    lines = [f"{len(points)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points)]
    lines += [f"{len(segments)} 0"] + [f"{i} {a} {b}" for i, (a, b) in enumerate(segments)]
    return "\n".join(lines + ["0", ""])


def star(tips=9, tip=0.35):
    points = [(r * math.cos(math.pi * i / tips), r * math.sin(math.pi * i / tips))
              for i, r in enumerate([1, tip] * tips)]
    return poly(points, [list(range(2 * tips))])


def gear(teeth=60):
    points = [(r * math.cos(2 * math.pi * (i + part) / teeth), r * math.sin(2 * math.pi * (i + part) / teeth))
              for i in range(teeth) for r, part in [(.8, 0), (.8, .25), (1, .35), (1, .65)]]
    return poly(points, [list(range(4 * teeth))])


DOMAINS = {"star.poly": star(), "gear.poly": gear()}

GROUPS = {
    "fill": ["square --metric swirl:12 --size 0.1", "star.poly --metric sink:12 --size 0.1",
             "airfoil --metric swirl:3 --size 0.15"],
    "mend": ["square --metric swirl:12 --random-points 20", "star.poly --metric swirl:12 --size 0.2",
             "square --metric sink:60 --size 0.3"],
    "bulk": ["square --random-points 2000 --angle-bound 0", "square --metric swirl:12 --size 0.1"],
    "improve": ["square --metric swirl:12 --size 0.2 --improve 5", "gear.poly --size 0.1 --improve 5"],
    "crowd": ["gear.poly --size 0.1 --max-sites 300", "gear.poly --metric swirl:3 --size 0.1 --max-sites 600"],
    "darts": ["square --metric swirl:3 --random-points 30 --refine darts",
              "star.poly --metric sink:3 --refine darts --angle-bound 15"],
    "delivered": ["square --metric swirl:100 --vertices 800", "star.poly --metric swirl:60 --vertices 500",
                  "square --metric shock:50 --vertices 1000"],
    "arcs": ["square --metric swirl:12 --random-points 30 --refine voronoi",
             "star.poly --metric swirl:3 --refine voronoi", "square --size 0.05 --refine voronoi"],
}

CONSTANTS = [
    Constant("first subsegments at a vertex", "mesh/fill/segment_division.cpp",
             "part_of_longest = @;", "0.92", ["0.8", "0.86", "0.96", "1"], "fill"),
    Constant("agreement of speeds", "mesh/fill/segment_division.cpp",
             "agreement = @;", "0.05", ["0.01", "0.2", "1"], "fill"),
    Constant("least depth of sampling", "mesh/fill/segment_division.cpp",
             "least_depth = @,", "4", ["2", "6"], "fill"),
    Constant("length not sampled further", "mesh/fill/segment_division.cpp",
             "finest_part = @;", "1.0 / 16", ["1.0 / 4", "1.0 / 64"], "fill"),
    Constant("stars that a new site is offered to", "mesh/stars/star_set.cpp",
             "reach_of_candidates = @;", "2.2", ["1.5", "2", "3"], "bulk"),
    Constant("scattered places for each site", "mesh/fill/site_proposals.cpp",
             "for_each_site = @,", "16", ["4", "64"], "fill"),
    Constant("scattered places at least", "mesh/fill/site_proposals.cpp",
             "at_least = @;", "4096", ["512", "32768"], "fill"),
    Constant("queue too short for many at once", "mesh/refine/arc_insertion.cpp",
             "fewest = @;", "32", ["4", "8", "128", "100000"], "arcs"),
    Constant("tolerance at exempt corners", "mesh/refine/arc_insertion.cpp",
             "modest = @;", "0x1p-4", ["0x1p-2", "0x1p-6", "0x1p-8"], "mend"),
    Constant("sites before steep places end a run", "mesh/refine/steepness.cpp",
             "at_least = @;", "1000", ["100", "10000"], "mend"),
    Constant("shrinking of the darts' tolerance", "mesh/refine/poisson_darts.cpp",
             "shrink = @;", "0.8", ["0.6", "0.9"], "darts"),
    Constant("reach of darts", "mesh/refine/poisson_darts.cpp",
             "reach = @;", "1.5", ["1", "2", "3"], "darts"),
    Constant("cost of a merge", "mesh/adapt/unit_mesh_improvement.cpp",
             "cost_of_merge = @;", "0.8", ["0", "0.3", "2"], "improve"),
    Constant("larger before flips and moves", "mesh/pipeline/improved_mesh.cpp",
             "larger = @;", "1.05", ["1", "1.02", "1.1"], "improve"),
    Constant("sweeps of smoothing", "mesh/adapt/unit_mesh_improvement.cpp",
             "sweeps = @;", "10", ["3"], "improve"),
    Constant("tries of a pass", "mesh/pipeline/improved_mesh.cpp",
             "most_tries = @;", "10", ["4", "20"], "improve"),
    Constant("segment at which sites begin", "mesh/metric/feature_size_field.cpp",
             "part_of_segment = @,", "1.3", ["1", "1.6"], "crowd"),
    Constant("growth away from segments", "mesh/metric/feature_size_field.cpp",
             "growth = @;", "0.7", ["0.5", "0.9"], "crowd"),
    Constant("features passed over", "mesh/metric/feature_size_field.cpp",
             "near_enough = @;", "1 / 1.16", ["1", "1 / 1.5"], "crowd"),
    Constant("clearance that rounding cannot turn", "mesh/adapt/local_tests.hpp",
             "least_clearance = @;", "1e-3", ["1e-6", "1e-2"], "delivered"),
    Constant("degrees to spare above the bound", "mesh/adapt/local_tests.cpp",
             "degrees_to_spare = @;", "0.05", ["0.01", "0.5"], "delivered"),
    Constant("clearance kept by tensors given back", "mesh/adapt/tensor_restoration.cpp",
             "room = @;", "0.15", ["1e-3", "0.05", "0.3"], "delivered"),
    Constant("degrees above the bound aimed at", "mesh/adapt/consistency_repair.cpp",
             "degrees_above = @;", "4", ["1", "2", "8"], "delivered"),
    Constant("likeness of tensors after an audit", "mesh/adapt/consistency_repair.cpp",
             "part = @;\n  next_.assign", "0.5", ["0.3", "0.8"], "delivered"),
    Constant("likeness of tensors at an edge", "mesh/adapt/consistency_repair.cpp",
             "part = @;\n  clip_distortion_at({q.a", "0.7", ["0.5", "0.9"], "delivered"),
    Constant("likeness of tensors at an angle", "mesh/adapt/consistency_repair.cpp",
             "part = @;\n  if (report_", "0.7", ["0.5", "0.9"], "delivered"),
    Constant("rounds before shapes are followed", "mesh/adapt/consistency_repair.cpp",
             "patience = @;", "6", ["2", "12"], "delivered"),
    Constant("excess left by a merge", "mesh/adapt/consistency_repair.cpp",
             "enough = @;\n  const double longest", "0.5", ["0.2", "0.9"], "delivered"),
    Constant("distance from a shape followed", "mesh/adapt/consistency_repair.cpp",
             "enough = @;  // log", "0.5", ["0.25", "0.6"], "delivered"),
    Constant("limit aimed at by gradation", "mesh/gradation/nodal_gradation.cpp",
             "aim = @;", "0.98", ["0.9", "1"], "delivered"),
    Constant("weight of a triangle's size", "mesh/adapt/shape_energy.hpp",
             "weight_of_size = @,", "0.3", ["0.1", "1"], "delivered"),
    Constant("weight of a low triangle", "mesh/adapt/shape_energy.hpp",
             "weight_of_low = @;", "0.5", ["0", "0.1", "2"], "delivered"),
    Constant("room for a new node", "mesh/adapt/unit_mesh.cpp",
             "room = @, far", "0.8", ["0.6", "0.9"], "delivered"),
    Constant("energy of a merge", "mesh/adapt/unit_mesh_lengths.cpp",
             "acceptable = @;", "2.5", ["1.5", "5"], "delivered"),
    Constant("energy not flipped", "mesh/adapt/unit_mesh_flips.cpp",
             "good = @;", "2.1", ["2.01", "2.4"], "delivered"),
    Constant("gain of a move", "mesh/adapt/unit_mesh.hpp",
             "least_gain_ = @;", "1e-3", ["1e-5", "1e-2"], "delivered"),
    Constant("least room across a split edge", "mesh/adapt/unit_mesh_lengths.cpp",
             "room = @;  // units", "0.55", ["0.4", "0.7"], "delivered"),
]
