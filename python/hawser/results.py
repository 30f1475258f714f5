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
from functools import cached_property
from typing import Any, Dict, List, Mapping, Optional, Union

import numpy as np

from . import scenes
from ._interrupts import Progress, communicate
from ._library import program
from .errors import Status, error, exit_error


_LARGE = 1 << 20  # bytes of a table
_SHORT = ("n", "o", "j")
_TEXT = ("check", "init", "schema", "report", "completion")  # commands that write text, not a result
_OF_MODEL = ("n", "load", "keep", "ripple", "damping", "carriers", "lane", "contact", "case", "model_library")  # options
_NO_TITLE = {"where", "or", "of", "for", "the", "it", "parameter", "missing", "index", "name"}


def _options(given: Mapping[str, Any]) -> List[str]:
    """--from 1 of from_=1. True is an option without argument; a tuple has several arguments; a list repeats the
    option. n=4 is -n 4."""
    words: List[str] = []
    for key, value in given.items():
        name = key.rstrip("_").replace("_", "-")
        option = ("-" if name in _SHORT else "--") + name
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


def _table(path: pathlib.Path) -> "tuple[List[str], np.ndarray[Any, Any]]":
    """Comments without "# ", and the rows as records: numbers where all are numbers, else words."""
    comments: List[str] = []
    with path.open(encoding="utf-8") as lines:
        for line in lines:
            if not line.startswith("#"):
                break
            comments.append(line[1:].strip())
        else:
            return comments, np.zeros(0, [])
        names = line.rstrip("\n").split("\t")
        columns = _columns_of(path, len(comments)) or _columns_in([row.rstrip("\n").split("\t") for row in lines], len(names))
    table = np.zeros(len(columns[0]), [(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        table[name] = column
    return comments, table


def _columns_in(rows: List[List[str]], count: int) -> "List[np.ndarray[Any, Any]]":
    columns: List[Any] = []
    for index in range(count):
        words = [row[index] for row in rows]
        try:
            columns.append(np.array([_number(word) for word in words], dtype=float))
        except ValueError:
            columns.append(np.array(words, dtype=str))
    return columns


def _columns_of(path: pathlib.Path, comments: int) -> "Optional[List[np.ndarray[Any, Any]]]":
    """The same of a large table, by pandas where it is installed: its import takes longer than a small one."""
    if path.stat().st_size < _LARGE:
        return None
    try:
        import pandas
    except ImportError:
        return None
    frame = pandas.read_csv(path, sep="\t", skiprows=comments, engine="c", float_precision="round_trip", low_memory=False,
                            keep_default_na=False, na_values={}, quoting=3, skip_blank_lines=False, encoding="utf-8")
    return [_as_column(frame.iloc[:, k]) for k in range(frame.shape[1])]


def _as_column(series: Any) -> "np.ndarray[Any, Any]":
    """Words stay words; of numbers an empty cell is NaN."""
    if series.dtype.kind in "fiu":
        return np.asarray(series, dtype=float)
    words = series.tolist()
    try:
        return np.array([_number(word) if isinstance(word, str) else float(word) for word in words], dtype=float)
    except ValueError:
        return np.array([str(word) for word in words], dtype=str)


class Result:
    """What a command computed. `json`: the whole result; `table`: the rows as a numpy record array, whose names have
    their unit at the end (Omega_rad_s); `comments`: the lines above the table; `warnings`: the program's warnings;
    `text`: what it printed."""

    def __init__(self, command: str, data: str, table: Optional[pathlib.Path], warnings: str = "", text: str = "",
                 origin: Optional[Dict[str, Any]] = None) -> None:
        self.command, self.warnings, self.text = command, warnings, text
        self._data, self._origin = data, origin or {}
        self.comments, self.table = _table(table) if table and table.is_file() else ([], np.zeros(0, []))

    @cached_property
    def json(self) -> Dict[str, Any]:
        """The whole result, in SI; read when it is first asked for."""
        data: Dict[str, Any] = json.loads(self._data or "{}")
        return data

    @property
    def names(self) -> List[str]:
        """The table's columns."""
        return list(self.table.dtype.names or ())

    @cached_property
    def columns(self) -> List[Dict[str, str]]:
        """Of each column of the table its name, key (the name without unit), title, meaning and unit."""
        at = self._data.rfind('\n "columns": ')  # the other members, which may be large, are not read for it
        known = {c["name"]: c for c in json.JSONDecoder().raw_decode(self._data, at + 13)[0]} if at >= 0 else {}
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
        """A pandas frame of the table, or of a list of objects in the JSON such as "peaks". The frame of "events" has those of
        all branches, with the number of the branch."""
        import pandas  # optional: asked for by name

        if key is None:
            return pandas.DataFrame({name: self.table[name] for name in self.names})
        if key == "events" and "branches" in self.json:
            branches = [self.json] + self.json["branches"]
            return pandas.json_normalize([{"branch": number, **event} for number, branch in enumerate(branches, 1)
                                          for event in branch["events"]])
        return pandas.json_normalize(self.json[key])

    def branches(self) -> Dict[int, Any]:
        """The branches of a response, or the curves of loci, by their number: pandas frames of their rows."""
        name = next((name for name in ("branch", "curve") if name in self.names), None)
        frame = self.frame()
        return {1: frame} if name is None else {int(number): rows for number, rows in frame.groupby(name)}

    def _from_label(self, command: str, label: int, option: str, options: Mapping[str, Any]) -> "Result":
        scene = self._origin.get("scene")
        if self.command != "frf" or scene is None:
            raise error(Status.ARGUMENT, f"labels are of a result that hawser.run(\"frf\", ...) returned, not of {self!r}")
        given = {key: value for key, value in self._origin["options"].items() if key in _OF_MODEL}
        with tempfile.TemporaryDirectory(prefix="hawser-") as folder:
            path = pathlib.Path(folder) / "response.json"
            path.write_text(self._data, encoding="utf-8")
            return _run(command, scene, [], self._origin["set"], None, {**given, option: f"{path}#{label}", **options}, [])

    def orbit(self, label: int, **options: Any) -> "Result":
        """The periodic motion at a label of a response, as hawser orbit computes it."""
        return self._from_label("orbit", label, "from_label", options)

    def restart(self, label: int, switch: bool = False, **options: Any) -> "Result":
        """A response that begins at a label of this one, with further options such as to="1.5w1"; with `switch` the branch
        that crosses there, at a branch point or a period doubling."""
        return self._from_label("frf", label, "switch" if switch else "from_label", options)

    def plot(self, x: Optional[str] = None, y: Union[str, List[str], None] = None, ax: Any = None) -> Any:
        """Draw columns with matplotlib; see hawser.plots.result. Returns the axes."""
        from . import plots

        return plots.result(self, x, y, ax)

    def plotly(self, x: Optional[str] = None, y: Union[str, List[str], None] = None) -> Any:
        """The same as a figure of plotly, which shows values under the pointer and zooms."""
        from . import interactive

        return interactive.result(self, x, y)


def run(command: str, scene: Union[scenes.SceneLike, None] = None, *more: str,
        set: Optional[Mapping[str, Any]] = None, timeout: Optional[float] = None, progress: Progress = None,
        **options: Any) -> Result:
    """Run `hawser COMMAND SCENE`. The scene is a file or a nested dict; `set` overrides keys ({"tension.T0": "90 kN"}).
    Options are those of the program, with _ for - and a _ behind Python's own words: run("frf", scene,
    from_="0.9w1", to="1.1w1", n=5). With `progress` a line says how far a long computation is, rewritten in a terminal or below
    the cell of a notebook; a function is called with its text. A failure is a hawser.Error with the program's message; Ctrl-C raises KeyboardInterrupt,
    whose attribute `partial` is the result so far of commands that have one (frf, folds, integrate, map ...)."""
    return _run(command, scene, list(more), set, timeout, options, [], progress)


def _run(command: str, scene: Optional[scenes.SceneLike], more: List[str], set: Optional[Mapping[str, Any]],
         timeout: Optional[float], options: Mapping[str, Any], last: List[str], progress: Progress = None) -> Result:
    words = command.split()
    with tempfile.TemporaryDirectory(prefix="hawser-") as folder, scenes.as_file(scene or "") as path:
        data, table = (pathlib.Path(folder) / name for name in ("result.json", "result.tsv"))
        arguments = words + ([path] if scene else []) + more + _options(options)
        for change in scenes.overrides(set):
            arguments += ["--set", change]
        if command not in _TEXT:
            arguments += ["--quiet", "--json", str(data), "--tsv", str(table)]
        code, text, said, stop = _start(arguments + last, timeout, progress)
        if code and not data.is_file():
            raise stop or _failure(code, said or text)
        whole = data.read_text(encoding="utf-8") if data.is_file() else text if command == "schema" else ""
        result = Result(command, whole, table, said.strip(), text, {"scene": scene, "set": set, "options": dict(options)})
    if stop:
        stop.partial = result  # type: ignore[attr-defined]
        raise stop
    if code and (command != "sweep" or result.json["failed"] == result.json["variations"]):
        failure = _failure(code, said or text)
        failure.partial = result  # type: ignore[attr-defined]
        raise failure
    return result


def _start(arguments: List[str], timeout: Optional[float],
           progress: Progress) -> "tuple[int, str, str, Optional[BaseException]]":
    """Exit status and output of the program, and KeyboardInterrupt if Ctrl-C ended it."""
    process = subprocess.Popen([program()] + arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, encoding="utf-8", errors="replace", env={**os.environ, "NO_COLOR": "1", **({"HAWSER_PROGRESS": "lines"} if progress else {})},
                               start_new_session=True)  # for a second signal, from the terminal, would end it without a result
    out, said, stop = communicate(process, timeout, progress)
    return process.returncode, out, said, stop


def _failure(status: int, said: str) -> Exception:
    lines = said.strip().split("\n")
    begin = max((i for i, line in enumerate(lines) if line.startswith("hawser: ")), default=0)
    message = " ".join(line.strip() for line in lines[begin:])
    prefix = "hawser: "
    code = 128 - status if status < 0 else status
    return exit_error(code, message[len(prefix):] if message.startswith(prefix) else message or f"exit status {code}")
