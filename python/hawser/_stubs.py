"""Type stubs (.pyi) of modules whose names the sources do not spell out: members of structures, from the C headers, and keys of
scenes, from the program's schema. setup.py writes them beside the modules, where editors look.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ast
import keyword
import pathlib
from typing import Any, Dict, List, Mapping, Sequence, Tuple

_KINDS = {"double": "float", "int": "int", "long": "int", "size_t": "int", "unsigned": "int", "unsigned char": "int", "char": "bytes"}


def attributes(members: Sequence[Tuple[str, str, List[int]]]) -> Dict[str, str]:
    """The type of each member of a structure, as ctypes hands it out."""
    return {name: "Any" if dimensions or kind not in _KINDS else _KINDS[kind] for name, kind, dimensions in members}


def keywords(schema: Dict[str, Any], depth: int = 2) -> List[str]:
    """The sections of a schema and their keys."""
    forms = [schema, *schema.get("anyOf", []), *schema.get("oneOf", [])]
    forms += [schema[key] for key in ("then", "else") if key in schema]
    own = {key: inner for form in forms for key, inner in form.get("properties", {}).items()}
    below = [key for inner in own.values() if depth > 1 and isinstance(inner, dict) for key in keywords(inner, depth - 1)]
    return sorted(key for key in {*own, *below} if key.isidentifier() and not keyword.iskeyword(key))


class _Strip(ast.NodeTransformer):
    """Functions without their bodies; the attributes and keywords added."""

    def __init__(self, members: Mapping[str, Mapping[str, str]], keys: Mapping[str, Sequence[str]]) -> None:
        self.members, self.keys = members, keys

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        more, keys = self.members.get(node.name), self.keys.get(node.name)
        replaced = (["__getattr__"] if more else []) + (["__init__", "set"] if keys else [])
        node.body = [self.visit(item) for item in node.body if getattr(item, "name", "") not in replaced]
        if more:
            node.body += ast.parse("\n".join(f"{name}: {kind}" for name, kind in more.items())).body
        if keys:
            listed = ", ".join(f"{key}: Any = ..." for key in keys)
            node.body += ast.parse(f"def __init__(self, *, {listed}) -> None: ...\ndef set(self, *, {listed}) -> {node.name!r}: ...").body
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        text = ast.get_docstring(node)
        node.body = [ast.Expr(ast.Constant(text))] if text else []
        node.body.append(ast.Expr(ast.Constant(...)))
        return node


def stub(source: str, members: Mapping[str, Mapping[str, str]], keys: Mapping[str, Sequence[str]]) -> str:
    """The stub of a module's source. members: types of attributes of a class; keys: keywords of its __init__ and set."""
    return ast.unparse(ast.fix_missing_locations(_Strip(members, keys).visit(ast.parse(source)))) + "\n"


def write(folder: pathlib.Path, target: pathlib.Path, structs: Mapping[str, Any], schemas: Mapping[str, Dict[str, Any]]) -> None:
    """models.pyi and, with schemas of the kinds by the class that has them, objects.pyi."""
    members = {"Statics": attributes(structs["hawser_statics"])}
    (target / "models.pyi").write_text(stub((folder / "models.py").read_text(encoding="utf-8"), members, {}), encoding="utf-8")
    if schemas:
        keys = {name: keywords(schema) for name, schema in schemas.items()}
        (target / "objects.pyi").write_text(stub((folder / "objects.py").read_text(encoding="utf-8"), {}, keys), encoding="utf-8")
