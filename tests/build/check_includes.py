# SPDX-License-Identifier: MIT
"""Checks that each file includes what it names: of the standard library, and what one header of the project declares
alone. It may reach a header by others of the project. A united build hides one that is left out, since a file before has
read it; a build that is not united shows it, and takes three times as long.

    check_includes.py [SOURCE]

It reads words, not C++. So it does not see what has no std:: before it, operators, members, what several headers declare,
names of one word, and one that the file or a header of its declares as something else.
"""
from __future__ import annotations

import collections
import functools
import os
import pathlib
import re

import sources

TOP = sources.root()
FOLDERS = [*sources.FOLDERS, "python/src", "tests"]

# The headers of the standard library whose names are looked for. A name in several is found in any of them. Not here:
# move and forward, which every container's header has brought with every library so far. CLI11's functions take
# std::function, so its header counts too.
STANDARD = {
    "CLI/CLI.hpp": "function",
    "algorithm": """all_of any_of none_of copy_if count count_if find find_if find_if_not for_each is_sorted lower_bound
        upper_bound equal equal_range max_element min_element minmax_element nth_element partition remove_if replace reverse
        rotate set_difference set_union set_intersection sort stable_sort transform unique binary_search adjacent_find fill
        fill_n generate clamp stable_partition is_permutation next_permutation partial_sort make_heap push_heap pop_heap""",
    "array": "array to_array", "atomic": "atomic atomic_bool atomic_flag",
    "bit": "bit_cast countl_zero countr_zero popcount bit_width has_single_bit",
    "cfenv": "fegetround fesetround feclearexcept fetestexcept", "charconv": "from_chars to_chars chars_format errc",
    "cmath": """sqrt cbrt fma isfinite isnan isinf ldexp frexp nextafter copysign signbit lround llround floor ceil trunc fmod
        ilogb""",
    "condition_variable": "condition_variable", "csignal": "signal raise sig_atomic_t",
    "cstdio": "fopen fclose fread fwrite printf fprintf snprintf fflush",
    "cstdlib": "getenv strtod strtol strtoll strtoul abort", "cstring": "memcpy memcmp memset strlen strcmp strerror",
    "deque": "deque", "exception": "exception current_exception rethrow_exception exception_ptr",
    "filesystem": "filesystem error_code", "fstream": "ifstream ofstream",
    "functional": "function hash less greater invoke reference_wrapper", "iostream": "cout cerr cin clog",
    "iterator": "back_inserter istreambuf_iterator istream_iterator ostream_iterator inserter", "limits": "numeric_limits",
    "list": "list", "map": "map multimap pair",
    "memory": "unique_ptr shared_ptr make_unique make_shared weak_ptr addressof",
    "mutex": "mutex lock_guard scoped_lock unique_lock once_flag call_once", "new": "bad_alloc nothrow align_val_t",
    "numbers": "numbers", "numeric": "accumulate iota inner_product partial_sum gcd lcm exclusive_scan midpoint",
    "optional": "optional nullopt make_optional", "queue": "queue priority_queue", "random": "mt19937 mt19937_64",
    "regex": "regex smatch", "set": "set multiset", "span": "span as_bytes",
    "sstream": "ostringstream istringstream stringstream",
    "stdexcept": "runtime_error logic_error invalid_argument out_of_range length_error",
    "string": "string to_string stod stoi getline string_view", "string_view": "string_view",
    "system_error": "error_code errc system_error", "thread": "thread this_thread",
    "tuple": "tuple tie make_tuple forward_as_tuple apply",
    "type_traits": "is_same_v enable_if_t decay_t conditional_t remove_cvref_t is_same",
    "unordered_map": "unordered_map pair", "unordered_set": "unordered_set",
    "utility": "pair swap exchange make_pair index_sequence",
    "variant": "variant visit get_if holds_alternative monostate", "vector": "vector",
}

_NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"', re.DOTALL)
_TYPE = re.compile(r"^(?:struct|class|enum class)(?: ASTERISM_EXPORT)? (\w+)[^;{()]*\{", re.MULTILINE)
_FUNCTION = re.compile(r"^(?!using|return|struct|class|enum|namespace|template|#)[\w:\[\]]+[\w:<>,&*\[\] ]*? [&*]*(\w+)"
                       r"\([^{}]*?\)[^;{}()]*[;{]", re.MULTILINE)
