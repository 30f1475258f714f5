"""Scenes as objects: Span, Net, Ropeway. Their keys are those of hawser-scene(5), from the schema that the program writes.

An object is a mapping, so that it stands wherever a scene does: hawser.run("statics", span), hawser.Model(span).

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import copy
import difflib
import html
from functools import lru_cache
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, TypeVar, Union

from . import scenes
from .errors import Status, error
from .results import Result, run

Of = TypeVar("Of", bound="SceneObject")


@lru_cache(maxsize=None)
def schema(kind: str) -> Dict[str, Any]:
    """The JSON Schema of scenes of a kind (hawser schema)."""
    return run("schema", None, kind).json


def _forms(of: Dict[str, Any]) -> List[Dict[str, Any]]:
    """The forms that a value may have: this one and its alternatives."""
    alternatives = [of[key] for key in ("then", "else") if key in of] + of.get("anyOf", []) + of.get("oneOf", [])
    return [of] + [form for one in alternatives for form in _forms(one)]


def _keys(of: Dict[str, Any]) -> Dict[str, Any]:
    """The keys of a section, with the schema of each."""
    keys: Dict[str, Any] = {}
    for form in _forms(of):
        for key, inner in form.get("properties", {}).items():
            old = keys.get(key, inner)
            keys[key] = inner if old == inner else {**inner, "anyOf": [*inner.get("anyOf", []), old]}
    return keys


def _unknown(place: str, key: str, known: Sequence[str]) -> Exception:
    near = [one for one in known if one.lower() == key.lower()] or difflib.get_close_matches(key, known, 1, 0.5)
    return error(Status.SCENE, f"unknown key {place + '.' if place else ''}{key}: " + (f"did you mean {near[0]}? " if near else "")
                 + f"{place or 'the scene'} takes {', '.join(known[:30])}{', ...' if len(known) > 30 else ''}")


def check_keys(value: Any, of: Dict[str, Any], place: str = "") -> None:
    """Fails where a mapping has a key that the schema does not have there, or lacks one that it must have."""
    if isinstance(value, Mapping):
        known = _keys(of)
        free = [form["additionalProperties"] for form in _forms(of) if form.get("additionalProperties", False)]
        for key, item in value.items():
            if key not in known and not free and known:
                raise _unknown(place, key, list(known))
            inner = known.get(key, free[0] if free else True)
            if isinstance(inner, dict):
                check_keys(item, inner, f"{place}.{key}" if place else key)
    elif scenes.is_list(value):
        items = next((form["items"] for form in _forms(of) if isinstance(form.get("items"), dict)), None)
        for number, item in enumerate(value if items else []):
            check_keys(item, items or {}, f"{place}[{number}]")


class SceneObject(Mapping[str, Any]):
    """A scene. Keywords are its sections, such as cable={...}, or keys of these, such as EA="400 MN"."""

    kind = "cable"  # of hawser schema
    root: Tuple[str, ...] = ()  # of scenes all of whose keys are in one section

    def __init__(self, **keys: Any) -> None:
        self.scene: Dict[str, Any] = {}
        self.set(**keys)

    def set(self: Of, **keys: Any) -> Of:
        """Set sections, or keys of them; returns the object."""
        scene = copy.deepcopy(self.scene)
        for key, value in keys.items():
            *sections, last = self._place(key)
            at = scene
            for section in sections:
                at = at.setdefault(section, {})
            if isinstance(value, Mapping) and isinstance(at.get(last), dict):
                at[last].update(value)
            else:
                at[last] = dict(value) if isinstance(value, Mapping) else value
        check_keys(scene, schema(self.kind))
        self.scene = scene  # which a mistake has not changed
        return self

    def _place(self, key: str) -> Tuple[str, ...]:
        """Where the key is in the scene."""
        known = _keys(schema(self.kind))
        if key in known:
            return (key,)
        for section in self.root:
            known = _keys(known[section])
        if key in known:
            return self.root + (key,)
        places = [name for name, section in known.items() if key in _keys(section)]
        if not places:
            raise _unknown("", key, [*known, *dict.fromkeys(k for section in known.values() for k in _keys(section))])
        if len(places) > 1:  # a key that the wind has, say, though the water of a mesh has it too
            plain = _keys(schema(self.kind).get("else", {}))
            places = [name for name in places if key in _keys(plain.get(name, {}))] or places
        if len(places) > 1:
            raise error(Status.SCENE, f"{key} is a key of {', '.join(places)}: write {places[0]}={{\"{key}\": ...}}")
        return self.root + (places[0], key)

    def __getitem__(self, key: str) -> Any:
        return self.scene[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self.scene)

    def __len__(self) -> int:
        return len(self.scene)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{key}={value!r}' for key, value in self.scene.items())})"

    @property
    def yaml(self) -> str:
        """The scene as a file has it."""
        return scenes.text(self.scene)

    def check(self) -> str:
        """What the program says of the scene; an exception where it is wrong."""
        return run("check", self).text

    def run(self, command: str, *more: str, **options: Any) -> Result:
        """hawser.run with this scene."""
        return run(command, self, *more, **options)

    def _repr_html_(self) -> str:
        rows = [f"<tr><td><code>{html.escape(key)}</code></td><td>{html.escape(value)}</td><td>{html.escape(text)}</td></tr>"
                for key, value, text in _described(self.scene, schema(self.kind))]
        return f"<table><caption>{type(self).__name__}</caption>{''.join(rows)}</table>"


def _described(value: Any, of: Dict[str, Any], place: str = "") -> Iterator[Tuple[str, str, str]]:
    """Each key, its value and its line in the schema."""
    if isinstance(value, Mapping) and value:
        free: Any = next((form["additionalProperties"] for form in _forms(of) if form.get("additionalProperties")), {})
        for key, item in value.items():
            inner = _keys(of).get(key, free)
            yield from _described(item, inner if isinstance(inner, dict) else {}, f"{place}.{key}" if place else key)
    else:
        yield place, value if isinstance(value, str) else scenes.flow(value), of.get("description", "")


class Span(SceneObject):
    """A span of cable: Span(EA="400 MN", rho="6 kg/m", d="250 m", h="10 m", T0="80 kN", damping={"ratio": "0.2 %"})."""


class Net(SceneObject):
    """Cables between nodes: Net().node("A", 0, 0, 0).node("J").cable("A", "J", EA="1 MN", rho=2, length0="5 m")."""

    kind = "net"

    def __init__(self, **keys: Any) -> None:
        super().__init__(kind="net", **keys)

    def node(self, name: str, *place: Any, held: Union[bool, Sequence[str], None] = None, mass: Any = None,
             load: Any = None) -> "Net":
        """A node. With a place x, y, z it is held there, or only in the directions `held`, such as "xy"; without one its place
        is to be found."""
        if place and len(place) != 3:
            raise error(Status.SCENE, f"node {name}: a place has three numbers x, y, z; y points up")
        self.set(nodes={name: list(place) if place else {}})
        if held or (held is None and place):
            self.set(supports={name: "fixed" if held in (None, True) else {"fixed": list(held)}})  # type: ignore[arg-type]
        for section, value in (("masses", mass), ("loads", load)):
            if value is not None:
                self.set(**{section: {name: value}})
        return self

    def cable(self, start: str, end: str, name: Optional[str] = None, **keys: Any) -> "Net":
        """A cable between two nodes, with the keys of cables: EA, rho, length0 and so on."""
        for node in (start, end):
            if node not in self.scene.get("nodes", {}):
                raise error(Status.SCENE, f"there is no node {node}: begin with .node(\"{node}\", ...)")
        cables = self.scene.get("cables", [])
        return self.set(cables=cables + [{**({"name": name} if name else {}), "from": start, "to": end, **keys}])


class Ropeway(SceneObject):
    """A ropeway: Ropeway(rope={...}, bottom={...}, top={...}, carriers={...}).tower("80 m", "17 m", battery="support")."""

    kind = "ropeway"
    root = ("ropeway",)

    def tower(self, x: Any, y: Any, **keys: Any) -> "Ropeway":
        """A tower whose battery has its summit at x, y, with the keys of towers."""
        towers = self.scene.get("ropeway", {}).get("towers", [])
        return self.set(towers=towers + [{"at": [x, y], **keys}])
