# SPDX-License-Identifier: MIT
"""The recorded runs: jobs, each of a few commands in a folder of its own. Records are compared by the jobs' names,
which therefore stay."""
import dataclasses
import re

import inputs as given


@dataclasses.dataclass(frozen=True)
class Change:
    """Writes `target`, the text of `source` with the first match of `pattern` replaced."""
    source: str
    target: str
    pattern: str
    replacement: str

    def apply(self, folder):
        """Writes the file. Returns whether there was a match."""
        text = (folder / self.source).read_text(encoding="utf-8")
        text, count = re.subn(self.pattern, self.replacement, text, count=1)
        (folder / self.target).write_text(text, encoding="utf-8")
        return count == 1


@dataclasses.dataclass(frozen=True)
class Job:
    """A job. Its steps are command lines, without the program's name, and changes of files. A file whose name ends in
    a slash is a folder."""
    name: str
    steps: tuple
    files: dict = dataclasses.field(default_factory=dict)
    text: str = ""  # standard input of each command


def of_fields():
    """Built-in metrics on the square, and the options that shape a field."""
    yield Job("square", ("mesh square -o out.mesh -o out.svg",
                         "mesh square --metric identity --size 0.5 -o sized.mesh"))
    yield Job("random", ("mesh square --random-points 30 --seed 5 -o out.mesh -o out.vtu",
                         "mesh square --metric swirl --random-points 5 -o swirl.mesh"))
    yield Job("swirl", ("mesh square --metric swirl:12 --size 0.3 -o out.mesh -o out.vtu -o out.svg",))
    yield Job("sink", ("mesh square --metric sink:60 --size 0.5 -o out.mesh",
                       "mesh square --metric sink:12 --size 0.5 --gradation 1.1 -o graded.mesh"))
    yield Job("fitted", ("mesh square --metric swirl:60 --size 0.7 -o out.mesh -o out.svg",))
    yield Job("layer", ("mesh square --metric layer --size 1 -o out.mesh",
                        "mesh square --metric layer:0.05,0.5 --size 1 -o own.mesh"))
    yield Job("shock", ("mesh square --metric shock:10 --size 1.5 --gradation 1.3 -o out.mesh",))
    yield Job("benchmarks", ("mesh square --metric linear --size 3 -o linear.mesh",
                             "mesh square --metric polar-1 --size 3 --gradation 1.5 -o one.mesh",
                             "mesh square --metric polar-2 --size 3 --gradation 1.5 -o two.mesh",
                             "mesh square --metric circle-1 --size 4 --gradation 1.5 -o circle.mesh"))
    yield Job("formula", ("mesh square --metric 'expr:1+9*x^2;0.5*x*y;1+y^2' --size 0.2 "
                          "--angle-bound 15 -o out.mesh",))
    yield Job("background", ("mesh square --metric swirl:12 --size 0.4 --quiet -o back.mesh",
                             "mesh in.poly --metric back.mesh --size 1.5 -o out.mesh"),
              {"in.poly": given.SQUARE})


def of_refinement():
    """Strategies, the options of refinement, and what is written."""
    yield Job("bound", ("mesh square --metric swirl:3 --size 0.3 --angle-bound 28 -o high.mesh",
                        "mesh square --metric swirl:12 --random-points 20 --angle-bound 0 -o none.mesh",
                        "mesh square --metric swirl:3 --refine fill --random-points 12 -o out.mesh"))
    yield Job("voronoi", ("mesh square --metric sink:3 --refine voronoi --angle-bound 15 --size 0.4 "
                          "-o out.mesh",
                          "mesh square --metric swirl:12 --refine voronoi --angle-bound 10 "
                          "--random-points 9 -o points.mesh"))
    darts = "mesh square --metric swirl:12 --refine darts --angle-bound 10 --size 0.4"
    yield Job("darts", (f"{darts} -o out.mesh", f"{darts} --seed 7 -o seven.mesh"))
    yield Job("tolerance", ("mesh square --metric swirl:3 --refine voronoi --random-points 10 --tol 0.05 "
                            "-o out.mesh",
                            "mesh square --metric swirl:12 --tol 0.5 --random-points 10 -o far.mesh"))
    yield Job("improve", ("mesh square --metric swirl:12 --size 0.3 --improve 2 -o out.mesh",
                          "mesh square --size 0.2 --improve 1 -o round.mesh"))
    yield Job("threads", ("mesh square --metric swirl:12 --size 0.1 --threads 1 -o one.mesh",
                          "mesh square --metric swirl:12 --size 0.1 --threads 2 -o two.mesh"))
    yield Job("dual", ("mesh square --metric swirl:12 --size 0.3 --certify voronoi -o out.mesh",
                       "mesh square --size 0.5 --certify stars -o stars.mesh"))
    yield Job("outputs", ("mesh square --metric swirl:3 --size 0.5 --quiet --certificate named.json "
                          "-o out.vtu -o out.mesh",))
    yield Job("pictures", ("mesh square --metric swirl:12 --size 0.5 --ellipses -o out.png -o out.pdf "
                           "-o out.svg",))


