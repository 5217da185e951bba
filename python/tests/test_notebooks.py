# SPDX-License-Identifier: MIT
"""The notebooks of examples/notebooks run as written, and hold what they show: scripts/run-notebooks stores it."""
import os
import pathlib

import pytest

import asterism

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")
pytest.importorskip("ipykernel")
pytest.importorskip("scipy")
pytest.importorskip("matplotlib")
pytest.importorskip("shapely")

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples/notebooks"
BOOKS = sorted(FOLDER.glob("*.ipynb"))


def test_there_are_six():
    assert [path.name[0] for path in BOOKS] == list("123456")


def texts_of(cell):
    """What a cell printed and the text of its value."""
    outputs = cell.get("outputs", ())
    return ("".join(o.get("text", "") for o in outputs), [o["data"].get("text/plain") for o in outputs if "data" in o])


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_notebook(path, tmp_path, monkeypatch):
    # The kernel is the system's Python, also where the tests run in a virtual environment.
    package = pathlib.Path(asterism.__file__).absolute().parents[1]
    monkeypatch.setenv("PYTHONPATH", str(package) + os.pathsep + os.environ.get("PYTHONPATH", ""))
    book = nbformat.read(path, as_version=4)
    stored = [texts_of(cell) for cell in book.cells]
    kept = [output for cell in book.cells for output in cell.get("outputs", ())]
    nbclient.NotebookClient(book, timeout=600, kernel_name="python3",
                            resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = [output for cell in book.cells for output in cell.get("outputs", ())]
    pictures = [o for o in shown if {"image/svg+xml", "image/png"} & set(o.get("data", {}))]
    assert pictures
    assert len(pictures) == sum(bool({"image/svg+xml", "image/png"} & set(o.get("data", {}))) for o in kept)
    assert [texts_of(cell) for cell in book.cells] == stored, "scripts/run-notebooks stores what they show now"
