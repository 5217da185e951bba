# SPDX-License-Identifier: MIT
"""Calls with unknown names of arguments, or too few or too many: errors that name the possible arguments."""
from __future__ import annotations

import difflib
import functools
import inspect
import os
import sys
import unicodedata
import warnings
from typing import Any, Callable, Dict, Iterable, List, Tuple, Type, TypeVar, cast

from ._asterism import InputError

Function = TypeVar("Function", bound=Callable[..., Any])
Class = TypeVar("Class")

_PACKAGE = os.path.dirname(os.path.abspath(__file__)) + os.sep

# Names of arguments in other packages, and the names here. The first that the function has is suggested.
_OTHER_NAMES: Dict[str, Tuple[str, ...]] = {
    "h": ("size", "hmax"), "lc": ("size",), "hsiz": ("size",), "mesh_size": ("size",), "edge_length": ("size",),
    "max_size": ("hmax", "size"), "min_size": ("hmin",), "max_volume": ("size",), "max_area": ("size",),
    "max_length": ("hmax", "size"), "hgrad": ("gradation",), "growth": ("gradation",),
    "min_angle": ("angle_bound",), "minimum_angle": ("angle_bound",), "angle": ("angle_bound",),
    "timeout": ("max_seconds",), "time_limit": ("max_seconds",), "num_threads": ("threads",), "n_jobs": ("threads",),
    "workers": ("threads",), "callback": ("progress",), "verbose": ("progress",), "verbosity": ("progress",),
    "nv": ("vertices",), "n_vertices": ("vertices",), "target": ("vertices",), "max_vertices": ("max_sites",),
    "nbvx": ("max_sites",), "err": ("error",), "tensors": ("metric",), "field": ("values",), "u": ("values",),
    "solution": ("values",), "refinement_func": ("metric",), "holes_points": ("holes",),
    "vertices": ("points",), "nodes": ("points",), "coords": ("points",), "coordinates": ("points",),
    "cells": ("triangles",), "faces": ("triangles",), "elements": ("triangles",), "simplices": ("triangles",),
    "facets": ("segments", "edges"), "edges": ("segments",), "lines": ("segments", "edges"),
    "segments": ("edges",), "tags": ("markers",), "labels": ("markers", "regions"), "references": ("markers",),
    "filename": ("path",), "file": ("path",), "method": ("how",), "tolerance": ("chord", "chord_tolerance"),
}


# Greatest length of a word, and numbers of characters that stay at the beginning and at the end of a longer word: the
# limits of the command line (mesh/support/one_line.hpp), there in bytes.
_LONGEST_WORD, _KEPT_BEFORE, _KEPT_AFTER = 240, 100, 60
_DIRECTIONS = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"


def one_line(text: str) -> str:
    """A message that holds names and parts of files, as one line that a terminal shows as it is."""
    safe = "".join("?" if unicodedata.category(c) in ("Cc", "Zl", "Zp", "Cs") or c in _DIRECTIONS else c for c in text)
    return " ".join(word if len(word) <= _LONGEST_WORD else f"{word[:_KEPT_BEFORE]}...{word[-_KEPT_AFTER:]}"
                    for word in safe.split(" "))


class CallError(InputError, TypeError):
    """An InputError that is also a TypeError, which Python itself raises for such calls."""


def meant(word: str, names: Iterable[str]) -> str:
    """Returns '; did you mean size?', or "" where no name is near."""
    near = difflib.get_close_matches(word, list(names), 1, 0.7)
    return f"; did you mean {near[0]}?" if near else ""


def _hint(word: str, known: List[str]) -> str:
    for ours in _OTHER_NAMES.get(word, ()):
        if ours in known:
            return f"; here it is {ours}"
    return meant(word, known) or "; there are " + ", ".join(known)


def _why(name: str, signature: inspect.Signature, arguments: Tuple[Any, ...], more: Dict[str, Any]) -> str:
    """Returns the fault of a call's arguments, or "" if there is none."""
    known = [of for of in signature.parameters if of not in ("self", "cls")]
    kinds = [of.kind for of in signature.parameters.values()]
    if inspect.Parameter.VAR_KEYWORD not in kinds:
        for word in more:
            if word not in known:
                return f"{name}(): there is no argument {word!r}{_hint(word, known)}"
    placed = [of for of, kind in zip(signature.parameters, kinds) if kind is inspect.Parameter.POSITIONAL_OR_KEYWORD]
    if len(arguments) > len(placed) and inspect.Parameter.VAR_POSITIONAL not in kinds:
        first = [of for of in placed if of in known]
        return (f"{name}(): {len(arguments) - len(placed) + len(first)} arguments without a name, and there are "
                f"{len(first)}: {', '.join(first)}; the others go by name")
    for of in placed[:len(arguments)]:
        if of in more:
            return f"{name}(): {of} is given twice, by its place and by its name"
    for of in placed[len(arguments):]:
        if of not in more and of in known and signature.parameters[of].default is inspect.Parameter.empty:
            return f"{name}(): {of} is missing; {name}({', '.join(p for p in placed if p in known)}) wants it"
    for of, kind in zip(signature.parameters, kinds):
        if kind is inspect.Parameter.KEYWORD_ONLY and of not in more and \
                signature.parameters[of].default is inspect.Parameter.empty:
            return f"{name}(): {of} is missing"
    return ""


def told(function: Function) -> Function:
    """Returns the function wrapped: calls with wrong names or numbers of arguments raise CallError."""
    signature = inspect.signature(function)
    name = function.__qualname__.replace(".__init__", "")

    @functools.wraps(function)
    def call(*arguments: Any, **more: Any) -> Any:
        try:
            return function(*arguments, **more)
        except TypeError as odd:
            # An error of the call itself was raised in this frame. One of the function's body was raised deeper, and
            # is passed on.
            at = odd.__traceback__
            why = _why(name, signature, arguments, more) if at is not None and at.tb_next is None else ""
            if not why:
                raise
        except InputError as wrong:
            wrong.args = tuple(one_line(part) if isinstance(part, str) else part for part in wrong.args)
            raise
        raise CallError(one_line(why))

    return cast(Function, call)


def told_methods(of: Type[Class]) -> Type[Class]:
    """Returns the class with its public methods wrapped by told(). Of a subclass of another class here, wraps its own
    methods only."""
    for name, value in list(vars(of).items()):
        if name.startswith("_") and name != "__init__":
            continue
        if isinstance(value, (classmethod, staticmethod)):
            setattr(of, name, type(value)(told(value.__func__)))
        elif inspect.isfunction(value):
            setattr(of, name, told(value))
    return of


def warn(message: str, category: Type[Warning] = UserWarning) -> None:
    """Warns at the line outside of this package that called it, once for each such line."""
    level = 2
    frame = sys._getframe(1)
    while frame.f_back is not None and os.path.abspath(frame.f_code.co_filename).startswith(_PACKAGE):
        frame = frame.f_back
        level += 1
    warnings.warn(one_line(message), category, stacklevel=level)
