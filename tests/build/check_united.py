# SPDX-License-Identifier: MIT
"""Files of a folder can be compiled as one, and those of folders that asterism_unite joins (also asterism_join): what
two of them define without linkage has different names, or different parameters. The first and the second command build so, the developers'
presets do not.

    check_united.py [SOURCE]
"""
from __future__ import annotations

import collections
import pathlib
import re

import sources

_TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)[^;{]*\{", re.MULTILINE)
_ALIAS = re.compile(r"^using (\w+) = ([^;]*);", re.MULTILINE)
_USING = re.compile(r"^using ([\w:]+::(\w+));", re.MULTILINE)
_CONSTANT = re.compile(r"^(?:static |inline )*const(?:expr)? [^;={}()]*?(\w+)(?:\[[^\]]*\])? ?(?:=|\{)", re.MULTILINE)
_FUNCTION = re.compile(r"^(?!using|return|struct|class|enum|namespace|#)[\w:][\w:<>,&*\[\]() ]*?(?<![\w:])(\w+)"
                       r"\(([^;{}]*)\)[\w ]* \{", re.MULTILINE)
_HIDDEN = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
_AROUND = re.compile(r"^namespace ([\w:]+) \{$", re.MULTILINE)
_ALONE = re.compile(r"asterism_unite\([^)]*?\bALONE ([^)]*?)(?:TOGETHER[^)]*)?\)")
_TOGETHER = re.compile(r"asterism_unite\([^)]*?\bTOGETHER ([^)]*)\)")


def parameter_types(text: str) -> tuple[str, ...]:
    """Returns the types of parameters. Names and default values do not distinguish functions."""
    commas = re.compile(r",(?![^<>]*>)")  # commas between parameters, but not those of templates
    return tuple(re.sub(r"(?<=[\w&*>]) *\b\w+$", "", re.sub(r"\s*=.*", "", " ".join(one.split())))
                 for one in commas.split(re.sub(r"/\*.*?\*/", "", text)) if one.strip())


def hidden_things(text: str) -> set[tuple[str, str, str]]:
    """Returns what unnamed namespaces define at their top level: the enclosing namespace, the name, and its kind."""
    found: set[tuple[str, str, str]] = set()
    for block in _HIDDEN.finditer(text):
        part, around = block[1], ["", *_AROUND.findall(text[:block.start()])][-1]
        found |= {(around, name, "one") for name in _TYPE.findall(part) + _CONSTANT.findall(part)}
        found |= {(around, name, "alias of " + of) for name, of in _ALIAS.findall(part)}
        found |= {(around, name, "alias of " + of) for of, name in _USING.findall(part)}
        found |= {(around, name, f"of {parameter_types(inside)}") for name, inside in _FUNCTION.findall(part)}
    return found


def can_meet(kinds: list[str]) -> bool:
    """True for overloads, and for an alias that is declared twice alike."""
    all_functions = all(kind.startswith("of ") for kind in kinds)
    one_alias = kinds[0].startswith("alias ") and len(set(kinds)) == 1
    return one_alias or (all_functions and len(set(kinds)) == len(kinds))


def clashes(files: list[pathlib.Path]) -> list[str]:
    things = collections.defaultdict(list)
    for file in files:
        for around, name, kind in sorted(hidden_things(file.read_text())):
            things[around, name].append((kind, file.name))
    return [f"{files[0].parent}: {name} is defined in {' and '.join(sorted({file for _, file in found}))}"
            for (_, name), found in sorted(things.items())
            if len({file for _, file in found}) > 1 and not can_meet([kind for kind, _ in found])]


def clashes_with_headers(source: pathlib.Path, files: list[pathlib.Path]) -> list[str]:
    """Reports a hidden type named as one of a header that another file of the same unit includes: a use is ambiguous."""
    hidden = {(around, name): file for file in files for around, name, kind in hidden_things(file.read_text())
              if kind == "one"}
    included = {header for file in files for header in sources.own_includes(source, file.relative_to(source))}
    found = []
    for header in sorted(included):
        text = (source / header).read_text()
        for one in _TYPE.finditer(text):
            around = ["", *_AROUND.findall(text[:one.start()])][-1]
            if (around, one[1]) in hidden:
                found.append(f"{hidden[around, one[1]]}: {one[1]} is a type of {header}, too")
    return found


def lists_of(folder: pathlib.Path) -> str:
    lists = [folder / "CMakeLists.txt", folder.parent / "CMakeLists.txt"]
    return "\n".join(file.read_text() for file in lists if file.exists())


def united_files(folder: pathlib.Path) -> list[pathlib.Path]:
    """Returns the files of a folder that are compiled together with others."""
    alone = {pathlib.PurePath(name).name for names in _ALONE.findall(lists_of(folder)) for name in names.split()}
    return [file for file in sorted(folder.glob("*.cpp")) if file.name not in alone]


def joined_folders(source: pathlib.Path) -> list[list[pathlib.Path]]:
    """Returns the folders that TOGETHER joins, each of which must exist."""
    return [[file.parent / name for name in word.split("+")]
            for file in sorted(source.glob("*/CMakeLists.txt"))
            for words in _TOGETHER.findall(file.read_text()) for word in words.split()]


def types_of_headers(source: pathlib.Path) -> list[str]:
    """Reports a type that two headers define differently under one name. No linker tells: template functions over it
    have one name too, and the linker keeps one of them."""
    homes = collections.defaultdict(set)
    for top in ("core", "predicates", "kernels", "challenge", "mesh", "apps", "python/src"):
        for file in (source / top).rglob("*.hpp"):
            text = file.read_text()
            for found in re.finditer(_TYPE.pattern, text, re.MULTILINE):
                around = ["", *_AROUND.findall(text[:found.start()])][-1]
                if found[1] != "ASTERISM_EXPORT":
                    homes[around, found[1]].add(str(file.relative_to(source)))
    return [f"{around}::{name} is defined in {' and '.join(sorted(files))}"
            for (around, name), files in sorted(homes.items()) if len(files) > 1]


def main() -> None:
    source, wrong, checked = sources.root(), [], 0
    joined = joined_folders(source)
    wrong += types_of_headers(source)
    wrong += [f"{folder}: asterism_unite joins it, and it is not there" for folders in joined for folder in folders
              if not any(folder.glob("*.cpp"))]
    alone = [[folder] for folder in sorted({file.parent for top in ("mesh", "apps", "challenge", "python/src")
                                            for file in (source / top).rglob("*.cpp")})]
    for folders in alone + joined:
        files = [file for folder in folders for file in united_files(folder)]
        found = clashes(files) + clashes_with_headers(source, files) if files else []
        wrong += [clash for clash in found if clash not in wrong]
        checked += len(files)
    if wrong:
        wrong.append("Give each a name of its own, or one home: these files are compiled as one.")
    sources.finish(wrong, checked)


if __name__ == "__main__":
    main()
