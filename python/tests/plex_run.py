# SPDX-License-Identifier: MIT
"""The jobs that test_petsc.py runs under mpirun: `plex_run.py JOB`. Prints one line of JSON on the first process."""
import hashlib
import json
import pathlib
import sys

import numpy as np
from petsc4py import PETSc

import asterism
import asterism.petsc

COMM = PETSc.COMM_WORLD
MPI = COMM.tompi4py()
N = 14


def square(is_distributed=True):
    """Returns a grid of the unit square with labels of every kind, distributed by PETSc itself."""
    cells, points = np.zeros((0, 3), dtype=PETSc.IntType), np.zeros((0, 2))
    if MPI.rank == 0:
        points = np.array([(i / N, j / N) for j in range(N + 1) for i in range(N + 1)])
        quads = [(j * (N + 1) + i, j * (N + 1) + i + 1, (j + 1) * (N + 1) + i + 1, (j + 1) * (N + 1) + i)
                 for j in range(N) for i in range(N)]
        cells = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], dtype=PETSc.IntType)
    dm = PETSc.DMPlex().createFromCellList(2, cells, points, interpolate=True, comm=COMM)
    for name in ("Cell Sets", "Face Sets", "marker", "probe"):
        dm.createLabel(name)
    if MPI.rank == 0:
        label_all(dm, points)
    if is_distributed:
        dm.distribute(overlap=1 if "overlap" in sys.argv else 0)
    return dm


def label_all(dm, points):
    cells, edges, vertices = dm.getHeightStratum(0), dm.getDepthStratum(1), dm.getDepthStratum(0)
    for edge in range(*edges):
        (x0, y0), (x1, y1) = (points[v - vertices[0]] for v in dm.getCone(edge))
        for tag, on in ((1, y0 == y1 == 0), (2, x0 == x1 == 1), (3, y0 == y1 == 1), (4, x0 == x1 == 0),
                        (9, x0 == x1 == 0.5 and max(y0, y1) <= 0.5)):
            if on:
                dm.setLabelValue("Face Sets", edge, tag)
                if tag != 9:
                    for point in (edge, *dm.getCone(edge)):
                        dm.setLabelValue("marker", point, 1)
    for cell in range(*cells):
        corners = points[dm.getTransitiveClosure(cell)[0][-3:] - vertices[0]]
        dm.setLabelValue("Cell Sets", cell, 5 if corners.mean(axis=0)[0] < 0.5 else 6)
    dm.setLabelValue("probe", vertices[0] + 4 * (N + 1) + 3, 7)


def coordinates(dm):
    return dm.getCoordinatesLocal().array_r.reshape(-1, 2)


def front(p):
    return np.tanh(25 * (p[:, 1] - 0.4 - 0.2 * np.sin(4 * p[:, 0])))


def digest(whole):
    told = hashlib.sha256()
    for part in (whole.points, whole.cells, *[of for group in (
            whole.cell_labels, whole.edge_labels, whole.vertex_labels) for of in group.values()]):
        told.update(np.ascontiguousarray(part).tobytes())
    return told.hexdigest()


def measures(whole):
    corners = whole.points[whole.cells]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    sizes = lambda edges: np.linalg.norm(whole.points[edges[:, 0]] - whole.points[edges[:, 1]], axis=1).sum()
    return {"areas": {f"{n} {v}": areas[of].sum() for (n, v), of in whole.cell_labels.items() if len(of)},
            "lengths": {f"{n} {v}": sizes(of) for (n, v), of in whole.edge_labels.items() if len(of)},
            "probe": whole.points[whole.vertex_labels["probe", 7]].tolist(),
            "marked": sorted(whole.points[whole.vertex_labels["marker", 1]].tolist())}


def whole(dm):
    parts = MPI.gather(asterism.petsc._part_of(dm, {}))
    return asterism.petsc._whole_of(parts) if MPI.rank == 0 else None


def run_adapt(is_distributed=True):
    dm = square(is_distributed)
    for _ in range(2):
        at = coordinates(dm)
        made = asterism.petsc.adapt(dm, values=front(at), carry={"x": at[:, 0], "v": at}, vertices=700,
                                    threads=1 + MPI.size % 2)
        dm = made.dm
        new = coordinates(dm)
        assert np.allclose(made.carried["x"], new[:, 0], atol=1e-13) and np.allclose(made.carried["v"], new, atol=1e-13)
        assert len(made.values) == len(new) and abs(made.values).max() <= 1
    found = whole(dm)
    share = MPI.gather(dm.getHeightStratum(0)[1])
    if MPI.rank == 0:
        assert made.asterism.certified
        return {"digest": digest(found), "mesh": hashlib.sha256(made.asterism.sites.tobytes()).hexdigest(),
                "vertices": len(found.points), "share": share, "reached": made.report["reached"], **measures(found)}


