"""Gears for the tests of the package, and the program to which the tests compare it."""

import json
import os
import pathlib
import subprocess

import gearwright as gw

BIN = os.environ["GW_BIN"]
SOURCE = pathlib.Path(os.environ["GW_SOURCE"])
BUILD = pathlib.Path(os.environ["GW_BUILD"])


def pinion(**more):
    return gw.Gear(**{"teeth": 17, "normal_module": 2.5, "helix_angle_deg": 15, "profile_shift": 0.3,
                      "thickness_allowance": -0.05, "face_width": 25, **more})


def wheel(**more):
    return gw.Gear(**{"teeth": 43, "normal_module": 2.5, "helix_angle_deg": -15, "profile_shift": 0.1,
                      "thickness_allowance": -0.07, "face_width": 25, **more})


def pair(**more):
    return gw.Pair(pinion(), wheel(), **{"center_distance": 78.6056, **more})


def batch(verb, specs):
    """Returns the output of the program for each spec, from a single run."""
    lines = "\n".join(json.dumps(spec) for spec in specs)
    run = subprocess.run([BIN, "batch", verb], input=lines, capture_output=True, text=True)
    # With status 1, some spec has an error, which is in its line.
    assert run.returncode in (0, 1), run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]