def of_domains():
    """Domains that are not the square."""
    yield Job("airfoil", ("mesh airfoil --size 0.3 -o out.mesh -o out.svg",
                          "mesh airfoil --metric swirl:12 --size 0.5 --refine voronoi --angle-bound 15 "
                          "-o swirl.mesh"))
    yield Job("frame", ("mesh in.poly --size 0.15 -o out.mesh -o out.svg",
                        "mesh in.poly --metric sink:3 --refine darts --angle-bound 10 -o darts.mesh"),
              {"in.poly": given.FRAME})
    yield Job("regions", ("mesh in.poly --regions --size 0.4 -o out.mesh -o out.vtu",),
              {"in.poly": given.FRAME})
    yield Job("nodes", ("mesh in.poly --metric swirl:3 --size 0.5 -o out.mesh",),
              {"in.poly": given.NODES_POLY, "in.node": given.NODES})
    yield Job("repaired", ("mesh in.poly -o out.mesh", "mesh in.poly --quiet -o quiet.mesh"),
              {"in.poly": given.REPAIRED})
    yield Job("parts", ("mesh in.poly --size 0.5 --regions -o out.mesh",), {"in.poly": given.PARTS})
    yield Job("sharp", ("mesh in.poly -o out.mesh", "mesh in.poly --metric swirl:12 -o swirl.mesh",
                        "verify swirl.mesh"), {"in.poly": given.SHARP})
    yield Job("again", ("mesh square --metric swirl:3 --size 0.4 --quiet -o first.mesh",
                        "mesh first.mesh --metric swirl:3 --size 0.4 -o same.mesh",
                        "mesh first.mesh --metric swirl:3 --size 0.2 -o finer.mesh"))


def of_runs_not_reached():
    """Metrics that are delivered as wanted or replaced, and limits. Most of the commands end with status 1."""
    jump = "mesh square --metric 'expr:(x>0)?100:1;0;1'"
    yield Job("size-jump", ("mesh square --metric 'expr:(x<0.1)?100:1;0;(x<0.1)?100:1' --size 1 "
                            "-o out.mesh", "verify out.mesh"))
    yield Job("jump", (f"{jump} --size 0.5 -o out.mesh -o out.vtu", "verify out.mesh",
                       Change("out.certificate.json", "hidden.json",
                              r'("low_triangles_as_wanted": )\[[^\]]*\]', r"\1[]"),
                       "verify out.mesh --certificate hidden.json"))
    yield Job("strict", (f"{jump} --metric-tolerance 0 -o out.mesh -o out.svg", "verify out.mesh"))
    yield Job("last-resort", ("mesh square --metric shock:10 --size 2 -o out.mesh",
                          "mesh square --metric swirl:400 --max-sites 60 -o few.mesh"))
    yield Job("demands", ("mesh airfoil --size 0.3 --max-sites 120 -o out.mesh",))
    yield Job("thin", ("mesh square --metric 'expr:10000;99;1' --random-points 5 -o out.mesh",
                       "mesh square --metric 'expr:1000000;999.9;1' --random-points 5 --max-sites 1000 "
                       "-o limit.mesh"))
    yield Job("max-sites", ("mesh square --size 0.001 --max-sites 500 -o out.mesh",
                            "mesh square --metric swirl:12 --size 0.5 --angle-bound 45 --max-sites 300 "
                            "-o steep.mesh -o steep.vtu"))
    yield Job("limits", ("mesh square --size 0.02 --max-memory 1 -o out.mesh",
                         "mesh square --metric sink:3 --size 0.3 --max-seconds 100000 "
                         "--max-memory 100000 --max-sites 5000 -o free.mesh"))
    yield Job("not-dual", ("mesh square --metric swirl:12 --certify voronoi -o out.mesh",
                           "verify out.mesh", "verify out.mesh --voronoi"))


