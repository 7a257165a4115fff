"""Errors of the input, with the information that the user needs to correct it."""

from __future__ import annotations


class SpecError(ValueError):
    """A number that no gear can have.

    key      the key of a spec, "pair.center_distance_mm"; of a Gear by itself "helix_angle_deg"
    value    the given value as a text; empty if there is none or it cannot be shown in a sentence
    allowed  what is wrong, what is allowed and why, what would help
    message  all of these in one sentence
    """

    def __init__(self, key: str, value: str, allowed: str, message: str) -> None:
        super().__init__(key, value, allowed, message)
        self.key = key
        self.value = value
        self.allowed = allowed
        self.message = message

    def __str__(self) -> str:
        return self.message
