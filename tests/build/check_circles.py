# SPDX-License-Identifier: MIT
"""No circle between modules, and no header that declares what another module defines. A module is a header
and the sources that define what it declares: those of its name, or of its name and an ending
(editable_mesh_build.cpp). The lists below name what is otherwise, with the reason: an entry that is not needed
any more must be taken out.

A C header is a module of its own. It includes nothing of C++, and several sources define what it
declares."""
import collections
import re

import sources

# Circles that are excepted: the modules of each, sorted.
CIRCLES = set()
# Headers that list functions of one kind, each defined in a source of its own. A file that includes one calls most of
# its functions.
CONTENTS = {
    "apps/base/commands.hpp": "the commands, which the program adds one after another",
    "mesh/audit/checks.hpp": "the checks, which the auditor goes through",
    "mesh/io/listed_readers.hpp": "the readers of meshes, of which the table of kinds of files has a row each",
}
# Headers that show the insides of a public module to the library alone, and that module. The installed header may not
# show them.
INSIDE = {
    "kernels/filtered_edge_test.hpp": "kernels/filtered_kernel",
    "mesh/io/medit_writer.hpp": "mesh/io/medit",
    "mesh/io/solution_output.hpp": "mesh/io/solution_file",
}

COMMENT = re.compile(r"//[^\n]*")
# Matches a declaration or definition that begins a line: clang-format does not indent those of a namespace.
HEADING = re.compile(r"^(?!static|inline|template|using|struct|class|enum|namespace|extern|return|constexpr|typedef)"
                     r"[A-Za-z_][^\n;{}()=]*?\b([A-Za-z_][\w:]*)\((?:[^;{}]|\{\})*?\)"
                     r"(?:\s*(?:const|noexcept))*\s*([;{])", re.MULTILINE)


def stem(name):
    return name.rsplit(".", 1)[0]


def module_of(name, headers):
    """Returns for a source the module of the header whose name is the longest beginning of the source's name."""
    if name.endswith(".h"):
        return name
    own = stem(name)
    if f"{own}.hpp" in INSIDE:
        return INSIDE[f"{own}.hpp"]
    if name.endswith(".hpp"):
        return own
    while own not in headers and "_" in own.rsplit("/", 1)[1]:
        own = own.rsplit("_", 1)[0]
    return own if own in headers else stem(name)


def graph_of(top, paths, headers):
    graph = collections.defaultdict(set)
    for path in paths:
        own = module_of(path.as_posix(), headers)
        graph[own] |= {module_of(name, headers) for name in sources.own_includes(top, path)} - {own}
    return graph


def circles_in(graph):
    """Returns the strongly connected components of more than one module, by Tarjan's algorithm without recursion."""
    found, number, lowest, stack, on_stack = [], {}, {}, [], set()
    for start in sorted(graph):
        if start in number:
            continue
        walk = [(start, None)]
        while walk:
            at, after = walk.pop()
            if after is None:
                number[at] = lowest[at] = len(number)
                stack.append(at)
                on_stack.add(at)
                after = iter(sorted(graph.get(at, ())))
            for to in after:
                if to not in number:
                    walk += [(at, after), (to, None)]
                    break
                if to in on_stack:
                    lowest[at] = min(lowest[at], number[to])
            else:
                if walk:
                    lowest[walk[-1][0]] = min(lowest[walk[-1][0]], lowest[at])
                if lowest[at] == number[at]:
                    part = set()
                    while at not in part:
                        part.add(stack.pop())
                    on_stack -= part
                    if len(part) > 1:
                        found.append(tuple(sorted(part)))
    return found


def headings(top, path, ending):
    text = COMMENT.sub("", (top / path).read_text(encoding="utf-8"))
    return {m.group(1).rsplit("::", 1)[-1] for m in HEADING.finditer(text) if m.group(2) == ending}


def foreign_headers(top, paths, headers):
    """Yields for each header the functions that it declares and that only sources of other modules define. Counts a
    source only if it includes the header, since other functions may have the same name."""
    definers = collections.defaultdict(set)
    for path in paths:
        if path.suffix == ".cpp":
            for name in headings(top, path, "{"):
                definers[name].add(path)
    for path in paths:
        if path.suffix != ".hpp":
            continue
        own = stem(path.as_posix())
        for name in sorted(headings(top, path, ";")):
            by = {p for p in definers[name] if path.as_posix() in set(sources.own_includes(top, p))
                  or p.parent == path.parent}
            if by and not any(module_of(p.as_posix(), headers) in (own, INSIDE.get(path.as_posix())) for p in by):
                yield path.as_posix(), name, sorted(p.as_posix() for p in by)


def main():
    top = sources.root()
    paths = sources.files(top, sources.FOLDERS, sources.CODE)
    headers = {stem(p.as_posix()) for p in paths if p.suffix == ".hpp"}
    found = set(circles_in(graph_of(top, paths, headers)))
    problems = [f"a circle of modules: {' '.join(circle)}" for circle in sorted(found - CIRCLES)]
    problems += [f"no circle any more, take it out of the list: {' '.join(circle)}"
                 for circle in sorted(CIRCLES - found)]
    foreign = list(foreign_headers(top, paths, headers))
    problems += [f"{header}: declares {name}, which {' and '.join(by)} defines"
                 for header, name, by in foreign if header not in CONTENTS]
    problems += [f"{header}: is no list of what other modules define, take it out"
                 for header in CONTENTS if header not in {found for found, _, _ in foreign}]
    problems += [f"{header}: does not exist, take it out"
                 for header in [*CONTENTS, *INSIDE] if not (top / header).is_file()]
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