def of_verify():
    yield Job("verify", ("mesh in.poly --metric swirl:3 --size 0.5 --regions --quiet -o out.mesh",
                         "verify out.mesh", "verify out.mesh --voronoi",
                         "verify out.mesh --domain in.poly --regions --angle-bound 15",
                         "verify out.mesh --domain square", "verify out.mesh --angle-bound 40",
                         Change("out.mesh", "bare.mesh", "$", ""), Change("out.sol", "bare.sol", "$", ""),
                         "verify bare.mesh", "verify bare.mesh --certificate out.certificate.json"),
              {"in.poly": given.FRAME})
    lies = (('"mean_quality": 0', '"mean_quality": 1'), ('"worst_angle": ', '"worst_angle": 1'),
            ('"fingerprint": "....', '"fingerprint": "0000'), ('"angle_bound": 20', '"angle_bound": 35'))
    steps = ["mesh square --metric swirl:3 --size 0.5 --quiet -o out.mesh"]
    for name, (old, new) in zip("abcd", lies):
        steps += [Change("out.certificate.json", f"{name}.json", old, new),
                  f"verify out.mesh --certificate {name}.json"]
    yield Job("forged", tuple(steps))
    yield Job("tampered", ("mesh square --metric swirl:3 --random-points 5 --quiet -o out.mesh",
                           Change("out.sol", "out.sol", r"\n4 3 4\n", "\n4 2.5 4\n"), "verify out.mesh",
                           Change("out.mesh", "out.mesh", r"\n0\.", "\n-0."), "verify out.mesh"))


def of_certify():
    varied = given.solution(given.grid_tensors(5, given.varying))
    yield Job("certify", ("certify in.mesh -o out.mesh", "verify out.mesh", "certify in.mesh in.mtr",
                          "certify in.mesh length.mtr", "certify in.mesh other.sol --angle-bound 0",
                          "certify in.mesh --metric 'expr:1;-0.5;1' --size 0.25 --angle-bound 50 "
                          "-o own.mesh"),
              {"in.mesh": given.grid(5), "other.sol": varied,
               "in.sol": given.solution(given.grid_tensors(5, given.slanted)),
               "in.mtr": given.tensors_of_bamg(given.grid_tensors(5, given.slanted)),
               "length.mtr": given.tensors_of_bamg([(0.5,)] * 36)})
    yield Job("certify-dual", ("certify in.mesh --voronoi --angle-bound 0",
                               "certify in.mesh --metric 'expr:1;-0.5;1' --voronoi -o out.mesh"),
              {"in.mesh": given.grid(8), "in.sol": given.solution(given.grid_tensors(8, given.reaching))})
    yield Job("repair", ("certify in.mesh --repair --angle-bound 24 -o out.mesh", "verify out.mesh",
                         "certify in.mesh --metric swirl:12 --repair --voronoi -o formula.mesh",
                         "certify in.mesh --repair --angle-bound 28 --max-sites 40 -o limit.mesh"),
              {"in.mesh": given.grid(5), "in.sol": varied})
    yield Job("inverted", ("certify in.mesh --repair -o out.mesh", "mesh in.mesh -o out.mesh"),
              {"in.mesh": given.INVERTED, "in.sol": given.solution([(1, 0, 1)] * 4)})


def of_other_commands():
    yield Job("help", ("--help", "--version", "mesh --help", "verify --help", "certify --help",
                       "eval --help", "draw --help"))
    yield Job("draw", ("draw in.mesh -o out.svg --ellipses --no-sites --width 400",
                       "draw in.mesh -o out.pdf", "draw in.mesh -o out.png --width 300",
                       "draw bare.mesh -o bare.svg", "draw bare.mesh -o no.svg --ellipses"),
              {"in.mesh": given.grid(5), "bare.mesh": given.grid(3),
               "in.sol": given.solution(given.grid_tensors(5, given.varying))})
    yield Job("eval", ("eval", "eval --stats in.txt", "eval --kernel exact --stats in.txt",
                       "eval --kernel interval --stats -", "eval --kernel double in.txt in.txt",
                       "eval --kernel filtered bad.txt in.txt"),
              {"in.txt": given.RECORDS, "bad.txt": given.BAD_RECORDS}, given.RECORDS)


