# SPDX-License-Identifier: MIT
"""Sizes at places, as mesh() takes them and as the certificate words them."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

Places = Iterable[Sequence[float]]
Sizes = Mapping[int, Union[float, Sequence[float]]]


def _numbers(values: Any) -> str:
    return ",".join(repr(float(x)) for x in np.atleast_1d(values))


def words_of(at: Places, boxes: Places, regions: Optional[Sizes], near: Optional[Sizes], layers: Optional[Sizes],
             bounds: Mapping[str, Optional[float]]) -> str:
    """The sizes in one text, "none" for none."""
    words = [f"at {_numbers(one[:3])}:{_numbers(one[3:])}" for one in at]
    words += [f"box {_numbers(one[:4])}:{_numbers(one[4:])}" for one in boxes]
    for kind, sizes in (("in", regions), ("near", near), ("layers", layers)):
        words += [f"{kind} {int(number)}:{_numbers(values)}" for number, values in (sizes or {}).items()]
    words += [f"{name} {_numbers(bound)}" for name, bound in bounds.items() if bound is not None]
    return "; ".join(words) or "none"
