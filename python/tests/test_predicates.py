# SPDX-License-Identifier: MIT
"""Predicates over arrays: shapes, layouts, answers, refusals."""
import fractions

import numpy as np
import pytest

import asterism

RANDOM = np.random.default_rng(16)


def sites(count):
    """Positive definite by construction: L L^T."""
    a, b, c = RANDOM.uniform(0.5, 2, (3, count))
    return np.column_stack([RANDOM.uniform(-1, 1, (count, 2)), a * a, a * b, b * b + c * c])


def exact_turn(p, q, r):
    p, q, r = ([fractions.Fraction(float(x)) for x in of] for of in (p, q, r))
    value = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return (value > 0) - (value < 0)


def test_orientation_is_exact_where_doubles_are_not():
    i, j = (x.ravel() for x in np.mgrid[:32, :32])
    p = np.column_stack([0.5 + i * 2.0 ** -53, 0.5 + j * 2.0 ** -53])
    answers, tiers = asterism.orientation(p, [12, 12], [24, 24], counts=True)
    assert answers.dtype == np.int8 and answers.shape == (1024,)
    assert list(answers) == [exact_turn(row, (12, 12), (24, 24)) for row in p]
    assert sum(tiers.values()) == 1024 and tiers["exact"] > 0
    with_doubles = np.sign((12 - p[:, 0]) * (24 - p[:, 1]) - (12 - p[:, 1]) * (24 - p[:, 0]))
    assert (with_doubles != answers).any()


def test_single_rows_give_an_int_and_stand_for_all():
    assert asterism.orientation((0, 0), (1, 0), (0, 1)) == 1
    assert isinstance(asterism.orientation((0, 0), (1, 0), (0, 1)), int)
    assert list(asterism.in_circle((0, 0), (1, 0), (0, 1), [(1, 1), (0.5, 0.5), (2, 2)])) == [0, 1, -1]
    assert asterism.in_circle((0, 0), (1, 0), (0, 1), (1, 1), metric=(2, 1, 1)) == -1


@pytest.mark.parametrize("layout", [np.ascontiguousarray, np.asfortranarray,
                                    lambda s: np.repeat(s, 2, axis=0)[::2],
                                    lambda s: s[::-1][::-1], lambda s: s.tolist(),
                                    lambda s: s.astype(">f8")])
def test_every_layout_of_an_array_gives_the_same_answers(layout):
    v, w, x, y = (sites(64) for _ in range(4))
    wanted = asterism.edge_test(v, w, x, y)
    assert set(wanted) <= {0, 1}
    assert (asterism.edge_test(layout(v), layout(w), layout(x), layout(y)) == wanted).all()
    points = asterism.compare_distance(v, w, x[:, :2])
    assert (asterism.compare_distance(v, w, np.array(x[:, :2])) == points).all()


def test_a_table_of_one_row_stands_for_all():
    p, q, r = np.zeros((3, 2)), [(1, 0)], [(0, 1), (0, -1), (2, 0)]
    assert asterism.orientation(p, q, r).tolist() == [1, -1, 0]
    assert asterism.orientation([(0, 0)], q, [(0, 1)]).tolist() == [1]
    assert asterism.orientation(np.zeros((0, 2)), q, np.zeros((0, 2))).shape == (0,)


def test_a_batch_is_its_rows():
    v, w, x, y = (sites(50) for _ in range(4))
    for ask, arguments in [(asterism.edge_test, (v, w, x, y)), (asterism.insertion_test, (v, w, x, y)),
                           (asterism.encroaches, (v, w, x)), (asterism.voronoi_vertex_count, (v, w, x)),
                           (asterism.arc_intersection_count, (v, w, x)),
                           (asterism.dominates, (v, w, x[:, :2])), (asterism.in_wedge, (v, w, x[:, :2])),
                           (asterism.is_positive_definite, (v[:, 2:],))]:
        answers = ask(*arguments)
        assert list(answers) == [ask(*(a[k] for a in arguments)) for k in range(50)], ask


def test_no_rows():
    empty = np.empty((0, 5))
    assert asterism.edge_test(empty, empty, empty, empty).shape == (0,)


def test_refusals_name_the_row_and_the_argument():
    v, w, x, y = (sites(9) for _ in range(4))
    w[7, 3] = 50
    with pytest.raises(asterism.InputError, match="row 7: the metric of a site is not positive"):
        asterism.edge_test(v, w, x, y)
    with pytest.raises(ValueError, match=r"q: the shape \(n, 2\)"):
        asterism.orientation((0, 0), (1, 0, 0), (1, 1))
    with pytest.raises(asterism.InputError, match="9 and 8 rows"):
        asterism.encroaches(v, x[:8], y)
    with pytest.raises(asterism.InputError, match="not a number"):
        asterism.orientation((0, 0), (np.nan, 0), (1, 1))
    with pytest.raises(asterism.InputError, match="p: an array of numbers"):
        asterism.orientation("abc", (0, 0), (1, 1))


def test_an_interrupt_is_heard_between_batches(monkeypatch):
    import os
    import signal

    module, asked = asterism._predicates._asterism, []
    real = module._orientation

    def ask(*tables, counts):
        asked.append(len(tables[0]))
        os.kill(os.getpid(), signal.SIGINT)
        return real(*tables, counts=counts)

    monkeypatch.setattr(module, "_orientation", ask)
    with pytest.raises(KeyboardInterrupt):
        asterism.orientation(np.zeros((200000, 2)), (1, 0), (0, 1))
    assert len(asked) == 1 and asked[0] < 100000