def of_adaptation():
    """Metrics, meshes and fields from a solution, in loops."""
    files = {"in.mesh": given.grid(8), "u.sol": given.values(given.grid_values(8)),
             "next.sol": given.values([y - x for x, y in given.grid_places(8)])}
    yield Job("adapt", ("adapt in.mesh --solution u.sol --vertices 200 -o out.mesh", "verify out.mesh",
                        "adapt in.mesh --solution u.sol --error 0.01 --relative --aspect 50 -o err.mesh",
                        "adapt in.mesh --solution u.sol --vertices 150 --keep always --no-split-across "
                        "-o kept.mesh", "adapt in.mesh --solution u.sol --vertices 150 --periodic 1,3 "
                        "-o periodic.mesh", "adapt in.mesh --solution u.sol --vertices 1 -o none.mesh",
                        "adapt in.mesh --solution missing.sol --vertices 9 -o none.mesh"), files)
    yield Job("metric", ("metric in.mesh --solution u.sol --vertices 200 -o m.mesh",
                         "mesh in.mesh --metric m.mesh --threads 2 -o out.mesh", "verify out.mesh",
                         "metric in.mesh --solution u.sol -o none.sol"), files)
    yield Job("transfer", ("mesh square --size 0.2 --quiet -o new.mesh",
                           "transfer in.mesh u.sol new.mesh -o moved.sol",
                           "transfer in.mesh u.sol new.mesh --transfer project -o kept.sol",
                           "transfer in.mesh missing.sol new.mesh -o none.sol"), files)


def of_wishes():
    """Sizes at places, layers, seams that repeat, regions, and guarantees."""
    yield Job("sizes", ("mesh in.poly --size 0.4 --size-at 0.2,0.2,0.3:0.05 "
                        "--size-box 2,1,3,2:0.1 -o at.mesh", "verify at.mesh",
                        "mesh in.poly --size 0.4 --size-near 1:0.05,1.3 --hmax 0.3 -o near.mesh",
                        "mesh in.poly --size 0.4 --layers 1:0.01,1.4,3 --aspect 20 -o layers.mesh",
                        "mesh in.poly --size 0.4 --size-in 2:0.05 --regions -o in.mesh"),
              {"in.poly": given.FRAME})
    yield Job("periodic", ("mesh square --size 0.2 --periodic 2,4 -o out.mesh", "verify out.mesh",
                           "mesh square --size 0.2 --periodic 2,9 -o none.mesh"))
    yield Job("guarantee", ("mesh square --metric swirl:1.2 --size 0.3 --guarantee -o out.mesh",
                            "verify out.mesh"))
    yield Job("polygons", ("mesh in.geojson --size 0.3 -o out.mesh", "verify out.mesh",
                           "info in.geojson", "draw in.geojson -o out.svg", "mesh in.wkt -o wkt.mesh",
                           "mesh bad.geojson -o bad.mesh"),
              {"in.geojson": given.PROVINCES, "in.wkt": given.WKT, "bad.geojson": given.PROVINCES[:90]})


