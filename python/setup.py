"""Installs the package with the layout of the library's structures, read from the C headers beside this folder.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import importlib.util
import pathlib

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent


class Build(build_py):
    def run(self):
        super().run()
        spec = importlib.util.spec_from_file_location("_headers", HERE / "hawser" / "_headers.py")
        headers = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(headers)
        folder = HERE.parent / "include" / "hawser"
        if not (folder / "hawser.h").is_file():
            raise SystemExit(f"{folder} is missing: install from the source tree, with: pip install ./python")
        target = pathlib.Path(self.build_lib) / "hawser" / "layout.json"
        target.write_text(headers.read(folder).json(), encoding="utf-8")


setup(cmdclass={"build_py": Build})
