"""A pair in build123d: exact STEP bodies, a bore cut into each, and both gears in place.

Not run by the tests: build123d is not in Debian 12 (python3 -m pip install build123d).
"""

import build123d as bd
import gearwright as gw

pair = gw.load("examples/helical_pair.toml")
bodies = []
for which, gear in ((1, pair.gear1), (2, pair.gear2)):
    gear = gear.replace(bore=None)  # removes the spec's bore and keyway
    body = bd.import_step(gear.step(f"gear{which}.step")) - bd.Cylinder(radius=8, height=2 * gear.face_width)
    pose = pair.pose(which)
    plane = bd.Plane(origin=tuple(pose[:3, 3]), x_dir=tuple(pose[:3, 0]), z_dir=tuple(pose[:3, 2]))
    bodies.append(plane * body)
bd.export_step(bd.Compound(children=bodies), "pair_build123d.step")