def run_blocks():
    """As many vertices as are meshed in blocks, by as many threads as the last word says."""
    dm = square()
    made = asterism.petsc.adapt(dm, values=front(coordinates(dm)), vertices=6000, threads=int(sys.argv[2]))
    found = whole(made.dm)
    if MPI.rank == 0:
        return {"digest": digest(found), "vertices": len(found.points), "certified": made.asterism.certified}


def run_undistributed():
    """All of the mesh is on the first process; others have none of it."""
    return run_adapt(False)


def run_metric():
    dm = square()
    at = coordinates(dm)
    tensors = np.column_stack([100 + 900 * at[:, 0], 0 * at[:, 0], np.full(len(at), 100.0)])
    made = asterism.petsc.adapt(dm, tensors, keep="never")
    vector = PETSc.Vec().createWithArray(np.stack([np.array([[a, b], [b, c]]) for a, b, c in tensors]).reshape(-1).copy()
                                         if len(at) else np.zeros(0), comm=PETSc.COMM_SELF)
    same = asterism.petsc.adapt(dm, vector, keep="never")
    one, two = whole(made.dm), whole(same.dm)
    more = {"isotropic": isotropic(dm, np.full(len(at), 400.0)), "by tensors": alike(dm, (400, 0, 400))}
    if MPI.rank == 0:
        return {"digest": digest(one), "same": digest(two), "vertices": len(one.points), **more}


def run_tensors():
    """Second derivatives, metrics to intersect with, callables and periodic sides, each from local rows or by labels."""
    dm = square()
    at = coordinates(dm)
    curved = np.column_stack([2 + at[:, 0], 0 * at[:, 0], -1 - 30 * at[:, 1]])
    sizes = 0.05 + 0.1 * at[:, 0]
    rows = np.column_stack([sizes ** -2, 0 * sizes, sizes ** -2])
    sides = ("Face Sets", 4), ("Face Sets", 2)
    made = {name: asterism.petsc.adapt(dm, **of) for name, of in {
        "hessian": dict(hessian=curved, vertices=300), "named": dict(hessian={"a": curved}, vertices=300),
        "intersect": dict(metric=0.2, intersect=[sizes]), "array": dict(metric=0.2, intersect=sizes),
        "list": dict(metric=0.2, intersect=[rows, 4 * rows]),
        "stack": dict(metric=0.2, intersect=np.stack([rows, 4 * rows])),
        "callables": dict(metric=lambda p: 0.2 + 0 * p[:, 0], intersect=[lambda p: 0.05 + 0.1 * p[:, 0]]),
        "tensors": dict(metric=(25, 0, 25), intersect=[(100, 0, 100)]),
        "texts": dict(metric="expr:25;0;25", intersect=["expr:100;0;100"]),
        "periodic": dict(values=front(at), vertices=300, periodic=[sides])}.items()}
    found = {name: whole(of.dm) for name, of in made.items()}
    if MPI.rank == 0:
        at = made["periodic"].asterism.points
        return {**{name: digest(of) for name, of in found.items()}, "sizes": len(made["hessian"].asterism.points),
                "left": sorted(at[at[:, 0] == 0, 1]), "right": sorted(at[at[:, 0] == 1, 1])}


def alike(dm, metric):
    found = whole(asterism.petsc.adapt(dm, metric, keep="never").dm)
    return digest(found) if MPI.rank == 0 else None


def isotropic(dm, entries):
    """Adapts by PETSc's isotropic metric, whose numbers are no sizes. Without PETSc's mark on the dm it is refused."""
    vector = PETSc.Vec().createWithArray(entries, comm=PETSc.COMM_SELF)
    try:
        asterism.petsc.adapt(dm, vector)
        raise AssertionError("no error")
    except asterism.InputError as error:
        assert "metricIsIsotropic" in str(error)
    dm.metricSetIsotropic(True)
    found = alike(dm, vector)
    dm.metricSetIsotropic(False)
    return found


def cracked():
    """Returns two triangles that meet in a crack: each has a vertex of its own at (0, 0)."""
    cells, points = np.zeros((0, 3), dtype=PETSc.IntType), np.zeros((0, 2))
    if MPI.rank == 0:
        cells = np.array([(0, 1, 2), (3, 2, 4)], dtype=PETSc.IntType)
        points = np.array([(0, 0), (1, 0), (0, 1), (0, 0), (-1, 0.0)])
    dm = PETSc.DMPlex().createFromCellList(2, cells, points, interpolate=True, comm=COMM)
    dm.distribute()
    return dm


