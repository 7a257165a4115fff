// The interface for scripts: tests, and users of the browser's console.
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
    /** The answer on screen is that of the text on screen. */
    settled: (): boolean => bench.solved?.text === bench.text,
    /** The engine has nothing more to do. */
    idle: (): boolean =>
      bench.solved?.text === bench.text &&
      !page.tabs.busy &&
      [bench.front, bench.back, bench.press, bench.seek].every((one) => one.idle),
    /** Nothing of the verdict is pending. */
    judged: (): boolean => bench.solved?.text === bench.text && judgement.pending.length === 0,
    /** Which spec is on screen: pictures of it have the same in `data-revision`. */
    revision: (): string => revisionOf(bench.text),
    /** Of the last change: until the answer was here, and what of it was the engine's work. */
    lastMs: (): number => bench.lastMs,
    engineMs: (): number => bench.solved?.milliseconds ?? NaN,
  };
}
