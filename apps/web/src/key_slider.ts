// A slider for a number of the spec, with the words and the symbol of its key, and with its value.

import type { InputKey } from "../engine/engine";
import { h, onKeys, symbol, type Properties } from "./elements";

export interface KeySlider {
  place: string; // path of the number in the spec
  key: InputKey;
  input: HTMLInputElement;
  output: HTMLOutputElement; // shows the value
  row: HTMLElement;
}

/** Makes a slider. `name` is its name for screen readers, and `range` contains its ends and its
 *  step. `moved` is called while the slider moves. A double click or the key 0 calls `reset`. */
export function keySlider(
  { place, key, words, name }: { place: string; key: InputKey; words: string; name: string },
  range: Properties,
  moved: () => void,
  reset: () => void,
): KeySlider {
  const output = h("output", {});
  const properties = { type: "range", "aria-label": name, "data-slide": place, ...range };
  const input = h("input", { ...properties, input: moved, dblclick: reset });
  onKeys(input, { "0": reset });
  const head = h("span", { class: "slider-words" }, words, " ", symbol(key.symbol));
  const row = h("label", { class: "slider", title: key.meaning }, head, output, input);
  return { place, key, input, output, row };
}
