"""hawser.run: the program's commands from Python, with their results.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import json
import os
import pathlib
import subprocess
import tempfile
from fnmatch import fnmatchcase
from typing import Any, Dict, List, Mapping, Optional, Union

import numpy as np

from . import scenes
from ._interrupts import communicate
from ._library import program
from .errors import exit_error


_NO_TITLE = {"where", "or", "of", "for", "the", "it", "parameter", "missing", "index", "name"}


def _options(given: Mapping[str, Any]) -> List[str]:
    """--from 1 of from_=1. True is an option without argument; a tuple has several arguments; a list repeats the
    option. n=4 is -n 4."""
    words: List[str] = []
    for key, value in given.items():
        name = key.rstrip("_").replace("_", "-")
        option = ("-" if len(name) == 1 and name == "n" else "--") + name
        for item in value if isinstance(value, list) else [value]:
            if item is None or item is False:
                continue
            words.append(option)
            if item is not True:
                words += [str(part) for part in (item if isinstance(item, tuple) else (item,))]
    return words


def _number(word: str) -> float:
    """The number in a cell; none is NaN. Python would take the name 1_2 for 12."""
    if "_" in word:
        raise ValueError(word)
    return float(word) if word else np.nan


def _table(text: str) -> "tuple[List[str], np.ndarray[Any, Any]]":
    """Comments without "# ", and the rows as records: numbers where all are numbers, else words."""
    lines = text.split("\n")
    comments = [line[1:].strip() for line in lines if line.startswith("#")]
    rows = [line.split("\t") for line in lines if line and not line.startswith("#")]
    if not rows:
        return comments, np.zeros(0, [])
    names, cells = rows[0], rows[1:]
    columns: List[Any] = []
    kinds: List[Any] = []
    for index, name in enumerate(names):
        words = [row[index] for row in cells]
        column: Any
        try:
            column = np.array([_number(word) for word in words])
        except ValueError:
            column = np.array(words, dtype=str)
        columns.append(column)
        kinds.append((name, column.dtype))
    table = np.zeros(len(cells), kinds)
    for (name, _), column in zip(kinds, columns):
        table[name] = column
    return comments, table


class Result:
    """What a command computed. `json`: the whole result; `table`: the rows as a numpy record array, whose names have
    their unit at the end (Omega_rad_s); `comments`: the lines above the table; `warnings`: the program's warnings."""

    def __init__(self, command: str, data: Dict[str, Any], text: str, warnings: str) -> None:
        self.command, self.json, self.warnings = command, data, warnings
        self.comments, self.table = _table(text)

    @property
    def names(self) -> List[str]:
        """The table's columns."""
        return list(self.table.dtype.names or ())

    @property
    def columns(self) -> List[Dict[str, str]]:
        """Of each column of the table its name, key (the name without unit), title, meaning and unit."""
        known = {column["name"]: column for column in self.json.get("columns", [])}
        return [known.get(name, {"name": name, "key": name, "title": "", "meaning": "", "unit": ""}) for name in self.names]

    @property
    def keys(self) -> List[str]:
        """The names of the columns without their units."""
        return [column["key"] for column in self.columns]

    def _about(self, name: str) -> Dict[str, str]:
        return self.columns[self.names.index(name)]

    def key(self, name: str) -> str:
        """The column's name without its unit."""
        return self._about(name)["key"]

    def unit(self, name: str) -> str:
        """The column's unit, "" for none."""
        return self._about(name)["unit"]

    def title(self, name: str) -> str:
        """The column's title in pictures, without unit."""
        about = self._about(name)
        key = {"Omega": "Ω", "omega": "ω"}.get(about["key"], about["key"].replace("_", " "))
        words = about["meaning"].split()
        if about["title"] or not 1 <= len(words) <= 3 or not all(word.isalpha() for word in words) or set(words) & _NO_TITLE:
            return about["title"] or key
        meaning = about["meaning"][:1].upper() + about["meaning"][1:]
        return meaning if key in words or key == about["meaning"] else f"{meaning} {key}"

    def find(self, wanted: str) -> List[str]:
        """The columns of these names or keys, separated by blanks, or patterns such as "u_*"; "kind+1" is the one behind
        `kind`, "+1" the first."""
        found: List[str] = []
        for word in wanted.split():
            after, plus, number = word.rpartition("+")
            if plus and number.isdigit():
                at = (self.keys.index(after) if after in self.keys else -1 if not after else len(self.keys)) + int(number)
                found += self.names[at:at + 1]
            else:
                found += [n for n, key in zip(self.names, self.keys) if word in (n, key) or fnmatchcase(key, word)]
        return list(dict.fromkeys(found))

    def __repr__(self) -> str:
        names = ", ".join(self.names[:6])
        return f"<hawser {self.command}: {len(self.table)} rows of {names}, ...>"

    def __getitem__(self, name: str) -> Any:
        """A column of the table, or else a key of the JSON."""
        if name in self.names:
            return self.table[name]
        return self.json[name]

    def frame(self, key: Optional[str] = None) -> Any:
        """A pandas frame of the table, or of a list of objects in the JSON such as "events"."""
        import pandas  # optional: asked for by name

        if key is None:
            return pandas.DataFrame({name: self.table[name] for name in self.names})
        return pandas.json_normalize(self.json[key])

    def plot(self, x: Optional[str] = None, y: Union[str, List[str], None] = None, ax: Any = None) -> Any:
        """Draw columns with matplotlib; see hawser.plots.result. Returns the axes."""
        from . import plots

        return plots.result(self, x, y, ax)


