# SPDX-License-Identifier: MIT
"""FreeFEM's own scripts with each call of adaptmesh rewritten as one line of asterism.idp, beside the scripts as they
are: vertices, errors where a reference can be had, and the table of docs/results/solvers.md. Where there is a reference
each script runs with its err times STEPS factors from 0.75 to 1.35 too, and the last column compares the two lines of
errors against vertices. The scripts are FreeFEM's and not shipped: FOLDER is examples of
github.com/FreeFem/FreeFem-sources.

  freefem_scripts.py --asterism COMMAND --scripts FOLDER [--limit SECONDS] [--steps STEPS] [NAME...]
"""
import argparse
import dataclasses
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import adaptmesh_calls  # noqa: E402

INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "apps" / "freefem"


@dataclasses.dataclass
class Script:
    """One script: how the table calls it; code appended to it that prints "measured VERTICES ERROR", and in which
    asReference stands for the number that other code prints, appended to the script by itself; text that is removed
    since Debian's FreeFEM lacks that part; and, where no err says how fine the mesh is, text that does and the text
    that replaces it, with {} for a factor of sizes or errors."""
    name: str
    measured: str = ""
    kind: str = ""
    reference: str = ""
    without: tuple[str, ...] = ()
    finer: tuple[str, str] = ("", "")


def energy(load, on, mass="0", weight="1", element="P1", mesh="Th", finest="1e-7", rounds=4):
    """Returns the parts of a Script for the energy norm of the error of Galerkin's method on the last mesh. The
    reference is a solution of degree 2 on meshes of adaptmesh for a far smaller error. Energies of nested minimisers
    differ by the square of the error."""
    def problem(name, on_mesh, unknown, degree):
        conditions = on.replace("U", unknown)
        return f"""
fespace {name}Space({on_mesh}, {degree});
{name}Space {unknown}, {unknown}T;
problem {name}({unknown}, {unknown}T, solver = sparsesolver)
  = int2d({on_mesh}, qforder = 9)(({weight}) * (dx({unknown})*dx({unknown}T) + dy({unknown})*dy({unknown}T))
                                  + {mass} * {unknown}*{unknown}T)
  - int2d({on_mesh}, qforder = 9)(({load}) * {unknown}T) {conditions};
"""
    def value(on_mesh, unknown):
        return f"int2d({on_mesh}, qforder = 9)(({weight}) * (dx({unknown})^2 + dy({unknown})^2))"
    reference = (f"{{ mesh asFine = {mesh};\n" + problem("asReference", "asFine", "asW", "P2")
                 + f"for (int as = 0; as < {rounds}; ++as) {{\n  asReference;\n  asFine = adaptmesh(asFine, asW, "
                   f"err = 0.01 * 3.^-as, hmin = {finest}, nbvx = 200000, iso = 1, splitpbedge = 0);\n}}\n"
                   f'asReference;\ncout.precision(17);\ncout << "reference " << {value("asFine", "asW")} << endl; }}\n')
    measured = ("{ " + problem("asCoarse", mesh, "asU", element)
                + f'asCoarse;\ncout << "measured " << {mesh}.nv << " " '
                + f'<< sqrt(asReference - {value(mesh, "asU")}) << endl; }}\n')
    return {"measured": measured, "reference": reference, "kind": "energy"}


def in_the_mean(mesh, found, exact):
    """Returns code for the error of a function on a mesh in the mean square."""
    return (f'cout << "measured " << {mesh}.nv << " " << sqrt(int2d({mesh}, qforder = 9)(square({found} - ({exact})))) '
            "<< endl;\n")


DIRAC = """{ fespace asSpace(Th, P1);
asSpace asU, asV, asB;
matrix asD = interpolate(asSpace, xdelta, ydelta);
asB[] = asD * cdelta;
asB[] = -asB[];
problem asLaplace(asU, asV, solver = sparsesolver)
  = int2d(Th)(dx(asU)*dx(asV) + dy(asU)*dy(asV)) + asB[] + on(1, 2, 3, 4, asU = 0);
asLaplace;
func asLog = -(cdelta[0] * log(square(x - xdelta[0]) + square(y - ydelta[0]))
               + cdelta[1] * log(square(x - xdelta[1]) + square(y - ydelta[1]))) / (4 * pi);
mesh asFine = square(80, 80);
fespace asSmooth(asFine, P2);
asSmooth asS, asT;
solve asRest(asS, asT, solver = sparsesolver)
  = int2d(asFine)(dx(asS)*dx(asT) + dy(asS)*dy(asT)) + on(1, 2, 3, 4, asS = -asLog);
""" + in_the_mean("Th", "asU", "asLog + asS") + "}\n"

