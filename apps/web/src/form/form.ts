// The form shows the spec as rows, with a column for each gear. The rows follow from the catalogue of inputs.
//
// Rows appear and disappear with the keys in the text. Otherwise only values change, so the focus and the
// slider are preserved.

import { inputKey } from "../catalogue";
import { button, Choice, fill, h } from "../elements";
import { onUnitChange, showLengthsIn, lengthUnit } from "../numbers";
import { at, bench, hasRack, isDrive } from "../workbench";
import { columnHeads, Rows } from "./row";
import { planOf, signatureOf, type Section } from "./plan";

export class Form {
  readonly element = h("div", { class: "form" });
  readonly units = new Choice("unit of length", { mm: "mm", in: "inch" }, lengthUnit(), showLengthsIn);
  private signature = "";
  private readonly rows = new Rows();
  private readonly opened = new Set<string>(["gear", "pair", "search", "fit"]);
  private readonly more = new Set<string>();
  private readonly general = h("p", { class: "fault", role: "alert" });
  private readonly body = h("div");
  private readonly title = h("input", {
    type: "text",
    "aria-label": "title of the design",
    placeholder: "title",
    class: "title",
    maxlength: 200,
    input: () => bench.setKey("title", this.title.value || undefined),
  });

  constructor() {
    fill(this.element, this.title, this.general, this.body);
    onUnitChange(() => {
      this.units.show(lengthUnit());
      this.signature = "";
      this.update();
    });
    bench.on("read", () => this.update());
  }

  update(): void {
    const solved = bench.solved;
    if (!solved) return;
    const spec = solved.spec ?? bench.good?.spec ?? null;
    if (!spec) {
      // The text cannot be read, and there was no design before, so the form is empty.
      this.signature = this.title.value = "";
      this.rows.clear();
      fill(this.body);
    } else {
      const plan = planOf(spec);
      const signature = signatureOf(plan);
      if (signature !== this.signature) {
        this.signature = signature;
        this.build(plan);
      }
      this.rows.show(spec);
      if (document.activeElement !== this.title)
        this.title.value = typeof spec["title"] === "string" ? spec["title"] : "";
    }
    const blamed = this.rows.blame(bench.fault);
    blamed?.element.closest("details")?.setAttribute("open", "");
    this.general.textContent = blamed ? "" : (bench.fault?.message ?? "");
  }

  private build(plan: Section[]): void {
    const focused = (document.activeElement as HTMLElement | null)?.dataset?.["key"];
    this.rows.clear();
    fill(this.body, ...plan.map((section) => this.section(section)), this.offers(plan));
    if (focused) this.body.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private section(section: Section): HTMLElement {
    const columns = section.places.length;
    const showMore = this.more.has(section.id);
    const keys = showMore ? [...section.rows, ...section.more] : section.rows;
    const words = showMore ? "fewer" : `${section.more.length} more`;
    const toggle = button(
      words,
      () => {
        if (showMore) this.more.delete(section.id);
        else this.more.add(section.id);
        this.signature = "";
        this.update();
      },
      {
        class: "quiet more",
        "aria-expanded": String(showMore),
        "aria-label": `show ${words} keys of ${section.title}`,
      },
    );
    const open = this.opened.has(section.id) || section.present;
    const details = h(
      "details",
      { class: "section", open, style: `--columns:${columns}` },
      h(
        "summary",
        { title: section.meaning },
        h("span", { class: "section-title" }, section.title),
        ...columnHeads(section.places),
      ),
      this.rows.add(section.table, keys, section.places),
      section.more.length > 0 && toggle,
    );
    details.querySelector("summary")!.addEventListener("click", () => {
      if (details.open)
        this.opened.delete(section.id); // the keys of this section will be hidden again
      else this.opened.add(section.id);
    });
    return details;
  }

  /** Returns a button that adds a second gear, if the text has only one. */
  private offers(plan: Section[]): HTMLElement | null {
    const gears = plan.find((one) => one.id === "gear")?.places.length;
    if (gears !== 1 || bench.finder || isDrive() || hasRack(bench.solved?.spec)) return null;
    return button(
      "add a second gear",
      () => {
        bench.setKey("gear2.teeth", 40);
        for (const name of ["normal_module_mm", "normal_pressure_angle_deg"]) {
          const value = at(bench.solved?.spec ?? null, "gear1." + name);
          if (value !== undefined && inputKey("gear", name)) bench.setKey("gear2." + name, value);
        }
      },
      { class: "quiet" },
    );
  }
}
