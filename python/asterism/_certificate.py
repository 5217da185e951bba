# SPDX-License-Identifier: MIT
"""The auditor's answer in Python's types."""
from __future__ import annotations

import json
from typing import Any, Dict, List, NamedTuple

from ._calls import meant


class Finding(NamedTuple):
    """A fault that the auditor found in a mesh: its kind, and a sentence that names the place."""

    kind: str
    witness: str


class Certificate:
    """The auditor's answer about a mesh. Attributes are the entries of `data`, and of the objects in it."""

    certified: bool
    complete: bool
    reason: str
    worst_angle: float
    angle_bound: float
    vertices: int
    triangles: int

    def __init__(self, text: str) -> None:
        self.text = text
        self.data: Dict[str, Any] = json.loads(text)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name in ("data", "text"):
            raise AttributeError(name)
        for part in self._parts():
            if name in part:
                return part[name]
        raise AttributeError(f"a certificate has no {name!r}{meant(name, dir(self)) or '; dir() lists what it has'}")

    def _parts(self) -> List[Dict[str, Any]]:
        return [self.data, *[part for part in self.data.values() if isinstance(part, dict)]]

    def __dir__(self) -> List[str]:
        names = {name for part in self._parts() for name in part if name.isidentifier()}
        return sorted(names | set(super().__dir__()))

    def __repr__(self) -> str:
        return f"<Certificate: {', '.join(self.data)}>"


def judged(answer: Dict[str, Any]) -> Dict[str, Any]:
    """Returns the module's answer with its findings as objects."""
    answer["findings"] = [Finding(*finding) for finding in answer["findings"]]
    return answer
