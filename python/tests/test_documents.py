"""The examples of doc/python.md print what the page shows.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import importlib.util
import io
import os
import re

from conftest import TREE


def test_examples_of_the_page(scenes, monkeypatch):
    monkeypatch.chdir(scenes)
    names = {}
    pandas = importlib.util.find_spec("pandas")
    blocks = re.findall(r"^```python\n(.*?)^```", (TREE / "doc" / "python.md").read_text(encoding="utf-8"), re.M | re.S)
    assert len(blocks) >= 5 and os.path.exists("chairlift.yaml")
    for block in blocks:
        if not pandas and ("sweep(" in block or ".frame(" in block):
            continue
        shown = re.findall(r"^# (.*)$", block, re.M)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(block, names)
        assert out.getvalue().splitlines() == shown, block