# A word after a type: a product or a comparison has a space before its sign.
_DECLARED = re.compile(r"(?:\w|[\w>][&*]+|(?<! )>|\])(?<!\breturn)(?<!\belse)(?<!\bthrow)(?<!\bcase) (\w+)(?=\s*[(=,;:){\[])")


@functools.cache
def code(path: pathlib.Path) -> str:
    """The file without its comments and without what its strings say."""
    return _NO_CODE.sub(lambda found: " " if found[0][0] == "/" else '""', (TOP / path).read_text(encoding="utf-8"))


@functools.cache
def own_includes(path: pathlib.Path) -> list[pathlib.Path]:
    """Returns the project's files that a file includes, those that tests include from their own folders among them."""
    named = [pathlib.Path(os.path.normpath(name)) for name in sources.own_includes(TOP, path)]
    of_tests = [pathlib.Path(folder) / name for folder in ("tests/mesh", "bench/angle_theorem")
                for name in sources.includes(TOP / path)]
    return named + [name for name in of_tests if (TOP / name).is_file()]


@functools.cache
def reached(path: pathlib.Path) -> frozenset[pathlib.Path]:
    """The file and all of the project's own that it includes, by others too."""
    found, left = {path}, [path]
    while left:
        new = [name for name in own_includes(left.pop()) if name not in found]
        found.update(new)
        left += new
    return frozenset(found)


def standard_problems(path: pathlib.Path, homes: dict[str, set[str]]) -> list[str]:
    included = {name for file in reached(path) for name in sources.includes(TOP / file)}
    used = sorted(set(re.findall(r"\bstd::(\w+)", code(path))))
    return [f"{path}: std::{name} without <{'> or <'.join(sorted(homes[name]))}>"
            for name in used if name in homes and not homes[name] & included]


def layer(path: pathlib.Path) -> int:
    """Returns the number of the file's layer, 0 at the bottom. Tests, in no layer, may include every layer."""
    folder = path.parent.as_posix()
    return sources.LAYERS.index(folder) if folder in sources.LAYERS else len(sources.LAYERS)


def own_homes(headers: list[pathlib.Path]) -> dict[str, pathlib.Path]:
    """Types and functions that one header declares alone, at the start of a line. Names of several words: one word alone
    is easily a name of something else as well."""
    homes: dict[str, set[pathlib.Path]] = collections.defaultdict(set)
    for path in headers:
        for name in {*_TYPE.findall(code(path)), *_FUNCTION.findall(code(path))}:
            homes[name].add(path)
    homes = {name: paths for name, paths in homes.items() if "_" in name}
    return {name: next(iter(paths)) for name, paths in homes.items() if len(paths) == 1}


@functools.cache
def declared(path: pathlib.Path) -> frozenset[str]:
    """Words that the file declares as anything: types within others, variables, functions, parameters, enumerators."""
    text = code(path)
    return frozenset(re.findall(r"\b(?:struct|class|enum class|using|auto|typename) [&*]*(\w+)", text) + _DECLARED.findall(text)
                     + re.findall(r"(?:#define \w+\(|[\[,] ?&?)(\w+)(?= ?[=)])", text))


def own_problems(path: pathlib.Path, homes: dict[str, pathlib.Path]) -> list[str]:
    known = frozenset().union(*(declared(file) for file in reached(path)))
    used = set(re.findall(r"(?<![.>:\w])([a-z]\w+)(?=\(|::|\{| &?\w+[;,)({=]|[&*>])", code(path))) - known
    missing = [name for name in sorted(used) if name in homes and homes[name] not in reached(path)]
    return [f'{path}: {name} without "asterism/{homes[name]}"' for name in missing if layer(homes[name]) <= layer(path)]


def main() -> None:
    of_standard = collections.defaultdict(set)
    for header, names in STANDARD.items():
        for name in names.split():
            of_standard[name].add(header)
    files = sources.files(TOP, FOLDERS, {".hpp", ".cpp"})
    of_project = own_homes([path for path in files if path.suffix == ".hpp" and path.parts[0] in sources.FOLDERS])
    wrong = [problem for path in files for problem in standard_problems(path, of_standard) + own_problems(path, of_project)]
    sources.finish(wrong, len(files))


if __name__ == "__main__":
    main()
