"""Scenes as files, text or nested dicts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import json
import math
import os
import pathlib
import tempfile
from contextlib import contextmanager
from typing import Any, Iterator, List, Mapping, Optional, Union

SceneLike = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def scalar(value: Any) -> str:
    """A value in YAML: words and quantities ("80 kN") in quotes, numbers with all digits."""
    if isinstance(value, bool) or value is None:
        raise TypeError(f"a scene has no value {value!r}: give a number, a quantity such as '80 kN', or a word")
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if hasattr(value, "magnitude") and hasattr(value, "units"):  # of pint
        return json.dumps(f"{value.magnitude!r} {value.units:~C}", ensure_ascii=False)
    if isinstance(value, int):
        return str(value)
    number = float(value)  # of numpy too
    if math.isnan(number):
        raise ValueError("a scene has no value nan")
    return repr(number) if math.isfinite(number) else (".inf" if number > 0 else "-.inf")


def is_list(value: Any) -> bool:
    return not isinstance(value, (str, Mapping)) and hasattr(value, "__iter__") and not hasattr(value, "magnitude")


def flow(value: Any) -> str:
    """A value on one line: as --set takes it, and as the items of a list are written."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key}: {flow(item)}" for key, item in value.items()) + "}"
    return "[" + ", ".join(flow(item) for item in value) + "]" if is_list(value) else scalar(value)


def text(scene: Mapping[str, Any], indent: str = "") -> str:
    """The scene as YAML, one key a line, so that messages name the line of one key."""
    lines: List[str] = []
    for key, value in scene.items():
        if isinstance(value, Mapping) and value:
            lines += [f"{indent}{key}:", text(value, indent + "  ").rstrip("\n")]
        elif is_list(value) and any(isinstance(item, Mapping) for item in value):
            lines += [f"{indent}{key}:"] + [f"{indent}  - {flow(item)}" for item in value]
        else:
            lines.append(f"{indent}{key}: {flow(value)}")
    return "\n".join(lines) + "\n"


def overrides(changes: Optional[Mapping[str, Any]]) -> List[str]:
    """KEY=VALUE of --set from {"tension.T0": "90 kN"}."""
    return [f"{key}={value if isinstance(value, str) else flow(value)}" for key, value in (changes or {}).items()]


@contextmanager
def as_file(scene: SceneLike) -> Iterator[str]:
    """The path of the scene; of a dict that of a file which exists as long as the context."""
    if not isinstance(scene, Mapping):
        yield os.fspath(scene)
        return
    with tempfile.TemporaryDirectory(prefix="hawser-") as folder:
        path = pathlib.Path(folder) / "scene.yaml"
        path.write_text(text(scene), encoding="utf-8")
        yield str(path)
