"""Tests DXF files of gears with an independent reader.

audit     ezdxf finds nothing to correct and no errors
units     $INSUNITS is millimetres; the version is AutoCAD 2000
closed    the layer PROFILE is one closed chain, counter-clockwise and once around the axis: a closed polyline
          with bulges, or splines and arcs whose ends meet
bore      the layer BORE is a circle or a closed polyline inside the profile, or around it for an internal
          gear

Usage: test_dxf.py [FILE.dxf ...]. Without files, the program (GW_BIN) exports sample gears, and the
script checks these. First, all checks except the audit are applied to drawings that must fail them.
Exit status 77: ezdxf is not installed.
"""

import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import ezdxf
    from ezdxf import recover
    from ezdxf.math import bulge_to_arc
except ImportError:
    print("skipped: no ezdxf (Debian: python3-ezdxf)")
    sys.exit(77)

MEET = 1e-12  # gap relative to the radius; a double in degrees has this rounding error
SPECS = {
    "spur": "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 10\n",
    "bored": "[gear1]\nteeth = 31\nnormal_module_mm = 1.5\nhelix_angle_deg = 18\nface_width_mm = 10\n"
             "[gear1.bore]\ndiameter_mm = 20\n",
    "keyed": "[gear1]\nteeth = 25\nnormal_module_mm = 2\nprofile_shift = 0.3\nface_width_mm = 10\n"
             "[gear1.bore]\ndiameter_mm = 18\nkeyway_width_mm = 6\nkeyway_depth_mm = 2.8\n",
    "undercut": "[gear1]\nteeth = 9\nnormal_module_mm = 3\nface_width_mm = 10\n",
}


class Edge:
    """A directed edge with its end points and the points between them."""

    def __init__(self, points):
        self.points = points


def arc_points(center, radius, begin, end, n=16):
    return [(center[0] + radius * math.cos(begin + (end - begin) * i / n),
             center[1] + radius * math.sin(begin + (end - begin) * i / n)) for i in range(n + 1)]


def edges_of(entity):
    kind = entity.dxftype()
    if kind == "LWPOLYLINE":
        vertices = list(entity.get_points("xyb"))
        pairs = list(zip(vertices, vertices[1:] + (vertices[:1] if entity.closed else [])))
        edges = []
        for (x0, y0, bulge), (x1, y1, _) in pairs:
            points = [(x0, y0), (x1, y1)]
            if bulge:
                center, begin, end, radius = bulge_to_arc((x0, y0), (x1, y1), bulge)
                end += 2 * math.pi if end <= begin else 0.0
                inner = arc_points(center, radius, begin, end)[1:-1]
                points[1:1] = inner if bulge > 0 else inner[::-1]
            edges.append(Edge(points))
        return edges
    if kind == "CIRCLE":
        return [Edge(arc_points(entity.dxf.center, entity.dxf.radius, 0.0, 2 * math.pi, 64))]
    if kind == "ARC":
        begin, end = math.radians(entity.dxf.start_angle), math.radians(entity.dxf.end_angle)
        end += 2 * math.pi if end <= begin else 0.0
        return [Edge(arc_points(entity.dxf.center, entity.dxf.radius, begin, end))]
    if kind == "SPLINE":
        return [Edge([(p.x, p.y) for p in entity.construction_tool().approximate(16)])]
    if kind == "LINE":
        return [Edge([tuple(entity.dxf.start)[:2], tuple(entity.dxf.end)[:2]])]
    raise ValueError(f"{kind} on a drawing of arcs")


def area_and_turn(edges):
    points = [p for edge in edges for p in edge.points[:-1]]
    area = turn = 0.0
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        cross = x0 * y1 - x1 * y0
        area += cross / 2
        turn += math.atan2(cross, x0 * x1 + y0 * y1)
    return area, turn / (2 * math.pi)


def chain_faults(name, entities):
    """Returns the reasons why the entities, in their order, are not one closed chain about the axis."""
    if any(e.dxftype() == "LWPOLYLINE" and not e.closed for e in entities):
        return [f"{name}: the polyline is not closed"]
    edges = [edge for e in entities for edge in edges_of(e)]
    reach = max(math.hypot(*p) for edge in edges for p in edge.points)
    faults = []
    for a, b in zip(edges, edges[1:] + edges[:1]):
        gap = math.dist(a.points[-1], b.points[0])
        if gap > MEET * reach:
            faults.append(f"{name}: a gap of {gap:.3g} mm at {b.points[0]}")
    splines = [e for e in entities if e.dxftype() == "SPLINE"]
    if len(splines) == len(entities):
        for a, b in zip(splines, splines[1:] + splines[:1]):
            if tuple(a.control_points[-1]) != tuple(b.control_points[0]):
                faults.append(f"{name}: neighbouring splines have different end points")
    area, turns = area_and_turn(edges)
    if area <= 0 or abs(turns - 1) > 1e-9:
        faults.append(f"{name}: {turns:.3f} turns about the axis, area {area:.3f} mm²")
    return faults


