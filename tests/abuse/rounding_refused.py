# SPDX-License-Identifier: MIT
"""A target that cannot round upward gets no library whose intervals believe that it can. Compiled for
WebAssembly, and for a target whose <cfenv> has no FE_UPWARD, headers with intervals in them refuse
directed rounding with a message, and are accepted without it.
    rounding_refused.py INCLUDE_DIRECTORY WORK --emscripten PROGRAM COMPILER...
PROGRAM may be empty: it is said that Emscripten was not asked."""
import pathlib
import subprocess
import sys

FEATURE = "core/directed_rounding.hpp"
INTERVALS = ["core/interval.hpp", "core/two_lanes.hpp", "core/rounded_interval.hpp"]
CHECK = "static_assert(ASTERISM_DIRECTED_ROUNDING == 0);\n"
DIRECTED, TO_NEAREST = "-DASTERISM_DIRECTED_ROUNDING=1", "-DASTERISM_DIRECTED_ROUNDING=0"
MESSAGE = "cannot round upward"


def compiled(compiler, include, header, *flags):
    command = [compiler, "-std=c++20", "-fsyntax-only", *flags, "-I", include, "-x", "c++", "-"]
    text = f'#include "asterism/{header}"\n{CHECK}'
    return subprocess.run(command, input=text, text=True, capture_output=True, check=False)


def attempts(compilers, emscripten, stub):
    """Yields compiler, flags, header and whether the header must be refused."""
    for compiler in compilers:
        unknown = ["-U__SSE2__", "-isystem", stub]
        yield compiler, unknown, FEATURE, True
        yield compiler, [*unknown, DIRECTED], FEATURE, True
        yield compiler, [*unknown, TO_NEAREST], FEATURE, False
        yield compiler, [TO_NEAREST], INTERVALS[0], False
        if "clang" in compiler:
            web = ["--target=wasm32"]
            yield compiler, web, FEATURE, False
            yield compiler, [*web, DIRECTED], FEATURE, True
            # Emscripten defines __SSE2__ with -msse2, though WebAssembly has the names of SSE2 alone.
            yield compiler, [*web, "-D__SSE2__", DIRECTED], FEATURE, True
            yield compiler, [*web, "-D__SSE2__"], FEATURE, False
    for header in INTERVALS if emscripten else []:
        yield emscripten, [], header, False
        yield emscripten, ["-msimd128", "-msse2"], header, False
        yield emscripten, [DIRECTED], header, True
        yield emscripten, ["-msimd128", "-msse2", DIRECTED], header, True


def main():
    include, work, _, emscripten, *compilers = sys.argv[1:]
    stub = pathlib.Path(work)
    stub.mkdir(parents=True, exist_ok=True)
    (stub / "cfenv").write_text("#pragma once\n", encoding="ascii")
    problems, tried = [], 0
    for compiler, flags, header, refused in attempts(compilers, emscripten, str(stub)):
        tried += 1
        done = compiled(compiler, include, header, *flags)
        if refused and (done.returncode == 0 or MESSAGE not in done.stderr):
            problems.append(f"{compiler} {' '.join(flags)}: {header} is not refused as it should be")
        elif not refused and done.returncode != 0:
            problems.append(f"{compiler} {' '.join(flags)}: {header}:\n{done.stderr}")
    if not emscripten:
        print("skipped: em++ is not installed; clang++ alone was asked for WebAssembly")
    print("\n".join(problems) or f"{tried} compilations, no problem")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
