// Offers files as downloads. The engine makes them with the same code as the program.

import type { FileKind } from "../engine/engine";
import { button, download, fill, foldOut, h, sentenceOf } from "./elements";
import { bench, hasRack, isDrive } from "./workbench";

interface Offer {
  kind: FileKind;
  words: string;
  what: string;
  gears: (0 | 1 | 2)[];
}
const kOffers: Offer[] = [
  { kind: "report", words: "Report", what: "one page with all numbers and pictures", gears: [0] },
  { kind: "json", words: "JSON", what: "all numbers, as printed by the program", gears: [0] },
  { kind: "drawing", words: "Drawing", what: "workshop drawing with gear data and views, PDF", gears: [1, 2, 0] },
  { kind: "step", words: "STEP", what: "exact solids for CAD, AP242", gears: [1, 2, 0] },
  { kind: "3mf", words: "3MF", what: "mesh for 3D printing", gears: [1, 2] },
  { kind: "stl", words: "STL", what: "mesh of triangles", gears: [1, 2] },
  { kind: "glb", words: "GLB", what: "mesh of all gears in place for 3D viewers", gears: [0] },
  { kind: "dxf", words: "DXF", what: "transverse section as arcs", gears: [1, 2] },
  { kind: "svg", words: "SVG", what: "transverse section as a picture", gears: [1, 2] },
];
const kOfDrives: FileKind[] = ["report", "json", "step", "3mf", "glb"];
const kEndings: Partial<Record<FileKind, string>> = { report: "html", drawing: "pdf" };

/** Returns a file name made from the title. Letters and digits of any script are kept. Other characters become _. */
export function fileName(): string {
  const title = bench.good?.spec?.["title"];
  const name =
    typeof title === "string"
      ? title
          .replace(/[^\p{L}\p{N}]+/gu, "_")
          .replace(/^_+|_+$/g, "")
          .slice(0, 60)
      : "";
  return name || "gears";
}

export class TakeHome {
  private readonly sheet = h("div", { class: "menu", role: "dialog", "aria-label": "files to download" });
  private readonly state = h("p", { class: "soft", role: "status" });
  private readonly opener = button("Download", () => undefined, { "aria-haspopup": "true", class: "main" });
  readonly element = foldOut("menu-holder", this.opener, this.sheet, () => this.show());

  constructor(private readonly save: () => void) {}

  private show(): void {
    this.state.textContent = "";
    const gears = bench.good?.gears ?? 0;
    const pair = bench.good?.hasPair ?? false;
    const rows = kOffers.map((offer) => {
      const alone = offer.kind === "report" || offer.kind === "json";
      if (isDrive()) return kOfDrives.includes(offer.kind) ? this.row(offer, [0], alone) : null;
      const places = offer.gears.filter((gear) => (gear === 0 ? alone || pair : gear <= gears));
      return places.length ? this.row(offer, places, alone) : null;
    });
    const spec = h(
      "div",
      { class: "offer" },
      h("span", {}, h("b", {}, "Spec"), h("span", { class: "soft" }, " the design as text, TOML")),
      h("span", { class: "offer-buttons" }, button("save", this.save)),
    );
    if (bench.good && bench.good.text !== bench.text)
      this.state.textContent = "The spec on screen has no result. These are the files of the last valid spec.";
    fill(this.sheet, spec, ...(bench.good ? rows : []), this.state);
    this.sheet.querySelector("button")?.focus();
  }

  private row(offer: Offer, places: (0 | 1 | 2)[], alone: boolean): HTMLElement {
    return h(
      "div",
      { class: "offer" },
      h("span", {}, h("b", {}, offer.words), h("span", { class: "soft" }, " " + offer.what)),
      h("span", { class: "offer-buttons" }, ...places.map((gear) => this.getter(offer, gear, alone))),
    );
  }

  private getter(offer: Offer, gear: 0 | 1 | 2, alone: boolean): HTMLButtonElement {
    const words = alone ? "save" : gear === 0 ? (isDrive() ? "drive" : "pair") : gear === 2 && hasRack(bench.good?.spec) ? "rack" : `gear ${gear}`;
    return button(words, () => void this.get(offer, gear), { "aria-label": `${offer.words}, ${words}` });
  }

  private async get(offer: Offer, gear: 0 | 1 | 2): Promise<void> {
    const text = bench.good?.text;
    if (text === undefined) return;
    const ending = kEndings[offer.kind] ?? offer.kind;
    const who = offer.gears.length > 1 ? (gear === 0 ? (isDrive() ? "" : "_pair") : `_gear${gear}`) : "";
    this.state.textContent = `Making ${offer.words} …`;
    try {
      const bytes = await bench.back.call("file", { text, kind: offer.kind, gear });
      download(`${fileName()}${who}.${ending}`, bytes as Uint8Array<ArrayBuffer>);
      this.state.textContent = `${offer.words}: ${(bytes.length / 1e6).toFixed(2)} MB`;
    } catch (reason) {
      this.state.textContent = sentenceOf(reason);
    }
  }
}
