// Makes elements of the page without a framework.
//
// Every text becomes a text node, not markup. A spec can therefore not insert HTML into the page.

export type Child = Node | string | number | null | undefined | false;
type Handler = (event: never) => void;
export type Properties = Record<string, string | number | boolean | null | undefined | Handler>;

function dress(element: Element, properties: Properties, children: Child[]): void {
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  put(element, ...children);
}

/** Makes an element, for example h("button", {class: "plain", click: go}, "Open"). */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  dress(element, properties, children);
  return element;
}

/** Makes an SVG element. The arguments are the same as for h(). */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  dress(element, properties, children);
  return element;
}

function put(element: Element, ...children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : String(child));
  }
}

export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  put(element, ...children);
}

/** Returns a button with words. If the words are too short to be clear, the property `title` explains them. */
export function button(words: string, click: () => void, properties: Properties = {}): HTMLButtonElement {
  return h("button", { type: "button", click, ...properties }, words);
}

/** Returns a slider from `min` to `max` that calls `change` while it moves. */
export function slider(
  name: string,
  range: { min: number; max: number; step: number; value?: number },
  change: (value: number) => void,
): HTMLInputElement {
  const input = h("input", { type: "range", ...range, "aria-label": name });
  input.addEventListener("input", () => change(Number(input.value)));
  return input;
}
/** Returns a slider that belongs to a picture, with its name before it and its value after it. */
export function slide(words: string, of: HTMLInputElement, ...rest: Child[]): HTMLElement {
  return h("label", { class: "slide" }, h("span", {}, words), of, ...rest);
}
/** Returns a check box followed by its label. */
export function check(words: string, box: HTMLInputElement): HTMLElement {
  return h("label", { class: "check" }, box, words);
}

type Words = Record<string, string> | ArrayLike<string>;
/** A row of buttons of which one is pressed. */
export class Choice {
  readonly element: HTMLElement;
  constructor(
    name: string,
    options: Words, // the label of each value
    now: string,
    private readonly pick: (value: string) => void,
    properties: Properties = {},
  ) {
    this.element = h("div", { class: "choice", role: "group", "aria-label": name, ...properties });
    this.offer(options, now);
  }
  offer(options: Words, now: string): void {
    const one = ([value, words]: [string, string]) =>
      button(words, () => this.press(value), { "data-choice": value });
    fill(this.element, ...Object.entries<string>(options).map(one));
    this.show(now);
  }
  show(now: string): void {
    for (const one of this.element.querySelectorAll("button"))
      one.setAttribute("aria-pressed", String(one.dataset["choice"] === now));
  }
  private press(value: string): void {
    this.show(value);
    this.pick(value);
  }
}

/** Returns a panel that the button `opener` opens and closes. Escape or a click outside closes it, too. */
export function foldOut(
  style: string,
  opener: HTMLButtonElement,
  sheet: HTMLElement,
  opened: () => void = () => undefined,
): HTMLElement {
  const toggle = () => {
    sheet.hidden = !sheet.hidden;
    opener.setAttribute("aria-expanded", String(!sheet.hidden));
    if (!sheet.hidden) opened();
  };
  const holder = h("div", { class: style }, opener, sheet);
  sheet.hidden = true;
  opener.setAttribute("aria-expanded", "false");
  opener.addEventListener("click", toggle);
  document.addEventListener("pointerdown", (event) => {
    if (!sheet.hidden && !holder.contains(event.target as Node)) toggle();
  });
  holder.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || sheet.hidden) return;
    toggle();
    opener.focus();
  });
  return holder;
}

/** Calls the action for a key that is pressed while the element has the focus. `actions` maps keys to actions. */
export function onKeys(
  element: HTMLElement | SVGElement,
  acts: Record<string, (event: KeyboardEvent) => void>,
): void {
  element.addEventListener("keydown", (event) => {
    const act = acts[(event as KeyboardEvent).key];
    if (!act) return;
    event.preventDefault();
    act(event as KeyboardEvent);
  });
}

/** Returns a scrolling area that has a name for screen readers and can be scrolled with the keyboard. */
export function scroller(style: string, name: string, ...children: Child[]): HTMLDivElement {
  return h("div", { class: style, tabindex: "0", role: "region", "aria-label": name }, ...children);
}

export function tableOf(style: string, heads: Child[], ...rows: Child[]): HTMLTableElement {
  return h("table", { class: style }, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows));
}

/** Returns a symbol of the catalogue, such as "d_a", "F_z/F_t" or "α_wn", as italic letters with subscripts. */
export function symbol(text: string): HTMLElement {
  const whole = h("span", { class: "symbol" });
  for (const part of text.split(/(_[\p{L}\p{N},]+|(?<=\p{L})\d|\*)/u)) {
    if (!part) continue;
    if (part === "*") whole.append(h("sup", {}, "*"));
    else if (/^\d$/.test(part) || (part.startsWith("_") && part.length > 1))
      whole.append(h("sub", {}, part.replace("_", "")));
    else
      for (const piece of part.split(/([\p{L}]+)/u))
        if (piece) whole.append(/\p{L}/u.test(piece) ? h("var", {}, piece) : piece);
  }
  return whole;
}

/** Returns a colour in the current colour scheme, for example colour("g1-fill"). */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement)
    .getPropertyValue("--" + name)
    .trim();
}

/** Calls `then` when the colour scheme changes between light and dark. */
export function onThemeChange(then: () => void): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", then);
}

/** Returns a function that requests `paint` for the next frame. Several requests cause only one call. */
export function onNextFrame(paint: () => void): () => void {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      paint();
    });
  };
}

export function sentenceOf(reason: unknown): string {
  return reason instanceof Error ? reason.message : String(reason);
}

/** Offers the bytes to the user as a download. */
export function download(name: string, bytes: BlobPart, type = "application/octet-stream"): void {
  const address = URL.createObjectURL(new Blob([bytes], { type }));
  const link = h("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
