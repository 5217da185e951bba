# SPDX-License-Identifier: MIT
"""The predicates need GMP only: no source of core/ and kernels/ reaches a header but the project's
own, the standard library's and gmp.h.

  check_predicates_dependencies.py PROJECT BUILD WORK COMPILER
"""
import pathlib
import sys

import sources
import standard_headers


def problems_of(path, top, build, work, compiler, allowed):
    unit = work / "unit.cpp"
    unit.write_text(f'#include "{top / path}"\n', encoding="utf-8")
    found = compiler.dependencies(unit, ["-I", f"{build}/include", "-frounding-math"], compiles=False)
    if isinstance(found, str):
        yield f"{path} cannot be read:\n{found}"
        return
    for used in sorted(found - allowed - {unit.resolve()}):
        if not used.is_relative_to(top) and not used.name.startswith("gmp"):
            yield f"{path} reaches {used}"


def main():
    top, build, work = sources.root(), sys.argv[2], pathlib.Path(sys.argv[3])
    work.mkdir(parents=True, exist_ok=True)
    compiler = standard_headers.Compiler(sys.argv[4])
    allowed = compiler.standard_library(work)
    paths = sources.files(top, ["core", "kernels"], {".cpp"})
    problems = []
    for path in paths:
        problems += problems_of(path, top, build, work, compiler, allowed)
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