def of_files():
    """Formats, what files hold, and meshes in several parts."""
    endings = ("meshb", "msh", "vtu", "2dm", "fort.14", "su2", "off")
    yield Job("convert", ("mesh square --size 0.5 --quiet -o in.mesh",
                          *(f"convert in.mesh out.{ending}" for ending in endings),
                          *(f"info out.{ending}" for ending in endings),
                          "certify out.msh --metric identity", "certify out.vtu --metric identity",
                          "mesh out.su2 --size 0.3 -o again.mesh", "convert in.mesh out.xyz",
                          "convert missing.msh out.vtu"))
    yield Job("pieces", ("mesh square --metric swirl:12 --size 0.1 --pieces 4 -o parts/",
                         "verify parts/", "verify parts/piece_2.mesh",
                         "mesh square --metric swirl:12 --size 0.1 --pieces 4 --resume -o parts/",
                         Change("parts/piece_1.mesh", "parts/piece_1.mesh", r"\n0\.", "\n-0."),
                         "verify parts/"))
    yield Job("proof", ("mesh in.poly --metric swirl:12 --size 0.2 --proof out.proof -o out.mesh",
                        "check out.mesh out.proof --domain in.poly --angle-bound 20 --metric out.sol",
                        "check out.mesh out.proof --domain in.poly --angle-bound 35 --metric out.sol",
                        "check out.mesh out.mesh --domain in.poly --angle-bound 20 --metric out.sol"),
              {"in.poly": given.SQUARE})
    yield Job("second-order", ("mesh square --size 0.5 --order 2 -o out.msh", "verify out.msh",
                               "convert out.msh corners.mesh"))


def of_surfaces():
    yield Job("surfaces", ("surface octant --chord 0.02 -o out.obj",
                           "surface saddle --chord 0.05 -o out.mesh", "verify out.mesh",
                           "deviation out.mesh saddle --at-most 0.05",
                           "deviation out.mesh saddle --at-most 0.0001",
                           "surface bad.json --chord 0.1 -o bad.obj"),
              {"bad.json": "{}"})


def refused(name, arguments, files=None):
    """Returns a job of `asterism mesh`, with a command for each of the arguments."""
    return Job(name, tuple(f"mesh {words} -o out.mesh" for words in arguments), files or {})


def refused_files(name, texts):
    """Returns a job of `asterism mesh`, with a command for each text of a .poly file."""
    files = {f"{chr(ord('a') + i)}.poly": text for i, text in enumerate(texts)}
    return refused(name, files, files)


def of_bad_arguments():
    yield Job("bad-usage", ("", "knit", "mesh", "mesh square", "mesh -o out.mesh", "verify",
                            "draw in.mesh", "mesh square --colour red -o out.mesh",
                            "mesh square --refine magic -o out.mesh", "eval --kernel guess",
                            "certify in.mesh in.sol --metric identity", "certify in.mesh --size 2",
                            "certify in.mesh --repair", "certify in.mesh --max-sites 8"),
              {"in.mesh": given.grid(2), "in.sol": given.solution([(1, 0, 1)] * 9)})
    yield refused("bad-number", [f"square {words}" for words in (
        "--size -1", "--size nan", "--size 3cm", "--size 1e-200", "--gradation 1", "--angle-bound 60",
        "--tol 0", "--max-sites 3", "--max-sites -7", "--random-points 1e3",
        "--seed 99999999999999999999", "--threads 0", "--improve 1.5")])
    yield refused("bad-metric", [f"square --metric {words}" for words in (
        "swril:3", "swirl:-3", "sink:much", "layer:0.1", "polar-1:3", "'expr:1;1'", "'expr:1+;0;1'",
        "'expr:1+z;0;1'", "''", "missing.mesh")])
    yield refused("indefinite", [f"square --metric {words}" for words in (
        "'expr:1;2;1'", "'expr:x;0;1'", "'expr:1/(x+1);0;1'", "'expr:x;0;1' --gradation 2")])
    yield Job("missing", ("mesh missing.poly -o out.mesh", "mesh triangle -o out.mesh",
                          "mesh folder.poly -o out.mesh", "verify missing.mesh", "verify in.mesh",
                          "certify missing.mesh", "certify in.mesh", "certify in.mesh missing.sol",
                          "draw missing.mesh -o out.svg", "eval missing.txt"),
              {"folder.poly/": "", "in.mesh": given.grid(2)})
    yield Job("bad-places", ("mesh square -o out.stl", "mesh square -o out",
                             "mesh square -o nowhere/out.mesh", "mesh square -o folder.mesh",
                             "mesh square -o out.mesh -o nowhere/out.svg",
                             "mesh square -o out.mesh -o ./out.mesh",
                             "mesh in.poly -o out.mesh --certificate in.poly",
                             "mesh square -o out.mesh --certificate out.sol",
                             "mesh square -o out.mesh --certificate nowhere/c.json",
                             "draw in.mesh -o out.gif", "draw in.mesh -o out.vtu",
                             "draw in.mesh -o out.svg --width 1",
                             "certify in.mesh --metric identity -o in.mesh"),
              {"folder.mesh/": "", "in.poly": given.SQUARE, "in.mesh": given.grid(2)})


