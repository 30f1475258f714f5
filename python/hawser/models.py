"""The stages of the library: scene, statics, modes, model, response, motion.

Each object holds the library's own structure. Arrays are views of the library's memory: they are not copied, cannot
be written, and keep that memory alive. Objects are pickled by their scene: what is unpickled is computed again. As in the library they are scaled by the model's units, `length` (m) and
`time` (s), where a name is not in SI; the properties that end in `_si` are converted copies.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import os
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from . import scenes
from ._interrupts import call_apart, ended
from ._library import Owner, call, function, layout, record, struct
from .errors import InputError, Status, error

_ABOVE = 4.0  # modes up to this multiple of the highest kept frequency add to displacements, as in the program


def _names(address: int, count: int) -> "list[str]":
    if not address or count == 0:
        return []
    return [(name or b"").decode() for name in (ctypes.c_char_p * count).from_address(address)]


def _frequency(value: Union[float, str], first: float) -> float:
    """rad/s, or "0.9w1": that many times the first natural frequency."""
    if isinstance(value, str):
        if not value.endswith("w1"):
            raise error(Status.ARGUMENT, f"frequency {value!r}: give a number in rad/s, or a multiple of the first "
                                         "natural frequency such as \"0.9w1\"")
        return float(value[:-2]) * first
    return float(value)


class Scene:
    """A scene of a span, from a file or a nested dict; `set` as the program's --set."""

    def __init__(self, source: scenes.SceneLike, set: Optional[Mapping[str, Any]] = None) -> None:
        changes = scenes.overrides(set)
        texts = (ctypes.c_char_p * len(changes))(*(c.encode() for c in changes))
        self._source, self._set = dict(source) if isinstance(source, Mapping) else source, set
        self._owner = Owner("hawser_scene", "hawser_scene_clear")
        with scenes.as_file(source) as path:
            call("hawser_scene_open", self._owner, os.fsencode(path), texts if changes else None, len(changes))
        if self._owner.beam.form != 0:
            raise error(Status.ARGUMENT, "this scene describes a travelling beam or string: use "
                                         "hawser.run(\"beam\", ...)")

    def __reduce__(self) -> Any:
        return Scene, (self._source, self._set)

    def __getitem__(self, key: str) -> Union[float, str]:
        """The value of a key in SI, such as scene["cable.EA"], or its word."""
        value = ctypes.c_double()
        try:
            call("hawser_scene_get", self._owner, ctypes.addressof(value), key.encode())
        except InputError as failure:
            word = ctypes.create_string_buffer(layout["constants"]["HAWSER_WORD_SIZE"])
            try:
                call("hawser_scene_word", self._owner, ctypes.addressof(word), key.encode())
            except InputError:
                raise failure from None
            return word.value.decode()
        return value.value


class Statics:
    """The static shape. Members of struct hawser_statics are attributes: .H, .T0, .sag (SI), .closure."""

    def __init__(self, scene: Union[Scene, scenes.SceneLike]) -> None:
        self.scene = scene if isinstance(scene, Scene) else Scene(scene)
        self._owner = Owner("hawser_statics")
        call_apart("hawser_statics_scene", self._owner, self.scene._owner)

    def __reduce__(self) -> Any:
        return Statics, (self.scene,)

    def __dir__(self) -> "list[str]":
        return sorted({*super().__dir__(), *(name for name, _, _ in layout["structs"]["hawser_statics"])})

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._owner, name)

    def profile(self, points: int = 101) -> "np.ndarray[Any, Any]":
        """A record array [points] of S, x, y, z (m), T (N), slope, at equal unstretched arclengths."""
        at = function("hawser_statics_actual_at")
        rows = np.zeros(points, record("hawser_profile_point"))
        whole = function("hawser_statics_actual")(self._owner.address).length0
        for i, S in enumerate(np.linspace(0.0, whole, points)):
            point = at(self._owner.address, S)
            ctypes.memmove(rows[i:].ctypes.data, ctypes.addressof(point), rows.itemsize)
        return rows


