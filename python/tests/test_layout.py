"""The layouts that the package reads from the headers against the library's sizes and a C compiler's offsets.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import ctypes
import os
import pathlib
import shutil
import subprocess

import pytest

import hawser
from hawser import _library, _stubs, objects

TREE = _library.TREE
PUBLIC = [name for name in _library.layout["structs"] if "." not in name]


def test_sizes_are_the_librarys():
    sizeof = _library.function("hawser_sizeof")
    known = 0
    for name in PUBLIC:
        size = sizeof(name.encode())
        assert size in (0, ctypes.sizeof(_library.struct(name))), name
        known += size > 0
    assert known >= 250  # the others are inner structures that no caller allocates


def test_functions_are_the_librarys():
    for name in _library.layout["functions"]:
        assert hasattr(_library.library(), name), name
    assert hawser.library_version() == subprocess.run(
        [_library.program(), "--version"], capture_output=True, text=True, check=True).stdout.split()[1]


def test_statuses_are_the_headers():
    for status in hawser.Status:
        name = "HAWSER_OK" if status == 0 else "HAWSER_ERR_" + status.name
        assert _library.layout["constants"][name] == status


def test_offsets_are_a_compilers(tmp_path):
    cc = shutil.which(os.environ.get("CC", "cc").split()[0]) or shutil.which("gcc")
    if not cc or not (TREE / "include").is_dir():
        pytest.skip("no C compiler, or no headers")
    lines = []
    for name in PUBLIC:
        for member, _, _ in _library.layout["structs"][name]:
            offset = getattr(_library.struct(name), member).offset
            lines.append(f'_Static_assert(offsetof(struct {name}, {member}) == {offset}, "{name}.{member}");')
    assert len(lines) > 1500
    source = tmp_path / "offsets.c"
    source.write_text("#include <stddef.h>\n#include <hawser/hawser.h>\n" + "\n".join(lines) + "\n")
    done = subprocess.run([cc, "-std=c11", "-fsyntax-only", "-I", str(TREE / "include"), str(source)],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[:2000]


def test_a_wrong_size_is_refused(monkeypatch):
    members = _library.layout["structs"]["hawser_modes_options"]
    monkeypatch.setitem(_library.layout["structs"], "hawser_modes_options", members[:-2])
    monkeypatch.delitem(_library._structs, "hawser_modes_options", raising=False)
    with pytest.raises(hawser.SystemFailure, match="hawser_modes_options has .* bytes"):
        _library.struct("hawser_modes_options")


def test_stubs_name_members_and_keys(tmp_path):
    source = pathlib.Path(objects.__file__).parent
    kinds = {"Span": objects.Span.kind, "Net": objects.Net.kind, "Ropeway": objects.Ropeway.kind}
    _stubs.write(source, tmp_path, _library.layout["structs"], {name: objects.schema(kind) for name, kind in kinds.items()})
    for name, of, known in (("models", "Statics", {"H", "T0", "sag"}), ("objects", "Span", {"EA", "d", "T0", "damping"})):
        tree = ast.parse((tmp_path / (name + ".pyi")).read_text())
        body = next(item.body for item in tree.body if isinstance(item, ast.ClassDef) and item.name == of)
        listed = {item.target.id for item in body if isinstance(item, ast.AnnAssign)}
        for item in body:
            if isinstance(item, ast.FunctionDef) and item.name in ("__init__", "set"):
                listed |= {argument.arg for argument in item.args.kwonlyargs}
        assert known <= listed and not any(getattr(item, "name", "") == "__getattr__" for item in body), (name, listed)
