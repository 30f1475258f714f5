"""Paths for the tests. SPDX-License-Identifier: GPL-3.0-or-later"""
import pathlib
import sys

import pytest

TREE = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(TREE / "python"))


@pytest.fixture(scope="session")
def scenes():
    return TREE / "notebooks-data" / "scenes"
