# SPDX-License-Identifier: MIT
"""Arrays that know how they were made."""
from __future__ import annotations

from typing import Any, Dict, Optional

import numpy as np


class ReportedArray(np.ndarray):  # type: ignore[type-arg]
    """An array with a `report` of how it was made. Of a metric: complexities, the error predicted,
    the shares of the vertices at which bounds, gradation and intersections changed something. Of
    transferred values: integrals and extrema before and after, and what lay outside."""

    report: Optional[Dict[str, Any]]

    def __array_finalize__(self, of: Any) -> None:
        self.report = getattr(of, "report", None)
