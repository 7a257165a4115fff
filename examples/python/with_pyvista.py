"""A pair in PyVista, gear 1 coloured by the height along its axis.

Not run by the tests: PyVista is not in Debian 12 (python3 -m pip install pyvista).
"""

import gearwright as gw
import numpy as np
import pyvista as pv

pair = gw.load("examples/helical_pair.toml")
plotter = pv.Plotter()
for which, gear in ((1, pair.gear1), (2, pair.gear2)):
    vertices, triangles = gear.mesh(tolerance=0.01)
    faces = np.column_stack([np.full(len(triangles), 3), triangles])
    body = pv.PolyData(vertices, faces.ravel())
    body["height"] = vertices[:, 2]
    plotter.add_mesh(body.transform(pair.pose(which), inplace=False), scalars="height" if which == 1 else None)
plotter.show()