def run_errors():
    """Each error is raised on all processes; afterwards all go on together."""
    dm = square()
    at = coordinates(dm)
    last = MPI.size - 1
    several = ((dict(dm=dm, values=front(at), overlap=MPI.rank), "overlap: process 1 gives 1"),
               (dict(dm=dm, values=front(at), vertices=300 + MPI.rank), "vertices: process 1 gives 301"),
               (dict(dm=dm, values=front(at), **({} if MPI.rank else {"error": 1})), "error: process 1 gives None"),
               (dict(dm=dm, metric=np.sin if MPI.rank else 0.1), "process 1 gives 'a callable'"),
               (dict(dm=dm, metric="swirl" if MPI.rank else "sink"), "process 1 gives"),
               (dict(dm=dm, hessian=np.ones(len(at))), "second derivatives (n, 3)"),
               (dict(dm=dm, values=front(at), periodic=[(4, 2)]), "the name and the value of a label"),
               (dict(dm=dm, values=front(at), periodic=[(("Face Sets", 4), ("Face Sets", 8))]), "('Face Sets', 9)"))
    for wrong, of in ((dict(dm=None), "DMPlex"), (dict(dm=dm, values=front(at), overlap=-1), "overlap"),
                      (dict(dm=cracked()), "at (0, 0) there are 2 vertices"), *several):
        try:
            asterism.petsc.adapt(**wrong)
            raise AssertionError("no error")
        except asterism.InputError as error:
            assert of in str(error)
    told = []
    for arguments in ({"metric": np.ones((2, 3))} if MPI.rank == last else {"metric": (1, 0, 1)},
                      {"metric": (1, 2, 1) if MPI.rank == last else (1, 0, 1)},
                      {"values": front(at), "vertices": -1}, {"values": np.full(len(at), float(MPI.rank + 1)) + at[:, 0] * MPI.rank},
                      {"values": {"T": front(at) / (MPI.rank != last)}, "vertices": 300},
                      {"values": {"b" if MPI.rank == last else "a": front(at)}},
                      {"values": at if MPI.rank == last else front(at)},
                      {"values": front(at), "progress": lambda state: 1 / 0, "vertices": 3000, "keep": "never"}):
        try:
            asterism.petsc.adapt(dm, **arguments)
            told.append(None)
        except (asterism.InputError, ZeroDivisionError) as error:
            told.append(f"{type(error).__name__}: {error}")
    every = MPI.gather(told)
    if MPI.rank == 0:
        return {"told": every}


@asterism.petsc.abort_on_exception()
def run_fails():
    """The last process fails, by an exception or an exit, and the others wait for it."""
    if MPI.rank == MPI.size - 1:
        sys.exit(3) if sys.argv[2] == "exit" else 1 / 0
    MPI.barrier()


def run_built():
    """The dm made of numbered edges has the points that PETSc's own search for edges makes."""
    cells, points = np.zeros((0, 3), dtype=PETSc.IntType), np.zeros((0, 2))
    if MPI.rank == 0:
        points = np.random.default_rng(1).random((60, 2))
        cells = np.array([(3, 1, 2), (2, 1, 0), (4, 3, 2), (5, 0, 1), (1, 3, 6)], dtype=PETSc.IntType)
    one = asterism.petsc._plex_of(COMM, cells, points)
    two = PETSc.DMPlex().createFromCellList(2, cells, points, interpolate=True, comm=COMM)
    told = []
    for dm in (one, two):
        points_of = [[of(p).tolist() for of in (dm.getCone, dm.getConeOrientation, dm.getSupport)]
                     for p in range(*dm.getChart())]
        told.append([*map(list, (dm.getChart(), dm.getHeightStratum(0), dm.getDepthStratum(0))), points_of,
                     dm.getCoordinatesLocal().array_r.tolist()])
    if MPI.rank == 0:
        return {"points": len(told[0][3]), "same": told[0] == told[1]}


def run_page():
    page = (pathlib.Path(__file__).parents[2] / "docs/manual/solvers.md").read_text()
    names = {}
    exec(page.split("```python\n")[2].split("```")[0], names)
    count = len(whole(names["dm"]).points) if MPI.size == 1 else None
    return {"reached": names["made"].report["reached"], "vertices": count}


if __name__ == "__main__":
    jobs = {"adapt": run_adapt, "undistributed": run_undistributed, "metric": run_metric, "errors": run_errors,
            "tensors": run_tensors, "page": run_page, "fails": run_fails, "built": run_built, "blocks": run_blocks}
    told = jobs[sys.argv[1]]()
    if MPI.rank == 0:
        print(json.dumps(told))
