"""Pictures with matplotlib, in the style of the program's own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Optional, Union

import numpy as np

if TYPE_CHECKING:
    from .models import Response, Statics
    from .results import Result

# The colours of src/output/drawing/style.c, in its order, told apart by people who do not see red or green.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8a8a8a"]
STYLE: Dict[str, Any] = {
    "font.family": "sans-serif", "font.size": 9.0, "axes.edgecolor": "#404040", "axes.labelcolor": "#202020",
    "axes.grid": True, "grid.color": "#d8d8d8", "grid.linestyle": "-", "grid.linewidth": 0.5,
    "axes.spines.top": False, "axes.spines.right": False, "xtick.color": "#404040", "ytick.color": "#404040",
    "lines.linewidth": 1.4, "lines.markersize": 3.5, "legend.frameon": False, "figure.figsize": (6.3, 3.9),
    "figure.constrained_layout.use": True, "savefig.dpi": 150,
}
# What is drawn over what, where the caller does not say: columns by the beginning of their names.
_AXES = {
    "frf": ("Omega", ["z_mid", "y_mid"]), "statics": ("x", ["y"]), "integrate": ("t", ["y_mid", "z_mid"]),
    "modes": ("index", ["frequency"]),
}
_SHARED = {"frf": "amplitude", "integrate": "displacement"}
_UNITS = ("rad_s2", "rad_s", "m_s2", "m_s", "Nm", "Hz", "kg", "rad", "N", "m", "s", "J", "K")


@contextmanager
def _drawing(ax: Any) -> Iterator[Any]:
    """The axes, or new ones, in the style; new ones are closed if drawing fails."""
    import matplotlib.pyplot as pyplot

    # outside the context: the first figure chooses the backend, which the end of the context would undo
    figure = None if ax is not None else pyplot.figure(figsize=STYLE["figure.figsize"], constrained_layout=True)
    try:
        with pyplot.rc_context(STYLE):
            axes = ax if figure is None else figure.add_subplot()
            if figure is not None:
                axes.set_prop_cycle(color=COLOURS)
            yield axes
    except BaseException:
        if figure is not None:
            pyplot.close(figure)
        raise


def title(column: str) -> str:
    """The title of an axis: "z_mid_m" is "z_mid (m)", "Omega_rad_s" is "Omega (rad/s)"."""
    for unit in _UNITS:
        if column.endswith("_" + unit) and len(column) > len(unit) + 1:
            shown = unit.replace("_", "/").replace("s2", "s²")
            return f"{column[:-len(unit) - 1]} ({shown})"
    return column


def _find(names: List[str], wanted: str) -> Optional[str]:
    """The column of that name, with or without its unit."""
    return next((n for n in names if n == wanted or title(n).split(" (")[0] == wanted), None)


def curve(ax: Any, x: "np.ndarray[Any, Any]", y: "np.ndarray[Any, Any]", stable: Any = None,
          **keywords: Any) -> None:
    """A line that is dashed where it is not stable."""
    line = ax.plot(x, y if stable is None else np.where(stable, y, np.nan), **keywords)[0]
    if stable is not None and not np.all(stable):
        unstable = ~np.asarray(stable, bool)
        dashed = unstable.copy()
        dashed[:-1] |= unstable[1:]  # with the points beside, so that no gap is left
        dashed[1:] |= unstable[:-1]
        ax.plot(x, np.where(dashed, y, np.nan), color=line.get_color(), linestyle=(0, (4, 2)),
                linewidth=0.8*line.get_linewidth(), zorder=line.get_zorder() - 0.1)


def result(of: "Result", x: Optional[str] = None, y: Union[str, List[str], None] = None, ax: Any = None) -> Any:
    """Columns y over column x of a result's table. Unstable parts of a response are dashed."""
    with _drawing(ax) as axes:
        return _result(of, x, y, axes)


