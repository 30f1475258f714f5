"""The layout of the library's structures and its functions' arguments, read from the C headers.

No layout is written by hand: `read` parses include/hawser/*.h, whose style is regular, into plain data, which
setup.py stores as layout.json. When a structure is used, its size is compared with hawser_sizeof, and
tests/test_layout.py compares every member's offset with a C compiler's.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import json
import pathlib
import re
from typing import Any, Dict, List, Tuple

# A member: name, type ("double", "pointer", "struct x"), dimensions.
Member = Tuple[str, str, List[int]]
SCALARS = ("double", "int", "long", "char", "size_t", "unsigned", "unsigned char")


def _plain(text: str) -> str:
    """The text without comments, preprocessor lines, and the C++ frame."""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.M)
    return re.sub(r'extern "C" \{', "", text)


def _split(text: str, separator: str) -> List[str]:
    """The parts between separators that stand in no bracket."""
    parts, depth, begin = [], 0, 0
    for i, letter in enumerate(text):
        depth += letter in "([{"
        depth -= letter in ")]}"
        if letter == separator and depth == 0:
            parts.append(text[begin:i])
            begin = i + 1
    return [part.strip() for part in parts + [text[begin:]] if part.strip()]


class Layout:
    """What the headers declare: constants, structures, functions."""

    def __init__(self) -> None:
        self.constants: Dict[str, int] = {}
        self.structs: Dict[str, List[Member]] = {}
        self.functions: Dict[str, List[str]] = {}  # the result's type first

    def _value(self, text: str) -> int:
        array = re.search(r"sizeof \(\(struct (\w+) \*\)0\)->(\w+)", text)
        if array:
            return next(d[0] for name, _, d in self.structs[array[1]] if name == array[2])
        if not re.fullmatch(r"[\w\s+*/()-]+", text):
            raise ValueError("no constant: " + text)
        return int(eval(text, {"__builtins__": {}}, self.constants))  # digits, names, + - * ( )

    def _enums(self, text: str) -> None:
        for body in re.findall(r"\benum\s*\w*\s*\{([^}]*)\}", text):
            value = -1
            for item in _split(body, ","):
                name, _, given = (part.strip() for part in item.partition("="))
                value = self._value(given) if given else value + 1
                self.constants[name] = value

    def _declarator(self, text: str, kind: str, within: str) -> Member:
        dimensions = [self._value(d) for d in re.findall(r"\[([^\]]+)\]", text)]
        if text.startswith("("):  # a pointer to a function or to rows
            name = re.search(r"\(\*\s*(\w+)\)", text)
            if not name:
                raise ValueError(f"{within}: {text}")
            return name[1], "pointer", []
        name = re.search(r"\w+", text)
        assert name
        return name[0], "pointer" if "*" in text[:name.start()] else kind, dimensions

    def _members(self, body: str, within: str) -> List[Member]:
        members: List[Member] = []
        for line in _split(body, ";"):
            inner = re.match(r"(?:struct|union)\s*(\w*)\s*\{(.*)\}\s*(.*)$", line, flags=re.S)
            if inner:
                name = inner[1] or within + "." + re.findall(r"[a-z]\w*", inner[3])[0]
                self.structs[name] = self._members(inner[2], name)
                kind, rest = "struct " + name, inner[3]
            else:
                line = re.sub(r"\bconst\b", "", line).strip()
                match = re.match(r"((?:struct|enum)\s+\w+|unsigned char|\w+)\s*(.*)$", line, flags=re.S)
                if not match:
                    raise ValueError(f"{within}: {line}")
                kind, rest = " ".join(match[1].split()), match[2]
                if kind.startswith("enum"):
                    kind = "int"
            for text in _split(rest, ","):
                members.append(self._declarator(text, kind, within))
        for name, kind, _ in members:
            if kind not in SCALARS and kind != "pointer" and not kind.startswith("struct "):
                raise ValueError(f"{within}.{name}: {kind}")
        return members

    @staticmethod
    def _type(text: str) -> str:
        """The type of an argument or a result."""
        if "*" in text or "[" in text:
            return "text" if re.fullmatch(r"const char \*\w*", text) else "pointer"
        text = re.sub(r"\bconst\b", "", text).strip()
        match = re.match(r"struct \w+|unsigned char|\w+", text)
        assert match
        return "int" if match[0] == "enum" else match[0]

    def add(self, text: str) -> None:
        """Declarations of one header; those of the headers it includes were added before."""
        text = _plain(text)
        self._enums(text)
        begin = 0
        while True:
            match = re.compile(r"^struct (\w+) \{", re.M).search(text, begin)
            if not match:
                break
            end = text.index("\n};", match.end())
            self.structs[match[1]] = self._members(text[match.end():end], match[1])
            text = text[:match.start()] + text[end + 3:]
            begin = match.start()
        prototype = (r"^([a-z][\w \t]*?\*?)\b(hawser_[a-z]\w*)\(((?:[^()]|\([^()]*\))*)\)\s*"
                     r"(?:HAWSER_MUST_CHECK|HAWSER_PRINTF\([^)]*\)\s*)*;")
        for result, name, arguments in re.findall(prototype, text, flags=re.M):
            given = [] if arguments.strip() == "void" else _split(arguments, ",")
            self.functions[name] = [self._type(result.strip())] + [
                self._type(" ".join(argument.split())) for argument in given]

    def json(self) -> str:
        return json.dumps({"constants": self.constants, "structs": self.structs, "functions": self.functions})


def read(folder: pathlib.Path) -> Layout:
    """The layout of all headers in a folder, each after those that it includes."""
    layout, done = Layout(), set()

    def visit(name: str) -> None:
        path = folder / name
        if name in done or not path.is_file():
            return
        done.add(name)
        text = path.read_text(encoding="utf-8")
        for other in re.findall(r"#include <hawser/([\w.]+)>", text):
            visit(other)
        layout.add(text)

    for path in sorted(folder.glob("*.h")):
        visit(path.name)
    return layout


def load(text: str) -> Dict[str, Any]:
    data: Dict[str, Any] = json.loads(text)
    return data
