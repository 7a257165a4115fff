// The starts from a few known numbers. Each start makes a spec from the values of its fields.

interface Blank {
  name: string;
  words: string;
  value: string;
  unit?: string;
  optional?: boolean; // true if the user may leave the field empty
}
export interface Have {
  words: string;
  blanks: Blank[];
  tab: string;
  spec(value: Record<string, number>): string;
}
export const kHave: Have[] = [
  {
    words: "Two tooth numbers and a centre distance",
    blanks: [
      { name: "z1", words: "teeth of gear 1", value: "17" },
      { name: "z2", words: "teeth of gear 2", value: "43" },
      { name: "a", words: "centre distance", value: "90", unit: "mm" },
    ],
    tab: "search",
    spec: (v) => `title = "${v["z1"]} : ${v["z2"]} at ${v["a"]} mm"

# The search finds standard modules and helix angles that fit. Click a row of the result to select a design.
[search]
pinion_teeth = [${v["z1"]}, ${v["z1"]}]
ratio = [${v["z2"]! / v["z1"]! - 1e-6}, ${v["z2"]! / v["z1"]! + 1e-6}]
center_distance_mm = ${v["a"]}
modules_mm = "ISO54-I+II"
helix_angle_deg = [0, 30]
helix_step_deg = 2.5
`,
  },
  {
    words: "A ratio and a centre distance",
    blanks: [
      { name: "u", words: "ratio", value: "3.2" },
      { name: "a", words: "approximate centre distance", value: "120", unit: "mm" },
    ],
    tab: "search",
    spec: (v) => `title = "ratio ${v["u"]} at about ${v["a"]} mm"

[search]
ratio = [${v["u"]! * 0.98}, ${v["u"]! * 1.02}]
target_ratio = ${v["u"]}
center_distance_mm = [${v["a"]! * 0.99}, ${v["a"]! * 1.01}]
modules_mm = "ISO54-I"
pinion_teeth = [14, 40]
contact_ratio_min = 1.3
coprime = true
objective = ["contact_ratio", "sliding"]
`,
  },
  {
    words: "A power, a ratio and a centre distance",
    blanks: [
      { name: "p", words: "power", value: "11", unit: "kW" },
      { name: "n", words: "speed of gear 1", value: "1450", unit: "1/min" },
      { name: "u", words: "ratio", value: "3.15" },
      { name: "a", words: "centre distance", value: "125", unit: "mm" },
    ],
    tab: "search",
    spec: (v) => `title = "${v["p"]} kW, ratio ${v["u"]} at ${v["a"]} mm"

# The search finds module, teeth, profile shifts and the least face width. Click a row of the result to select a design.
[search]
ratio = [${v["u"]! * 0.98}, ${v["u"]! * 1.02}]
target_ratio = ${v["u"]}
center_distance_mm = ${v["a"]}
modules_mm = "ISO54-I"
pinion_teeth = [17, 40]
helix_angle_deg = 10
safety_flank_min = 1.2
safety_root_min = 1.5
objective = "mass"
thickness_series = "cd25"

[gear1.material]
name = "16MnCr5"

[rating]
power_kW = ${v["p"]}
speed_rpm = ${v["n"]}
application_factor = 1.25
life_h = 20000
quality = 6
face_load_factor = 1.3
`,
  },
  {
    words: "A rack and pinion",
    blanks: [
      { name: "z", words: "teeth of the pinion", value: "20" },
      { name: "m", words: "module", value: "2", unit: "mm" },
      { name: "l", words: "length of the rack", value: "250", unit: "mm", optional: true },
    ],
    tab: "mesh",
    spec: (v) => `title = "rack and pinion of ${v["z"]} teeth"

[gear1]
teeth = ${v["z"]}
normal_module_mm = ${v["m"]}
face_width_mm = ${10 * v["m"]!}

[gear2]
form = "rack"
${Number.isFinite(v["l"]) ? `teeth = ${Math.max(1, Math.round(v["l"]! / (Math.PI * v["m"]!)))}\n` : ""}height_mm = ${10 * v["m"]!}
thickness_allowance_mm = -0.05
`,
  },
  {
    words: "A planetary set",
    blanks: [
      { name: "s", words: "teeth of the sun", value: "21" },
      { name: "p", words: "teeth of a planet", value: "24" },
      { name: "r", words: "teeth of the ring", value: "69" },
      { name: "n", words: "number of planets", value: "3" },
      { name: "m", words: "module", value: "2", unit: "mm" },
    ],
    tab: "sheet",
    spec: (v) => `title = "planetary set ${v["s"]} / ${v["p"]} / ${v["r"]}"

[planetary]
sun = ${v["s"]}
planet = ${v["p"]}
ring = ${v["r"]}
planets = ${v["n"]}
normal_module_mm = ${v["m"]}
face_width_mm = ${10 * v["m"]!}
thickness_allowance_mm = -0.05
`,
  },
  {
    words: "A broken gear",
    blanks: [
      { name: "z", words: "teeth", value: "23" },
      { name: "da", words: "tip diameter", value: "66.71", unit: "mm" },
      { name: "k", words: "number of teeth in a span", value: "3", optional: true },
      { name: "w", words: "length of the span", value: "19.751", unit: "mm", optional: true },
    ],
    tab: "search",
    spec: (v) => `title = "a broken gear of ${v["z"]} teeth"

# The gear is identified from these readings. More readings make the result more certain.
[gear1]
teeth = ${v["z"]}

[gear1.measured]
tip_diameter_mm = ${v["da"]}
${Number.isFinite(v["k"]) && Number.isFinite(v["w"]) ? `span_mm = { ${v["k"]} = ${v["w"]} }\n` : ""}`,
  },
  {
    words: "A pinion with three teeth",
    blanks: [
      { name: "z2", words: "teeth of the wheel", value: "30" },
      { name: "m", words: "module", value: "2", unit: "mm" },
    ],
    tab: "search",
    spec: (v) => `title = "3 teeth drive ${v["z2"]}"

# The fit computes shifts, tips and fillets.
[gear1]
teeth = 3
normal_module_mm = ${v["m"]}
helix_angle_deg = 30
face_width_mm = ${6 * v["m"]!}

[gear2]
teeth = ${v["z2"]}
normal_module_mm = ${v["m"]}

[fit]
few_teeth = true
`,
  },
  {
    words: "Crossed shafts",
    blanks: [
      { name: "z1", words: "teeth of gear 1", value: "12" },
      { name: "z2", words: "teeth of gear 2", value: "24" },
      { name: "m", words: "module", value: "1.5", unit: "mm" },
      { name: "a", words: "centre distance", value: "40", unit: "mm" },
      { name: "s", words: "shaft angle", value: "90", unit: "°" },
    ],
    tab: "search",
    spec: (v) => `title = "${v["z1"]} : ${v["z2"]}, shafts ${v["a"]} mm apart at ${v["s"]} degrees"

# The helix angles are absent, and the fit computes all possible helix angles.
[gear1]
teeth = ${v["z1"]}
normal_module_mm = ${v["m"]}

[gear2]
teeth = ${v["z2"]}
normal_module_mm = ${v["m"]}

[pair]
center_distance_mm = ${v["a"]}
shaft_angle_deg = ${v["s"]}
`,
  },
];
