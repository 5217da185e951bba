# SPDX-License-Identifier: MIT
"""The predicates in one file, as scripts/single-file makes it, compile without a warning, answer the corpus rightly, and are
there for C.  single_file.py SOURCE WORK CXX"""
import lzma
import pathlib
import subprocess
import sys

C_PROGRAM = """#include <stdio.h>
#include "asterism_predicates.h"
int main(void) {
  const double a[2] = {0, 0}, b[2] = {1, 0}, c[2] = {0.125, 1};
  int answer = 0;
  const asterism_status status = asterism_orientation(a, b, c, &answer);
  printf("%d %d\\n", (int)status, answer);
  return status == ASTERISM_OK && answer == 1 ? 0 : 1;
}
"""


def main():
    source, work, cxx = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    work.mkdir(parents=True, exist_ok=True)

    def run(*words, **more):
        return subprocess.run([str(word) for word in words], cwd=work, check=True, timeout=1200, **more)

    run(sys.executable, source / "scripts/single-file", work)
    run(cxx, "-std=c++20", "-O2", "-Wall", "-Wextra", "-Werror", "-frounding-math", "-ffp-contract=off", "-c",
        "asterism_predicates.cpp")
    run(cxx, "-std=c++20", "-O2", f"-I{work}", source / "tests/examples/single_file_answers.cpp", "asterism_predicates.o",
        "-lgmp", "-o", "answers")
    text = lzma.decompress((source / "examples/challenge/corpus.txt.xz").read_bytes())
    expected = [line[3:] for line in text.decode().splitlines() if line.startswith("#= ")]
    answers = run("./answers", input=text, stdout=subprocess.PIPE).stdout.decode().splitlines()
    wrong = sum(a != b for a, b in zip(answers, expected))
    print(f"{len(answers)} answers of {len(expected)}, {wrong} wrong")
    if wrong or len(answers) != len(expected):
        sys.exit("the corpus is not answered rightly")
    (work / "program.c").write_text(C_PROGRAM, encoding="utf-8")
    run("cc", "-std=c90", "-pedantic", "-Wall", "-Werror", "-c", "program.c")
    run(cxx, "program.o", "asterism_predicates.o", "-lgmp", "-o", "program")
    run("./program")


if __name__ == "__main__":
    main()