OBSTACLE = """cout.precision(17);
real asEnergy = int2d(Th)((dx(uh)^2 + dy(uh)^2) / 2 - uh);
cout << "reference " << asEnergy << endl;
"""

HILL = in_the_mean("th", "vT", "1 - tanh(30*(sqrt((x - 0.3*(cos(t) + sin(t)))^2 + (y - 0.3*(cos(t) - sin(t)))^2)"
                   " - 0.2))")

EVERYWHERE = "+ on(1, 2, 3, 4, 5, 6, U = 0)"
SCRIPTS = [
    Script("adapt", **energy("-(x - y)", "", "1e-10")),
    Script("adaptindicatorP1", **energy("x - y", "", "1e-10")),
    Script("adaptindicatorP2", **energy("x - y", "", "1e-10", element="P2", rounds=6)),
    Script("AdaptResidualErrorIndicator", **energy("x - y", "", "1e-10"),
           finer=("real hinit = 0.2;", "real hinit = 0.2*{};")),
    Script("a_tutorial", in_the_mean("disk", "u", "(1 - x^2 - y^2)/4"), "mean square"),
    Script("Laplace-RHS-Dirac", DIRAC, "mean square"),
    Script("freeboundary"),
    Script("freeboundary-weak"),
    Script("VI-adap", OBSTACLE + 'cout << "measured " << Th.nv << " " << sqrt(asEnergy - (asReference)) << endl;\n',
           "energy"),
    Script("uniformmesh"),
    Script("fluidStructAdapt"),
    Script("wafer-heating-laser-axi", **energy("x * f / thC", "+ on(1, 2, 3, U = 0)", weight="x", finest="1e-3")),
    Script("demo", **energy("-1", EVERYWHERE)),
    Script("aadaptation", **energy("-1", EVERYWHERE.replace("1, 2, 3, 4, 5, 6", "aaa, bbb, ccc, ddd, eee, fff"))),
    Script("Richard"),
    Script("cavityNewton"),
    Script("NSP1P2"),
    Script("sphere", without=('load "medit"', "meshS Th3= movemesh23(Th,transfo=[f1,f2,f3]);", "plot(Th3,wait=1);",
                              'medit("sphere-a",Th3);')),
    Script("convect-apt", HILL, "mean square"),
    Script("aaa-adp", in_the_mean("Th", "fh", "f"), "mean square", finer=("real coef=50;", "real coef=50/{};")),
]


def run(text, name, by, options):
    """Returns the script's output, standard error included, and its exit status."""
    folder = pathlib.Path(options.work) / name / by
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file in pathlib.Path(options.scripts).glob("*/*.edp"):
        if f'"{file.name}"' in text:
            shutil.copy(file, folder)
    (folder / "script.edp").write_text(text, encoding="latin-1")
    try:
        done = subprocess.run([options.freefem, "-v", "0", "-nw", "script.edp"], cwd=folder, text=True,
                              encoding="latin-1", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=options.limit, check=False,
                              env={**os.environ, "ASTERISM": options.asterism, "FF_INCLUDEPATH": str(INCLUDE)})
    except subprocess.TimeoutExpired:
        return "", -1
    (folder / "output").write_text(done.stdout, encoding="utf-8")
    return done.stdout, done.returncode


def text_of(script, options):
    """Returns FreeFEM's script without the removed text and with the appended code that measures."""
    path, = pathlib.Path(options.scripts).glob(f"*/{script.name}.edp")
    text = path.read_text(encoding="latin-1")
    for words in script.without:
        if words not in text:
            raise SystemExit(f"{path}: '{words}' is not there")
        text = text.replace(words, "")
    return text


def reference_of(script, text, options):
    """Returns the reference: what the script's code prints, or VI-adap's own energy for a sixth of its tolerance."""
    code = script.reference
    if script.name == "VI-adap":
        for found, finer in (("tolmin=0.002", "tolmin=0.0003"), ("err=tol", "err=tol,nbvx=100000")):
            if found not in text:
                raise SystemExit(f"VI-adap: {found} is not there")
            text = text.replace(found, finer)
        code = OBSTACLE
    if not code:
        return ""
    output, _ = run(text + code, script.name, "reference", options)
    return re.findall(r"^reference (\S+)", output, re.MULTILINE)[-1]


