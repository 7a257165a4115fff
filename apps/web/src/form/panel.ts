// A few keys of the spec beside a picture that needs them: the same fields as in the form, with what
// the engine has to say against them when it makes that picture.

import { inputKey } from "../catalogue";
import { fill, h } from "../elements";
import type { Fault } from "../engine_worker";
import { onUnitChange } from "../numbers";
import { at, bench } from "../workbench";
import { implied, makeRow, type RowField } from "./row";

export interface PanelGroup {
  title: string;
  table: string; // of the catalogue
  places: string[]; // where its keys stand
  keys: string[];
}

export class KeyPanel {
  readonly element: HTMLElement;
  private readonly body = h("div");
  private fields: RowField[] = [];
  private answered: Fault | null = null;

  constructor(
    label: string,
    private readonly groups: PanelGroup[],
  ) {
    this.element = h("div", { class: "key-panel", role: "group", "aria-label": label }, this.body);
    onUnitChange(() => {
      this.fields = [];
      this.show();
    });
  }

  private build(): void {
    if (this.fields.length) return;
    fill(this.body);
    for (const group of this.groups) {
      const rows = h("div", { class: "rows", style: `--columns:${group.places.length}` });
      for (const name of group.keys) {
        const key = inputKey(group.table, name);
        if (!key) continue;
        const row = makeRow(group.table, key, group.places);
        this.fields.push(...row.fields);
        rows.append(...row.elements);
      }
      const heads = group.places.map((place) =>
        place.startsWith("gear") ? h("span", { class: "g" + place[4] }, "gear " + place[4]) : null,
      );
      this.body.append(h("h3", { style: `--columns:${group.places.length}` }, group.title, ...heads), rows);
    }
  }

  /** Shows what the spec says, and a fault at its field; of a table that is missing at its first.
   *  `answered` is what the engine had to say of the last spec that could be solved. Returns the
   *  sentence for the room beside the panel: the reason stands in one place only. */
  show(answered: Fault | null = this.answered): string {
    this.build();
    this.answered = answered;
    const typed = bench.solved?.fault ?? null; // of a spec that cannot be solved: the form has it, too
    const fault = typed ?? answered;
    const spec = bench.solved?.spec ?? bench.good?.spec ?? null;
    const blamed =
      fault &&
      (this.fields.find((one) => one.field.place === fault.key) ??
        this.fields.find((one) => fault.key !== "" && one.field.place.startsWith(fault.key + ".")));
    for (const { key, field } of this.fields) {
      field.show(at(spec, field.place), implied(key, field.place));
      field.fault(null);
    }
    for (const note of new Set(this.fields.map((one) => one.note))) note.fault(null);
    if (fault && blamed) {
      blamed.field.fault(fault.message);
      blamed.note.fault(fault.message);
    }
    if (!answered) return "";
    return blamed ? "There is no answer: see the marked field." : answered.message;
  }
}