class Modes:
    """Real modes about a static shape, the lowest n of both planes together (default: the scene's model.modes)."""

    def __init__(self, statics: Union[Statics, Scene, scenes.SceneLike], n: Optional[int] = None, basis: int = 0,
                 tolerance: float = 0.0, method: Optional[str] = None) -> None:
        self.statics = statics if isinstance(statics, Statics) else Statics(statics)
        self._asked = (n, basis, tolerance, method)
        scene = self.statics.scene
        if n is None:
            function("hawser_modes_settle")(scene._owner.address, self.statics._owner.address)
        wanted = scene._owner.model.modes if n is None else n
        if n is None and wanted == layout["constants"]["HAWSER_MODES_AUTO"]:
            raise error(Status.ARGUMENT, "the scene's modes are chosen by themselves (model.modes: auto), which "
                                         "hawser.run does: give the number of modes, n")
        if n is None and not tolerance and function("hawser_scene_written")(scene._owner.address, b"model.tolerance"):
            tolerance = scene._owner.model.tolerance
        self._text = method.encode() if method else None
        options = struct("hawser_modes_options")(n=wanted, basis=basis or scene._owner.model.basis, tolerance=tolerance)
        if self._text:
            options.method = ctypes.cast(ctypes.c_char_p(self._text), ctypes.c_void_p).value
        self._owner = Owner("hawser_modes", "hawser_modes_clear")
        call_apart("hawser_modes_solve", self._owner, self.statics._owner, options)

    def __reduce__(self) -> Any:
        return Modes, (self.statics, *self._asked)

    @property
    def n(self) -> int:
        return int(self._owner.n)

    @property
    def time(self) -> float:
        """Unit of time, s."""
        return float(self._owner.time_unit)

    @property
    def mode(self) -> "np.ndarray[Any, Any]":
        """View [n] of struct hawser_mode: omega (scaled), residual, plane, family, ..."""
        return self._owner.view(self._owner.memory.mode, (self.n,), record("hawser_mode"))

    @property
    def omega_si(self) -> "np.ndarray[Any, Any]":
        """[n] natural frequencies, rad/s."""
        return np.array(self.mode["omega"]) / self.time

    @property
    def S_si(self) -> "np.ndarray[Any, Any]":
        """[points] unstretched arclengths of the shapes, m: between the ends, which are no points."""
        grid = self._owner.grid
        whole = function("hawser_statics_actual")(self.statics._owner.address).length0
        return np.array(self.s * (whole / self._owner.view(grid.edge, (grid.elements + 1,))[-1]))

    def displaced(self, number: int, size: float = 1.0) -> "np.ndarray[Any, Any]":
        """[points][3] places x, y, z (m) of the cable in mode `number` (from 1), whose largest displacement is `size` (m)."""
        if not 1 <= number <= self.n:
            raise error(Status.ARGUMENT, f"mode {number}: there are 1 to {self.n}")
        at = [function("hawser_statics_actual_at")(self.statics._owner.address, S) for S in self.S_si]
        P, Q, B = self.shape[number - 1].T
        slope = np.arctan([point.slope for point in at])
        moved = np.stack([P * np.cos(slope) - Q * np.sin(slope), P * np.sin(slope) + Q * np.cos(slope), B], axis=1)
        rest = np.array([[point.x, point.y, 0.0] for point in at])
        return np.asarray(rest + moved * (size / np.sqrt((moved**2).sum(axis=1)).max()))

    def plot(self, ax: Any = None) -> Any:
        """The shapes, each by its largest component; see hawser.plots.shapes. Returns the axes."""
        from . import plots

        return plots.shapes(self, ax)

    def animate(self, number: int, size: Optional[float] = None, frames: int = 40) -> Any:
        """A mode in motion over a period, as an animation of matplotlib, which notebooks show; see hawser.plots.mode_motion."""
        from . import plots

        return plots.mode_motion(self, number, size, frames)

    @property
    def s(self) -> "np.ndarray[Any, Any]":
        """View [points] of the scaled arclengths of the shapes."""
        return self._owner.view(self._owner.grid.s, (self._owner.grid.points,))

    @property
    def shape(self) -> "np.ndarray[Any, Any]":
        """View [n][points][3] of the shapes P, Q, B: along the tangent, normal, binormal."""
        return self._owner.view(self._owner.memory.shape, (self.n, self._owner.grid.points, 3))


