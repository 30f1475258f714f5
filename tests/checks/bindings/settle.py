"""Defaults of options: settle.py LIBRARY prints what is wrong, a line each.

Every hawser_..._settle is called through ctypes, with the layouts of python/hawser/_headers.py: a member that is 0 gets
the number that its comment states ("0: 1e-9"), one that is given stays, and a second call changes nothing.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import ctypes as c
import math
import pathlib
import re
import sys

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(TREE / "python" / "hawser"))
sys.dont_write_bytecode = True
import _headers  # noqa: E402 # pylint: disable=wrong-import-position

SCALARS = {"double": c.c_double, "int": c.c_int, "long": c.c_long, "char": c.c_char, "size_t": c.c_size_t,
           "unsigned": c.c_uint, "unsigned char": c.c_ubyte, "pointer": c.c_void_p}
GIVEN = {"double": 2.385, "int": 7}
layout = _headers.read(TREE / "include" / "hawser")
text = "\n".join(path.read_text() for path in (TREE / "include" / "hawser").glob("*.h"))


def struct(name):
    """The structure as a ctypes class."""
    fields = []
    for member, kind, dimensions in layout.structs[name]:
        of = SCALARS.get(kind) or struct(kind.split()[1])
        for length in reversed(dimensions):
            of = of*length
        fields.append((member, of))
    return type(name, (c.Structure,), {"_fields_": fields})


def stated(name):
    """The defaults in the comments behind the members of a structure, by the member; NAN where they are words."""
    body = re.search(r"^struct %s \{(.*?)^\};" % name, text, re.M | re.S)[1]
    found = {}
    for line, comment in re.findall(r"([^;]*);[ \t]*/\*(.*?)\*/", body, re.S):
        default = re.search(r"\b0: ([^;)]*?)(?:, or\b|\. |[;)]|$)", comment, re.S)
        members = re.findall(r"(\w+)\s*(?:,|$)", re.sub(r"/\*.*?\*/", "", line, flags=re.S)) if default else []
        given = default[1].strip().split(" and ") if default else []
        for i, member in enumerate(members):
            number = given[i] if i < len(given) == len(members) else given[-1]
            found[member] = float(number) if re.fullmatch(r"[0-9][0-9.e-]*", number) else math.nan
    return found


def main():
    """Compare all of them."""
    library = c.CDLL(sys.argv[1])
    settles = re.findall(r"^void (hawser_\w+_settle)\(struct (\w+) \*\w+\);", text, re.M)
    assert len(settles) > 15
    for function, name in settles:
        options, given = struct(name)(), struct(name)()
        default, members = stated(name), {member: kind for member, kind, size in layout.structs[name] if not size}
        for member, kind in members.items():
            if kind in GIVEN:
                setattr(given, member, GIVEN[kind])
        getattr(library, function)(c.byref(options))
        getattr(library, function)(c.byref(given))
        for member, kind in members.items():
            if kind not in GIVEN:
                continue
            value = getattr(options, member)
            if value != default.get(member, 0) and not math.isnan(default.get(member, 0)):
                print("struct %s: %s is %g by default, its comment says %s" % (name, member, value, default.get(member)))
            if getattr(given, member) != GIVEN[kind]:
                print("%s changes %s, which is given" % (function, member))
        first = bytes(options)
        getattr(library, function)(c.byref(options))
        if bytes(options) != first:
            print("%s, called again, changes its options" % function)


main()
