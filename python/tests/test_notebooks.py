"""The notebooks of notebooks-data: they are light, and run; with HAWSER_LONG=1 all of them, by nbclient where it is installed and
their code cells in plain Python otherwise. Without it the code of one runs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import json
import os

import pytest
from conftest import TREE

BOOKS = sorted((TREE / "notebooks-data").glob("*.ipynb"))
LONG = bool(os.environ.get("HAWSER_LONG"))


def cells(path):
    return [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]


def printed(cell, outputs):
    return "".join(text for output in outputs if output["output_type"] == "stream"
                   for text in output["text"])


def test_notebooks_are_light_and_have_their_outputs():
    assert len(BOOKS) == 5
    for path in BOOKS:
        assert path.stat().st_size < 100000, path.name
        code = cells(path)
        assert all("error" != output["output_type"] for cell in code for output in cell["outputs"]), path.name
        assert any("image/png" in output.get("data", {}) for cell in code for output in cell["outputs"]), path.name
        for number, cell in enumerate(code):
            compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec")


@pytest.mark.parametrize("path", BOOKS if LONG else [p for p in BOOKS if p.stem == "chairlift"], ids=lambda p: p.stem)
def test_code_runs_and_prints_what_is_shown(path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(TREE / "notebooks-data")
    names = {}
    for cell in cells(path):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec("".join(cell["source"]), names)
        shown = printed(cell, cell["outputs"])
        # round-off, which residuals show, differs from one processor to the next
        assert _words(out.getvalue()) == _words(shown), path.name
    matplotlib.pyplot.close("all")


def _words(text):
    """The words, with numbers rounded to three digits and those below 1e-8 left out."""
    words = []
    for word in text.replace(",", " ").replace("[", " ").replace("]", " ").replace(";", " ").split():
        try:
            value = float(word)
        except ValueError:
            words.append(word)
            continue
        if abs(value) > 1e-8:
            words.append("%.3g" % value)
    return words


@pytest.mark.skipif(not LONG, reason="starts a kernel for each: HAWSER_LONG=1")
@pytest.mark.parametrize("path", BOOKS, ids=lambda p: p.stem)
def test_notebook_runs_in_a_kernel(path, monkeypatch):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    monkeypatch.setenv("PYTHONPATH", str(TREE / "python"))
    book = nbformat.read(path, as_version=4)
    nbformat.validate(book)
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(path.parent)}}).execute()
