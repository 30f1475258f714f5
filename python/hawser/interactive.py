"""Pictures with plotly, whose values the pointer shows and which zoom: those of hawser.plots, curve by curve.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, Dict, List, Optional

import numpy as np

from .errors import Status, error

_SYMBOLS = {"s": "square", "o": "circle", "D": "diamond", "^": "triangle-up", ".": "circle", "x": "x", "+": "cross"}


def _numbers(values: Any) -> List[Optional[float]]:
    return [float(value) if np.isfinite(value) else None for value in np.asarray(values, float)]


def _look(line: Any) -> Dict[str, Any]:
    """Mode, colour, dashes and symbol of a line of matplotlib."""
    from matplotlib.colors import to_hex

    drawn, marked = line.get_linestyle() not in ("None", "", " "), line.get_marker() not in ("None", "", None)
    colour = to_hex(line.get_color())
    dash = "solid" if line.get_linestyle() == "-" and not line.is_dashed() else "dash"
    return {"mode": "+".join(["lines"] * drawn + ["markers"] * marked), "line": {"color": colour, "dash": dash},
            "marker": {"color": colour, "symbol": _SYMBOLS.get(str(line.get_marker()), "circle")}}


def _trace(line: Any, place: str) -> Dict[str, Any]:
    label = str(line.get_label())
    named = {"name": "" if label.startswith("_") else label, "showlegend": not label.startswith("_")}
    if hasattr(line, "get_data_3d"):
        x, y, z = line.get_data_3d()
        look = _look(line)
        look["marker"].pop("symbol")  # in space there are others
        return {"type": "scatter3d", "scene": "scene", "x": _numbers(x), "y": _numbers(y), "z": _numbers(z), **named, **look}
    return {"type": "scatter", "x": _numbers(line.get_xdata()), "y": _numbers(line.get_ydata()), "xaxis": "x" + place,
            "yaxis": "y" + place, **named, **_look(line)}


def _points(collection: Any, place: str) -> Dict[str, Any]:
    """The points of a scatter plot."""
    from matplotlib.colors import to_hex

    at = np.asarray(collection.get_offsets(), float)
    return {"type": "scatter", "mode": "markers", "x": _numbers(at[:, 0]), "y": _numbers(at[:, 1]), "xaxis": "x" + place,
            "yaxis": "y" + place, "showlegend": False,
            "marker": {"color": [to_hex(colour) for colour in collection.get_facecolors()] or None}}


def spec(figure: Any) -> Dict[str, Any]:
    """What plotly draws, as it takes it: data and layout. Lines, points and vertical lines of all panels."""
    from matplotlib.collections import PathCollection

    data: List[Dict[str, Any]] = []
    layout: Dict[str, Any] = {"template": {}, "plot_bgcolor": "white", "shapes": []}
    for number, ax in enumerate(figure.axes):
        place = "" if number == 0 else str(number + 1)
        box = ax.get_position()
        for key, axis, low, high in (("x", ax.xaxis, box.x0, box.x1), ("y", ax.yaxis, box.y0, box.y1)):
            layout[f"{key}axis{place}"] = {"title": {"text": axis.get_label_text()}, "type": axis.get_scale(),
                                           "domain": [max(0.0, float(low)), min(1.0, float(high))],
                                           "linecolor": "#404040", "gridcolor": "#d8d8d8", "zeroline": False,
                                           "anchor": ("y" if key == "x" else "x") + place}
        for line in ax.get_lines():
            if hasattr(line, "get_data_3d") or line.get_transform() == ax.transData:
                data.append(_trace(line, place))
            else:  # across the panel
                x = float(line.get_xdata()[0])
                layout["shapes"].append({"type": "line", "x0": x, "x1": x, "xref": "x" + place, "y0": 0, "y1": 1,
                                         "yref": f"y{place} domain", **{"line": _look(line)["line"]}})
        data += [_points(one, place) for one in ax.collections if isinstance(one, PathCollection)]
    if not data:
        raise error(Status.ARGUMENT, "this picture has areas and no curves, which matplotlib draws: call plot()")
    return {"data": data, "layout": layout}


def result(of: Any, x: Optional[str] = None, y: Any = None) -> Any:
    """The picture of a result as a plotly figure."""
    try:
        import plotly.graph_objects as graph  # optional: asked for by name
    except ImportError:
        raise error(Status.PROGRAM, "interactive pictures need plotly: pip install \"hawser[plotly]\", or call plot()") from None
    import matplotlib.pyplot as pyplot

    figure = of.plot(x, y).figure
    figure.canvas.draw()  # for the places of panels
    try:
        return graph.Figure(spec(figure))
    finally:
        pyplot.close(figure)
