"""A pair in CadQuery: exact STEP bodies, a bore cut into each, and both gears in an assembly.

Not run by the tests: CadQuery is not in Debian 12 (python3 -m pip install cadquery).
"""

import cadquery as cq
import gearwright as gw

pair = gw.load("examples/helical_pair.toml")
assembly = cq.Assembly()
for which, gear in ((1, pair.gear1), (2, pair.gear2)):
    gear = gear.replace(bore=None)  # removes the spec's bore and keyway
    body = cq.importers.importStep(str(gear.step(f"gear{which}.step")))
    body = body.cut(cq.Workplane("XY").circle(8).extrude(gear.face_width, both=True))
    place = cq.Location(cq.Plane(origin=tuple(pair.pose(which)[:3, 3]), xDir=tuple(pair.pose(which)[:3, 0]),
                                 normal=tuple(pair.pose(which)[:3, 2])))
    assembly.add(body, loc=place, name=f"gear{which}")
assembly.export("pair_cadquery.step")
