// The interface for tests and for scripts in the console of the browser.
//
//   await gearwright.run("pair", text)   the output of `gearwright pair --json`
//   gearwright.open(text)                shows a design

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

/** True if the result on screen belongs to the text on screen, in pictures, words and numbers. */
const settled = () => bench.solved?.text === bench.text && !bench.unread;

export function doorOf(page: Page) {
  return {
    run: (verb: Verb, text: string): Promise<string> => bench.front.call("print", { text, verb }),
    open: (text: string, tab?: string): void => page.begin(text, tab),
    start: (): void => page.showStarts(),
    text: (): string => bench.text,
    settled,
    /** True if the engine has no pending work. */
    idle: (): boolean =>
      settled() &&
      !page.tabs.busy &&
      [bench.front, bench.back, bench.press, bench.seek].every((one) => one.idle),
    /** True if no part of the verdict is pending. */
    judged: (): boolean => settled() && judgement.pending.length === 0,
    /** The revision of the spec on screen. A picture of this spec has the same value in `data-revision`. */
    revision: (): string => revisionOf(bench.text),
    /** Time from the last change to its result, in ms. engineMs is the time that the engine needed. */
    lastMs: (): number => bench.lastMs,
    engineMs: (): number => bench.solved?.milliseconds ?? NaN,
  };
}
