// Elements of the page, made without a framework.
//
// Every text goes in as a text node, never as markup: what a person writes in a spec stays text
// wherever it is shown.

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

/** h("button", {class: "plain", click: go}, "Open") */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  dress(element, properties, children);
  return element;
}

/** The same for a picture. */
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

/** Takes everything out of an element and puts these in. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  put(element, ...children);
}

/** A button that says what it does; `title` only where the words are short. */
export function button(words: string, click: () => void, properties: Properties = {}): HTMLButtonElement {
  return h("button", { type: "button", click, ...properties }, words);
}

/** A room that scrolls by itself: the keyboard reaches it, and a screen reader knows its name. */
export function scroller(style: string, name: string, ...children: Child[]): HTMLDivElement {
  return h("div", { class: style, tabindex: "0", role: "region", "aria-label": name }, ...children);
}

/** A symbol of the catalogue, "d_a", "F_z/F_t", "α_wn": letters slanted, indices below. */
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

/** What a colour of the house is now, light or dark: colour("g1-fill"). */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement)
    .getPropertyValue("--" + name)
    .trim();
}

/** Calls `then` when light becomes dark or the other way round. */
export function onThemeChange(then: () => void): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", then);
}

/** Hands a file to the person who asked for it. */
export function download(name: string, bytes: BlobPart, type = "application/octet-stream"): void {
  const address = URL.createObjectURL(new Blob([bytes], { type }));
  const link = h("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** A picture, a curve or a map with its title and what is to be said of it. */
export function figure(of: Element, title: Node, ...rest: (string | Node)[]): HTMLElement {
  return h("figure", {}, of, h("figcaption", {}, title, ...rest));
}

/** The same for a map of the flank of gear 1 or 2, in its gear's colour. */
export function flankFigure(gear: 1 | 2, map: Element, words: string): HTMLElement {
  return figure(map, h("b", { class: `g${gear}` }, `Flank of gear ${gear}`), words);
}
