"""Pictures with matplotlib, in the style of the program's own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import re
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple, Union

import numpy as np

from .errors import Status, error
from .pictures import PICTURES, Panel, Picture

if TYPE_CHECKING:
    from .models import Modes, Response, Statics
    from .results import Result

Array = np.ndarray[Any, Any]
_LINES, _LEGEND, _PANELS = 24, 8, 6  # at most: lines of a panel, of its legend, panels of a sweep
MARKS = {"fold": "s", "branch-point": "o", "period-doubling": "D", "torus": "^"}  # of events
# The colours of src/output/drawing/style.c, in its order, told apart by people who do not see red or green.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8a8a8a"]
STYLE: Dict[str, Any] = {
    "font.family": "sans-serif", "font.size": 9.0, "axes.edgecolor": "#404040", "axes.labelcolor": "#202020",
    "axes.grid": True, "grid.color": "#d8d8d8", "grid.linestyle": "-", "grid.linewidth": 0.5,
    "axes.spines.top": False, "axes.spines.right": False, "xtick.color": "#404040", "ytick.color": "#404040",
    "lines.linewidth": 1.4, "lines.markersize": 3.5, "legend.frameon": False, "figure.figsize": (6.3, 3.9),
    "figure.constrained_layout.use": True, "savefig.dpi": 150,
}
@contextmanager
def _drawing(ax: Any, panels: int = 1, first: float = 1.0) -> Iterator[List[Any]]:
    """The axes, or new ones below each other, in the style; new ones are closed if drawing fails. The first is so many times
    as high as the others."""
    import matplotlib.pyplot as pyplot

    # outside the context: the first figure chooses the backend, which the end of the context would undo
    width, height = STYLE["figure.figsize"]
    size = (width, height * (1.0 if panels == 1 else 0.6 * panels + 0.6 * (first - 1.0)))
    figure = None if ax is not None else pyplot.figure(figsize=size, constrained_layout=True)
    try:
        with pyplot.rc_context(STYLE):
            places = [] if figure is None else figure.add_gridspec(panels, 1, height_ratios=[first] + [1.0] * (panels - 1))
            axes = [ax] if figure is None else [figure.add_subplot(place) for place in places]
            if figure is not None:
                for one in axes:
                    one.set_prop_cycle(color=COLOURS)
            yield axes
    except BaseException:
        if figure is not None:
            pyplot.close(figure)
        raise


def curve(ax: Any, x: Array, y: Array, stable: Any = None, **keywords: Any) -> Any:
    """A line that is dashed where it is not stable."""
    line = ax.plot(x, y if stable is None else np.where(stable, y, np.nan), **keywords)[0]
    if stable is not None and not np.all(stable):
        unstable = ~np.asarray(stable, bool)
        dashed = unstable.copy()
        dashed[:-1] |= unstable[1:]  # with the points beside, so that no gap is left
        dashed[1:] |= unstable[:-1]
        ax.plot(x, np.where(dashed, y, np.nan), color=line.get_color(), linestyle=(0, (4, 2)),
                linewidth=0.8 * line.get_linewidth(), zorder=line.get_zorder() - 0.1)
    return line


def result(of: "Result", x: Optional[str] = None, y: Union[str, Sequence[str], None] = None, ax: Any = None) -> Any:
    """The picture of a result (hawser.pictures), or columns y over column x. Unstable motions are dashed. Returns the
    first of the axes; those of further panels are in its figure."""
    if x is not None or y is not None:
        return _draw(of, (_chosen(of, x, y),), ax)
    for picture in PICTURES.get(of.command, []):
        if isinstance(picture, str):
            axes = _OWN[picture](of, ax)
            if axes is not None:
                return axes
        elif _fits(of, picture[0]):
            return _draw(of, tuple(panel for panel in picture if _fits(of, panel)), ax)
    raise error(Status.ARGUMENT, f"hawser {of.command} with this table has no picture: name the columns, such as plot("
                     f"{', '.join(repr(key) for key in of.keys[:2])})" if of.keys else
                     f"hawser {of.command} has no table to draw")


def _chosen(of: "Result", x: Optional[str], y: Union[str, Sequence[str], None]) -> Panel:
    """A panel of the columns that the caller names."""
    wanted = [y] if isinstance(y, str) else list(y or ())
    across = x or (_first(of, PICTURES.get(of.command, [])) or of.keys[:1] or [""])[0]
    missing = [name for name in [across] + wanted if not of.find(name)]
    if missing or not wanted:
        raise error(Status.ARGUMENT, (f"no column {', '.join(missing)} in the table of {of.command}" if missing else "give the column y")
                         + f": it has {', '.join(of.keys)}")
    return Panel(across, " ".join(wanted), by="curve branch sweep tori extreme backbone", stable="stable")


def _first(of: "Result", pictures: Sequence[Picture]) -> "List[str]":
    """The column x of the first picture that this table has."""
    return next((of.find(p[0].x)[:1] for p in pictures if not isinstance(p, str) and p[0].x and _fits(of, p[0])), [])


def _paths(of: "Result", panel: Panel) -> "List[List[str]]":
    """The coordinates of the paths that the table has."""
    paths = [of.find(three) for three in panel.space.split(",")]
    return [path for path in paths if len(path) >= 2]


def _columns(of: "Result", panel: Panel) -> "List[List[str]]":
    """The columns of each pattern of y."""
    for names in [panel.y] if isinstance(panel.y, str) else panel.y:
        found = [of.find(name) for name in names.split()]
        if any(found):
            return found
    return []


def _fits(of: "Result", panel: Panel) -> bool:
    if panel.space:
        return bool(_paths(of, panel))
    if panel.x.startswith("+") and not of.find((panel.by or panel.colour).split()[0]):
        return False  # a column without a name of its own is known by others
    return bool(of.find(panel.x) and any(_columns(of, panel)))


def _draw(of: "Result", panels: Sequence[Panel], ax: Any) -> Any:
    first = 2.0 if panels[0].space and len(_shown(of, panels[0])) == 3 else 1.0
    with _drawing(ax, 1 if ax is not None else len(panels), first) as axes:
        drawn = [(_space if panel.space else _panel)(of, panel, one) for panel, one in zip(panels, axes)]
    return drawn[0]


def groups(of: "Result", by: str) -> "List[Tuple[Tuple[Any, ...], Array]]":
    """The rows [bool] of each combination of values of these columns, in the order of the table."""
    columns = [of.table[name] for name in of.find(by)]
    if not columns:
        return [((), np.ones(len(of.table), bool))]
    rows = list(zip(*(column.tolist() for column in columns)))
    wanted = dict.fromkeys(tuple("" if v != v else v for v in row) for row in rows)
    plain = [tuple("" if v != v else v for v in row) for row in rows]
    return [(key, np.array([row == key for row in plain])) for key in wanted]


def _stability(of: "Result", panel: Panel) -> Optional[Array]:
    """[rows] where a motion is stable, as far as it is known."""
    names = of.find(panel.stable.rstrip("<")) if panel.stable else []
    if not names:
        return None
    value = of.table[names[0]]
    if not panel.stable.endswith("<"):
        return ~(value <= 0)
    size = [np.nanmax(np.abs(of.table[name])) for name in of.find("im")]  # of eigenvalues, of which re has round-off
    return ~(value > 1e-9 * max(size, default=0.0))


def _panel(of: "Result", panel: Panel, axes: Any) -> Any:
    x, patterns = of.find(panel.x)[0], _columns(of, panel)
    names = [name for found in patterns for name in found][:_LINES]
    hue = of.find(panel.colour)[:1]
    hues = list(dict.fromkeys(of.table[hue[0]].tolist())) if hue else [""]
    stable, bars, seen = _stability(of, panel), of.find(panel.bars), {"_"}
    for _, rows in groups(of, f"{panel.by} {panel.colour}"):
        value = of.table[hue[0]][rows].tolist()[0] if hue else ""
        turn = hues.index(value) if value in hues else 0
        for i, name in enumerate(names):
            y = np.abs(of.table[name][rows]) if panel.size else of.table[name][rows]
            if not np.any(np.isfinite(y)):
                continue
            group = next(j for j, found in enumerate(patterns) if name in found)
            number = re.search(r"_(\d+)", of.key(name)) if len(patterns[group]) > 1 else None  # of a mode
            place = group if panel.labels else int(number[1]) - 1 if number else i
            label = panel.labels[group] if panel.labels else _label(of, name, hue, value, len(names))
            tori = [column for column in of.find("tori") if of.table[column][rows][0] > 0]
            label += ", tori" if tori else ""
            _line(axes, panel, of.table[x][rows], y, None if stable is None else stable[rows],
                  of.table[bars[0]][rows] if bars else None, open_=len(names) > 1 and turn % 2 == 1,
                  color=COLOURS[(turn if hue and len(names) == 1 else place) % len(COLOURS)], label="_" if label in seen else label,
                  linewidth=STYLE["lines.linewidth"] * (0.7 if tori or panel.labels and group else 1.0))
            seen.add(label)
    _special(of, panel, axes, x, names)
    _finish(of, panel, axes, x, names)
    return axes


def _finish(of: "Result", panel: Panel, axes: Any, x: str, names: "List[str]") -> None:
    """Scales, titles, legend, names below the axis."""
    if "x" in panel.log:
        axes.set_xscale("log")
    if "y" in panel.log:
        axes.set_yscale("log")
    axes.set_xlabel(_title(of, [x], panel.across))
    axes.set_ylabel(_title(of, names, panel.up))
    if 1 < sum(not label.startswith("_") for label in axes.get_legend_handles_labels()[1]) <= _LEGEND:
        axes.legend(fontsize="small")
    if of.table.dtype[x].kind == "U":
        axes.tick_params(axis="x", rotation=90 if len(set(of.table[x])) > 6 else 20)
    elif of.key(x) == "index":
        axes.xaxis.get_major_locator().set_params(integer=True)


def _line(axes: Any, panel: Panel, x: Array, y: Array, stable: Optional[Array], bars: Optional[Array], open_: bool,
          **keywords: Any) -> None:
    """A curve, or points: open ones where a motion is unstable, or where others have the same colour."""
    if bars is not None:
        axes.errorbar(x, y, bars, fmt="o", **keywords)
        return
    if not panel.points:
        curve(axes, x, y, stable, **keywords)
        return
    full = np.full(len(y), not open_) if stable is None else stable
    for part, fill in ((full, keywords["color"]), (~full, "white")):
        if np.any(part):
            axes.plot(x[part], y[part], "o", markerfacecolor=fill, **keywords)
            keywords["label"] = "_"


def _label(of: "Result", name: str, hue: "List[str]", value: Any, names: int) -> str:
    key = of.key(name)
    if not hue:
        return key
    word = f"{value:g}" if isinstance(value, float) else str(value)
    column = of.key(hue[0])
    word = word if of.table.dtype[hue[0]].kind == "U" else f"{column} {word}"
    return word if names == 1 else f"{key}, {word}"


def _special(of: "Result", panel: Panel, axes: Any, x: str, names: "List[str]") -> None:
    """Special points: those whose word differs from that of the others, places of the JSON, or the events of a response."""
    seen = set()
    if panel.special and of.find(panel.special):
        word = of.table[of.find(panel.special)[0]]
        words, counts = np.unique(word, return_counts=True)
        for k, kind in enumerate(w for w in words if w != words[counts.argmax()]):
            axes.plot(of.table[x][word == kind], of.table[names[0]][word == kind], linestyle="", marker="os^Dv*"[k % 6],
                      color="#202020", label=kind)
    for place, kind in panel.marks(of.json):
        axes.axvline(place, color="#8a8a8a", linewidth=0.8, zorder=0, label="_" if kind in seen else kind)
        seen.add(kind)
    for kind, places in (events(of) if panel.stable == "stable" else {}).items():
        marker = MARKS.get(kind, "x")
        for name in names:
            at = np.array([[_between(of.table[column], row, share) for column in (x, name)] for row, share in places])
            axes.plot(at[:, 0], at[:, 1], linestyle="", marker=marker, color="#202020", markerfacecolor="white", zorder=3,
                      label=kind if name == names[0] else "_")


def _between(column: Array, row: int, share: float) -> float:
    """A value between this row and the next."""
    last = min(row + 1, len(column) - 1)
    return float(column[row] + share * (column[last] - column[row]))


def events(of: "Result") -> "Dict[str, List[Tuple[int, float]]]":
    """The special points of a response: of each kind the rows of the table after which they are, and the share of the way
    to the next row."""
    found: Dict[str, List[Tuple[int, float]]] = {}
    if of.command != "frf" or "points" not in of.json:
        return found
    for number, branch in enumerate([of.json] + of.json.get("branches", []), 1):
        rows = np.flatnonzero(_of_branch(of, number))
        points = branch.get("points", [])
        for event in branch.get("events", []):
            key = "parameter" if "parameter" in event else "Omega"
            at = min(max(int(event.get("after", 0)), 0), min(len(points), len(rows)) - 1)
            pair = [point.get(key, 0.0) for point in points[at:at + 2]]
            gap = pair[-1] - pair[0]
            share = min(max((event[key] - pair[0]) / gap, 0.0), 1.0) if gap else 0.0
            found.setdefault(event["kind"], []).append((int(rows[at]), share))
    return found


def _of_branch(of: "Result", number: int) -> Array:
    """[rows] of the curve of a branch."""
    mine = np.full(len(of.table), number == 1 or "branch" in of.names)
    if "branch" in of.names:
        mine &= of.table["branch"] == number
    for other in ("sweep", "tori", "backbone"):
        if other in of.names:
            mine &= ~(np.abs(of.table[other]) > 0)
    return mine


def _title(of: "Result", names: "List[str]", given: str) -> str:
    """A title with its unit: the one given, or those of the columns."""
    units = list(dict.fromkeys(of.unit(name) for name in names))
    titles = list(dict.fromkeys(of.title(name) for name in names))
    own = of.columns[of.names.index(names[0])]["title"] if len(names) == 1 else ""
    over = of.json.get("over")
    if isinstance(over, dict) and [of.key(name) for name in names] == ["parameter"]:
        own, units = over.get("key", own), [over.get("unit", "")]
    given = str(of.json.get(given[1:], "")) if given.startswith("$") else given[:1].upper() + given[1:]
    title = own or given or ", ".join(titles[:3])
    return f"{title} ({units[0]})" if len(units) == 1 and units[0] not in ("", "1") else title


def _shown(of: "Result", panel: Panel) -> "List[int]":
    """The coordinates in which paths extend: two where they lie in a plane."""
    paths = _paths(of, panel)
    ends = [[(np.nanmin(of.table[name]), np.nanmax(of.table[name])) for name in path] for path in paths]
    extent = [max(end[c][1] for end in ends) - min(end[c][0] for end in ends) for c in range(len(paths[0]))]
    shown = [c for c in range(len(extent)) if extent[c] > 0.02 * max(extent)] or [0, 1]
    if len(shown) == 1:
        shown = sorted({shown[0], 1 if shown[0] != 1 else 0})
    return shown


def _space(of: "Result", panel: Panel, axes: Any) -> Any:
    """Paths: in a plane where they lie in one, else in space."""
    paths, shown = _paths(of, panel), _shown(of, panel)
    if len(shown) == 3:
        axes = _in_space(axes)
    for i, path in enumerate(paths):
        for j, (key, rows) in enumerate(groups(of, panel.by)):
            label = panel.labels[i] if panel.labels else " ".join(str(v) for v in key)
            coordinates = [of.table[path[c]][rows] for c in shown]
            if axes.name == "3d":  # the axis y of hawser points up
                coordinates = [coordinates[0], coordinates[2], coordinates[1]]
            axes.plot(*coordinates, label=label or "_", color=COLOURS[(i + j) % len(COLOURS)] if j < _LINES else COLOURS[0])
    titles = [_title(of, [paths[0][c]], "xyz"[c] if panel.labels else "") for c in shown]
    if axes.name == "3d":
        axes.set_xlabel(titles[0])
        axes.set_ylabel(titles[2])
        axes.set_zlabel(titles[1])
    else:
        axes.set_xlabel(titles[0])
        axes.set_ylabel(titles[1])
    if 1 < len(paths) * len(groups(of, panel.by)) <= _LINES:
        axes.legend(fontsize="small", loc="upper left" if axes.name == "3d" else "best")
    return axes


def _in_space(axes: Any) -> Any:
    """The same place in the figure, with axes in space."""
    figure, place = axes.figure, axes.get_subplotspec()
    if axes.name == "3d" or place is None or axes.lines:
        return axes
    axes.remove()
    return figure.add_subplot(place, projection="3d")


def _shapes(of: "Result", ax: Any) -> Any:
    """Of each mode the largest component of its shape."""
    across = of.find("S")
    modes = dict.fromkeys(key.split("_", 1)[1] for key in of.keys if re.fullmatch(r"[PQB]_(re_)?\d+", key))
    if not across or not modes:
        return None
    with _drawing(ax) as (axes,):
        for mode in modes:
            name = max((n for c in "PQB" for n in of.find(f"{c}_{mode}")), key=lambda n: float(np.max(np.abs(of.table[n]))))
            word = {"P": "axial", "Q": "normal", "B": "out of plane"}[name[0]]
            for j, (_, rows) in enumerate(groups(of, "lane")):
                axes.plot(of.table[across[0]][rows], of.table[name][rows], color=COLOURS[(int(mode[-1]) - 1) % len(COLOURS)],
                          label="_" if j else f"mode {mode.replace('re_', '')}, {word}")
        axes.set_xlabel(_title(of, across, ""))
        axes.set_ylabel("shape")
        axes.legend(fontsize="small")
    return axes


def _multipliers(of: "Result", ax: Any) -> Any:
    """Floquet multipliers and the unit circle."""
    modulus, argument = (of.table[of.find(name)[0]] for name in ("modulus", "argument"))
    with _drawing(ax) as (axes,):
        turn = np.linspace(0.0, 2.0 * np.pi, 181)
        axes.plot(np.cos(turn), np.sin(turn), color="#8a8a8a", linewidth=0.8)
        axes.plot(modulus * np.cos(argument), modulus * np.sin(argument), "o")
        axes.set_aspect("equal")
        axes.set_xlabel("real part of the multipliers")
        axes.set_ylabel("imaginary part")
    return axes


def _map(of: "Result", ax: Any) -> Any:
    """The mapped quantity as colours over the two parameters; of a multiplier the boundary at 1 as a line."""
    names = of.names
    x, y, values = (of.table[name][np.isfinite(of.table[names[2]])] for name in names[:3])
    with _drawing(ax) as (axes,):
        if len(values) < 3:
            raise error(Status.ARGUMENT, "fewer than three points of the map have a value: there is nothing to draw")
        # of a smooth part the program writes only the corners of blocks of points: triangles fill it
        mesh = axes.tripcolor(x, y, values, shading="gouraud", cmap="cividis")
        if of.key(names[2]) == "multiplier" and values.min() < 1.0 < values.max():
            axes.tricontour(x, y, values, levels=[1.0], colors=COLOURS[1])
        axes.grid(False)
        axes.figure.colorbar(mesh, ax=axes, label=_title(of, names[2:3], ""))
        axes.set_xlabel(_title(of, names[:1], ""))
        axes.set_ylabel(_title(of, names[1:2], ""))
    return axes


def _sweep(of: "Result", ax: Any) -> Any:
    """Each kept number over the first parameter, with a curve for each value of the others."""
    over = [key["column"] for key in of.json["over"]]
    kept = [n for n in of.names if n not in over + ["status"] and of.table.dtype[n].kind == "f"]
    if not kept:
        raise error(Status.ARGUMENT, "no number was kept of the variations: there is nothing to draw")
    panels = tuple(Panel(of.key(over[0]), of.key(name), by=" ".join(of.key(name) for name in over[1:]),
                         colour=of.key(over[1]) if len(over) > 1 else "") for name in kept[:_PANELS])
    return _draw(of, panels, ax)


_OWN: Dict[str, Callable[["Result", Any], Any]] = {
    "shapes": _shapes, "multipliers": _multipliers, "map": _map, "sweep": _sweep}


def profile(of: "Statics", ax: Any = None) -> Any:
    """The static shape, height over distance."""
    rows = of.profile()
    with _drawing(ax) as (axes,):
        axes.plot(rows["x"], rows["y"])
        axes.set_xlabel("x (m)")
        axes.set_ylabel("height (m)")
    return axes


def response(of: "Response", probe: str = "mid", component: str = "z", ax: Any = None) -> Any:
    """The amplitude at a probe over the frequency, in SI; unstable parts are dashed."""
    names = of.model.probes
    if probe not in names or component not in ("x", "y", "z"):
        raise error(Status.ARGUMENT, f"no component {component} at {probe}: there are x, y, z at {', '.join(names)}")
    amplitude = of.probe[:, names.index(probe), "xyz".index(component)] * of.model.length
    with _drawing(ax) as (axes,):
        curve(axes, of.omega_si, amplitude, of.stable)
        axes.set_xlabel("Omega (rad/s)")
        axes.set_ylabel(f"amplitude of {component}, {probe} (m)")
    return axes


def shapes(of: "Modes", ax: Any = None) -> Any:
    """The shapes of modes over the unstretched arclength, each by its largest component."""
    with _drawing(ax) as (axes,):
        for k in range(of.n):
            c = int(np.abs(of.shape[k]).max(axis=0).argmax())
            axes.plot(of.S_si, of.shape[k, :, c], color=COLOURS[k % len(COLOURS)],
                      label=f"mode {k + 1}, {('axial', 'normal', 'out of plane')[c]}, {of.omega_si[k] / (2 * np.pi):.4g} Hz")
        axes.set_xlabel("Arclength S (m)")
        axes.set_ylabel("shape")
        if of.n <= _LEGEND:
            axes.legend(fontsize="small")
    return axes


class Animation:
    """An animation of matplotlib (`animation`), which notebooks show as a player."""

    def __init__(self, animation: Any) -> None:
        self.animation = animation

    def _repr_html_(self) -> str:
        return str(self.animation.to_jshtml())

    def save(self, path: str, **keywords: Any) -> None:
        """Write it to a file, such as one named .gif."""
        self.animation.save(path, **keywords)


def mode_motion(of: "Modes", number: int, size: Optional[float] = None, frames: int = 40) -> Animation:
    """A mode over a period: height over distance, or seen from above where it moves across the plane. The largest displacement
    is a twentieth of the length of the chord unless `size` (m) says otherwise."""
    from matplotlib.animation import FuncAnimation

    rest = of.displaced(number, 0.0)
    size = size if size is not None else 0.05 * float(np.sqrt(((rest[-1] - rest[0])**2).sum()))
    moved = of.displaced(number, size) - rest
    across = 2 if np.abs(moved[:, 2]).max() > np.abs(moved[:, :2]).max() else 1
    with _drawing(None) as (axes,):
        axes.plot(rest[:, 0], rest[:, across], color="#8a8a8a", linewidth=0.8)
        line = axes.plot(rest[:, 0], rest[:, across])[0]
        axes.set_ylim(rest[:, across].min() - 1.1 * size, rest[:, across].max() + 1.1 * size)
        axes.set_xlabel("Distance x (m)")
        axes.set_ylabel("Height y (m)" if across == 1 else "Across the plane z (m)")
        axes.set_title(f"mode {number}, {of.omega_si[number - 1] / (2 * np.pi):.4g} Hz", fontsize="medium")

    def show(frame: int) -> Any:
        place = rest + moved * np.cos(2.0 * np.pi * frame / frames)
        line.set_data(place[:, 0], place[:, across])
        return (line,)

    return Animation(FuncAnimation(axes.figure, show, frames=frames, interval=50, blit=True))
