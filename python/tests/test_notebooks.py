# SPDX-License-Identifier: MIT
"""The notebooks of examples/notebooks run as written, and are kept without outputs."""
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


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_notebook(path, tmp_path, monkeypatch):
    # The kernel is the system's Python, also where the tests run in a virtual environment.
    package = pathlib.Path(asterism.__file__).absolute().parents[1]
    monkeypatch.setenv("PYTHONPATH", str(package) + os.pathsep + os.environ.get("PYTHONPATH", ""))
    book = nbformat.read(path, as_version=4)
    assert not any(cell.get("outputs") for cell in book.cells)
    nbclient.NotebookClient(book, timeout=600, kernel_name="python3",
                            resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = [output for cell in book.cells for output in cell.get("outputs", ())]
    pictures = [o for o in shown if {"image/svg+xml", "image/png"} & set(o.get("data", {}))]
    assert pictures or "4_" in path.name
