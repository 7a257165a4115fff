"""Plots with matplotlib, if it is installed: gear.plot(), pair.plot(), pair.animate(), contact.plot()."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._errors import SpecError

ARCSEC = 3600 * 180 / np.pi
COLOURS = ("#0067a6", "#b54708")


def _axes(ax: Any, equal: bool) -> Any:
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.figure().add_subplot()
    if equal:
        ax.set_aspect("equal")
        ax.set_xlabel("x, mm")
        ax.set_ylabel("y, mm")
    return ax


def plot_gear(gear: _core.Gear, ax: Any = None, points: int = 20) -> Any:
    """Plots the section of all teeth and returns the axes."""
    ax = _axes(ax, True)
    section = gear.section(points)
    ax.plot(section[:, 0], section[:, 1], color=COLOURS[0], lw=1)
    return ax


def _placed(pair: _core.Pair, which: int, points: int, turn: float = 0.0) -> Any:
    """The section z = 0 of a gear in the housing, turned about its own axis."""
    section = (pair.gear1 if which == 1 else pair.gear2).section(points)
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    flat = np.column_stack([section @ rotation.T, np.zeros(len(section)), np.ones(len(section))])
    return (flat @ pair.pose(which).T)[:, :2]


def plot_pair(pair: _core.Pair, ax: Any = None, points: int = 20) -> Any:
    """Plots both sections in the housing, at rest, and returns the axes."""
    ax = _axes(ax, True)
    for which in (1, 2):
        section = _placed(pair, which, points)
        ax.plot(section[:, 0], section[:, 1], color=COLOURS[which - 1], lw=1)
    return ax


def animate(pair: _core.Pair, frames: int = 24, points: int = 12, interval: float = 40) -> Any:
    """The pair turning through one pitch, parallel axes: a matplotlib FuncAnimation; .to_jshtml() shows it in a
    notebook."""
    from matplotlib.animation import FuncAnimation

    if pair.shaft_angle != 0:
        why = "the picture is one plane section, and gears on crossed axes have none in common"
        raise SpecError("pair.shaft_angle_deg", "", why, "pair.shaft_angle_deg: " + why)
    ax = plot_pair(pair, points=points)
    lines = ax.get_lines()
    pitch = 2 * np.pi / abs(pair.gear1.teeth)

    def draw(frame: int) -> Any:
        turn = -pitch * frame / frames  # gear 1 turns clockwise
        for which, angle in ((1, turn), (2, -turn / pair.gear_ratio)):
            lines[which - 1].set_data(*_placed(pair, which, points, angle).T)
        return lines

    return FuncAnimation(ax.figure, draw, frames=frames, interval=interval, blit=True)


def plot_contact(contact: _core.Contact, ax: Any = None) -> Any:
    """Plots the transmission error over the rotation of gear 1 and returns the axes."""
    ax = _axes(ax, False)
    ax.plot(np.degrees(contact.rotation1), contact.transmission_error * ARCSEC, color=COLOURS[0])
    ax.set_xlabel("rotation of gear 1, degrees")
    ax.set_ylabel("transmission error, arc seconds")
    return ax


def plot_search(found: _core.Search, x: str = "center_distance_mm", y: str = "contact_ratio", ax: Any = None) -> Any:
    """Plots two columns of the designs against each other, with the front in colour, and returns the axes."""
    ax = _axes(ax, False)
    table = found.to_numpy()
    ax.plot(table[x], table[y], ".", color="0.6")
    front = list(found.front)
    ax.plot(table[x][front], table[y][front], ".", color=COLOURS[1])
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    return ax


def add() -> None:
    """Adds the plots as methods to the types."""
    for owner, name, method in ((_core.Gear, "plot", plot_gear), (_core.Pair, "plot", plot_pair),
                                (_core.Pair, "animate", animate), (_core.Contact, "plot", plot_contact),
                                (_core.Search, "plot", plot_search)):
        setattr(owner, name, method)
