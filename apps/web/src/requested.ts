// The answer of a verb whose computation takes long. The engine computes it only on request. A
// button starts the computation, and a click on the answer replaces the design by a spec of the
// answer.

import { button, fill, h, scroller, sentenceOf } from "./elements";
import type { Json } from "./engine_worker";
import type { Verb } from "../engine/engine";
import { bench } from "./workbench";

export type JsonRecord = { [key: string]: Json };

export abstract class Requested {
  private readonly go: HTMLButtonElement;
  private readonly state = h("span", { class: "soft", "aria-live": "polite" });
  private readonly table: HTMLElement;
  readonly element: HTMLElement;
  private of = ""; // text of the spec whose answer is shown or computed

  /** `name` is the class of the element, `start` is the text of the button, and `busy` is the text
   *  beside the button until the answer arrives. */
  constructor(
    private readonly verb: Verb,
    name: string,
    start: string,
    private readonly busy: string,
  ) {
    this.go = button(start, () => void this.compute(), { class: "main" });
    this.table = scroller("table-room", name);
    this.element = h("div", { class: name }, h("div", { class: "load-head" }, this.go, this.state), this.table);
  }

  /** Removes the answer for another spec. */
  show(text: string): void {
    if (this.of === text) return;
    this.of = "";
    this.go.disabled = false;
    fill(this.state);
    fill(this.table);
  }

  /** Returns the sentence beside the button, and the list of the answer, if it has one. */
  protected abstract read(answer: Json): { sentence: string; list?: HTMLElement | undefined };

  /** Returns a button that replaces the design by `spec`. `name` is the name of this change in the history of
   *  the design. */
  protected takeButton(spec: Json, name: string, label: string): HTMLButtonElement {
    const take = async () => bench.setText(await bench.front.call("tomlOf", { json: JSON.stringify(spec) }), name);
    return button("Take", () => void take(), { class: "main", "aria-label": label });
  }

  private async compute(): Promise<void> {
    const text = bench.good?.text;
    if (!text) return;
    this.of = text;
    this.go.disabled = true;
    this.state.textContent = this.busy;
    try {
      const answer = await bench.press.call("run", { text, verb: this.verb });
      if (this.of !== text) return;
      const { sentence, list } = this.read(answer);
      this.state.textContent = sentence;
      if (list) fill(this.table, list);
    } catch (reason) {
      if (this.of === text) this.state.textContent = sentenceOf(reason);
    }
  }
}
