# SPDX-License-Identifier: MIT
"""Without directed rounding the corpus is answered as it should be, and each tier settles what it settles
with directed rounding: bounds that are moved outward by arithmetic are the same bounds.
    rounding_corpus.py ANSWERS_TO_NEAREST ASTERISM SOURCE"""
import lzma
import pathlib
import subprocess
import sys
import tempfile


def main():
    to_nearest, asterism, source = sys.argv[1:]
    text = lzma.decompress((pathlib.Path(source) / "examples/challenge/corpus.txt.xz").read_bytes())
    expected = [line[3:] for line in text.decode().splitlines() if line.startswith("#= ")]
    with tempfile.NamedTemporaryFile(suffix=".txt") as corpus:
        corpus.write(text)
        corpus.flush()
        found, directed = (subprocess.run([*command, corpus.name], capture_output=True, text=True, check=True)
                           for command in ([to_nearest], [asterism, "eval", "--stats"]))
    answers = found.stdout.splitlines()
    wrong = sum(a != b for a, b in zip(answers, expected))
    print(f"{len(answers)} answers, {wrong} wrong\n{found.stderr}")
    if len(answers) != len(expected) or wrong:
        sys.exit("the corpus is not answered alike")
    if found.stderr != directed.stderr:
        sys.exit(f"the tiers settle other questions than with directed rounding:\n{directed.stderr}")


if __name__ == "__main__":
    main()
