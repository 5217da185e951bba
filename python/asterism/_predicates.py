# SPDX-License-Identifier: MIT
"""The predicates over arrays of any shape, evaluated in batches; Ctrl-C takes effect between two
batches.

An int for arguments of one row each, else int8, of the shape that the rows are broadcast to. With
counts=True returns a pair: the results, and the number of questions that each tier decided.
"""
from __future__ import annotations

import re
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._calls import told

# Questions in a batch, which takes a tenth of a second if half of them need exact numbers.
_BATCH = 16384


def _table(name: str, given: Any) -> Any:
    if isinstance(given, np.ndarray):
        return given
    try:
        return np.asarray(given)
    except ValueError:
        raise InputError(f"{name}: rows of numbers are wanted") from None


def _broadcast(tables: List[Any]) -> Tuple[List[Any], Tuple[int, ...]]:
    """Returns tables with a row for each question, and the shape of the answers. A table of one row stays as it
    is."""
    try:
        shape = np.broadcast_shapes(*[table.shape[:-1] for table in tables])
    except ValueError:
        shapes = ", ".join(str(table.shape) for table in tables)
        raise InputError(f"arguments whose shapes do not go together: {shapes}") from None
    rows = [table if table.ndim < 2 or table.size == table.shape[-1]
            else np.broadcast_to(table, (*shape, table.shape[-1])).reshape(-1, table.shape[-1])
            for table in tables]
    return [row.reshape(1, -1) if row.ndim > 2 else row for row in rows], shape


def _ask(function: Callable[..., Any], counts: bool, **given: Any) -> Any:
    tables = [_table(name, of) for name, of in given.items()]
    shape = None
    if max(table.ndim for table in tables) > 2:
        tables, shape = _broadcast(tables)
    rows = max(len(table) if table.ndim == 2 else 1 for table in tables)
    if rows <= _BATCH:
        answers, tiers = _asked(function, given, tables)
    else:
        answers, tiers = _in_batches(function, tables, rows)
    if shape is not None:
        answers = np.asarray(answers, dtype=np.int8).reshape(shape)
    return (answers, tiers) if counts else answers


def _asked(function: Callable[..., Any], given: Dict[str, Any], tables: List[Any]) -> Any:
    try:
        return function(*tables, counts=True)
    except InputError as refused:
        for name, table in zip(given, tables):
            wrong = _first_not_finite(table)
            if wrong is not None:
                raise InputError(f"{name}: {wrong} is infinite or not a number") from None
        raise refused


def _first_not_finite(table: Any) -> Optional[str]:
    if table.dtype.kind != "f" or np.isfinite(table).all():
        return None
    row = np.argwhere(~np.isfinite(table))[0]
    return f"row {row[0]}, {table[row[0]].tolist()}," if table.ndim == 2 else f"{table.tolist()}"


def _in_batches(function: Callable[..., Any], tables: List[Any], rows: int) -> Tuple[Any, Dict[str, int]]:
    for table in tables:
        if table.ndim == 2 and len(table) not in (1, rows):
            raise InputError(f"arguments of {rows} and {len(table)} rows")
    answers = np.empty(rows, dtype=np.int8)
    tiers: Dict[str, int] = {}
    for start in range(0, rows, _BATCH):
        part = slice(start, start + _BATCH)
        batch = [table[part] if table.ndim == 2 and len(table) > 1 else table for table in tables]
        try:
            answers[part], told = function(*batch, counts=True)
        except InputError as refused:
            raise InputError(re.sub(r"^row (\d+)", lambda at: f"row {int(at.group(1)) + start}",
                                    str(refused))) from None
        for tier, count in told.items():
            tiers[tier] = tiers.get(tier, 0) + count
    return answers, tiers


@told
def orientation(p: npt.ArrayLike, q: npt.ArrayLike, r: npt.ArrayLike, *, counts: bool = False) -> Any:
    """1 where p, q, r turn counter-clockwise, -1 clockwise, 0 on a line. Points (n, 2)."""
    return _ask(_asterism._orientation, counts, p=p, q=q, r=r)


@told
def is_positive_definite(metric: npt.ArrayLike, *, counts: bool = False) -> Any:
    """1 or 0 for each tensor, (n, 3) = m11 m12 m22."""
    return _ask(_asterism._is_positive_definite, counts, metric=metric)


@told
def in_circle(a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike, p: npt.ArrayLike,
              metric: npt.ArrayLike = (1, 0, 1), *, counts: bool = False) -> Any:
    """1 where p is inside the circle of the metric through a, b, c, -1 outside, 0 on it; signs are reversed where a,
    b, c are clockwise. Points (n, 2), tensors (n, 3)."""
    return _ask(_asterism._in_circle, counts, metric=metric, a=a, b=b, c=c, p=p)


@told
def compare_distance(v: npt.ArrayLike, w: npt.ArrayLike, q: npt.ArrayLike, *, counts: bool = False) -> Any:
    """-1 where q is nearer to v, 1 to w, each by its own metric; 0 on their bisector. Sites
    (n, 5) = x y m11 m12 m22."""
    return _ask(_asterism._compare_distance, counts, v=v, w=w, q=q)


@told
def in_wedge(v: npt.ArrayLike, w: npt.ArrayLike, q: npt.ArrayLike, *, counts: bool = False) -> Any:
    """1 where q is strictly inside the wedge of v and w."""
    return _ask(_asterism._in_wedge, counts, v=v, w=w, q=q)


@told
def dominates(v: npt.ArrayLike, w: npt.ArrayLike, p: npt.ArrayLike, *, counts: bool = False) -> Any:
    """1 where v dominates p over w, -1 where w does over v, 0 on the border."""
    return _ask(_asterism._dominates, counts, v=v, w=w, p=p)


@told
def voronoi_vertex_count(u: npt.ArrayLike, v: npt.ArrayLike, w: npt.ArrayLike, *, counts: bool = False) -> Any:
    """Number of points equally near to u, v and w, 0 to 4; -1: infinitely many."""
    return _ask(_asterism._voronoi_vertex_count, counts, u=u, v=v, w=w)


@told
def arc_intersection_count(v: npt.ArrayLike, w: npt.ArrayLike, x: npt.ArrayLike, *,
                           counts: bool = False) -> Any:
    """Number of points of the visible arc of v and w that are as near to x; -1: infinitely many."""
    return _ask(_asterism._arc_intersection_count, counts, v=v, w=w, x=x)


@told
def encroaches(a: npt.ArrayLike, b: npt.ArrayLike, w: npt.ArrayLike, *, counts: bool = False) -> Any:
    """1 where w is nearer than a and b somewhere inside the segment ab."""
    return _ask(_asterism._encroaches, counts, a=a, b=b, w=w)


@told
def insertion_test(v: npt.ArrayLike, w: npt.ArrayLike, x: npt.ArrayLike, y: npt.ArrayLike, *,
                   counts: bool = False) -> Any:
    """1 where w belongs between x and y in the star of v; touching is 0."""
    return _ask(_asterism._insertion_test, counts, v=v, w=w, x=x, y=y)


@told
def edge_test(v: npt.ArrayLike, w: npt.ArrayLike, x: npt.ArrayLike, y: npt.ArrayLike, *,
              counts: bool = False) -> Any:
    """insertion_test with ties broken alike in every star: the question of a mesh generator."""
    return _ask(_asterism._edge_test, counts, v=v, w=w, x=x, y=y)