class Model:
    """The reduced model of a scene, or of a model file (Model.open)."""

    def __init__(self, modes: Union[Modes, Statics, Scene, scenes.SceneLike]) -> None:
        modes = modes if isinstance(modes, Modes) else Modes(modes)
        self.modes: Optional[Modes] = modes
        self._path = ""  # of the file of a model without modes
        scene = modes.statics.scene
        if scene._owner.model.energy == layout["constants"]["HAWSER_ENERGY_EXACT"]:
            raise error(Status.ARGUMENT, "model.energy: exact makes a full-order model, which hawser.run makes")
        self._owner = Owner("hawser_rom", "hawser_rom_clear")
        call_apart("hawser_rom_build", self._owner, modes._owner, scene._owner)
        top = _ABOVE * float(modes.mode["omega"][-1])
        if self._owner.known.reach < top:
            call_apart("hawser_rom_know_below", self._owner, modes._owner, scene._owner, top)

    @classmethod
    def open(cls, path: str) -> "Model":
        """A model file (hawser-rom(5))."""
        made = cls.__new__(cls)
        made.modes, made._path = None, path
        made._owner = Owner("hawser_rom", "hawser_rom_clear")
        call("hawser_rom_open", made._owner, os.fsencode(path))
        return made

    def __reduce__(self) -> Any:
        return (Model.open, (self._path,)) if self.modes is None else (Model, (self.modes,))

    def save(self, path: str) -> None:
        call("hawser_rom_save", self._owner, os.fsencode(path))

    @property
    def n(self) -> int:
        return int(self._owner.n)

    @property
    def length(self) -> float:
        """Unit of length, m (1 if unknown)."""
        return float(self._owner.length)

    @property
    def time(self) -> float:
        """Unit of time, s (1 if unknown)."""
        return float(self._owner.time)

    @property
    def K(self) -> "np.ndarray[Any, Any]":
        """View [n][n] of the stiffness."""
        return self._owner.view(self._owner.memory.K, (self.n, self.n))

    @property
    def D(self) -> "np.ndarray[Any, Any]":
        """View [n][n] of the damping."""
        return self._owner.view(self._owner.memory.D, (self.n, self.n))

    @property
    def Q(self) -> "np.ndarray[Any, Any]":
        """View [quads] of the quadratic terms j, k, l, value."""
        return self._owner.view(self._owner.memory.Q, (self._owner.quads,), record("hawser_quad"))

    @property
    def C(self) -> "np.ndarray[Any, Any]":
        """View [cubics] of the cubic terms j, k, l, m, value."""
        return self._owner.view(self._owner.memory.C, (self._owner.cubics,), record("hawser_cubic"))

    @property
    def probes(self) -> "list[str]":
        """Names of the points whose displacement is known: quarter, mid, ..."""
        return _names(self._owner.shapes.name or 0, self._owner.shapes.points)

    @property
    def omega_si(self) -> float:
        """The first natural frequency, rad/s: the unit w1."""
        if self.modes is not None:
            return float(self.modes.omega_si[0])
        least = float(np.min(np.linalg.eigvals(self.K).real))
        return float(np.sqrt(max(least, 0.0))) / self.time

    def respond(self, start: Union[float, str], end: Union[float, str], method: Optional[str] = None,
                tolerance: float = 0.0, step: float = 0.005, max_points: int = 0,
                progress: Optional[Callable[[float], bool]] = None) -> "Response":
        """The frequency response from `start` to `end` (rad/s, or "0.9w1"). `progress` is called with the fraction
        that is done; it returns True to stop, and the points traced until then are the result. Ctrl-C raises
        KeyboardInterrupt, whose attribute `partial` is that result."""
        return Response(self, _frequency(start, self.omega_si), _frequency(end, self.omega_si), method, tolerance,
                        step, max_points, progress)

    def integrate(self, omega: Union[float, str], until: float, every: float,
                  initial: Optional[Sequence[float]] = None) -> "Motion":
        """Motion in time from rest, or from `initial` [2n], with the load at `omega` (rad/s, or "0.95w1"), until
        `until` (s), a row each `every` (s)."""
        return Motion(self, _frequency(omega, self.omega_si), until, every, initial)


