"""Errors of the input, with the information that the user needs to correct it."""

from __future__ import annotations


class SpecError(ValueError):
    """The input contains a number that is impossible for a gear.

    key      the key of a spec, for example "pair.center_distance_mm", or of a Gear, for example "helix_angle_deg"
    value    the given value as text, or "" if there is none or if it is too long for a sentence
    allowed  the violated rule, the permitted values with the reason, and a remedy
    message  all of these in one sentence
    kind     a word for programs, for example "missing" or "nothing_touches" (docs/spec.md)
    """

    def __init__(self, key: str, value: str, allowed: str, message: str, kind: str = "value") -> None:
        super().__init__(key, value, allowed, message, kind)
        self.key = key
        self.value = value
        self.allowed = allowed
        self.message = message
        self.kind = kind

    def __str__(self) -> str:
        return self.message
