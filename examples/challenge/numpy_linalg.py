#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""numpy: determinants by numpy.linalg.det, definiteness by eigenvalues, all records of one kind at
once."""
import sys

import numpy


def number(word):
    return float.fromhex(word) if "x" in word.lower() else float(word)


def signs(values):
    return numpy.sign(numpy.nan_to_num(values, nan=0.0)).astype(int)


def orient2d(n):
    p = n.reshape(-1, 3, 2)
    return signs(numpy.linalg.det(numpy.concatenate([p, numpy.ones((len(p), 3, 1))], axis=2)))


def in_metric(m, p):
    """Returns the determinant of the rows x, y, squared length, 1 of four points."""
    x, y = p[..., 0], p[..., 1]
    lifted = m[:, 0, None] * x * x + 2 * m[:, 1, None] * x * y + m[:, 2, None] * y * y
    return signs(numpy.linalg.det(numpy.stack([x, y, lifted, numpy.ones_like(x)], axis=2)))


def incircle(n):
    return in_metric(numpy.tile([1.0, 0.0, 1.0], (len(n), 1)), n.reshape(-1, 4, 2))


def in_circle(n):
    return in_metric(n[:, :3], n[:, 3:].reshape(-1, 4, 2))


def is_spd(n):
    tensors = n[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    return (numpy.linalg.eigvalsh(tensors)[:, 0] > 0).astype(int)


def compare_distance(n):
    def squared(site):
        d = n[:, 10:12] - site[:, :2]
        tensors = site[:, [2, 3, 3, 4]].reshape(-1, 2, 2)
        return numpy.einsum("ni,nij,nj->n", d, tensors, d)
    return signs(squared(n[:, :5]) - squared(n[:, 5:10]))


KNOWN = {"orient2d": orient2d, "orientation": orient2d, "incircle": incircle,
         "in_circle": in_circle, "is_spd": is_spd, "compare_distance": compare_distance}


def main():
    lines = [line.split() for line in sys.stdin]
    records = [line for line in lines if line and not line[0].startswith("#")]
    answers = ["error: not known"] * len(records)
    numpy.seterr(all="ignore")
    for name in sorted({r[0] for r in records} & set(KNOWN)):
        places = [i for i, r in enumerate(records) if r[0] == name]
        numbers = numpy.array([[number(w) for w in records[i][1:]] for i in places])
        for i, answer in zip(places, KNOWN[name](numbers)):
            answers[i] = str(answer)
    print("".join(a + "\n" for a in answers), end="")


if __name__ == "__main__":
    main()
