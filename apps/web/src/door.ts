// The interface for scripts. Tests and the console of the browser use it.
//
//   await gearwright.run("pair", text)   the JSON that `gearwright pair --json` prints
//   gearwright.open(text)                puts a design on screen

import type { Verb } from "../engine/engine";
import { judgement } from "./judgement";
import type { Page } from "./page";
import { revisionOf } from "./revision";
import { bench } from "./workbench";

declare global {
  interface Window {
    gearwright: ReturnType<typeof doorOf>;
  }
}

export function doorOf(page: Page) {
  return {
    run: (verb: Verb, text: string): Promise<string> => bench.front.call("print", { text, verb }),
    open: (text: string, tab?: string): void => page.begin(text, tab),
    start: (): void => page.showStarts(),
    text: (): string => bench.text,
    /** True if the answer on screen belongs to the text on screen. */
    settled: (): boolean => bench.solved?.text === bench.text,
    /** True if the engine has no work left. */
    idle: (): boolean =>
      bench.solved?.text === bench.text &&
      !page.tabs.busy &&
      [bench.front, bench.back, bench.press, bench.seek].every((one) => one.idle),
    /** True if no part of the verdict is pending. */
    judged: (): boolean => bench.solved?.text === bench.text && judgement.pending.length === 0,
    /** Identifies the spec on screen. Pictures of this spec have the same value in `data-revision`. */
    revision: (): string => revisionOf(bench.text),
    /** Duration of the last change until its answer arrived, in ms. engineMs is the part used by the engine. */
    lastMs: (): number => bench.lastMs,
    engineMs: (): number => bench.solved?.milliseconds ?? NaN,
  };
}
