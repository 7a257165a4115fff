"""Tests workshop drawings with independent readers.

PDF   pdftotext finds the words and the Greek letters, and one page for each gear or rack
SVG   the file is well-formed and in mm, and the paths of the gear are on the sheet
DXF   ezdxf finds nothing to correct; layers, line types and words exist; the outline of the gear has the
      scale in the title block
all   every run gives the same bytes

Exit status 77: ezdxf or pdftotext is not installed.
"""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

try:
    import ezdxf
    from ezdxf import recover
    from ezdxf.lldxf.encoding import decode_dxf_unicode
except ImportError:
    print("skipped: no ezdxf (Debian: python3-ezdxf)")
    sys.exit(77)
if not shutil.which("pdftotext"):
    print("skipped: no pdftotext (Debian: poppler-utils)")
    sys.exit(77)

BIN = os.environ["GW_BIN"]
SPEC = """
title = "Ritzel <β> & Rad, Größe 3"
[drawing]
number = "GW-0017"
author = "A. Example"
material = "18CrNiMo7-6"
[gear1]
teeth = 17
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
thickness_allowance_mm = [-0.10, -0.06]
face_width_mm = 25
quality = 6
[gear1.bore]
diameter_mm = 20
keyway_width_mm = 6
keyway_depth_mm = 2.8
[gear2]
teeth = 43
face_width_mm = 25
"""
RACK = """
[drawing]
flank_roughness = "MRR Ra 0.8"
[gear1]
teeth = 20
normal_module_mm = 2
helix_angle_deg = 20
face_width_mm = 20
[gear2]
form = "rack"
teeth = 26
height_mm = 12
"""


def check(held, what):
    if not held:
        raise SystemExit(f"FAILED: {what}")


def export(folder, name, *args):
    spec = folder / "spec.toml"
    spec.write_text(SPEC)
    path = folder / name
    subprocess.run([BIN, "export", str(spec), "--drawing", str(path), *args], check=True, stdout=subprocess.PIPE)
    return path


def words_of_pdf(path):
    return subprocess.run(["pdftotext", "-layout", str(path), "-"], check=True, stdout=subprocess.PIPE).stdout.decode()


def check_pdf(folder):
    path = export(folder, "both.pdf")
    text = words_of_pdf(path)
    check(text.count("\f") == 2, "the PDF must have a page for each gear")
    first, second, _ = text.split("\f")
    for words in ("Normal module", "αn", "β", "Span over 3 teeth", "19.5270 … 19.5646", "class 6", "Mating gear", "Ø20", "22.8",
                  "Keyway 6 wide", "GW-0017", "18CrNiMo7-6", "Ritzel <β> & Rad, Größe 3, gear 1", "1:1", "1/2", "Fα"):
        check(words in first, f"the PDF must contain {words}\n{first}")
    check("gear 2" in second and "1:2" in second and "left" in second, "gear 2 must have its own page")
    info = subprocess.run(["pdfinfo", str(path)], check=True, stdout=subprocess.PIPE).stdout.decode()
    check(re.search(r"Title:\s+Ritzel <β> & Rad, Größe 3$", info, re.M), info)
    check("PDF version:     1.4" in info and "(A4)" in info, info)
    check("Date" not in info, "the PDF must not contain a date, because none is given")
    a3 = subprocess.run(["pdfinfo", str(export(folder, "a3.pdf", "--sheet", "A3", "--gear", "1"))], check=True,
                        stdout=subprocess.PIPE).stdout.decode()
    check("Pages:           1" in a3 and "(A3)" in a3, a3)


def check_rack(folder):
    spec = folder / "rack.toml"
    spec.write_text(RACK)
    path = folder / "rack.pdf"
    subprocess.run([BIN, "export", str(spec), "--drawing", str(path)], check=True, stdout=subprocess.PIPE)
    pinion, rack, _ = words_of_pdf(path).split("\f")
    for words in ("Mating rack", "gear 1", "1/2"):
        check(words in pinion, f"the page of the pinion must contain {words}\n{pinion}")
    length = 26 * 2 * math.pi / math.cos(math.radians(20))
    for words in ("Rack data", "Hand of helix", "left", "Dimension over one pin", "back of the rack", "12", "14",
                  f"{length:.3f}", "rack", "2/2", "Ra 0.8"):
        check(words in rack, f"the page of the rack must contain {words}\n{rack}")


def check_svg(folder):
    root = ET.parse(export(folder, "one.svg", "--gear", "1")).getroot()
    check(root.get("width") == "210mm" and root.get("viewBox") == "0 0 210 297", "the SVG must be an A4 sheet in mm")
    texts = [e.text for e in root.iter("{http://www.w3.org/2000/svg}text")]
    for words in ("Normal module", "α", "Ø50.499", "19.5270 … 19.5646", "Ritzel <β> & Rad, Größe 3, gear 1"):
        check(words in texts, f"the SVG must contain {words}")
    for path in root.iter("{http://www.w3.org/2000/svg}path"):
        for x, y in re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", path.get("d")):
            check(0 <= float(x) <= 210 and 0 <= float(y) <= 297, "all paths must be on the sheet")


def check_dxf(folder):
    path = export(folder, "both.dxf")
    document, auditor = recover.readfile(path)
    check(not auditor.errors and not auditor.fixes, f"audit: {auditor.errors} {auditor.fixes}")
    document = ezdxf.readfile(path)
    audit = document.audit()
    check(not audit.errors and not audit.fixes, f"audit: {audit.errors} {audit.fixes}")
    check(document.header["$INSUNITS"] == 4, "millimetres")
    model = document.modelspace()
    check({e.dxf.layer for e in model} == {"OUTLINE", "HATCH", "AXIS", "DIMENSION", "DATA", "FRAME"}, "the layers")
    check(document.layers.get("AXIS").dxf.linetype == "CENTER", "axes must be chain lines")
    check(document.layers.get("OUTLINE").dxf.lineweight == 50, "outlines must be 0.5 mm wide")
    texts = [decode_dxf_unicode(e.dxf.text) for e in model.query("TEXT")]
    for words in ("Normal module", "α", "Ø50.499", "19.5270 … 19.5646", "Ritzel <β> & Rad, Größe 3, gear 1", "Scale"):
        check(words in texts, f"the DXF must contain {words}: {texts}")
    check({e.dxf.style for e in model.query("TEXT")} == {"SHEET"}, "all texts must have the style SHEET")
    # On each sheet, the outline in the circle of the axis layer must be the gear at the scale of the sheet.
    for low, high, scale, tip in ((0, 210, 1.0, 50.4992), (230, 440, 0.5, 116.2922)):
        outlines = [e for e in model.query('LWPOLYLINE[layer=="OUTLINE"]') if e.closed and low < e[0][0] < high]
        middle = [e.dxf.center for e in model.query('CIRCLE[layer=="AXIS"]') if low < e.dxf.center.x < high][0]
        reach = max(math.hypot(x - middle.x, y - middle.y) for x, y in max(outlines, key=len).get_points("xy"))
        check(abs(2 * reach - tip * scale) < 1e-3, f"the tip diameter on paper is {2 * reach}")


def main():
    with tempfile.TemporaryDirectory(prefix="gearwright_drawings_") as name:
        folder = Path(name)
        check_pdf(folder)
        check_rack(folder)
        check_svg(folder)
        check_dxf(folder)
        for ending in ("pdf", "svg", "dxf"):
            first = export(folder, f"a.{ending}").read_bytes()
            check(first == export(folder, f"b.{ending}").read_bytes(), f"two exports must be identical: {ending}")
    print("drawings: PDF, SVG and DXF are correct")


main()
