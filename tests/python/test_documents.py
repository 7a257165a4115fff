"""Tests that docs/python.md and the notebooks show what actually happens."""

import doctest
import os

import pytest

from common import SOURCE

NOTEBOOKS = sorted((SOURCE / "docs/notebooks").glob("*.ipynb"))


def test_the_page(tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    text = (SOURCE / "docs/python.md").read_text(encoding="utf-8").replace("```", "")
    test = doctest.DocTestParser().get_doctest(text, {}, "python.md", None, 0)
    said = []
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append)
    assert result.failed == 0, "".join(said)
    assert result.attempted > 20


def printed(notebook):
    """Returns the texts that the cells of a notebook print or show. Pictures are omitted, because they
    depend on the version of matplotlib."""
    texts = []
    for cell in notebook.cells:
        outputs = [o for o in cell.get("outputs", []) if not {"text/html", "image/png"} & set(o.get("data", {}))]
        # The output of one cell may be divided into several pieces.
        texts.append("".join(o.get("text") or o["data"]["text/plain"] for o in outputs))
    return [text for text in texts if text]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_notebooks(path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    told = nbformat.read(path, as_version=4)
    fresh = nbformat.reads(nbformat.writes(told), as_version=4)
    nbclient.NotebookClient(fresh, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(path.parent)}}).execute()
    if os.environ.get("GW_WRITE_DOCS"):
        nbformat.write(fresh, path)
        told = fresh
    assert printed(fresh) == printed(told)
    assert len(printed(told)) >= 3
