"""The type Record. An attribute of a gear, a pair or an answer has this type if its value is a
record of the catalogue."""

from __future__ import annotations

import copy
from typing import Any


class Record:
    """Quantities of the catalogue. Attributes are in mm and rad. Items have the units of their keys."""

    __slots__ = ("_attributes", "_items", "_keys")

    def __init__(self, attributes: dict[str, Any], items: dict[str, Any], keys: list[str]) -> None:
        self._attributes = attributes
        self._items = items
        self._keys = keys  # the keys that the JSON contains

    def __getattr__(self, name: str) -> Any:
        if name in self._attributes:
            return self._attributes[name]
        raise AttributeError(f"there is no quantity {name}")

    def __getitem__(self, key: str) -> Any:
        return copy.deepcopy(self._items[key])

    def __contains__(self, key: str) -> bool:
        return key in self._items

    def __dir__(self) -> list[str]:
        return ["as_dict", "keys", *self._attributes]

    def keys(self) -> list[str]:
        return list(self._keys)

    def as_dict(self) -> dict[str, Any]:
        """Returns every quantity by key, in the unit that the key names, as in JSON."""
        return {key: self[key] for key in self._keys}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self.as_dict() == other.as_dict()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.as_dict()!r})"

    def __copy__(self) -> Record:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Record:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        bound = ("figures", "to_parquet")  # objects of the engine, not pickled
        kept = {name: value for name, value in self._attributes.items() if name not in bound}
        return Record, (kept, self._items, self._keys)
