"""An exact engine for cylindrical gears.

    import gearwright as gw
    pinion = gw.Gear(teeth=17, normal_module=2.5, helix_angle_deg=15, profile_shift=0.3)
    wheel = gw.Gear(teeth=43, normal_module=2.5, helix_angle_deg=-15)
    pair = gw.Pair(pinion, wheel, center_distance=78.6)
    pair.contact_ratio, pair.replace(center_distance=79).backlash.normal

A name without a unit takes a value in mm or rad. A key with a unit takes a value in this unit. as_dict() returns
the keys of the program's JSON. A number that is impossible for a gear raises SpecError, which contains its key
and the permitted values. A defect of Gearwright itself raises ContractViolation. Please report its message.
"""

from __future__ import annotations

from . import _plots
from ._core import (ERRORS, Contact, ContractViolation, FileError, Gear, Loaded, Pair, Rating, Search, __version__,
                    compensate, fit, load, scatter, solve)
from ._doors import identify, measure, search, verify
from ._drives import Drive, load_drive, planetary, train
from ._errors import SpecError
from ._records import Record
from .closed_forms import (backlash, center_distance, contact_ratio, inverse_involute, involute, pair_table,
                           shift_limits, working_pressure_angle)

__all__ = [
    "ERRORS", "Contact", "ContractViolation", "Drive", "FileError", "Gear", "Loaded", "Pair", "Rating", "Record",
    "Search", "SpecError", "__version__", "backlash", "center_distance", "compensate", "contact_ratio", "fit", "identify",
    "inverse_involute", "involute", "load", "load_drive", "measure", "pair_table", "planetary", "scatter", "search",
    "shift_limits", "solve", "train", "verify", "working_pressure_angle"]

_plots.add()
