"""Installs the package with the layout of the library's structures, read from the C headers beside this folder, and with type stubs: of
structures' members, and, where the program is found ($HAWSER, PATH or ../build), of the keys of scenes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
KINDS = {"Span": "cable", "Net": "net", "Ropeway": "ropeway"}


def module(name):
    spec = importlib.util.spec_from_file_location(name, HERE / "hawser" / (name + ".py"))
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def schemas():
    program = os.environ.get("HAWSER") or shutil.which("hawser") or shutil.which(str(HERE.parent / "build" / "hawser"))
    return {name: json.loads(subprocess.run([program, "schema", kind], capture_output=True, check=True).stdout)
            for name, kind in KINDS.items() if program}


class Build(build_py):
    def run(self):
        super().run()
        folder = HERE.parent / "include" / "hawser"
        if not (folder / "hawser.h").is_file():
            raise SystemExit(f"{folder} is missing: install from the source tree, with: pip install ./python")
        target = pathlib.Path(self.build_lib) / "hawser"
        layout = module("_headers").read(folder)
        (target / "layout.json").write_text(layout.json(), encoding="utf-8")
        module("_stubs").write(HERE / "hawser", target, layout.structs, schemas())


setup(cmdclass={"build_py": Build})
