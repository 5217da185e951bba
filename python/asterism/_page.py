# SPDX-License-Identifier: MIT
"""The page about a mesh in a notebook: its contents, and how it is shown."""
from __future__ import annotations

import html
import os
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy.typing as npt

from . import _asterism
from ._asterism import InputError
from ._calls import told_methods
from ._domain import Domain
from ._forms import Fields, NamedFields, doubles, named_fields, path_of, tensor_rows, whole, write_text

if TYPE_CHECKING:
    from ._mesh import Mesh

# What stands on a page: a mesh with its own fields, a mesh with other fields, or a domain.
Earlier = Union["Mesh", Tuple["Mesh", Fields], Domain]
Before = Union[Earlier, Sequence[Earlier], Mapping[str, Earlier]]


@told_methods
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
        write_text(name, self.text)
        return name

    def __repr__(self) -> str:
        return f"<Page of {len(self.text)} characters: a notebook shows it, save() writes it for a browser>"


def page_of(mesh: Mesh, values: Optional[Fields], before: Optional[Before], wanted: Optional[npt.ArrayLike],
            title: str, label: Optional[str], height: int) -> Page:
    """Returns the page of Mesh.show(), whose arguments these are."""
    height = whole("height", height, 1, "a whole number of pixels")
    frames, own = _frames(before)
    words: Dict[str, Any] = {
        "title": title, "label": own if label is None else label, "before": frames,
        "fields": _fields(mesh.values if values is None else values),
        "wanted": None if wanted is None else tensor_rows("wanted", wanted, len(mesh.points))}
    return Page(_asterism._page(mesh._made, words), height)


def _fields(values: Fields) -> NamedFields:
    return [(name, doubles(name, of)) for name, of in named_fields(values)]


def _frames(before: Optional[Before]) -> Tuple[List[Any], str]:
    """Returns labels, meshes and fields in the module's form, and the label of the mesh itself."""
    if before is None:
        return [], ""
    if isinstance(before, Mapping):
        return [_frame(str(label), one) for label, one in before.items()], "After"
    if isinstance(before, (list, tuple)) and not _is_pair(before):
        return [_frame(f"Round {k}", one) for k, one in enumerate(before, 1)], f"Round {len(before) + 1}"
    return [_frame("Before", before)], "After"


def _is_shown(what: Any) -> bool:
    return isinstance(getattr(what, "_made", None), (_asterism._Mesh, _asterism._Domain))


def _is_pair(what: Any) -> bool:
    """True of a mesh with fields. Two meshes are two rounds."""
    return (isinstance(what, tuple) and len(what) == 2 and isinstance(getattr(what[0], "_made", None), _asterism._Mesh)
            and not _is_shown(what[1]) and not _is_pair(what[1]))


def _frame(label: str, one: Any) -> Tuple[str, Any, NamedFields]:
    shown, values = one if _is_pair(one) else (one, getattr(one, "values", {}))
    if not _is_shown(shown):
        raise InputError(f"before: a Mesh, a pair of a Mesh and fields, a Domain, or several of these are wanted, "
                         f"not {type(shown).__name__}")
    return label, shown._made, _fields(values)
