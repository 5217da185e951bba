# SPDX-License-Identifier: MIT
"""Sizes at places: the forms that mesh() takes, and their words in certificates."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from ._asterism import InputError
from ._forms import doubles

Places = Iterable[Sequence[float]]
_FORMS = {"size_at": "x, y, radius, h", "size_box": "x0, y0, x1, y1, h"}
Sizes = Mapping[int, Union[float, Sequence[float]]]


def _numbers(name: str, values: Any, least: int = 1) -> str:
    numbers = doubles(name, values).reshape(-1)
    if len(numbers) < least:
        raise InputError(f"{name}: {least} numbers or more are wanted, not {values!r}"
                         + (f"; a place is ({_FORMS[name]})" if name in _FORMS else ""))
    return ",".join(repr(float(x)) for x in numbers)


def _places(name: str, given: Places, width: int) -> Any:
    """Returns each place, and the size wanted there."""
    try:
        rows = [list(one) for one in given]
    except TypeError:
        raise InputError(f"{name}: a list of places is wanted, as [({_FORMS[name]})], not {given!r}") from None
    return [(_numbers(name, row[:width], width), _numbers(name, row[width:])) for row in rows]


def _items(name: str, given: Optional[Sizes]) -> Any:
    """Returns each number of a region or marker, and the size wanted there."""
    if not given:
        return []
    if not isinstance(given, Mapping) or not all(isinstance(number, (int, np.integer)) for number in given):
        raise InputError(f"{name}: sizes by the number of a region or marker are wanted, not {given!r}")
    return [(int(number), _numbers(name, values)) for number, values in given.items()]


def words_of(at: Places, boxes: Places, regions: Optional[Sizes], near: Optional[Sizes], layers: Optional[Sizes],
             bounds: Mapping[str, Optional[float]]) -> str:
    """Returns the sizes in one text; "none" if there are none."""
    words = [f"at {place}:{wanted}" for place, wanted in _places("size_at", at, 3)]
    words += [f"box {place}:{wanted}" for place, wanted in _places("size_box", boxes, 4)]
    for kind, name, sizes in (("in", "size_in", regions), ("near", "size_near", near), ("layers", "layers", layers)):
        words += [f"{kind} {number}:{wanted}" for number, wanted in _items(name, sizes)]
    words += [f"{name} {_numbers(name, bound)}" for name, bound in bounds.items() if bound is not None]
    return "; ".join(words) or "none"
