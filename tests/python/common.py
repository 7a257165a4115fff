"""What the tests of the package share: the gears of the documents, the program beside it."""

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
    """What the program answers to each spec, in one run."""
    lines = "\n".join(json.dumps(spec) for spec in specs)
    run = subprocess.run([BIN, "batch", verb], input=lines, capture_output=True, text=True)
    # 1: a spec has no answer, which is reported in its line
    assert run.returncode in (0, 1), run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]
