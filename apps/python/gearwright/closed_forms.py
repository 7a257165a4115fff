"""Closed forms over arrays, with NumPy's broadcasting, for gears on parallel axes that are given by numbers alone.

Angles are in rad and lengths in mm (in modules if normal_module is 1). Signs are those of ISO 21771: an internal gear
has negative teeth, and helix_angle belongs to gear 1. A missing value (no working angle, a tip inside its base circle)
is NaN.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Array = NDArray[np.float64]
_ALPHA = math.radians(20)
_COLUMNS = ("center_distance", "working_pressure_angle", "contact_ratio", "contact_ratio_true", "sliding", "tip_thickness1",
            "tip_thickness2", "tip_clearance1", "tip_clearance2")
# The keywords of center_distance(), working_pressure_angle() and contact_ratio().
_KEYWORDS = ("normal_module", "normal_pressure_angle", "addendum", "dedendum", "flank_depth", "mounting", "shorten_tips")


def _columns(*values: ArrayLike) -> tuple[list[Array], int, tuple[int, ...]]:
    """Returns the columns for the extension module, their common number of rows after broadcasting, and
    their shape. A single number is not expanded."""
    arrays = [_core._real(v) for v in values]
    shape = np.broadcast_shapes(*(a.shape for a in arrays))
    columns = [a if a.size == 1 else np.ascontiguousarray(np.broadcast_to(a, shape)) for a in arrays]
    return [c.reshape(-1) for c in columns], math.prod(shape), shape


def _teeth(number: ArrayLike) -> Array:
    z = _core._real(number)
    return np.where((z == np.round(z)) & (z != 0), z, np.nan)


def _sine_of_helix(angle: ArrayLike) -> Array:
    beta = _core._real(angle)
    sine: Array = np.sin(np.where(np.abs(beta) < math.pi / 2, beta, np.nan))
    return sine


def _number(name: str, value: float) -> float:
    """Returns the value of an argument that is the same for all rows."""
    if np.ndim(value) != 0:
        raise TypeError(f"{name}: must be one number for all rows, not {value!r}")
    number = float(_core._real(value))
    if not math.isfinite(number):
        raise ValueError(f"{name} = {number!r}: must be finite")
    return number


def _pressure_angle(angle: float) -> float:
    alpha = _number("normal_pressure_angle", angle)
    if not 0 < alpha < math.pi / 2:
        raise ValueError(f"normal_pressure_angle = {angle!r}: must lie between 0 and π/2 rad")
    return alpha


def _names(columns: tuple[str, ...] | None) -> tuple[str, ...]:
    if isinstance(columns, str):
        raise TypeError(f'columns: must be a tuple of names, ("{columns}",)')
    for name in columns or ():
        if name not in _COLUMNS:
            raise ValueError(f"columns: there is no column {name!r}; the columns are {', '.join(_COLUMNS)}")
    return tuple(columns or _COLUMNS)


def _shaped(column: Array, shape: tuple[int, ...]) -> Any:
    return column.reshape(shape) if shape else float(column[0])


def involute(alpha: ArrayLike) -> Any:
    """Returns inv α = tan α − α for |α| < π/2."""
    columns, rows, shape = _columns(alpha)
    return _shaped(_core._involute(columns, rows), shape)


def inverse_involute(inv: ArrayLike) -> Any:
    """Returns the pressure angle α with inv α = inv."""
    columns, rows, shape = _columns(inv)
    return _shaped(_core._inverse_involute(columns, rows), shape)


def pair_table(
    z1: ArrayLike,
    z2: ArrayLike,
    x1: ArrayLike = 0.0,
    x2: ArrayLike = 0.0,
    helix_angle: ArrayLike = 0.0,
    *,
    normal_module: ArrayLike = 1.0,
    normal_pressure_angle: float = _ALPHA,
    addendum: float = 1.0,
    dedendum: float = 1.25,
    flank_depth: float = 1.0,
    mounting: str = "tight",
    shorten_tips: bool = False,
    columns: tuple[str, ...] | None = None,
) -> dict[str, Any]:
    """Computes pairs from their numbers. Returns a dict with a column for each of these names:

    center_distance         a, by mounting: "tight" is free of backlash, "extended" is a_d + m_n (x1 + x2)
    working_pressure_angle  α_wt
    contact_ratio           ε_α between the tips; contact_ratio_true: ε_α of the path within the usable flanks
    sliding                 greatest |ζ| of both flanks at the ends of the path; inf at a base tangent point
    tip_thickness1, 2       s_an    tip_clearance1, 2   c

    addendum, dedendum and flank_depth (depth of the rack's straight flank) are in modules. Gear 2 may be internal, with
    more teeth than gear 1. If a formula does not apply to a row, if a number of teeth is 0 or not whole, or if the
    module is not positive, the row is NaN. Numbers for all rows must be finite.

    The search uses the same formulas. For gears of the same rack, they agree with a Pair to 1e-12, with one exception:
    contact_ratio_true neglects undercut, so for an undercut gear it is too large, and the result of the Pair is valid.
    The rack ISO53-A of a Gear has flank_depth = 1.25 − 0.38 (1 − sin 20°) = 0.99997; the default is 1.
    """
    if mounting not in ("tight", "extended"):
        raise ValueError(f'mounting = {mounting!r}: must be "tight" or "extended"')
    names = _names(columns)
    addendum, dedendum = _number("addendum", addendum), _number("dedendum", dedendum)
    flank_depth = _number("flank_depth", flank_depth)
    lanes, rows, shape = _columns(_teeth(z1), _teeth(z2), _sine_of_helix(helix_angle), x1, x2, normal_module)
    module = lanes.pop()
    meshes = (lanes[0] > 0) & ((lanes[1] > 0) | (lanes[0] + lanes[1] < 0)) & (module > 0) & (module < math.inf)
    lanes[0] = np.where(meshes, lanes[0], np.nan)
    found = _core._candidates(lanes, rows, math.tan(_pressure_angle(normal_pressure_angle)), (addendum, addendum),
                              (dedendum, dedendum), flank_depth, mounting == "tight", shorten_tips, names)
    table = {}
    for name, column in zip(names, found, strict=True):
        if name == "working_pressure_angle":
            column = np.arctan(column)
        elif name == "center_distance" or name.startswith("tip_"):
            column = column * module
        table[name] = _shaped(column, shape)
    return table


def _column(name: str, z1: ArrayLike, z2: ArrayLike, x1: ArrayLike, x2: ArrayLike, helix_angle: ArrayLike,
            more: dict[str, Any]) -> Any:
    for key in more:
        if key not in _KEYWORDS:
            raise TypeError(f"{name}() has no keyword {key!r}; the keywords are {', '.join(_KEYWORDS)}")
    return pair_table(z1, z2, x1, x2, helix_angle, columns=(name,), **more)[name]


def center_distance(z1: ArrayLike, z2: ArrayLike, x1: ArrayLike = 0.0, x2: ArrayLike = 0.0,
                    helix_angle: ArrayLike = 0.0, **more: Any) -> Any:
    """Returns the centre distance free of backlash (mounting="tight"), or a_d + m_n (x1 + x2) (mounting="extended").
    Keywords are those of pair_table."""
    return _column("center_distance", z1, z2, x1, x2, helix_angle, more)


def working_pressure_angle(z1: ArrayLike, z2: ArrayLike, x1: ArrayLike = 0.0, x2: ArrayLike = 0.0,
                           helix_angle: ArrayLike = 0.0, **more: Any) -> Any:
    """Returns the transverse working pressure angle α_wt. Keywords are those of pair_table."""
    return _column("working_pressure_angle", z1, z2, x1, x2, helix_angle, more)


def contact_ratio(z1: ArrayLike, z2: ArrayLike, x1: ArrayLike = 0.0, x2: ArrayLike = 0.0,
                  helix_angle: ArrayLike = 0.0, **more: Any) -> Any:
    """Returns the transverse contact ratio ε_α. Keywords are those of pair_table."""
    return _column("contact_ratio", z1, z2, x1, x2, helix_angle, more)


def backlash(z1: ArrayLike, z2: ArrayLike, x1: ArrayLike, x2: ArrayLike, center_distance: ArrayLike,
             helix_angle: ArrayLike = 0.0, *, thickness_allowance1: ArrayLike = 0.0,
             thickness_allowance2: ArrayLike = 0.0, normal_module: float = 1.0,
             normal_pressure_angle: float = _ALPHA) -> Any:
    """Returns the backlash j_n in the normal section at a centre distance. It is negative if the teeth overlap."""
    columns, rows, shape = _columns(z1, z2, x1, x2, _sine_of_helix(helix_angle), thickness_allowance1,
                                    thickness_allowance2, center_distance)
    tan_alpha = math.tan(_pressure_angle(normal_pressure_angle))
    module = _number("normal_module", normal_module)
    return _shaped(_core._backlash(columns, rows, module, tan_alpha), shape)


def shift_limits(z: ArrayLike, helix_angle: ArrayLike = 0.0, *, tip_thickness: float = 0.2,
                 normal_pressure_angle: float = _ALPHA, addendum: float = 1.0,
                 flank_depth: float = 1.0) -> tuple[Any, Any]:
    """Returns the least and the greatest profile shift. Between them, the tip is at least tip_thickness modules thick
    and not inside the base circle, and an external gear is not undercut.

    external gear  The least shift is usually the limit of undercut. At the greatest shift, the tip thickness is
                   tip_thickness.
    internal gear  It has no undercut, so its least shift is -inf, unless tips are too thin at smaller shifts. At the
                   greatest shift, the tip circle is the base circle, d_a = d_b.

    A limit that does not exist is NaN. If an argument is NaN, both limits are NaN."""
    columns, rows, shape = _columns(z, helix_angle)
    alpha = _pressure_angle(normal_pressure_angle)
    least, greatest = _core._shift_limits(columns, rows, alpha, _number("addendum", addendum),
                                          _number("flank_depth", flank_depth), _number("tip_thickness", tip_thickness))
    return _shaped(least, shape), _shaped(greatest, shape)
