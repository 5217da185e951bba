# SPDX-License-Identifier: MIT
"""Puts the records of a file to two kernels through `asterism eval` and prints where they differ.
    compare_kernels.py ASTERISM RECORDS KERNEL REFERENCE [EXPECTED]
Exit status 0 when the number of different answers is EXPECTED (a number, or "some"; default 0)."""
import pathlib
import subprocess
import sys


def answers(command, kernel, records):
    done = subprocess.run([command, "eval", "--kernel", kernel], input="\n".join(records) + "\n",
                          text=True, capture_output=True, check=False)
    lines = done.stdout.splitlines()
    if done.returncode != 0 or len(lines) != len(records):
        sys.exit(f"{command} eval --kernel {kernel}: exit status {done.returncode}, "
                 f"{len(lines)} answers to {len(records)} records\n{done.stderr}")
    return lines


def main():
    command, path, kernel, reference, *rest = sys.argv[1:]
    expected = rest[0] if rest else "0"
    text = pathlib.Path(path).read_text(encoding="utf-8")
    records = [line for line in text.splitlines() if line.strip() and line.strip()[0] != "#"]
    asked = zip(records, answers(command, kernel, records), answers(command, reference, records))
    # "?" is the interval kernel's "undecided" and counts as no difference.
    different = [(r, a, b) for r, a, b in asked if a != b and "?" not in (a, b)]
    for record, answer, right in different:
        print(f"{kernel} {answer}, {reference} {right}: {record}")
    print(f"{len(different)} of {len(records)} answers differ")
    ok = len(different) > 0 if expected == "some" else len(different) == int(expected)
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
