# SPDX-License-Identifier: MIT
"""The public face, as installed and moved elsewhere: the headers installed are those of
cmake/public_headers.txt; each compiles alone, and the README's program compiles, reaching no header
but these and the standard library's; they name nothing outside namespace asterism and nothing of
asterism::internal; what links the library is told of no other library's headers.

  check_public_headers.py PROJECT BUILD WORK COMPILER [C_COMPILER]
"""
import pathlib
import re
import shutil
import subprocess
import sys

import sources
import standard_headers

WARNINGS = ["-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror"]


def install_and_move(build, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    command = ["cmake", "--install", str(build), "--prefix", str(work / "first")]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    (work / "first").rename(work / "prefix")
    return work / "prefix"


def place_problems(prefix):
    """Reports files outside of the usual folders of a prefix, which other programs share."""
    usual = {"bin", "include", "lib", "share"}
    yield from (f"{p.name} is installed beside the folders of the prefix"
                for p in sorted(prefix.iterdir()) if p.name not in usual)


def list_problems(include, listed):
    installed = {p.relative_to(include).as_posix() for p in include.rglob("*") if p.is_file()}
    wanted = {f"asterism/{name}" for name in listed}
    yield from (f"{name} is installed and not public" for name in sorted(installed - wanted))
    yield from (f"{name} is public and not installed" for name in sorted(wanted - installed))


def reach_problems(name, text, include, compiler, allowed):
    """Compiles `text` and looks at every file the compiler opened for it."""
    ending = ".c" if compiler.is_c else ".cpp"
    unit = include.parent / ("unit" + ending)
    unit.write_text(text, encoding="utf-8")
    found = compiler.dependencies(unit, ["-I", str(include), *WARNINGS])
    if isinstance(found, str):
        yield f"{name} does not compile:\n{found}"
        return
    for path in sorted(found - allowed - {unit.resolve()}):
        if not path.is_relative_to(include.resolve()):
            yield f"{name} reaches {path}"


def without_comments(text):
    pattern = r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*")'
    return re.sub(pattern, lambda m: '""' if m.group(1) else " ", text, flags=re.DOTALL)


def outside_namespace(code):
    """Returns the code that stands outside of `namespace asterism {...}`."""
    outside, depth, kept_from = [], 0, 0
    for mark in re.finditer(r"namespace asterism(?:::\w+)*\s*\{|[{}]", code):
        if mark.group() == "}":
            depth -= depth > 0
            if depth == 0:
                kept_from = mark.end()
        elif depth > 0:
            depth += 1
        elif mark.group() != "{":
            outside.append(code[kept_from:mark.start()])
            depth = 1
    outside.append(code[kept_from:])
    return "".join(outside)


def name_problems(include, name):
    code = without_comments((include / "asterism" / name).read_text(encoding="utf-8"))
    for macro in re.findall(r"^\s*#\s*define\s+(\w+)", code, flags=re.MULTILINE):
        if not macro.startswith("ASTERISM_"):
            yield f"{name}: defines {macro}"
    if re.search(r"\binternal\s*::|::\s*internal\b|namespace\s+internal\b", code):
        yield f"{name}: names asterism::internal"
    code = re.sub(r"^\s*#.*(?:\\\n.*)*", "", code, flags=re.MULTILINE)
    if name.endswith(".h"):
        names = re.findall(r"\b(\w+)\s*\((?!\*)", code) + re.findall(r"\benum\s+(\w+)", code)
        yield from (f"{name}: {n} is not asterism_..." for n in names if not n.startswith("asterism_"))
    elif outside_namespace(code).strip():
        yield f"{name}: outside namespace asterism: {outside_namespace(code).strip()[:60]!r}"


def target_problems(prefix):
    """Reports exported targets that hand on definitions, or libraries for more than linking."""
    files = list(prefix.rglob("Asterism*.cmake"))
    if not files:
        yield "no exported targets"
    for path in files:
        text = path.read_text(encoding="utf-8")
        for libraries in re.findall(r'INTERFACE_LINK_LIBRARIES "([^"]*)"', text):
            for library in libraries.split(";"):
                if not re.match(r"\\\$<LINK_ONLY:|Asterism::", library):
                    yield f"{path.name}: whoever links gets {library}"
        for folder in re.findall(r'INTERFACE_INCLUDE_DIRECTORIES "([^"]*)"', text):
            if folder != "${_IMPORT_PREFIX}/include":
                yield f"{path.name}: whoever links includes from {folder}"
        if "INTERFACE_COMPILE_DEFINITIONS" in text:
            yield f"{path.name}: whoever links gets definitions"


def readme_program(top):
    text = (top / "README.md").read_text(encoding="utf-8")
    return re.search(r"```cpp\n([^`]*int main\(\)[^`]*)```", text).group(1)


def main():
    top, (build, work, cxx) = sources.root(), sys.argv[2:5]
    prefix = install_and_move(build, pathlib.Path(work))
    problems = list(place_problems(prefix))  # before anything is compiled there
    include = prefix / "include"
    listed = sources.public_headers(top)
    compiler = standard_headers.Compiler(cxx)
    allowed = compiler.standard_library(prefix)
    problems += [*list_problems(include, listed), *target_problems(prefix)]
    for name in listed:
        line = f"#include <asterism/{name}>\n"
        problems += reach_problems(name, line + line, include, compiler, allowed)
        problems += name_problems(include, name)
    problems += reach_problems("README.md", readme_program(top), include, compiler, allowed)
    if len(sys.argv) > 5:
        c = standard_headers.Compiler(sys.argv[5], is_c=True)
        for name in (name for name in listed if name.endswith(".h")):
            line = f"#include <asterism/{name}>\n"
            problems += reach_problems(f"{name} in C", line + line, include, c,
                                       c.standard_library(prefix))
    sources.finish(problems, len(listed))


if __name__ == "__main__":
    main()
