// Fields for a few keys of the spec, next to a picture that depends on these keys. The fields work
// like the fields of the form, and also show the errors that the engine reports for this picture.

import { inputKey } from "../catalogue";
import { fill, h } from "../elements";
import type { Fault } from "../engine_worker";
import { onUnitChange } from "../numbers";
import { bench } from "../workbench";
import { columnHeads, Rows } from "./row";

export interface PanelGroup {
  title: string;
  table: string; // table of the catalogue
  places: string[]; // paths of this table in the spec
  keys: string[];
}

export class KeyPanel {
  readonly element: HTMLElement;
  private readonly body = h("div");
  private readonly rows = new Rows();
  private answered: Fault | null = null;

  constructor(
    label: string,
    private readonly groups: PanelGroup[],
  ) {
    this.element = h("div", { class: "key-panel", role: "group", "aria-label": label }, this.body);
    onUnitChange(() => {
      this.rows.clear();
      this.show();
    });
  }

  private build(): void {
    if (!this.rows.empty) return;
    const group = ({ title, table, places, keys }: PanelGroup) =>
      h(
        "section",
        { style: `--columns:${places.length}` },
        h("h3", {}, title, ...columnHeads(places)),
        this.rows.add(table, keys.flatMap((name) => inputKey(table, name) ?? []), places),
      );
    fill(this.body, ...this.groups.map(group));
  }

  /** Shows the values of the spec. `answered` is the error of the picture, if there is one. An error is
   *  shown at its field. The error of a missing table is shown at the first field of this table. Returns
   *  the sentence to show in place of the picture. This sentence contains the reason only if no
   *  field shows the reason. */
  show(answered: Fault | null = this.answered): string {
    this.build();
    this.answered = answered;
    // If the spec cannot be solved, the form shows this error, too.
    const typed = bench.solved?.fault ?? null;
    const fault = typed ?? answered;
    const spec = bench.solved?.spec ?? bench.good?.spec ?? null;
    this.rows.show(spec);
    const blamed = this.rows.blame(fault, true);
    if (!answered) return "";
    return blamed ? "There is no result. Correct the marked field." : answered.message;
  }
}
