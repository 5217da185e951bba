# SPDX-License-Identifier: MIT
"""Makes the tables of the performance page."""
from measurements import Ratio, duration, short
from page import table


def goals(timed):
    """Returns the section on the project's own limits."""
    def ratio(predicate, given, above, below):
        samples = timed[predicate][given]
        return Ratio(samples[above], samples[below])

    rows = []

    def add(what, measured, least, aim):
        reached = "yes" if measured.value <= least else "no"
        rows.append([what, measured.text(), f"{short(least)}x", reached, aim])

    for predicate in ("compare_distance", "in_wedge", "dominates"):
        add(f"`{predicate}`, filtered / double, random",
            ratio(predicate, "uniform", "filtered", "double"), 1.5, "1.15x")
    add("`edge_test`, filtered / double, random smooth metrics",
        ratio("edge_test", "uniform", "filtered", "double"), 2, "1.3x")
    add("`edge_test`, filtered / double at two vertices alone",
        ratio("edge_test", "uniform", "filtered", "double, two vertices"), 2, "1.3x")
    add("`edge_test`, exact tier / CGAL algebraic, solve and signs",
        ratio("edge_test", "uniform", "exact", "CGAL algebraic, solve and signs"), 0.02, "20 us")
    add("orientation, filtered / EPICK", ratio("orientation", "uniform", "filtered", "CGAL EPICK"), 1, "")
    add("orientation, filtered / double", ratio("orientation", "uniform", "filtered", "double"), 1.75, "1.3x")
    add("equal metrics, filtered / EPICK in-circle with orientations",
        ratio("in_circle", "uniform", "filtered", "CGAL EPICK, with orientations"), 1, "")
    add("equal metrics, filtered / EPICK in-circle alone",
        ratio("in_circle", "uniform", "filtered", "CGAL EPICK, in-circle alone"), 1, "")
    add("equal metrics, filtered / double", ratio("in_circle", "uniform", "filtered", "double"), 1.81, "1.6x")
    circles = timed["in_circle"]
    for given, name in (("grid", "small integers"), ("degenerate", "20 bits")):
        add(f"cocircular ({name}) / random, equal metrics",
            Ratio(circles[given]["filtered"], circles["uniform"]["filtered"]), 10, "3x")
    for given, samples in timed["batch"].items():
        add(f"batch of 8 / scalar double: {given}", Ratio(samples["batch of 8"], samples["double"]), 2, "1x")
    exact = timed["edge_test"]["uniform"]["exact"].median
    note = ("Ratios of medians; in brackets, lower quartile over upper to upper over lower. The exact tier alone takes"
            f" {duration(exact)} for an edge test with random smooth metrics. With equal metrics an edge test is an"
            " in-circle test and the orientations of x and y: the row \"with orientations\" has EPICK with the same"
            " tests, \"alone\" without orientations. The double kernel's `edge_test` is written for clarity and tests"
            " every section of the arc, so the first ratio of that predicate is not useful; the row \"at two vertices"
            " alone\" compares with a fast edge test in doubles.\n\n")
    return note + table(["", "measured", "at most", "reached", "aim"], rows)


def times(timed):
    """Returns a table for each predicate: medians of every contender on every input, and their ratios to doubles."""
    parts, spreads = [], []
    for predicate, inputs in timed.items():
        if predicate == "batch":
            continue
        contenders = dict.fromkeys(name for samples in inputs.values() for name in samples)
        rows = [[contender] + [time_cell(samples, contender) for samples in inputs.values()]
                for contender in contenders]
        spreads += [half_spread(sample) for samples in inputs.values() for sample in samples.values()]
        parts += [f"### {predicate}\n", table(["contender"] + list(inputs), rows)]
    note = ("Medians; in brackets, over that of the double kernel. `in_circle` is `edge_test` with four equal metrics."
            " `interval` and `exact` are these tiers alone, on the same questions; the semi-static tier alone is the"
            " filtered kernel where it decides everything. The quartiles are within 5 % of the median in"
            f" {sum(s <= 0.05 for s in spreads)} of {len(spreads)} measurements, and within"
            f" {100 * max(spreads):.0f} % in all.\n")
    return "\n".join([note] + parts)


def time_cell(samples, contender):
    if contender not in samples:
        return "-"
    sample = samples[contender]
    return f"{duration(sample.median)} ({short(Ratio(sample, samples['double']).value)}x)"


def half_spread(sample):
    """Returns the distance of the farther quartile from the median, as a part of the median."""
    low, high = sample.quartiles()
    return max(high - sample.median, sample.median - low) / sample.median