def faults_of(path):
    try:
        document, auditor = recover.readfile(path)
    except (OSError, ezdxf.DXFError) as error:
        return [f"cannot be read: {error}"]
    auditor_again = document.audit()
    faults = [f"audit: {e.message}" for a in (auditor, auditor_again) for e in a.errors + a.fixes]
    if document.dxfversion != "AC1015":
        faults.append(f"version {document.dxfversion}, not AC1015")
    if document.header.get("$INSUNITS") != 4:
        faults.append(f"$INSUNITS = {document.header.get('$INSUNITS')}, not 4 (mm)")
    model = document.modelspace()
    layers = {"PROFILE": [], "BORE": []}
    for entity in model:
        if entity.dxf.layer not in layers:
            faults.append(f"{entity.dxftype()} on layer {entity.dxf.layer}")
        else:
            layers[entity.dxf.layer].append(entity)
    if not layers["PROFILE"]:
        return faults + ["nothing on layer PROFILE"]
    for name, entities in layers.items():
        if entities:
            faults += chain_faults(name, entities)
    if layers["BORE"]:
        radii = [[math.hypot(*p) for e in layers[n] for edge in edges_of(e) for p in edge.points]
                 for n in ("PROFILE", "BORE")]
        if not (max(radii[1]) < min(radii[0]) or min(radii[1]) > max(radii[0])):
            faults.append("BORE crosses PROFILE")
    return faults


def try_the_checks(folder):
    """Checks that each check, except the audit, rejects a drawing that has the error."""
    def drawing(units=4, version="R2000", close=True, bulge=1.0, gap=0.0, bore=None):
        document = ezdxf.new(version, units=units)
        for layer in ("PROFILE", "BORE"):
            document.layers.add(layer)
        model = document.modelspace()
        if gap:
            for k in range(2):
                model.add_arc((0, 0), 10, 180 * k, 180 * (k + 1) - gap, dxfattribs={"layer": "PROFILE"})
        else:
            model.add_lwpolyline([(10, 0, bulge), (-10, 0, bulge)], format="xyb", close=close,
                                 dxfattribs={"layer": "PROFILE"})
        if bore:
            model.add_circle((0, 0), bore, dxfattribs={"layer": "BORE"})
        path = folder / "probe.dxf"
        document.saveas(path)
        return faults_of(path)

    def expect(what, faults, word):
        if not any(word in f for f in faults):
            raise SystemExit(f"a check missed its error: {what} gives {faults}")

    if drawing() or drawing(bore=5):
        raise SystemExit(f"a correct drawing is rejected: {drawing()} {drawing(bore=5)}")
    expect("inches", drawing(units=1), "$INSUNITS")
    expect("another version", drawing(version="R2010"), "AC1015")
    expect("an open polyline", drawing(close=False), "not closed")
    expect("a clockwise profile", drawing(bulge=-1.0), "turns")
    expect("a gap", drawing(gap=1e-9), "gap")
    expect("a bore on the profile", drawing(bore=10), "crosses")
    (folder / "probe.dxf").write_text("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n")
    expect("an empty drawing", faults_of(folder / "probe.dxf"), "PROFILE")


def exported(folder):
    program = os.environ.get("GW_BIN", "build/release/gearwright")
    for name, spec in SPECS.items():
        toml, dxf = folder / f"{name}.toml", folder / f"{name}.dxf"
        toml.write_text(spec)
        done = subprocess.run([program, "export", str(toml), "--gear", "1", "--dxf", str(dxf)],
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"export of {name} has exit status {done.returncode}: {done.stderr.strip()}")
        yield dxf


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        try_the_checks(folder)
        files = [Path(f) for f in sys.argv[1:]] or list(exported(folder))
        bad = 0
        for path in files:
            faults = faults_of(path)
            for fault in faults:
                print(f"{path.name}: {fault}")
            bad += bool(faults)
        print(f"{len(files)} drawings, {bad} with errors")
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