def of_bad_domains():
    square, hole = given.SQUARE, given.SQUARE[:-2] + "1\n1 {} {}\n"
    changed = given.changed
    yield refused_files("poly-text", (
        "", "# nothing\n", square[:30], changed(square, "2 1 0\n", "2 one 0\n"),
        changed(square, "2 1 0\n", "2 1,0 0\n"), changed(square, "2 2 3 2\n", "2 2 9 2\n"),
        changed(square, "3 1 1\n", "2 1 1\n"), changed(square, "4 2 0 0", "4 3 0 0"),
        changed(square, "4 2 0 0", "4000000000000 2 0 0"), "".join(map(chr, range(1, 128)))))
    yield refused_files("poly-nan", (
        changed(square, "2 1 0\n", "2 nan 0\n"), changed(square, "2 1 0\n", "2 -inf 0\n"),
        changed(square, "2 1 0\n", "2 1e999 0\n"), hole.format("inf", 0)))
    yield refused_files("poly-cross", (
        changed(square, "2 2 3 2\n3 3 4 3\n4 4 1 4", "2 2 4 2\n3 4 3 3\n4 3 1 4"),))
    yield refused_files("poly-open", (
        changed(changed(square, "4 1\n", "3 1\n"), "4 4 1 4\n", ""),
        "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n0 0\n0\n",
        "3 2 0 0\n1 0 0\n2 1 1\n3 2 2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"))
    yield refused_files("poly-hole", (
        hole.format(5, 5), hole.format(0.5, 0), hole.format(0.5, 0.5), square + "1\n1 5 5 1\n",
        square + "2\n1 0.25 0.5 1\n2 0.5 0.5 2\n"))


def of_bad_meshes():
    corners, round_one = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], (1, 0, 1)
    texts = ("", "once upon a time\n", given.medit(corners, []), given.medit(corners, [(1, 2, 4, 0)]),
             given.medit(corners, [(1, 2, 2, 0)]), given.medit([*corners[:2], (0, 0, 0)], [(1, 2, 3, 0)]),
             given.medit([*corners[:2], (0, "nan", 0)], [(1, 2, 3, 0)]), given.TRIANGLE[:60])
    meshes = {f"{chr(ord('a') + i)}.mesh": text for i, text in enumerate(texts)}
    commands = [command.format(name) for name in meshes
                for command in ("certify {} in.sol", "mesh {} -o out.mesh", "draw {0} -o {0}.svg")]
    yield Job("bad-mesh", tuple(commands),
              {"in.sol": given.TRIANGLE_SOLUTION, **meshes})
    tensors = {"a.sol": "", "b.sol": given.solution([round_one] * 2),
               "c.sol": given.solution([round_one, (1, 2, 1), round_one]),
               "d.sol": given.solution([round_one, (1, 0, "nan"), round_one]),
               "e.mtr": "3 2\n1 1\n1 1\n1 1\n", "f.mtr": "3 1\n1\n0\n1\n", "g.mtr": "2 1\n1\n1\n",
               "h.mtr": "3 1\n1 1 1 1\n"}
    yield Job("bad-solution", tuple(f"certify in.mesh {name}" for name in tensors),
              {"in.mesh": given.TRIANGLE, **tensors})
    yield Job("bad-certificate", ("verify in.mesh --certificate a.json", "verify in.mesh",
                                  "verify in.mesh --certificate b.json",
                                  "verify in.mesh --certificate missing.json"),
              {"in.mesh": given.TRIANGLE, "in.sol": given.TRIANGLE_SOLUTION, "a.json": "{\"format\": ",
               "b.json": "[]", "in.certificate.json": "{\"format\": \"another\"}"})


def all_jobs():
    groups = (of_fields, of_refinement, of_domains, of_runs_not_reached, of_verify, of_certify,
              of_other_commands, of_adaptation, of_wishes, of_files, of_surfaces, of_bad_arguments,
              of_bad_domains, of_bad_meshes)
    return [job for group in groups for job in group()]
