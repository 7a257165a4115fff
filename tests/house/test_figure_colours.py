"""Tests that the marks of figures can be distinguished with any colour vision, and in grey.

The colours are read from gearwright/figure/figure_style.css, as they are on light and dark screens and on
paper, and the styles of curves from the sources that draw them. Rules:

    colour  the marks of each set in TOGETHER differ by at least 12 in CIELAB, which is five times the smallest
            visible difference (2.3), for normal vision, protanopia, deuteranopia and tritanopia
    grey    two curves of a figure differ in dashes, in width by at least 40 %, or in lightness by 20
    shades  the lightness of a map increases with its values

Protanopia, deuteranopia and tritanopia: Machado, Oliveira, Fernandes, "A physiologically-based model for
simulation of color vision deficiency", IEEE Trans. Vis. Comput. Graph. 15 (2009), severity 1, linear RGB.
CIELAB: ISO/CIE 11664-4, white D65. Each rule is first tested with styles that violate it.
"""

import itertools
import os
import re
import unittest
from pathlib import Path

ROOT = Path(os.environ.get("GW_SOURCE", Path(__file__).resolve().parents[2]))
FIGURE = ROOT / "gearwright/figure"
VISIONS = {"normal": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
           "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216),
                          (-0.003882, -0.048116, 1.051998)),
           "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413),
                            (-0.011820, 0.042940, 0.968881)),
           "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602),
                          (0.004733, 0.691367, 0.303900))}
TOGETHER = {"gears": ["g1", "g2"],
            "gears and path of contact": ["g1", "g2", "action"],
            "tooth pairs": ["flank", "root-fillet", "tip-land"],
            "arcs of a tooth": ["root-land", "root-fillet", "flank", "tip-fillet", "tip-land"],
            "bars": ["alpha", "beta"],
            "zones": ["more", "fewer"],
            "lines of action": ["g1", "g2", "action", "trailing"],
            "shares": ["action", "tip-fillet", "g1", "trailing", "g2"],
            "edges of a region": ["g1", "g2", "trailing", "action", "tip-fillet", "beta", "root-land"]}
DIFFERENT, DARKER, WIDER = 12.0, 20.0, 1.4


class Style:
    """The colours and the rules of a style sheet."""

    def __init__(self, text):
        text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
        roots = [dict(re.findall(r"--([\w-]+):(#\w+)", block)) for block in re.findall(r":root\{(.*?)\}", text, re.S)]
        self.colours = {medium: {**roots[0], **roots[i]} for i, medium in enumerate(("light", "dark", "paper"))}
        # The rules that apply to classes only, the less specific first.
        self.rules = sorted(((names.strip(".").split("."), dict(d.split(":", 1) for d in rule.split(";") if ":" in d))
                             for selectors, rule in re.findall(r"([^{}]+)\{([^{}]*)\}", text)
                             for names in re.findall(r"(?:^|,)\s*((?:\.[\w-]+)+)\s*(?=,|$)", selectors)),
                            key=lambda rule: len(rule[0]))

    def of(self, classes):
        """Returns the declarations of a mark with these classes."""
        whole = {}
        for names, rule in self.rules:
            if set(names) <= set(classes.split()):
                whole.update(rule)
        return whole


