"""Whole drives: Drive of a spec, planetary() for a planetary set and train() for a train of stages."""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping
from typing import Any

from . import _core
from ._errors import SpecError
from ._records import Record

# Endings of keys that name a unit of length or angle, and the size of this unit in mm or rad.
_UNITS: dict[str, float] = _core._units()
# Endings of all keys of results that their names lack, such as _mm and _MPa, and the size of this unit as above.
_ENDINGS: dict[str, float] = {
    ending: _UNITS.get(ending, 1.0)
    for table in _core._catalogue().values() for entry in table
    if entry["key"].startswith(entry["name"]) and (ending := entry["key"][len(entry["name"]):])}
_LENGTHS_IN_INCH = ("_in", "_uin")


def _scaled(value: Any, unit: float) -> Any:
    """Returns the numbers of a value multiplied by the size of their unit."""
    if isinstance(value, list):
        return [_scaled(v, unit) for v in value]
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return unit * value if number and unit != 1.0 else value


def _value(record: Mapping[str, Any], name: str) -> Any:
    """Returns the value of a key, or of a name without a unit, in mm and rad."""
    if name in record:
        return record[name]
    found = [(record[name + ending], unit) for ending, unit in _ENDINGS.items() if name + ending in record]
    if not found:
        raise AttributeError(f"there is no quantity {name}")
    # Of two keys with the same name, such as an angle and the travel of a rack, only one has a value.
    value, unit = next((pair for pair in found if pair[0] is not None), found[0])
    return _scaled(value, unit)


def _answer(spec: dict[str, Any], verb: str, folder: Any) -> dict[str, Any]:
    """Returns the program's answer for a drive in mm, as for the other objects. Errors have the units of the spec."""
    if spec.get("units") != "inch":
        return _core.solve(spec, verb, folder)
    try:
        return _core.solve(_core._in_mm(spec), verb, folder)
    except SpecError:
        return _core.solve(spec, verb, folder)  # raises the same error in inch


class Part(Record):
    """A part of a drive, for example a body or a mesh. Attributes have the names of keys without their unit, in mm and
    rad, and also those of keys."""

    __slots__ = ()

    def __init__(self, record: Mapping[str, Any]) -> None:
        super().__init__(dict(record), dict(record), list(record))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return _wrapped(_value(self._items, name))

    def __reduce__(self) -> tuple[Any, ...]:
        return Part, (self._items,)


def _wrapped(value: Any) -> Any:
    if isinstance(value, dict):
        return Part(value)
    if isinstance(value, list) and value and all(isinstance(v, dict) for v in value):
        return [Part(v) for v in value]
    return copy.deepcopy(value)


