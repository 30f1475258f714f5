"""hawser.sweep: a command over variations of a scene, as a frame or a grid.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import warnings
from typing import Any, List, Mapping, Optional, Sequence

from . import scenes
from ._interrupts import Progress
from .errors import Status, error
from .results import Result, _options, _run


def _values(key: str, values: Any) -> str:
    """KEY=VALUES of --over: a text is one already, such as "60 kN:100 kN:9"; else the values themselves."""
    if isinstance(values, str):
        return f"{key}={values}"
    listed = [value if isinstance(value, str) else scenes.flow(value) for value in values]
    if not listed:
        raise error(Status.ARGUMENT, f"{key} has no values: give a range such as \"60 kN:100 kN:9\", or a list")
    return f"{key}={','.join(listed)}"


def sweep(scene: scenes.SceneLike, over: Mapping[str, Any], command: str = "statics", keep: Optional[Sequence[str]] = None,
          rows: Optional[str] = None, grid: bool = False, set: Optional[Mapping[str, Any]] = None,
          threads: Optional[int] = None, progress: Progress = None, **options: Any) -> Any:
    """Run a command for each combination of values, {"tension.T0": "60 kN:100 kN:9", "cable.rho": [5, 6]}, and return a pandas
    frame of the varied keys, the exit status and the results that are kept; its `attrs` have the units of the columns and the
    failures, each with its message, of which a warning tells. `rows` chooses the rows of a variation ("values", "table", "peaks" ...), as hawser-sweep(1)
    says. With `grid` an xarray dataset whose dimensions are the keys; `progress` as in hawser.run. Further options are those of the command."""
    result = run_sweep(scene, over, command, keep, rows, set, threads, options, progress)
    frame = result.frame()
    frame.attrs = {"units": {name: result.unit(name) for name in result.names}, "failures": result.json["failures"]}
    if frame.attrs["failures"]:
        warnings.warn(result.warnings.replace("hawser: ", "", 1) or "some variations have no result", stacklevel=2)
    return _grid(result, frame) if grid else frame


def run_sweep(scene: scenes.SceneLike, over: Mapping[str, Any], command: str, keep: Optional[Sequence[str]],
              rows: Optional[str], set: Optional[Mapping[str, Any]], threads: Optional[int],
              options: Mapping[str, Any], progress: Progress = None) -> Result:
    """The same as a Result, which has a picture."""
    kept = [keep] if isinstance(keep, str) else keep
    own = {"over": [_values(key, values) for key, values in over.items()], "keep": ",".join(kept) if kept else None,
           "rows": rows, "j": threads}
    return _run("sweep", scene, [], set, None, own, ["--"] + command.split() + _options(options), progress)


def _grid(result: Result, frame: Any) -> Any:
    """The frame with an axis for each varied key."""
    try:
        import xarray  # optional: asked for by name
    except ImportError:
        raise error(Status.PROGRAM, "a grid needs xarray: install it, or leave out grid=True for a frame") from None
    keys: List[str] = [key["column"] for key in result.json["over"]]
    if frame.duplicated(keys).any():
        raise error(Status.ARGUMENT, "a grid has one row for each variation, and here are several: choose one with "
                                     "rows=\"values\" or max=COLUMN")
    dataset = xarray.Dataset.from_dataframe(frame.set_index(keys))
    for name in result.names:
        dataset[name].attrs["units"] = result.unit(name)
    return dataset