def lab(colour, vision):
    """Returns L*, a*, b* of a colour as seen with this vision."""
    digits = colour[1:] if len(colour) == 7 else "".join(2 * c for c in colour[1:])
    s = [int(digits[i:i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in s]
    r, g, b = (min(1.0, max(0.0, sum(m * v for m, v in zip(row, linear)))) for row in VISIONS[vision])
    x = (0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047
    y = 0.2126729 * r + 0.7151522 * g + 0.0721750 * b
    z = (0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883
    f = [v ** (1 / 3) if v > (6 / 29) ** 3 else v / (3 * (6 / 29) ** 2) + 4 / 29 for v in (x, y, z)]
    return 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])


def alike_in_colour(style, names):
    """Returns the pairs of colours that look alike, each with its medium and vision."""
    faults = []
    for (medium, colours), vision, (a, b) in itertools.product(
            style.colours.items(), VISIONS, itertools.combinations(names, 2)):
        distance = sum((p - q) ** 2 for p, q in zip(lab(colours[a], vision), lab(colours[b], vision))) ** 0.5
        if distance < DIFFERENT:
            faults.append(f"{a} and {b}, {medium}, {vision}: {distance:.1f}")
    return faults


def alike_in_grey(style, curves):
    """Returns the pairs of curves that look alike on paper without colours."""
    def seen(classes):
        rule = style.of("curve " + classes)
        colour = style.colours["paper"][re.search(r"--([\w-]+)", rule["stroke"])[1]]
        return rule.get("stroke-dasharray"), float(rule["stroke-width"]), lab(colour, "normal")[0]

    faults = []
    for a, b in itertools.combinations(curves, 2):
        (dash_a, wide_a, light_a), (dash_b, wide_b, light_b) = seen(a), seen(b)
        if dash_a == dash_b and max(wide_a / wide_b, wide_b / wide_a) < WIDER and abs(light_a - light_b) < DARKER:
            faults.append(f"{a} and {b}")
    return faults


def listed(path, name):
    """Returns the texts of the list of this name in a C++ source."""
    block = re.search(r"\b" + name + r"\{(.*?)\};", (ROOT / path).read_text(encoding="utf-8"), re.S)
    return re.findall(r'"([^"]*)"', block[1])


class TheStyleOfFigures(unittest.TestCase):
    style = Style((FIGURE / "figure_style.css").read_text(encoding="utf-8"))

    def test_the_rules_detect_faults(self):
        root = ":root{--ink:#000;--a:#0067a6;--b:#0072b2;--c:#f00}"
        style = Style(root * 3 + ".curve{stroke-width:2}.a{stroke:var(--a)}.b{stroke:var(--b)}.dash{stroke-dasharray:7 4}")
        self.assertEqual(len(alike_in_colour(style, ["a", "b"])), 12)
        self.assertEqual(alike_in_colour(style, ["a", "c"]), [])
        self.assertEqual(alike_in_grey(style, ["a", "b"]), ["a and b"])
        self.assertEqual(alike_in_grey(style, ["a", "b dash"]), [])
        self.assertAlmostEqual(lab("#fff", "normal")[0], 100, 3)
        # Red and green of equal lightness are almost the same for a person without green cones.
        style = Style(":root{--a:#cc5500;--b:#7f7f00}" * 3)
        self.assertIn("a and b, light, deuteranopia", " ".join(alike_in_colour(style, ["a", "b"])))

    def test_colours_of_marks_differ_with_any_colour_vision(self):
        bodies = [re.search(r"--([\w-]+)", self.style.of(f"b{i}")["--own"])[1] for i in range(8)]
        for what, names in {**TOGETHER, "bodies of a drive": bodies}.items():
            with self.subTest(what):
                self.assertEqual(alike_in_colour(self.style, names), [])

    def test_curves_of_a_figure_differ_in_grey(self):
        search = Style((FIGURE / "figure_style.css").read_text(encoding="utf-8") +
                       (ROOT / "gearwright/report/page/search_style.css").read_text(encoding="utf-8"))
        for path, name in (("gearwright/figure/contact_scene.cpp", "kPairs"),
                           ("gearwright/figure/load_scene.cpp", "kCurves"),
                           ("gearwright/figure/load_curves.cpp", "kOfGear"),
                           ("gearwright/report/face_picture.cpp", "kWidthStyles"),
                           ("gearwright/report/shift_charts.cpp", "kLimitStyles"),
                           ("gearwright/report/shift_charts.cpp", "kShareStyles")):
            with self.subTest(name):
                curves = listed(path, name)
                self.assertGreater(len(curves), 1)
                self.assertEqual(alike_in_grey(search, curves), [])

    def test_shades_of_a_map_become_lighter(self):
        text = (FIGURE / "figure_style.css").read_text(encoding="utf-8")
        shades = [lab(re.search(rf"\.s{i}\{{fill:(#\w+)", text)[1], "normal")[0] for i in range(10)]
        for darker, lighter in zip(shades, shades[1:]):
            self.assertGreater(lighter - darker, 5)


if __name__ == "__main__":
    unittest.main()
