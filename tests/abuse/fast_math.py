# SPDX-License-Identifier: MIT
"""Under -ffast-math, headers that compute refuse to compile, with a message that says why, and
headers that only declare functions compile.
    fast_math.py PROJECT INCLUDE_DIRECTORY COMPILER..."""
import pathlib
import platform
import subprocess
import sys

REFUSING = ["core/floating_point_environment.hpp", "core/interval.hpp", "core/plane_algebra.hpp",
            "kernels/interval_arithmetic.hpp", "kernels/double_arithmetic.hpp",
            "kernels/arc_search.hpp", "kernels/semi_static_filter.hpp", "kernels/star_gap.hpp",
            "kernels/star_gap_formulas.hpp", "kernels/normal_frame.hpp"]
DECLARING = ["kernels/filtered_kernel.hpp", "kernels/exact_kernel.hpp",
             "kernels/interval_kernel.hpp", "kernels/double_kernel.hpp",
             "kernels/batch_protocol.hpp", "kernels/batch_question.hpp", "kernels/batch.hpp",
             "kernels/fixed_width.hpp", "kernels/replay.hpp",
             "kernels/checked_kernel.hpp", "kernels/c_api.h"]
FLAGS = {"-ffast-math": "cannot be compiled with -ffast-math",
         "-Ofast": "cannot be compiled with -ffast-math",
         "-ffinite-math-only": "cannot be compiled with -ffast-math"}
# Options that -ffast-math includes, and one that computes in registers longer than a double. Only g++ defines macros
# for these.
GXX_FLAGS = {"-funsafe-math-optimizations": "cannot be compiled with -ffast-math",
             "-freciprocal-math": "cannot be compiled with -ffast-math",
             "-mfpmath=387": "need doubles that are rounded to doubles"}


def compile_alone(compiler, include, header, flag):
    command = [compiler, "-std=c++20", "-fsyntax-only", "-Wfatal-errors", flag, "-I", include,
               "-x", "c++", "-"]
    return subprocess.run(command, input=f'#include "asterism/{header}"\n', text=True,
                          capture_output=True, check=False)


def main():
    project, include, *compilers = sys.argv[1:]
    folder = pathlib.Path(project) / "predicates"
    refusing = REFUSING + sorted(f"predicates/{path.name}" for path in folder.glob("*.hpp"))
    problems, tried = [], 0
    for compiler in compilers:
        gcc = "clang" not in compiler and platform.machine() == "x86_64"
        for flag, message in {**FLAGS, **(GXX_FLAGS if gcc else {})}.items():
            for header in refusing if flag == "-ffast-math" else refusing[:3]:
                tried += 1
                done = compile_alone(compiler, include, header, flag)
                if done.returncode == 0 or message not in done.stderr:
                    problems.append(f"{compiler} {flag}: {header} is not refused as it should be")
            for header in DECLARING if flag == "-ffast-math" else []:
                tried += 1
                done = compile_alone(compiler, include, header, flag)
                if done.returncode != 0:
                    problems.append(f"{compiler} {flag}: {header}:\n{done.stderr}")
    print("\n".join(problems) or f"{tried} compilations, no problem")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
