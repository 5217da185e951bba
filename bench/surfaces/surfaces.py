# SPDX-License-Identifier: MIT
"""The six surfaces at three distances each: vertices, the distance proved, that found by sampling, and seconds of
processor, as a table; with --rival also OpenCASCADE's triangulations of those that its DRAW can be given."""
import argparse
import json
import pathlib
import re
import resource
import subprocess
import tempfile

from sampled_distances import Sampling

# Heights of the control points of a bicubic patch over the unit square, in thousandths.
HEIGHTS = ((0, 210, -60, 130), (180, 320, -240, 40), (-90, 60, 300, -150), (70, -200, 110, 0))
WIDTHS = {"torus": 1, "octant": 1, "saddle": 2, "bicubic": 1, "wing": 1, "teapot": 6.4}
DISTANCES = (1e-2, 3e-3, 1e-3)


def bicubic():
    return {"patches": [{"name": "bicubic", "degree": [3, 3], "control": [
        [[i / 3, j / 3, HEIGHTS[i][j] / 1000] for j in range(4)] for i in range(4)]}]}


def seconds_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(command, folder):
    before = seconds_of_children()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done, seconds_of_children() - before


def measure(program, name, chord, folder, sampled):
    of = name
    if name == "bicubic":
        of = "bicubic.json"
        (folder / of).write_text(json.dumps(bicubic()))
    for old in ("s.mesh", "s.certificate.json"):
        (folder / old).unlink(missing_ok=True)
    done, seconds = timed([program, "surface", of, "--chord", repr(chord), "-o", "s.mesh"], folder)
    claim = json.loads((folder / "s.certificate.json").read_text())
    again, proving = timed([program, "verify", "s.mesh"], folder)
    row = {"surface": name, "chord": chord, "status": done.returncode, "vertices": claim["vertices"],
           "triangles": claim["triangles"], "distance": claim["distance"], "seconds": seconds, "proving": proving,
           "verified": again.returncode == 0, "reason": claim["reason"]}
    if sampled:
        row["sampled"] = max(Sampling(folder / "s.certificate.json", folder / "s.mesh").greatest())
    return row


DRAW = {
    "torus": "torus ts 0 0 0 0 0 1 1 0.3\nmkface f ts 0 1.5707963267948966 -3.0787608005179972 3.0787608005179972\n",
    "bicubic": "beziersurf bs 4 4 %s\nmkface f bs\n" % " ".join(
        "%r %r %r" % tuple(p) for column in zip(*bicubic()["patches"][0]["control"]) for p in column)}


def plugins(folder):
    """Makes the plugins' names without version numbers, by which DRAW searches them and which Debian's packages
    lack."""
    place = folder / "plugins"
    place.mkdir(exist_ok=True)
    for library in pathlib.Path("/usr/lib/x86_64-linux-gnu").glob("libTK*.so.7"):
        link = place / library.name.removesuffix(".7")
        if not link.exists():
            link.symlink_to(library)
    return str(place)


def rival(program, name, chord, folder):
    """Returns OpenCASCADE's mesh for this deflection, and its distance from the surface."""
    (folder / "draw.tcl").write_text(
        f"pload MODELING\npload XSDRAW\n{DRAW[name]}incmesh f {chord!r} -a 60\nputs [trinfo f]\nwritestl f o.stl\nexit\n")
    done, _ = timed(["env", "LD_LIBRARY_PATH=" + plugins(folder), "occt-draw", "-b", "-f", "draw.tcl"], folder)
    vertices = int(re.search(r"(\d+) nodes", done.stdout)[1])
    of = "bicubic.json" if name == "bicubic" else name
    judged, _ = timed([program, "deviation", "o.stl", of, "--at-most", repr(chord), "--json"], folder)
    found = json.loads(judged.stdout)
    return {"vertices": vertices, "status": judged.returncode,
            "low": max(found[way]["low"] for way in ("mesh_to_surface", "surface_to_mesh")),
            "high": max(found[way]["high"] for way in ("mesh_to_surface", "surface_to_mesh"))}


def main():
    words = argparse.ArgumentParser(description=__doc__)
    words.add_argument("--asterism", required=True)
    words.add_argument("--surfaces", nargs="+", default=list(WIDTHS), choices=list(WIDTHS))
    words.add_argument("--distances", nargs="+", type=float, default=list(DISTANCES), help="shares of the width")
    words.add_argument("--no-sampling", action="store_true")
    words.add_argument("--rival", action="store_true")
    words.add_argument("--json", type=pathlib.Path)
    given = words.parse_args()
    program, rows = str(pathlib.Path(given.asterism).resolve()), []
    with tempfile.TemporaryDirectory(prefix="asterism-surfaces-") as place:
        for name in given.surfaces:
            for share in given.distances:
                row = measure(program, name, float("%.3g" % (share * WIDTHS[name])), pathlib.Path(place),
                              not given.no_sampling)
                if given.rival and name in DRAW:
                    row["rival"] = rival(program, name, row["chord"], pathlib.Path(place))
                rows.append(row)
                print(line_of(row), flush=True)
    if given.json:
        given.json.write_text(json.dumps(rows, indent=1))


def line_of(row):
    product = row["distance"] * row["vertices"]
    cells = [row["surface"], f"{row['chord']:g}", str(row["vertices"]), f"{row['distance']:.4g}", f"{product:.3g}"]
    if "rival" in row:
        other = row["rival"]
        cells.append("%d in %.4g: %.2f" % (other["vertices"], other["low"], product / (other["vertices"] * other["low"])))
    else:
        cells.append("")
    cells.append(f"{row['distance'] / row['sampled']:.3f}" if "sampled" in row else "")
    cells += [f"{row['seconds']:.1f}", f"{row['proving']:.1f}"]
    said = "" if row["status"] == 0 and row["verified"] else f" NOT CERTIFIED: {row['reason']}"
    return "| " + " | ".join(cells) + " |" + said


if __name__ == "__main__":
    main()