def batches(timed):
    rows = []
    for given, samples in timed["batch"].items():
        row = samples["batch of 8"]
        rows.append([given, duration(samples["double"].median), duration(samples["filtered"].median),
                     duration(row.median), Ratio(row, samples["double"]).text(),
                     Ratio(row, samples["filtered"]).text()])
    return ("Time a row of a batch of 8, against one call a question.\n\n"
            + table(["predicate", "double", "filtered", "batch", "batch / double", "batch / filtered"], rows))


def percent(part, whole):
    if part == 0:
        return "0"
    share = 100 * part / whole
    return f"{share:.2f} %" if share < 10 else f"{share:.0f} %"


def wrong(shares):
    predicates = list(shares["classes"][0]["predicates"])
    rows, filtered_wrong = [], 0
    for entry in shares["classes"]:
        counts = entry["predicates"]
        rows.append([entry["name"]] + [percent(counts[p]["double wrong"], counts[p]["questions"])
                                       for p in predicates])
        filtered_wrong += sum(c["filtered wrong"] for c in counts.values())
    questions = sum(c["questions"] for e in shares["classes"] for c in e["predicates"].values())
    note = (f"Share of wrong answers of the double kernel. The filtered kernel gave {filtered_wrong} wrong answers to"
            f" the same {questions} questions.\n\n")
    return note + table(["input"] + predicates, rows)


def tiers(shares):
    predicates = list(shares["classes"][0]["predicates"])
    names = list(shares["classes"][0]["predicates"]["edge_test"]["tiers"])
    rows = [[entry["name"]] + [tier_cell(entry["predicates"][p], names) for p in predicates]
            for entry in shares["classes"]]
    return (f"Percent of the questions that each tier decided: {', '.join(names)}.\n\n"
            + table(["input"] + predicates, rows))


def tier_cell(counts, names):
    return ", ".join(percent(counts["tiers"][n], counts["questions"]).removesuffix(" %") for n in names)


def with_doubles(runs):
    """Returns the tables of runs on plain doubles, and on the filtered kernel."""
    outcomes = [{k: run["kernels"][k]["outcome"] for k in ("double", "filtered", "exact")} for run in runs]

    def certified(kernel):
        return sum(bool(o[kernel].get("certified")) for o in outcomes)

    def like_exact(kernel):
        size = ("sites", "triangles")
        return sum(all(o[kernel].get(n) == o["exact"].get(n) for n in size) for o in outcomes)

    return (f"Of {len(runs)} jobs the auditor certifies {certified('filtered')} with the filtered kernel and"
            f" {certified('double')} with doubles; {like_exact('filtered')} and {like_exact('double')} have as many sites"
            " and triangles as with exact arithmetic. A wrong sign makes stars disagree that agree, or hides a"
            " disagreement; then the mesher inserts other sites. The mesh may be certified by chance; otherwise the"
            " auditor names the fault, or the run ends at the limit on sites.")


def whole(runs):
    kernels = ("double", "filtered", "exact")
    names = "\n".join(f"{number}. {run['name']}" for number, run in enumerate(runs, 1))
    rows, refused = [], []
    for number, run in enumerate(runs, 1):
        base = middle(run["kernels"]["filtered"]["milliseconds"])
        spent = [middle(run["kernels"][k]["milliseconds"]) for k in kernels]
        outcomes = [run["kernels"][k]["outcome"] for k in kernels]
        rows.append([str(number)] + [f"{short(s)} ms ({short(s / base)}x)" for s in spent]
                    + [", ".join(str(o.get(what, "-")) for o in outcomes) for what in ("sites", "triangles")])
        refused += [f"- {number}, {kernel}: {verdict(found)}"
                    for kernel, found in zip(kernels, outcomes) if verdict(found)]
    return ("The square at 20 degrees with the command's own strategy, in the metric named. Each kernel meshes with its own"
            " answers; the auditor, exact and sharing no code with the mesher, judges the meshes.\n\n"
            + with_doubles(runs) + "\n\n" + names
            + "\n\nMedian times; in brackets, over that of the filtered kernel. Sites and triangles with the double, the"
            " filtered and the exact kernel:\n\n"
            + table(["job"] + list(kernels) + ["sites", "triangles"], rows)
            + "\nThe auditor certifies all but these:\n\n" + "\n".join(refused or ["- none"]) + "\n")


def middle(times):
    return sorted(times)[len(times) // 2]


def verdict(found):
    """Returns why a run's mesh is not certified, or "" if it is."""
    told = "" if found["complete"] else f"not complete ({found['reason']})"
    if not found.get("certified"):
        findings = ", ".join(f"{n} {kind}" for kind, n in found.get("findings", {}).items())
        told += f"{'; ' if told else ''}refused: {findings}"
    return told
