# SPDX-License-Identifier: MIT
"""The page about a mesh, in a notebook."""
from __future__ import annotations

import html
import os

from ._forms import path_of


class Page:
    """A page about a mesh: one file of HTML that needs no network, shown by notebooks in a frame."""

    def __init__(self, text: str, height: int) -> None:
        self.text = text
        self.height = height

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="{self.height}" '
                'style="border: 0" allowfullscreen></iframe>')

    def save(self, path: "str | os.PathLike[str]") -> str:
        """Writes the page to a file, for a browser. Returns the file's name."""
        name = path_of(path)
        with open(name, "w", encoding="utf-8") as file:
            file.write(self.text)
        return name

    def __repr__(self) -> str:
        return f"<Page of {len(self.text)} characters: a notebook shows it, save() writes it for a browser>"