def scaled(script, text, factor):
    """Returns the script with err, or what says in its place how fine the mesh is, times the factor."""
    if factor == 1:
        return text
    if script.finer[0]:
        if script.finer[0] not in text:
            raise SystemExit(f"{script.name}: '{script.finer[0]}' is not there")
        return text.replace(script.finer[0], script.finer[1].format(factor))
    plain, made, done = adaptmesh_calls.without_comments(text), "", 0
    for found in adaptmesh_calls.CALL.finditer(plain):
        end = adaptmesh_calls.end_of_call(plain, found.end())
        call = re.sub(r"\berr\s*=\s*([^,]*)", rf"err = {factor}*(\1)", plain[found.end():end])
        if "err = " not in call:
            raise SystemExit(f"{script.name}: a call of adaptmesh has no err")
        made, done = made + text[done:found.end()] + call, end
    return made + text[done:]


def outcomes(script, text, code, factor, options):
    """Returns of either program the last number of vertices, or the status that is not 0, and what was measured."""
    text, found = scaled(script, text, factor), []
    mesh = list(adaptmesh_calls.CALL.finditer(adaptmesh_calls.without_comments(text)))[-1].group(1)
    for by, body in (("adaptmesh", text), ("asterism", adaptmesh_calls.rewrite(text)[0])):
        output, status = run(f'{body}\ncout << "last " << {mesh}.nv << endl;\n{code}', script.name, by, options)
        count = re.findall(r"^last (\d+)", output, re.MULTILINE)
        error = re.findall(r"^measured (\d+) (\S+)", output, re.MULTILINE)
        if status != 0 or not count or (code and not error):
            found.append((f"status {status}", None))
        else:
            found.append((count[-1], (int(error[-1][0]), float(error[-1][1])) if error else None))
    return found


def at_equal_vertices(first, second):
    """Returns the ratio of errors at equal numbers of vertices, the second over the first, and its standard error: two
    parallel lines of log error against log vertices, by least squares. The arguments are lists of (vertices, error)."""
    groups = [[(math.log(n), math.log(e)) for n, e in group] for group in (first, second)]
    means = [[sum(values) / len(values) for values in zip(*group)] for group in groups]
    apart = [(x - mean[0], y - mean[1]) for group, mean in zip(groups, means) for x, y in group]
    squares = sum(x * x for x, _ in apart)
    slope = sum(x * y for x, y in apart) / squares
    (x, y), (z, w) = means
    variance = sum((b - slope * a)**2 for a, b in apart) / (len(apart) - 3)
    error = math.sqrt(variance * (1 / len(first) + 1 / len(second) + (z - x)**2 / squares))
    return math.exp(w - y - slope * (z - x)), error, slope


def row(script, options):
    """Returns the row of the table."""
    text, code = text_of(script, options), script.measured
    code = code.replace("asReference", reference_of(script, text, options))
    found = outcomes(script, text, code, 1, options)
    words = [script.name, f"{adaptmesh_calls.rewrite(text)[1]}", *(str(count) for count, _ in found)]
    if not all(error for _, error in found):
        return "| " + " | ".join([*words, "", "", "", ""]) + " |"
    words.append(f"{script.kind}: {found[0][1][1]:.3g}, {found[1][1][1]:.3g}")
    runs = []
    for step in range(options.steps):
        factor = round(0.75 * (1.35 / 0.75)**(step / max(1, options.steps - 1)), 4)
        runs.append([error for _, error in outcomes(script, text, code, factor, options)])
    if all(all(pair) for pair in runs) and len(runs) >= 3:
        words.append("{:.3f} | {:.3f} | {:.2f}".format(*at_equal_vertices(*zip(*runs))))
    else:
        words += ["", "", ""]
    return "| " + " | ".join(words) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--asterism", required=True)
    parser.add_argument("--scripts", required=True)
    parser.add_argument("--freefem", default="FreeFem++-nw")
    parser.add_argument("--work", default="/tmp/bench-freefem-scripts")
    parser.add_argument("--limit", type=float, default=900)
    parser.add_argument("--steps", type=int, default=11)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    options.asterism = os.path.abspath(options.asterism)
    print("| script | calls | vertices, adaptmesh | asterism | error: adaptmesh, asterism | "
          "at equal vertices | +- | power |\n|---|---|---|---|---|---|---|---|", flush=True)
    for script in SCRIPTS:
        if not options.names or script.name in options.names:
            print(row(script, options), flush=True)


if __name__ == "__main__":
    main()
