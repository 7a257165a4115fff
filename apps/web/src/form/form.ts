// The form: the spec as rows, a column for each gear, made from the catalogue of inputs.
//
// Rows come and go with the keys of the text; as long as they stay, only values change, so that
// focus and slider stay where they are.

import type { InputKey } from "../../engine/engine";
import { inputKey } from "../catalogue";
import { button, fill, h } from "../elements";
import { inInches, onUnitChange, setInches } from "../numbers";
import { at, bench } from "../workbench";
import { implied, makeRow, type RowField } from "./row";
import { planOf, signatureOf, type Section } from "./plan";

export class Form {
  readonly element = h("div", { class: "form" });
  readonly units = h("div", { class: "choice", role: "group", "aria-label": "unit of length" });
  private signature = "";
  private fields: RowField[] = [];
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
    const unit = (words: string, yes: boolean) =>
      button(words, () => setInches(yes), {
        class: "unit-choice",
        "aria-pressed": String(inInches() === yes),
        "data-unit": words,
      });
    fill(this.units, unit("mm", false), unit("inch", true));
    fill(this.element, this.title, this.general, this.body);
    onUnitChange(() => {
      for (const one of this.units.querySelectorAll("button"))
        one.setAttribute("aria-pressed", String((one.dataset["unit"] === "inch") === inInches()));
      this.signature = "";
      this.update();
    });
    bench.on("solved", () => this.update());
  }

  update(): void {
    const solved = bench.solved;
    if (!solved) return;
    const spec = solved.spec ?? bench.good?.spec ?? null;
    if (!spec) {
      // A text that cannot be read, and no design before it: there is nothing to show.
      this.signature = this.title.value = "";
      this.fields = [];
      fill(this.body);
    } else {
      const plan = planOf(spec);
      const signature = signatureOf(plan);
      if (signature !== this.signature) {
        this.signature = signature;
        this.build(plan);
      }
      for (const { key, field } of this.fields) field.show(at(spec, field.place), implied(key, field.place));
      if (document.activeElement !== this.title)
        this.title.value = typeof spec["title"] === "string" ? spec["title"] : "";
    }
    this.showFault();
  }

  private showFault(): void {
    const fault = bench.solved?.fault ?? null;
    const asks = bench.asks;
    let found = false;
    for (const { field } of this.fields) field.fault(null);
    for (const note of new Set(this.fields.map((one) => one.note))) note.fault(null);
    for (const { field, note } of this.fields) {
      if (!fault || asks || field.place !== fault.key) continue;
      found = true;
      field.fault(fault.message);
      note.fault(fault.message);
      field.element.closest("details")?.setAttribute("open", "");
    }
    this.general.textContent = fault && !found && !asks ? fault.message : "";
  }

  private build(plan: Section[]): void {
    const focused = (document.activeElement as HTMLElement | null)?.dataset?.["key"];
    this.fields = [];
    fill(this.body, ...plan.map((section) => this.section(section)), this.offers(plan));
    if (focused) this.body.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private section(section: Section): HTMLElement {
    const columns = section.places.length;
    const rows = h("div", { class: "rows" });
    const addRow = (key: InputKey) => {
      const row = makeRow(section.table, key, section.places);
      this.fields.push(...row.fields);
      rows.append(...row.elements);
    };
    for (const key of section.rows) addRow(key);
    const showMore = this.more.has(section.id);
    if (showMore) for (const key of section.more) addRow(key);
    const toggle =
      section.more.length > 0
        ? button(
            showMore ? "fewer" : `${section.more.length} more`,
            () => {
              if (showMore) this.more.delete(section.id);
              else this.more.add(section.id);
              this.signature = "";
              this.update();
            },
            {
              class: "quiet more",
              "aria-expanded": String(showMore),
              "aria-label": `${showMore ? "fewer" : section.more.length + " more"} keys: ${section.title}`,
            },
          )
        : null;
    const heads = section.places.map((place) =>
      place.startsWith("gear") ? h("span", { class: "g" + place[4] }, "gear " + place[4]) : null,
    );
    const open = this.opened.has(section.id) || section.present;
    const details = h(
      "details",
      { class: "section", open, style: `--columns:${columns}` },
      h(
        "summary",
        { title: section.meaning },
        h("span", { class: "section-title" }, section.title),
        ...heads,
      ),
      rows,
      toggle,
    );
    details.querySelector("summary")!.addEventListener("click", () => {
      if (details.open)
        this.opened.delete(section.id); // it is about to close
      else this.opened.add(section.id);
    });
    return details;
  }

  /** What the text does not have yet: a second gear. */
  private offers(plan: Section[]): HTMLElement | null {
    const gears = plan.find((one) => one.id === "gear")?.places.length;
    if (gears !== 1 || bench.asks) return null;
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
