"""The library by ctypes: results whose layout is not known are buffers of hawser_sizeof bytes.

Usage: frf.py LIBRARY SCENE; prints what bindings.sh compares, the same as frf.cpp.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import ctypes as c
import sys

lib = c.CDLL(sys.argv[1])
lib.hawser_sizeof.restype = c.c_size_t


def size_of(name):
    size = lib.hawser_sizeof(name.encode())
    assert size > 0, name
    return size


def opaque(name):
    """A type of the right size and alignment for a structure whose members are not read."""
    return c.c_double*(size_of(name)//c.sizeof(c.c_double))


class Report(c.Structure):
    _fields_ = [("status", c.c_int), ("message", c.c_char*640), ("where", c.c_char_p),
                ("iteration", c.c_int), ("residual", c.c_double)]


class ModesOptions(c.Structure):
    _fields_ = [("n", c.c_int), ("basis", c.c_int), ("tolerance", c.c_double), ("method", c.c_char_p),
                ("any_error", c.c_int)]


class Modes(c.Structure):
    _fields_ = [("statics", opaque("hawser_statics")), ("method", c.c_char_p), ("gyroscopic", c.c_int),
                ("n", c.c_int), ("basis", c.c_int), ("time_unit", c.c_double),
                ("mode", c.POINTER(opaque("hawser_mode"))), ("grid", opaque("hawser_grid")),
                ("shape", c.c_void_p), ("slope", c.c_void_p), ("stroke", c.c_void_p)]


class State(c.Structure):
    _fields_ = [("stage", c.c_char_p), ("unit", c.c_char_p), ("done", c.c_long), ("expected", c.c_long),
                ("fresh", c.c_long), ("fraction", c.c_double), ("seconds", c.c_double),
                ("left", c.c_double), ("omega", c.c_double), ("load", c.c_double), ("events", c.c_int),
                ("frf", c.c_void_p), ("longer", c.c_int)]


Function = c.CFUNCTYPE(c.c_int, c.c_void_p, c.POINTER(State))


class Progress(c.Structure):
    _fields_ = [("function", Function), ("data", c.c_void_p)]


class FrfOptions(c.Structure):
    _fields_ = [("method", c.c_char_p), ("family", c.c_void_p), ("omega", c.c_double),
                ("turn", c.c_void_p), ("from_", c.c_double), ("to", c.c_double), ("begin", c.c_double),
                ("direction", c.c_int), ("tolerance", c.c_double), ("event_tolerance", c.c_double),
                ("segments", c.c_int), ("max_points", c.c_int), ("step_max", c.c_double),
                ("skip_events", c.c_int), ("unjudged", c.c_int), ("end_at_slack", c.c_int),
                ("most_unstable", c.c_int), ("most_work", c.c_double), ("samples", c.c_int),
                ("resonance", c.c_void_p), ("start", c.c_void_p), ("along", c.c_void_p),
                ("progress", Progress)]


class FrfBegin(c.Structure):
    """The first members of struct hawser_frf."""
    _fields_ = [("n", c.c_int), ("points", c.c_int)]


MIRRORED = [("hawser_report", Report), ("hawser_modes_options", ModesOptions), ("hawser_modes", Modes),
            ("hawser_progress_state", State), ("hawser_progress", Progress),
            ("hawser_frf_options", FrfOptions)]
TABLES = ("hawser_scene_key", "hawser_plausible_rule", "hawser_statics_model", "hawser_modes_method",
          "hawser_complex_modes_method", "hawser_beam_method", "hawser_integrate_method",
          "hawser_frf_method", "hawser_map_quantity", "hawser_fidelity")
report = Report()


def call(name, *arguments):
    function = getattr(lib, name)
    if function(*arguments, c.byref(report)):
        sys.exit(report.message.decode())


def first_of(table):
    """The name of the first row, which is the first member of every row."""
    function = getattr(lib, table)
    function.restype = c.POINTER(c.c_char_p)
    count = 0
    while function(count):
        count += 1
    assert count > 1 and not function(-1) and not function(count + 1), table
    return function(0)[0].decode()


def trace(rom, omega, progress):
    frf = opaque("hawser_frf")()
    options = FrfOptions(from_=0.95*omega, to=1.05*omega, progress=progress)
    call("hawser_frf_trace", c.byref(frf), c.byref(rom), c.byref(options))
    return frf


def points(frf):
    return FrfBegin.from_buffer(frf).points


def main():
    """The sizes first: a call with a structure of another layout can end the program."""
    other = [name for name, kind in MIRRORED if size_of(name) != c.sizeof(kind)]
    if other:
        sys.exit("tests/checks/bindings/frf.py mirrors another layout of " + ", ".join(other))
    texts = []

    def watch(_, state):
        text = c.create_string_buffer(100)
        lib.hawser_progress_text(state, text, c.c_size_t(100))
        texts.append(text.value.decode())
        return int(state.contents.done >= 5)

    scene, statics, rom = (opaque("hawser_" + name)() for name in ("scene", "statics", "rom"))
    call("hawser_scene_open", c.byref(scene), sys.argv[2].encode(), None, c.c_size_t(0))
    call("hawser_statics_scene", c.byref(statics), c.byref(scene))
    kept = []
    for n in (2, 3, 4):
        made, moved = Modes(), Modes()
        call("hawser_modes_solve", c.byref(made), c.byref(statics), c.byref(ModesOptions(n=n)))
        c.memmove(c.byref(moved), c.byref(made), c.sizeof(Modes))
        c.memset(c.byref(made), 0, c.sizeof(Modes))
        kept.append(moved)
    for modes in kept:
        print("%d modes, %.10g rad/s" % (modes.n, modes.mode[0][0]/modes.time_unit))
    call("hawser_rom_build", c.byref(rom), c.byref(kept[1]), c.byref(scene))
    omega = kept[1].mode[0][0]
    whole = trace(rom, omega, Progress())
    part = trace(rom, omega, Progress(function=Function(watch)))
    print("%s; %d of %d points, %s" % (texts[0], points(part), points(whole),
                                       "interrupted" if points(part) < points(whole) else "complete"))
    print("sizes agree")
    print("first rows:", *(first_of(table) for table in TABLES))
    for frf in (whole, part):
        lib.hawser_frf_clear(c.byref(frf))
    lib.hawser_rom_clear(c.byref(rom))
    for modes in kept:
        lib.hawser_modes_clear(c.byref(modes))
    lib.hawser_scene_clear(c.byref(scene))


main()
