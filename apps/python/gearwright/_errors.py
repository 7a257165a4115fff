"""What is wrong with an input, so that whoever gave it can mend it."""

from __future__ import annotations


class SpecError(ValueError):
    """A number that no gear can have.

    key      the key of a spec, "pair.center_distance_mm"; of a Gear by itself "helix_angle_deg"
    value    what stands there, as a text; empty: nothing, or nothing that a sentence could show
    allowed  what is wrong, what is allowed and why, what would help
    message  all of it in one sentence
    """

    def __init__(self, key: str, value: str, allowed: str, message: str) -> None:
        super().__init__(key, value, allowed, message)
        self.key = key
        self.value = value
        self.allowed = allowed
        self.message = message

    def __str__(self) -> str:
        return self.message
