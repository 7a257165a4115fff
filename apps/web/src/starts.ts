// The first screen. A design starts either from a few known numbers, or from an example with its picture.
//
// Each start consists of a spec. If numbers in it are unknown, the engine computes them by search or fit.

import { fill, h } from "./elements";
import { numberIn } from "./form/field";
import { bench } from "./workbench";

const examples = import.meta.glob("../../../examples/*.toml", {
  query: "?raw",
  import: "default",
  eager: true,
}) as Record<string, string>;

export interface Example {
  name: string;
  text: string;
  title: string;
  sentence: string;
}
function exampleOf([path, text]: [string, string]): Example {
  const name = path.replace(/^.*\//, "").replace(/\.toml$/, "");
  const title = /^title = "(.*)"/m.exec(text)?.[1] ?? name.replaceAll("_", " ");
  const comment: string[] = [];
  for (const line of text.split("\n")) {
    if (!line.startsWith("#")) break;
    if (/^#\s*$/.test(line) || /gearwright /.test(line)) {
      if (comment.length) break;
      continue;
    }
    comment.push(line.slice(1).trim());
  }
  const whole = comment.join(" ");
  return { name, text, title, sentence: /^.*?[.:](?=\s|$)/.exec(whole)?.[0].replace(/:$/, ".") ?? whole };
}
// Examples with a rack are omitted, because the page cannot show racks.
export const kExamples: Example[] = Object.entries(examples)
  .filter(([, text]) => !/^form = "rack"/m.test(text))
  .map(exampleOf);
/** The view for the small picture of a card: the whole gears in section, without labels. */
const kCard = { frame: "whole", width: 320, height: 200, window: null, bodies: true } as const;
const kFirst = [
  "helical_pair",
  "spur_pair",
  "planetary_ring",
  "crossed_pair",
  "two_tooth_drive",
  "circular_arc_drive",
  "misaligned_pair",
  "gearbox_search",
];
kExamples.sort((a, b) => rank(a.name) - rank(b.name));
function rank(name: string): number {
  const index = kFirst.indexOf(name);
  return index < 0 ? 99 : index;
}

interface Blank {
  name: string;
  words: string;
  value: string;
  unit?: string;
  optional?: boolean; // true if the user may leave the field empty
}
interface Have {
  words: string;
  blanks: Blank[];
  tab: string;
  spec(value: Record<string, number>): string;
}
const kHave: Have[] = [
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

export class Starts {
  readonly element = h("main", { class: "starts", id: "starts" });
  private painted = false;
  private readonly pictures = new Map<string, HTMLElement>();

  constructor(private readonly begin: (text: string, tab: string) => void) {
    const cards = kExamples.map((one) => this.card(one));
    fill(
      this.element,
      h(
        "p",
        { class: "soft" },
        "Design, check and export cylindrical gears: exact geometry, tooth contact, load, strength.",
      ),
      h("h2", {}, "Start from …"),
      h("div", { class: "haves" }, ...kHave.map((one) => this.have(one))),
      h("h2", {}, "Or start from an example"),
      h("div", { class: "cards" }, ...cards),
      h(
        "p",
        { class: "soft" },
        "You can also drop a spec file or a link here. Everything is computed on your machine, and no data is sent.",
      ),
    );
  }

  private have(have: Have): HTMLElement {
    const inputs = have.blanks.map((blank) =>
      h(
        "label",
        {},
        h("span", {}, blank.words),
        h(
          "span",
          { class: "with-unit" },
          h("input", {
            name: blank.name,
            value: blank.value,
            inputmode: "decimal",
            required: !blank.optional,
            autocomplete: "off",
          }),
          blank.unit ?? "",
        ),
      ),
    );
    const wrong = h("p", { class: "fault", role: "alert" });
    const form = h(
      "form",
      {
        class: "have",
        submit: (event: Event) => {
          event.preventDefault();
          const values: Record<string, number> = {};
          for (const input of form.querySelectorAll("input")) {
            const empty = input.value.trim() === "";
            const value = numberIn(input.value);
            if (!Number.isFinite(value) && !(empty && !input.required)) {
              wrong.textContent = `“${input.value.slice(0, 40)}” is not a number.`;
              return input.focus();
            }
            values[input.name] = value;
          }
          wrong.textContent = "";
          this.begin(have.spec(values), have.tab);
        },
      },
      h("h3", {}, have.words),
      ...inputs,
      wrong,
      h("button", { type: "submit" }, "Start"),
    );
    return form;
  }

  private card(example: Example): HTMLElement {
    const picture = h("div", { class: "card-picture", "aria-hidden": "true" });
    this.pictures.set(example.name, picture);
    const tab =
      /^\[(search|fit)\]/m.test(example.text) || example.name.endsWith("_fit")
        ? "search"
        : example.text.includes("[errors]")
          ? "contact"
          : "mesh";
    return h(
      "button",
      {
        type: "button",
        class: "card",
        "data-example": example.name,
        click: () => this.begin(example.text, tab),
      },
      picture,
      h("span", { class: "card-title" }, example.title),
      h("span", { class: "card-sentence" }, example.sentence),
    );
  }

  /** Draws the pictures of the cards one after the other, with the engine of the page. */
  async paint(): Promise<void> {
    if (this.painted) return;
    this.painted = true;
    for (const example of kExamples) {
      const picture = this.pictures.get(example.name)!;
      if (this.element.hidden) {
        this.painted = false;
        return;
      }
      const searching = /^\[search\]/m.test(example.text);
      try {
        if (searching) throw new Error("a search has no picture yet");
        const { text } = example;
        const view = { ...kCard, name: example.name };
        picture.innerHTML = (await bench.back.call("meshFigure", { text, view })).html;
        picture.querySelector("svg")!.removeAttribute("tabindex"); // the card itself has the focus
      } catch {
        // The gears of this example must be computed first, so the card has no picture.
        picture.textContent = (searching ? "search" : "fit") + " …";
      }
    }
  }
}
