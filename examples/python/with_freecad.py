"""A pair in FreeCAD: exact STEP bodies, a bore cut into each, placed by pose(), saved as a document.

Run it with FreeCAD's own Python: freecadcmd examples/python/with_freecad.py (Debian: freecad-python3, 650 MB). The
tests run it only if freecadcmd is installed, because the package is large. It has been run with FreeCAD 0.20.2.
"""

import FreeCAD as App
import gearwright as gw
import Part

pair = gw.load("examples/helical_pair.toml")
document = App.newDocument("pair")
for which, gear in ((1, pair.gear1), (2, pair.gear2)):
    gear = gear.replace(bore=None)  # removes the spec's bore and keyway
    solid = Part.read(str(gear.step(f"gear{which}.step")))
    bore = Part.makeCylinder(8, 2 * gear.face_width, App.Vector(0, 0, -gear.face_width))
    body = document.addObject("Part::Feature", f"Gear{which}")
    body.Shape = solid.cut(bore)
    print(f"gear {which}: {solid.Volume:.1f} mm³ before the cut, {body.Shape.Volume:.1f} after")
    body.Placement = App.Placement(App.Matrix(*pair.pose(which).ravel()))
document.recompute()
document.saveAs("pair.FCStd")