def run(command: str, scene: Union[scenes.SceneLike, None] = None, *more: str,
        set: Optional[Mapping[str, Any]] = None, timeout: Optional[float] = None, **options: Any) -> Result:
    """Run `hawser COMMAND SCENE`. The scene is a file or a nested dict; `set` overrides keys ({"tension.T0": "90 kN"}).
    Options are those of the program, with _ for - and a _ behind Python's own words: run("frf", scene,
    from_="0.9w1", to="1.1w1", n=5). A failure is a hawser.Error with the program's message; Ctrl-C raises KeyboardInterrupt,
    whose attribute `partial` is the result so far of commands that have one (frf, folds, integrate, map ...)."""
    words = command.split()
    with tempfile.TemporaryDirectory(prefix="hawser-") as folder, scenes.as_file(scene or "") as path:
        files = [str(pathlib.Path(folder) / name) for name in ("result.json", "result.tsv")]
        arguments = words + ([path] if scene else []) + list(more) + _options(options)
        for change in scenes.overrides(set):
            arguments += ["--set", change]
        code, _, said, stop = _start(arguments + ["--quiet", "--json", files[0], "--tsv", files[1]], timeout)
        if code and not (stop and os.path.isfile(files[0])):
            raise stop or _failure(code, said)
        data = json.loads(pathlib.Path(files[0]).read_text(encoding="utf-8"))
        rows = pathlib.Path(files[1])
        table = rows.read_text(encoding="utf-8") if rows.is_file() else ""
    result = Result(command, data, table, said.strip())
    if stop:
        stop.partial = result  # type: ignore[attr-defined]
        raise stop
    return result


def _start(arguments: List[str], timeout: Optional[float]) -> "tuple[int, str, str, Optional[BaseException]]":
    """Exit status and output of the program, and KeyboardInterrupt if Ctrl-C ended it."""
    process = subprocess.Popen([program()] + arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, encoding="utf-8", errors="replace", env={**os.environ, "NO_COLOR": "1"},
                               start_new_session=True)  # for a second signal, from the terminal, would end it without a result
    out, said, stop = communicate(process, timeout)
    return process.returncode, out, said, stop


def _failure(status: int, said: str) -> Exception:
    lines = said.strip().split("\n")
    begin = max((i for i, line in enumerate(lines) if line.startswith("hawser: ")), default=0)
    message = " ".join(line.strip() for line in lines[begin:])
    prefix = "hawser: "
    code = 128 - status if status < 0 else status
    return exit_error(code, message[len(prefix):] if message.startswith(prefix) else message or f"exit status {code}")