def _result(of: "Result", x: Optional[str], y: Union[str, List[str], None], axes: Any) -> Any:
    if x is None and y is None and of.command in _OWN:
        return _OWN[of.command](of, axes)
    names = of.names
    numbers = [n for n in names if of.table.dtype[n].kind == "f"]
    if len(numbers) < 2:
        raise ValueError(f"the table of {of.command} has no two columns of numbers to draw")
    default = _AXES.get(of.command, (numbers[0], numbers[1:2]))
    across = _find(names, x or default[0]) or (numbers[0] if x is None else None)
    wanted = [y] if isinstance(y, str) else y or default[1]
    up = [_find(names, w) for w in wanted]
    if y is None:
        others: List[Optional[str]] = [n for n in numbers if n != across]
        up = [u for u in up if u] or others[:1]
    missing = [w for w, found in zip([x] + list(wanted), [across] + up) if w and not found]
    if across is None or missing:
        raise ValueError(f"no column {', '.join(missing)} in the table of {of.command}: it has {', '.join(names)}")
    stable = of.table["stable"] > 0 if "stable" in names else None
    for name in up:
        if name:
            curve(axes, of.table[across], of.table[name], stable, label=title(name).split(" (")[0])
    axes.set_xlabel(title(across))
    units = {title(name or "").partition(" (")[2].rstrip(")") for name in up}
    axes.set_ylabel(title(up[0] or "") if len(up) == 1 else f"{_SHARED.get(of.command, '')} ({units.pop()})" if len(units) == 1 else "")
    if len(up) > 1:
        axes.legend()
    return axes


def _irvine(of: "Result", axes: Any) -> Any:
    """Branches of frequencies along a sweep; those out of the plane are dashed."""
    names = of.names
    for name in names:
        if name.startswith(("in_", "out_")):
            axes.plot(of.table[names[0]], of.table[name], color=COLOURS[int(name.startswith("out_"))],
                      linestyle=(0, (4, 2)) if name.startswith("out_") else "-")
    axes.set_xscale("log")
    axes.set_xlabel(title(names[0]))
    axes.set_ylabel("normalised frequency (in the plane; dashed: out of it)")
    return axes


def _campbell(of: "Result", axes: Any) -> Any:
    """Frequencies over the speed."""
    for plane, colour, line in (("in", COLOURS[0], "-"), ("out", COLOURS[1], (0, (4, 2)))):
        rows = of.table[of.table["plane"] == plane]
        for branch in np.unique(rows["branch"]):
            part = rows[rows["branch"] == branch]
            axes.plot(part["speed_m_s"], part["im_rad_s"], color=colour, linestyle=line)
    axes.set_xlabel("speed (m/s)")
    axes.set_ylabel("frequency (rad/s) (in the plane; dashed: out of it)")
    return axes


def _map(of: "Result", axes: Any) -> Any:
    """The mapped quantity as colours over the two parameters; of a multiplier the boundary at 1 as a line."""
    names = of.names
    x, y, values = (of.table[name][np.isfinite(of.table[names[2]])] for name in names[:3])
    # of a smooth part the program writes only the corners of blocks of points: triangles fill it
    mesh = axes.tripcolor(x, y, values, shading="gouraud", cmap="cividis")
    if names[2] == "multiplier" and values.min() < 1.0 < values.max():
        axes.tricontour(x, y, values, levels=[1.0], colors=COLOURS[1])
    axes.grid(False)
    axes.figure.colorbar(mesh, ax=axes, label=title(names[2]))
    axes.set_xlabel(title(names[0]))
    axes.set_ylabel(title(names[1]))
    return axes


_OWN: Dict[str, Callable[["Result", Any], Any]] = {"irvine": _irvine, "campbell": _campbell, "map": _map}


def profile(of: "Statics", ax: Any = None) -> Any:
    """The static shape, height over distance."""
    rows = of.profile()
    with _drawing(ax) as axes:
        axes.plot(rows["x"], rows["y"])
        axes.set_xlabel("x (m)")
        axes.set_ylabel("height (m)")
    return axes


def response(of: "Response", probe: str = "mid", component: str = "z", ax: Any = None) -> Any:
    """The amplitude at a probe over the frequency, in SI; unstable parts are dashed."""
    names = of.model.probes
    if probe not in names or component not in ("x", "y", "z"):
        raise ValueError(f"no component {component} at {probe}: there are x, y, z at {', '.join(names)}")
    amplitude = of.probe[:, names.index(probe), "xyz".index(component)] * of.model.length
    with _drawing(ax) as axes:
        curve(axes, of.omega_si, amplitude, of.stable)
        axes.set_xlabel("Omega (rad/s)")
        axes.set_ylabel(f"amplitude of {component}, {probe} (m)")
    return axes
