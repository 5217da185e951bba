# SPDX-License-Identifier: MIT
"""Arrays with a report of how they were made."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np


class ReportedArray(np.ndarray):  # type: ignore[type-arg]
    """An array with a `report` of how it was made; a copy has it, an array computed from it has not.

    Of a metric: complexities, the error predicted, the shares of the vertices at which bounds,
    gradation and intersections changed something. Of transferred values: integrals and extrema before
    and after, and the numbers of vertices and triangles outside.
    """

    report: Optional[Dict[str, Any]]

    def __array_finalize__(self, of: Any) -> None:
        self.report = None

    def copy(self, order: Any = "C") -> ReportedArray:
        same = super().copy(order)
        same.report = self.report
        return same

    def __copy__(self) -> ReportedArray:
        return self.copy()

    def __deepcopy__(self, memo: Any) -> ReportedArray:
        return self.copy()

    def __reduce__(self) -> Tuple[Any, ...]:
        make, arguments, state = super().__reduce__()  # type: ignore[misc]
        return make, arguments, (state, self.report)

    def __setstate__(self, state: Any) -> None:
        super().__setstate__(state[0])
        self.report = state[1]


def reported(array: Any, report: Dict[str, Any]) -> ReportedArray:
    """Returns the array with its report."""
    made: ReportedArray = array.view(ReportedArray)
    made.report = report
    return made
