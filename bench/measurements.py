# SPDX-License-Identifier: MIT
"""Times of interleaved repetitions: medians, quartiles, and their ratios."""
import collections
import statistics


class Sample:
    """Nanoseconds per question, a number for each repetition."""

    def __init__(self, times):
        self.times = sorted(times)
        self.median = statistics.median(self.times)

    def quartiles(self):
        if len(self.times) < 4:
            return self.times[0], self.times[-1]
        low, _, high = statistics.quantiles(self.times, n=4)
        return low, high


class Ratio:
    """Returns the ratio of medians. Its range is from lower over upper to upper over lower quartile: wide when either
    measurement was disturbed."""

    def __init__(self, above, below):
        self.value = above.median / below.median
        (low, high), (base_low, base_high) = above.quartiles(), below.quartiles()
        self.low, self.high = low / base_high, high / base_low

    def text(self):
        return f"**{short(self.value)}x** ({short(self.low)}-{short(self.high)})"


def short(x):
    """Returns three significant digits, or two of small numbers, without exponent."""
    if x >= 100:
        return f"{x:.0f}"
    if x >= 0.1:
        return f"{x:.1f}" if x >= 10 else f"{x:.2f}"
    return f"{x:.4f}"


def duration(nanoseconds):
    for unit, size in (("ms", 1e6), ("us", 1e3)):
        if nanoseconds >= size:
            return f"{short(nanoseconds / size)} {unit}"
    return f"{short(nanoseconds)} ns"


def measurements(report):
    """Returns {predicate: {input: {contender: Sample}}}, in the order of registration."""
    times = collections.defaultdict(list)
    family = {}
    for entry in report["benchmarks"]:
        if entry["run_type"] == "iteration":
            times[entry["run_name"]].append(1e9 / entry["items_per_second"])
            family[entry["run_name"]] = entry["family_index"]
    result = {}
    for name in sorted(times, key=family.get):
        predicate, given, contender = name.split("/")
        result.setdefault(predicate, {}).setdefault(given, {})[contender] = Sample(times[name])
    return result
