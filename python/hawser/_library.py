"""The shared library: where it is, its structures and functions, and failures as exceptions.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
import shutil
import weakref
from typing import Any, Callable, Dict, List, Optional, Sequence, Type

import numpy as np

from . import _headers
from .errors import Status, error

HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parent.parent  # of the sources, where this package is used from them

_SCALARS: Dict[str, Any] = {
    "double": ctypes.c_double, "int": ctypes.c_int, "long": ctypes.c_long, "char": ctypes.c_char,
    "size_t": ctypes.c_size_t, "unsigned": ctypes.c_uint, "unsigned char": ctypes.c_ubyte, "pointer": ctypes.c_void_p,
}
_structs: Dict[str, Type[ctypes.Structure]] = {}
_open: Dict[str, ctypes.CDLL] = {}


def _read_layout() -> Dict[str, Any]:
    stored = HERE / "layout.json"
    if stored.is_file():
        return _headers.load(stored.read_text(encoding="utf-8"))
    headers = TREE / "include" / "hawser"
    if not headers.is_dir():
        raise ImportError("hawser: layout.json is missing; install with: pip install ./python")
    return _headers.load(_headers.read(headers).json())


layout: Dict[str, Any] = _read_layout()


def program() -> str:
    """The hawser program: $HAWSER, or the first one in PATH."""
    found = os.environ.get("HAWSER") or shutil.which("hawser")
    if not found:
        raise error(Status.PROGRAM, "the hawser program is not in PATH: install it, or set the environment "
                                    "variable HAWSER to its path, such as build/hawser")
    return found


def _candidates() -> List[str]:
    given = os.environ.get("HAWSER_LIBRARY")
    if given:
        return [given]
    names = []
    beside = os.environ.get("HAWSER") or shutil.which("hawser")
    if beside:
        folder = pathlib.Path(beside).resolve().parent
        for place in (folder / ".libs", folder, folder.parent / "lib"):
            names += [str(path) for path in sorted(place.glob("libhawser.so*"))]
    return names + ["libhawser.so.0", ctypes.util.find_library("hawser") or "libhawser.so"]


def library() -> ctypes.CDLL:
    """The shared library: $HAWSER_LIBRARY, or that beside the program, or the loader's."""
    if "hawser" in _open:
        return _open["hawser"]
    reasons = []
    for name in _candidates():
        try:
            _open["hawser"] = ctypes.CDLL(name)
            return _open["hawser"]
        except OSError as failure:
            reasons.append(str(failure))
    raise error(Status.PROGRAM, "the library libhawser is not found: install hawser, or set the environment "
                                "variable HAWSER_LIBRARY to the file libhawser.so ("
                                + "; ".join(reasons) + ")")


def function(name: str) -> Callable[..., Any]:
    """A function of the library with the arguments that the headers declare."""
    found = getattr(library(), name)
    if found.argtypes is None:
        kinds = [_argument(kind) for kind in layout["functions"][name]]
        found.restype, found.argtypes = kinds[0], kinds[1:]
    return found  # type: ignore[no-any-return]


def _argument(kind: str) -> Any:
    if kind == "void":
        return None
    if kind == "text":
        return ctypes.c_char_p
    return _SCALARS[kind] if kind in _SCALARS else struct(kind[len("struct "):])


def struct(name: str) -> Type[ctypes.Structure]:
    """The structure as a ctypes class. Its size is compared with the library's."""
    if name in _structs:
        return _structs[name]
    fields = []
    for member, kind, dimensions in layout["structs"][name]:
        of: Any = _SCALARS[kind] if kind in _SCALARS else struct(kind[len("struct "):])
        for length in reversed(dimensions):
            of = of * length
        fields.append((member, of))
    made: Type[ctypes.Structure] = type(name, (ctypes.Structure,), {"_fields_": fields})
    if "." not in name:
        sizeof = library().hawser_sizeof
        sizeof.restype, sizeof.argtypes = ctypes.c_size_t, [ctypes.c_char_p]
        size = sizeof(name.encode())
        if size and size != ctypes.sizeof(made):
            raise error(Status.PROGRAM, f"struct {name} has {size} bytes in the library and "
                                        f"{ctypes.sizeof(made)} in the headers that this package was "
                                        "installed from: install both from the same version")
    _structs[name] = made
    return made


_PLAIN: Dict[str, Any] = {"double": np.float64, "int": np.intc, "long": np.int_, "unsigned": np.uintc,
                          "size_t": np.uintp, "pointer": np.uintp, "unsigned char": np.uint8}


def record(name: str) -> "np.dtype[Any]":
    """The structure as a numpy record, with its own offsets."""
    made = struct(name)
    names, formats, offsets = [], [], []
    for member, kind, dimensions in layout["structs"][name]:
        if kind == "pointer":
            continue  # addresses are no data
        shape = tuple(dimensions)
        if kind == "char":
            base: Any = "S%d" % (shape[-1] if shape else 1)
            shape = shape[:-1]
        else:
            base = _PLAIN[kind] if kind in _PLAIN else record(kind[len("struct "):])
        names.append(member)
        formats.append((base, shape) if shape else base)
        offsets.append(getattr(made, member).offset)
    return np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": ctypes.sizeof(made)})


def _release(clear: Callable[[int], None], memory: ctypes.Structure) -> None:
    clear(ctypes.addressof(memory))


class Owner:
    """A structure of the library and what it owns, released with the last view of it."""

    def __init__(self, name: str, clear: Optional[str] = None) -> None:
        self.memory = struct(name)()
        if clear:  # the memory is an argument, so that it outlives this call
            weakref.finalize(self, _release, function(clear), self.memory).atexit = False

    def __getattr__(self, name: str) -> Any:
        return getattr(self.memory, name)

    @property
    def address(self) -> int:
        return ctypes.addressof(self.memory)

    def view(self, address: Optional[int], shape: Sequence[int], kind: Any = np.float64) -> "np.ndarray[Any, Any]":
        """The array at an address as numpy sees it: no copy, not writable, and it keeps the owner alive."""
        dtype = np.dtype(kind)
        count = int(np.prod(shape, dtype=np.intp))
        if not address or count == 0:
            return np.zeros(shape, dtype)
        memory: Any = (ctypes.c_char * (count * dtype.itemsize)).from_address(address)
        memory._owner = self
        array: "np.ndarray[Any, Any]" = np.frombuffer(memory, dtype).reshape(shape)
        array.flags.writeable = False
        return array


def call(name: str, *arguments: Any) -> None:
    """Call a function whose last argument is the report; a failure is an exception."""
    report = struct("hawser_report")()
    given = [a.address if isinstance(a, Owner) else ctypes.addressof(a) if isinstance(a, ctypes.Structure) else a
             for a in arguments]
    status = function(name)(*given, ctypes.addressof(report))
    if status:
        raise error(Status(status), report.message.decode(errors="replace"))