class Drive:
    """A planetary set, a train or any other drive, with its speeds, torques, positions, phases and backlash, and the
    pairs of its meshes.

    The object is immutable and hashable. Attributes, such as `drive.ratio` and `drive.backlash.output`, are in
    mm and rad. Items and as_dict() have the keys of the program's JSON for a spec in mm. `bodies` and
    `meshes` are dicts by name.
    """

    __slots__ = ("_folder", "_record", "_spec", "_verdict", "_warnings")
    _spec: dict[str, Any]
    _folder: str | os.PathLike[str] | None
    _record: dict[str, Any]
    _verdict: dict[str, Any]
    _warnings: list[dict[str, Any]]

    def __init__(self, spec: Mapping[str, Any], folder: str | os.PathLike[str] | None = None) -> None:
        """`spec` is a dict with the tables of a spec file. Relative file names in it start at `folder`."""
        if not isinstance(spec, Mapping):
            raise TypeError(f"spec: must be a dict with the tables of a spec, not {spec!r}; load_drive(path) reads a file")
        if not spec:
            why = "is empty; a drive is described by [planetary], [[stage]] or [drive]"
            raise SpecError("spec", "{}", why, f"spec = {{}}: {why}", "missing")
        own = copy.deepcopy(dict(spec))
        answer = _answer(own, "drive", folder)
        for name, value in (("_spec", own), ("_folder", folder), ("_record", answer["drive"]),
                            ("_verdict", answer["verdict"]), ("_warnings", answer["warnings"])):
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name}: a Drive cannot be changed; replace() returns a changed drive")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{name}: a Drive cannot be changed; replace() returns a changed drive")

    @property
    def spec(self) -> dict[str, Any]:
        """The values from which the drive was made, by key."""
        return copy.deepcopy(self._spec)

    @property
    def bodies(self) -> dict[str, Part]:
        """Speeds, torques and powers of the bodies, by name."""
        return {name: Part(body) for name, body in self._record["bodies"].items()}

    @property
    def meshes(self) -> dict[str, Part]:
        """Frequencies, losses and pairs of the meshes, by name."""
        return {name: Part(mesh) for name, mesh in self._record["meshes"].items()}

    @property
    def verdict(self) -> Part:
        """Level, headline and findings for the drive and the pairs in its meshes. The worst finding determines the
        level."""
        return Part(self._verdict)

    @property
    def warnings(self) -> list[Part]:
        return [Part(warning) for warning in self._warnings]

    def rate(self, **rating: Any) -> dict[str, Part]:
        """Returns the strength by ISO 6336 of each loaded mesh as a dict by name. Keywords are keys of [rating], for
        example quality=[6, 6], material={"name": "17CrNiMo6"}, mesh_load_factor. If torque and speed are absent,
        the values of the drive are used."""
        table = {**self._spec.get("rating", {}), **rating}
        answer = _answer({**self._spec, "rating": table}, "rate", self._folder)
        rated = {name: mesh["rating"] for name, mesh in answer["drive"]["meshes"].items()}
        return {name: Part(record) for name, record in rated.items() if record}

    def replace(self, **changes: Any) -> Drive:
        """Returns the drive with other tables of the spec, such as rating={...}. For a planetary
        set, keys of [planetary] are also accepted, such as planets=4. A table is replaced as a
        whole. None removes a table or key."""
        spec = self.spec
        own = spec["planetary"] if "planetary" in spec else spec
        tables = {entry["key"] for entry in _core._keys()["spec"]}
        for key, value in changes.items():
            target = spec if key in tables else own
            target.pop(key, None)
            for suffix in (*_UNITS, *_LENGTHS_IN_INCH):  # removes the same quantity if it is given in another unit
                target.pop(key + suffix, None)
                if key.endswith(suffix):
                    target.pop(key[: -len(suffix)], None)
            if value is not None:
                target[key] = value
        return Drive(spec, self._folder)

    def as_dict(self) -> dict[str, Any]:
        """Returns every quantity by key, in the unit that the key names, as in JSON."""
        return copy.deepcopy(self._record)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return _wrapped(_value(self._record, name))

    def __getitem__(self, key: str) -> Any:
        return copy.deepcopy(self._record[key])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Drive) and self._record == other._record

    def __hash__(self) -> int:
        return hash((self._record["ratio"], frozenset(self._record["bodies"]), frozenset(self._record["meshes"])))

    def __copy__(self) -> Drive:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Drive:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Drive, (self._spec, self._folder)

    def __repr__(self) -> str:
        ratio, exact = self._record["ratio"], self._record["ratio_exact"]
        said = f"ratio={exact[0]}/{exact[1]}" if exact and exact[1] != 1 else f"ratio={ratio}"
        efficiency = self._record["efficiency"]
        return f"Drive({said}" + (f", efficiency={efficiency:.4f})" if efficiency is not None else ")")


def planetary(**keys: Any) -> Drive:
    """Makes a planetary set from the keys of [planetary]. For example,
    gw.planetary(sun=20, planet=25, ring=70, planets=3, normal_module=2)."""
    return Drive({"planetary": keys})


def train(*stages: Mapping[str, Any]) -> Drive:
    """Makes a train of stages. Each stage is a dict with the keys of [[stage]]. For example,
    gw.train({"teeth": [19, 58]}, {"teeth": [17, 67]})."""
    return Drive({"stage": [dict(stage) for stage in stages]})


def load_drive(path: str | os.PathLike[str] | Mapping[str, Any]) -> Drive:
    """Makes the drive of a spec file, in TOML or JSON, or of a dict. Relative file names start at the folder of the spec
    file."""
    return Drive(*_core._read(path))
