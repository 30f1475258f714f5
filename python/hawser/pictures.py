"""Which picture shows the result of which command.

A command has a list of pictures, and its result is drawn as the first one whose columns the table has. Titles and units are
those of the program (result.columns), so that --units is obeyed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Sequence, Tuple, Union


@dataclass(frozen=True)
class Panel:
    """Columns over a column. Columns are named by their keys, or by patterns such as "u_*"; "kind+1" is the column behind
    `kind`, and "+1" the first one."""
    x: str = ""  # alternatives are separated by blanks: the first that there is
    y: Union[str, Sequence[str]] = ""  # names separated by blanks; of several such texts the first of which the table has one
    by: str = ""       # columns whose values are curves of their own
    colour: str = ""   # the column that chooses the colour; else the columns of y do
    stable: str = ""   # the column that is above 0 where a motion is stable; "unstable<": stable where it is not above 0
    log: str = ""      # logarithmic axes
    points: bool = False
    size: bool = False  # absolute values
    bars: str = ""     # half the height of error bars
    special: str = ""  # the column whose value is the same on a curve, but not at special points
    marked: str = ""   # a list of the JSON and the place that its objects have on the axis x, for vertical lines
    across: str = ""   # titles, "$key" of the JSON, where those of the columns would not do
    up: str = ""
    labels: Tuple[str, ...] = ()  # of the patterns of y, or of paths
    space: str = ""    # instead of x and y: the coordinates of a path, or those of several, separated by commas

    def marks(self, data: Dict[str, Any]) -> List[Tuple[float, str]]:
        """Where vertical lines are, and the kind of each."""
        name, _, place = self.marked.partition(" ")
        return [(one[place], one["kind"]) for one in data.get(name, []) if place in one]


Picture = Union[str, Tuple[Panel, ...]]  # the name of a function of hawser.plots, or panels below each other
_DISPLACED, _PLACES = ("y_mid z_mid", "y_* z_*", "u_*"), ("end_[xyz]", "*_[xyz]")
_RESPONSE = ("y_mid z_mid", "y_* z_*", "x_* y_* z_*", "u_*")
_TRACK = (Panel("+1", ("frequency", "omega"), by="branch", colour="plane", up="frequency"),)
_INDEX = (Panel("index", ("frequency", "omega"), colour="plane", points=True, across="mode", up="frequency"),)
_MOTION = [(Panel("frequency", _DISPLACED, log="y", across="frequency", up="amplitude"),),
           (Panel("t", _DISPLACED, up="displacement"),),
           (Panel("t", "*_x", up="x"), Panel("t", "*_y", up="y"), Panel("t", "*_z", up="z"), Panel("t", "*_T", up="tension")),
           (Panel("t", _PLACES, up="place"),)]
_FRF = (Panel("parameter Omega", ("a",) + _RESPONSE, by="branch sweep tori extreme backbone", stable="stable", up="amplitude"),)


def _names(x: str, y: str, up: str = "") -> Tuple[Panel, ...]:
    """Values of named things."""
    return (Panel(x, y, colour="lane", points=True, up=up),)


PICTURES: Dict[str, List[Picture]] = {
    "statics": [
        (Panel(space="x y z", by="cable lane"), Panel("S s", "T", by="cable lane", colour="lane", up="tension")),
        _names("tower", "T_in T_out", "tension"), _names("tower", "T_max T_min", "tension"),
        _names("span", "T_from T_to", "tension"), _names("case", "T0 T1", "tension"), _names("case", "T_max T_min", "tension"),
        _names("cable", "T_max T_min", "tension"),
        (Panel("model", "error_H error_T0 error_T1 error_sag", points=True, log="y", size=True, up="error, relative"),),
        (Panel("H", "length0"), Panel("H", "sag")),
        (Panel("speed", "T0 T1 H", by="hold state", up="tension"), Panel("speed", "sag", by="hold state")),
        (Panel("index", "energy", points=True, stable="unstable<"),)],
    "modes": ["shapes", (Panel("value", "damping_ratio", by="plane number", colour="plane", across="$over"),), _TRACK, _INDEX],
    "irvine": [
        (Panel("irvine_source", "in_* out_*", log="x", across="Irvine's parameter λ", up="frequency",
               labels=("in the plane", "out of it"), marked="crossovers irvine_source"),), _TRACK],
    "campbell": [(Panel("speed", "im", by="plane branch", colour="plane", stable="re<", up="frequency"),), _TRACK],
    "beam": [
        (Panel("speed", "im_*", up="imaginary part", marked="events speed"),
         Panel("speed", "re_*_high re_*_low", up="real part", marked="events speed")),
        (Panel("boundary+1", "speed", by="boundary piece", colour="boundary"),),
        (Panel("time", "y"),), (Panel("re", "im", by="number", points=True, across="real part", up="imaginary part"),)],
    "integrate": [*_MOTION],
    "orbit": [*_MOTION],
    "transient": [
        (Panel("t", "speed wheel", up="speed"), Panel("t", "force motor", up="force"),
         Panel("t", "T_up T_down T_bottom_up", up="tension"), Panel("t", "travel", up="travel of the carriage"), Panel("t", "pressing", up="least pressing force")),
        (Panel("t", "T_in T_out", up="tension"), Panel("t", "pressing", up="pressing force")),
        _names("span", "T_max T_min", "tension"), _names("tower", "T_max T_min", "tension")],
    "trajectory": [(Panel(space="x y z"),)],
    "tow": [(Panel(space="top_x top_y top_z, body_x body_y body_z", labels=("towing point", "body")),
             Panel("t", "tilt"), Panel("t", "tension_top tension_end", up="tension"))],
    "tow steady": [(Panel(space="x y z"), Panel("s", "T"))],
    "frf": [(Panel("Omega", ("amplitude", "T"), by="component coordinate", colour="component", points=True),), _FRF],
    "mms": [_FRF],
    "folds": [(Panel("Omega", "load_factor", by="curve", colour="curve", special="kind"),)],
    "locus": [(Panel("Omega", "parameter", by="curve", colour="curve", special="kind", up="$key"),)],
    "nnm": [(Panel("energy", "Omega", by="curve", stable="unstable<", log="x"),)],
    "hill": [(Panel("kind+1", "kind+2", by="boundary", colour="kind"),), "multipliers"],
    "map": [(Panel("+1", "+2", points=True, colour="along"),), "map"],
    "sweep": ["sweep"],
    "compare": [
        (Panel("Omega", "size", colour="fidelity", points=True),),
        (Panel("processor_s", "distance", colour="fidelity", points=True, log="xy", across="processor time (s)", up="error of the response, relative"),)],
    "compare modes": [(Panel("time_s", "frequency_error", by="method", colour="method", points=True, log="xy",
                             across="time (s)", up="error of the frequencies, relative"),)],
    "compare mms": [(Panel("e", "Omega_distance", by="mark", colour="mark", points=True, log="xy"),)],
    "compare motion": [_names("model", "max_*", "largest displacement")],
    "identify": [(Panel("measured", "difference", colour="plane", points=True, bars="deviation",
                        across="measured frequency", up="computed/measured − 1"),)],
}