class Response:
    """A branch of periodic motions. Arrays have a row a point."""

    def __init__(self, model: Model, start: float, end: float, method: Optional[str], tolerance: float, step: float,
                 max_points: int, progress: Optional[Callable[[float], bool]]) -> None:
        self.model = model
        self._asked = (start, end, method, tolerance, step, max_points, None)
        options = struct("hawser_frf_options")(tolerance=tolerance, step_max=step, max_points=max_points)
        setattr(options, "from", start * model.time)
        options.to = end * model.time
        text = method.encode() if method else None
        if text:
            options.method = ctypes.cast(ctypes.c_char_p(text), ctypes.c_void_p).value
        self._owner = Owner("hawser_frf", "hawser_frf_clear")
        with ended(options, self, progress):
            call("hawser_frf_trace", self._owner, model._owner, options)

    def __reduce__(self) -> Any:
        return Response, (self.model, *self._asked)

    def _rows(self, member: str, *shape: int) -> "np.ndarray[Any, Any]":
        return self._owner.view(getattr(self._owner.memory, member), (self._owner.points,) + shape)

    @property
    def point(self) -> "np.ndarray[Any, Any]":
        """View [points] of struct hawser_frf_point: omega (scaled), unstable, error, ..."""
        return self._owner.view(self._owner.memory.point, (self._owner.points,), record("hawser_frf_point"))

    @property
    def event(self) -> "np.ndarray[Any, Any]":
        """View [events] of struct hawser_frf_event: kind, omega (scaled), bracket, ..."""
        return self._owner.view(self._owner.memory.event, (self._owner.events,), record("hawser_frf_event"))

    @property
    def event_names(self) -> "list[str]":
        name = function("hawser_event_name")
        return [name(int(kind)).decode() for kind in self.event["kind"]]

    @property
    def coordinate(self) -> "np.ndarray[Any, Any]":
        """View [points][n] of the largest |u_j| over a period, scaled."""
        return self._rows("coordinate", self.model.n)

    @property
    def probe(self) -> "np.ndarray[Any, Any]":
        """View [points][probes][3] of the largest |x|, |y|, |z| over a period, scaled."""
        return self._rows("probe", self._owner.probes, 3)

    @property
    def tension(self) -> "np.ndarray[Any, Any]":
        """View [points][2] of the smallest and largest tension, N; [0][2] if the model has none."""
        if not self._owner.memory.tension:
            return np.zeros((0, 2))
        return self._rows("tension", 2)

    @property
    def multiplier(self) -> "np.ndarray[Any, Any]":
        """View [points][2n][2] of the Floquet multipliers: log modulus, argument."""
        return self._rows("multiplier", 2 * self.model.n, 2)

    @property
    def state(self) -> "np.ndarray[Any, Any]":
        """View [points][2n] of the orbits' states at phase 0: u, du/dt, scaled."""
        return self._rows("state", 2 * self.model.n)

    @property
    def omega_si(self) -> "np.ndarray[Any, Any]":
        """[points] frequencies, rad/s."""
        return np.array(self.point["omega"]) / self.model.time

    @property
    def stable(self) -> "np.ndarray[Any, Any]":
        return np.asarray(self.point["unstable"] == 0)

    @property
    def end(self) -> str:
        """Why the branch ends."""
        name = function("hawser_frf_end_name")(self._owner.memory.end)
        return str(name.decode())


class Motion:
    """A run in time."""

    def __init__(self, model: Model, omega: float, until: float, every: float,
                 initial: Optional[Sequence[float]]) -> None:
        self.model = model
        self._asked = (omega, until, every, initial)
        options = struct("hawser_integrate_options")(omega=omega * model.time, until=until / model.time,
                                                     every=every / model.time)
        if initial is not None:
            begin = np.ascontiguousarray(initial, np.float64)
            if begin.shape != (2 * model.n,):
                raise error(Status.ARGUMENT, f"initial has the shape {begin.shape}: give {2 * model.n} numbers, the "
                                             "coordinates and their velocities")
            options.initial = begin.ctypes.data
        self._owner = Owner("hawser_trajectory", "hawser_trajectory_clear")
        with ended(options, self):
            call("hawser_integrate", self._owner, model._owner, options)

    def __reduce__(self) -> Any:
        return Motion, (self.model, *self._asked)

    @property
    def rows(self) -> int:
        return int(self._owner.rows)

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended it before its time."""
        return bool(self._owner.interrupted)

    @property
    def time(self) -> "np.ndarray[Any, Any]":
        """View [rows], scaled."""
        return self._owner.view(self._owner.memory.time, (self.rows,))

    @property
    def time_si(self) -> "np.ndarray[Any, Any]":
        """[rows] s."""
        return np.array(self.time) * self.model.time

    @property
    def state(self) -> "np.ndarray[Any, Any]":
        """View [rows][2n] of u and du/dt, scaled."""
        return self._owner.view(self._owner.memory.state, (self.rows, 2 * self.model.n))

    @property
    def energy(self) -> "np.ndarray[Any, Any]":
        """View [rows], scaled."""
        return self._owner.view(self._owner.memory.energy, (self.rows,))
