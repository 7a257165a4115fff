"""A pair in trimesh: closed meshes in place, their volumes, and whether they touch.

Not run by the tests: trimesh is not in Debian 12 (python3 -m pip install trimesh).
"""

import gearwright as gw
import trimesh

pair = gw.load("examples/helical_pair.toml")
scene = trimesh.Scene()
for which, gear in ((1, pair.gear1), (2, pair.gear2)):
    mesh = trimesh.Trimesh(*gear.mesh(tolerance=0.01))
    print(f"gear {which}: watertight {mesh.is_watertight}, {mesh.volume:.1f} mm³")
    mesh.apply_transform(pair.pose(which))
    scene.add_geometry(mesh, node_name=f"gear{which}")
scene.export("pair_trimesh.glb")
