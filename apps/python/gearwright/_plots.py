"""Plots the data of figures, sections of gears and designs of a search with matplotlib, if it is installed."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._errors import SpecError

PLANE = {"x": {"words": "x", "unit": "mm"}, "y": {"words": "y", "unit": "mm"}}


def plot(data: dict[str, Any], ax: Any = None) -> Any:
    """Draws the curves and dots of a figure and returns the axes of matplotlib. Curves with the same name
    have the same colour."""
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.figure().add_subplot()
    colours: dict[str, str] = {}
    for kind, mark in (("curves", "-"), ("dots", ".")):
        for one in data.get(kind, ()):
            points = np.array(one["points"], dtype=float)  # None, a gap in a line, becomes NaN
            colour = colours.setdefault(one["name"], f"C{len(colours)}")
            ax.plot(points[:, 0], points[:, 1], mark, color=colour, label=one["name"])
    for axis, label in (("x", ax.set_xlabel), ("y", ax.set_ylabel)):
        label(", ".join(filter(None, (data[axis]["words"], data[axis]["unit"]))))
    if data["x"] == PLANE["x"]:
        ax.set_aspect("equal")
    return ax


def plot_gear(gear: _core.Gear, ax: Any = None, points: int = 20) -> Any:
    """Plots the section of all teeth and returns the axes."""
    return plot({**PLANE, "curves": [{"name": "gear", "points": gear.section(points)}]}, ax)


def _placed(pair: _core.Pair, which: int, points: int, turn: float = 0.0) -> Any:
    """Returns the section z = 0 of a gear in the housing. `turn` is a rotation about the axis of the gear."""
    section = (pair.gear1 if which == 1 else pair.gear2).section(points)
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    flat = np.column_stack([section @ rotation.T, np.zeros(len(section)), np.ones(len(section))])
    return (flat @ pair.pose(which).T)[:, :2]


def plot_pair(pair: _core.Pair, ax: Any = None, points: int = 20) -> Any:
    """Plots the sections of both gears in the housing and returns the axes."""
    curves = [{"name": f"gear {which}", "points": _placed(pair, which, points)} for which in (1, 2)]
    return plot({**PLANE, "curves": curves}, ax)


def animate(pair: _core.Pair, frames: int = 24, points: int = 12, interval: float = 40) -> Any:
    """Returns a matplotlib FuncAnimation of a pair on parallel axes that turns through one pitch. Its method
    .to_jshtml() shows the animation in a notebook."""
    from matplotlib.animation import FuncAnimation

    ratio = pair.gear_ratio
    if ratio is None:
        why = "makes gear 2 a rack, but the animation needs two gears that rotate"
        raise SpecError("gear2.form", '"rack"', why, f'gear2.form = "rack": {why}')
    if pair.shaft_angle != 0:
        why = "the picture shows a plane section, and gears on crossed axes have no common plane section"
        raise SpecError("pair.shaft_angle_deg", "", why, "pair.shaft_angle_deg: " + why)
    ax = plot_pair(pair, points=points)
    lines = ax.get_lines()
    pitch = 2 * np.pi / abs(pair.gear1.teeth)

    def draw(frame: int) -> Any:
        turn = -pitch * frame / frames  # gear 1 turns clockwise
        for which, angle in ((1, turn), (2, -turn / ratio)):
            lines[which - 1].set_data(*_placed(pair, which, points, angle).T)
        return lines

    return FuncAnimation(ax.figure, draw, frames=frames, interval=interval, blit=True)


def plot_contact(contact: _core.Contact, ax: Any = None) -> Any:
    """Plots the transmission error over the rotation of gear 1 and returns the axes."""
    figures = contact.figures
    if not figures:
        raise ValueError("no teeth touch, so there is no transmission error")
    return plot(figures[0].data, ax)


def plot_search(found: _core.Search, x: str = "center_distance_mm", y: str = "contact_ratio", ax: Any = None) -> Any:
    """Plots two columns of the designs against each other and returns the axes. The Pareto front has another colour."""
    table = found.to_numpy()
    points = np.column_stack([table[x], table[y]])
    dots = [{"name": "designs", "points": points}, {"name": "front", "points": points[list(found.front)]}]
    return plot({"x": {"words": x, "unit": ""}, "y": {"words": y, "unit": ""}, "dots": dots}, ax)


def add() -> None:
    """Adds the plots as methods to the types."""
    for owner, name, method in (
            (_core.Figure, "plot", lambda figure, ax=None: plot(figure.data, ax)), (_core.Gear, "plot", plot_gear),
            (_core.Pair, "plot", plot_pair), (_core.Pair, "animate", animate), (_core.Search, "plot", plot_search),
            (_core.Contact, "plot", plot_contact)):
        setattr(owner, name, method)
