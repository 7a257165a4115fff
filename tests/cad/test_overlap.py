"""Tests exported pairs on parallel and on crossed axes, including gears cut by gears. The mounted gears
must not overlap at the centre distance without backlash. If they are 0.05 mm closer, they must
overlap.

The meshes are turned through one pitch in five steps and intersected by manifold-3d. Chords of convex
flanks are inside the tooth, so touching flanks have no common volume except for rounding of the
coordinates (float32, about 2 nm, times some square millimetres). If the gears are 0.05 mm closer, the
flanks overlap by h = 0.05 sin α = 0.017 mm on an area of at least the face width times 0.1 mm. Flanks on
crossed axes overlap in a lens of the depth h and the volume π h² ρ. Its radius of curvature ρ is at least
some millimetres.

The flanks of an internal gear are concave. Their chords extend out of the tooth by up to h, the tolerance
of the mesh. Touching flanks share a sliver of this height and the width 2 √(2 ρ h), where 1/ρ = 1/ρ1 -
1/ρ2. At most four flanks touch.

Concave circular-arc flanks touch at points. Two flanks share a lens of the height h and the volume π
h²/√(k1 k2), where k1 and k2 are the relative curvatures. Both flanks of the teeth in mesh touch, at most
two pairs of them.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
BIN, NODE = os.environ["GW_BIN"], os.environ.get("GW_NODE") or "node"
TOLERANCE = 0.0005  # mm, tolerance of the meshes
# mm, for gears on crossed axes, which are convex and wide. It reduces the number of triangles to a quarter.
SCREW_TOLERANCE = 0.002

PAIRS = {
    "helical": dict(z=(17, 31), m=2.5, beta=15, x=(0.3, 0.1), b=12),
    "spur": dict(z=(20, 33), m=2, beta=0, x=(0.0, 0.0), b=8),
    "undercut pinion": dict(z=(9, 40), m=3, beta=0, x=(0.2, -0.2), b=8),
    "left hand": dict(z=(13, 29), m=1.5, beta=-25, x=(0.4, 0.5), b=10),
    "herringbone": dict(z=(17, 31), m=2, beta=30, x=(0.3, 0.1), b=14, halves="double_helical = {}"),
    "double helical, staggered": dict(z=(13, 29), m=2, beta=-25, x=(0.4, 0.5), b=14,
                                      halves="double_helical = { gap_mm = 4, stagger_pitches = 0.5 }"),
    "screws at 90 deg": dict(z=(12, 18), m=2, beta=(45, 45), x=(0.2, 0.1), b=22, shaft=90),
    "screws, above their least distance": dict(z=(11, 23), m=2, beta=(50, -20), x=(0.3, 0.2), b=30, shaft=29),
    "left-hand screws": dict(z=(9, 15), m=2, beta=(-50, -38), x=(0.3, 0.2), b=24, shaft=-88),
}


# A gear with two teeth and the wheel that it cuts, a gear with one tooth and its wheel, and an internal gear
# cut by a pinion cutter. The cutters have longer teeth than the gears, because otherwise the fillets would
# touch over their whole length, and their chords would overlap the concave arcs.
FILLETED = """
teeth = {z}
profile_shift = {x}
rack = {{ dedendum = 1.0, root_fillet_radius = 0 }}
root_fillet = {{ offset_mm = {offset} }}
tip_fillet = {{ radius_mm = {radius} }}
"""
FEW_TEETH = """
[gear1]
normal_module_mm = {m}
helix_angle_deg = {beta}
face_width_mm = {b}
tip_diameter_mm = {tip1}
{pinion}
[gear2]
teeth = {z2}
face_width_mm = {b}
tip_diameter_mm = {tip2}
[gear2.cut_by]
{pinion}
[pair]
center_distance_mm = {a}
"""
RING = """
[gear1]
teeth = 18
normal_module_mm = 2
helix_angle_deg = 20
profile_shift = 0.3
face_width_mm = 5
[gear2]
teeth = -49
face_width_mm = 5
profile_shift = -0.3
tip_diameter_mm = 101.6
bore = { diameter_mm = 118 }
[gear2.cut_by]
teeth = 20
rack = { addendum = 1.25, tip_fillet_radius = 0.2 }
"""
TWO_TEETH = dict(m=1.75, beta=30, b=5, a=61.33509, z2=60, tip1=8.16, tip2=119.665,
                 pinion=FILLETED.format(z=2, x=0.7, offset=0.01, radius=0.332))
ONE_TOOTH = dict(m=2, beta=55, b=5, a=54.0468, z2=30, tip1=10.0, tip2=106.4,
                 pinion=FILLETED.format(z=1, x=0.75, offset=0.05, radius=0.5))
PAIRS |= {
    "gear with two teeth and the wheel that it cuts": dict(z=(2, 60), b=5, spec=FEW_TEETH.format(**TWO_TEETH)),
    "gear with one tooth and the wheel that it cuts": dict(z=(1, 30), b=5, spec=FEW_TEETH.format(**ONE_TOOTH)),
    "internal gear cut by a pinion": dict(z=(18, -49), b=5, spec=RING),
}

# Convex and concave teeth without backlash. The centre distance is the sum of the pitch radii.
ARCS = """
[gear1]
teeth = 12
normal_module_mm = 2
helix_angle_deg = 20
face_width_mm = 20
rack = { kind = "circular_arc", cutter = "F", arc_radius = 1.4, center_a = 0.4224355652982141, center_b = 0.24389328734019564 }
[gear2]
teeth = 30
normal_module_mm = 2
helix_angle_deg = -20
face_width_mm = 20
rack = { kind = "circular_arc", cutter = "P", arc_radius = 1.55, center_a = 0.5523393758658799, center_b = 0.31889328734019567 }
"""
PAIRS["circular arcs"] = dict(z=(12, 30), b=20, spec=ARCS)


def spec(p):
    if "spec" in p:
        return p["spec"]
    lines = []
    beta = p["beta"] if "shaft" in p else (p["beta"], -p["beta"])
    for i in (0, 1):
        lines += [f"[gear{i + 1}]", f"teeth = {p['z'][i]}", f"normal_module_mm = {p['m']}",
                  f"helix_angle_deg = {beta[i]}", f"profile_shift = {p['x'][i]}",
                  f"face_width_mm = {p['b']}", p.get("halves", "")]
    if "shaft" in p:
        lines += ["[pair]", f"shaft_angle_deg = {p['shaft']}"]
    return "\n".join(lines) + "\n"


def allowed_overlap(p, pair):
    rounding = 2e-6 * 10.0
    if pair.get("arc_contacts"):
        k1, k2 = pair["arc_contacts"][0]["gap_curvature_per_mm"]
        return rounding + 4 * math.pi * TOLERANCE**2 / math.sqrt(k1 * k2)
    if p["z"][1] > 0:
        return rounding
    rho = [d / 2 * math.sin(math.radians(angle)) for d, angle in
           zip(pair["working_pitch_diameter_mm"], pair["working_transverse_pressure_angle_deg"])]
    relative = rho[0] * rho[1] / (rho[1] - rho[0])
    sliver = 2 / 3 * TOLERANCE * 2 * math.sqrt(2 * relative * TOLERANCE)
    return rounding + 4 * sliver * p["b"]


def main():
    faults = []
    for name, p in PAIRS.items():
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "pair.toml"
            file.write_text(spec(p))
            pair = json.loads(subprocess.run([BIN, "pair", file, "--json"], capture_output=True, check=True).stdout)["pair"]
            for gear in (1, 2):
                subprocess.run([BIN, "export", file, "--gear", str(gear), "--stl", f"{folder}/{gear}.stl",
                                "--mesh-tolerance", str(SCREW_TOLERANCE if "shaft" in p else TOLERANCE)], check=True, capture_output=True)
            a = pair["backlash_free_center_distance_mm"] or pair["reference_center_distance_mm"]
            # To move closer to its internal gear, a pinion moves outward.
            closer_by = 0.05 if p["z"][1] > 0 else -0.05
            least = 3.14 * 0.017**2 * 1.0 if "shaft" in p else 0.017 * 0.1 * p["b"]
            modules = ["--modules", os.environ["GW_MODULES"]] if os.environ.get("GW_MODULES") else []
            run = subprocess.run([NODE, HERE / "check_overlap.mjs", f"{folder}/1.stl", f"{folder}/2.stl",
                                  *map(str, p["z"]), "5", str(a), str(a - closer_by), "--shaft",
                                  str(p.get("shaft", 0)), "--enough", str(least), *modules],
                                 capture_output=True, text=True)
            if run.returncode != 0:
                print(run.stderr)
                sys.exit(run.returncode)
            touching, closer = (r["overlap_mm3"] for r in json.loads(run.stdout))
            allowed = allowed_overlap(p, pair)
            print(f"{name}: {touching:.2e} mm3 of overlap (allowed {allowed:.1e}), {closer:.3f} mm3 if 0.05 mm closer")
            if touching > allowed:
                faults.append(f"{name}: overlap of {touching} mm3 at the centre distance without backlash")
            if closer < least:
                faults.append(f"{name}: overlap of only {closer} mm3 if 0.05 mm closer")
    for f in faults:
        print(f)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
