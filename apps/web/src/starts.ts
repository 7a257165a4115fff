// The first screen. A design starts either from a few known numbers, or from an example with its picture.
//
// Each start consists of a spec. If numbers in it are unknown, the engine computes them by search or fit.

import { fill, h } from "./elements";
import { numberIn } from "./form/field";
import { kHave, type Have } from "./known_starts";
import { bench } from "./workbench";

const examples = import.meta.glob(["../../../examples/*.toml", "../../../examples/drives/*.toml"], {
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
export const kExamples: Example[] = Object.entries(examples).map(exampleOf);
const kDrive = /^\[+(planetary|stage|drive)\b/m;
/** The view for the small picture of a card: the whole gears in section, without labels. */
const kCard = { frame: "whole", width: 320, height: 200, window: null, bodies: true } as const;
const kFirst = [
  "helical_pair",
  "spur_pair",
  "planetary_ring",
  "crossed_pair",
  "steering_rack",
  "planetary_set",
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
        : kDrive.test(example.text)
          ? "sheet"
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
        const figure = kDrive.test(text)
          ? (await bench.back.call("driveFigures", { text, width: kCard.width }))[0]!
          : (await bench.back.call("mesh", { text, view, positions: 0 })).figure;
        // All schemes have the same id, but an id must be unique in the page.
        picture.innerHTML = figure.html.replaceAll(new RegExp(`\\b${figure.id}(?=["-])`, "g"), example.name);
        picture.querySelector("svg")!.removeAttribute("tabindex"); // the card itself has the focus
        picture.querySelector("figcaption")?.remove();
      } catch {
        // The gears of this example must be computed first, so the card has no picture.
        picture.textContent = (searching ? "search" : kDrive.test(example.text) ? "drive" : "fit") + " …";
      }
    }
  }
}
