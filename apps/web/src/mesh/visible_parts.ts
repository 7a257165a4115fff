// Removes parts of the figure of the mesh that are outside the picture, so that it can be drawn in every frame
// while a value changes. These parts are most teeth and most of the circles. The visible parts are the same as in
// the complete figure, except that dashes can be displaced along their circle by some pixels.

import { svg } from "../elements";

type Box = { left: number; right: number; top: number; bottom: number }; // px

const kStrokes = 8; // px, more than half the width of a line

/** Removes invisible parts of a new figure. `shown` is the plot of the previous figure, whose gears have their
 *  current positions, and `size` is the size of the picture on screen, px. */
export function keepVisible(nodes: DocumentFragment, shown: Element | null, size: [number, number]): void {
  const [x, y, width, height] = (nodes.querySelector("svg")?.getAttribute("viewBox") ?? "").split(" ").map(Number);
  // The size is 0 while another tab is shown.
  if (!shown || x === undefined || y === undefined || !width || !height || !size[0] || !size[1]) return;
  const box = { left: x, right: x + width, top: y, bottom: y + height };
  for (const gear of [0, 1]) keepTeeth(nodes, shown, gear, box);
  const scale = Math.min(size[0] / width, size[1] / height);
  for (const circle of nodes.querySelectorAll("circle.thin")) keepArcs(circle, shown, box, scale);
}

function grown({ left, right, top, bottom }: Box, by: number): Box {
  return { left: left - by, right: right + by, top: top - by, bottom: bottom + by };
}
function inside(x: number, y: number, box: Box): boolean {
  return x > box.left && x < box.right && y > box.top && y < box.bottom;
}
/** Returns the numbers of a function in a transform, for example [10, 20] for "translate(10 20)". */
function numbersIn(transform: string | null | undefined, name: string): number[] | undefined {
  return transform?.match(new RegExp(`${name}\\(([^)]*)\\)`))?.[1]?.split(" ").map(Number);
}

/** Removes the teeth of a gear whose roots are more than two pitches outside the picture. A tooth extends over
 *  less than two pitches from its root. */
function keepTeeth(nodes: DocumentFragment, shown: Element, gear: number, box: Box): void {
  const of = `use[data-turn][data-gear="${gear}"]`;
  const [use, old] = [nodes.querySelector(of), shown.querySelector(of)];
  // The angle is that of the previous figure. If the number of teeth has changed, it is not known.
  if (!use || !old || use.getAttribute("data-turn") !== old.getAttribute("data-turn")) return;
  const [cx, cy] = numbersIn(use.getAttribute("transform"), "translate") ?? [];
  const [scale] = numbersIn(use.getAttribute("transform"), "scale") ?? [];
  const [turned] = numbersIn(old.getAttribute("transform"), "rotate") ?? [];
  const id = CSS.escape(use.getAttribute("href")!.slice(1));
  const teeth = nodes.querySelectorAll(`#${id} > use[href="#${id}-tooth"]`);
  const outline = nodes.querySelector(`path#${id}-tooth, #${id}-tooth path`)?.getAttribute("d");
  const start = outline?.match(/^M(-?\d+) (-?\d+)/); // in the middle of the space before the tooth
  if (cx === undefined || cy === undefined || !scale || turned === undefined || !start) return;
  const radius = scale * Math.hypot(Number(start[1]), Number(start[2]));
  const near = grown(box, (2 * 2 * Math.PI * radius) / teeth.length);
  for (const tooth of teeth) {
    const [at] = numbersIn(tooth.getAttribute("transform"), "rotate") ?? [];
    if (at === undefined) return;
    const angle = ((turned + at) * Math.PI) / 180;
    if (!inside(cx + radius * Math.cos(angle), cy + radius * Math.sin(angle), near)) tooth.remove();
  }
}

/** Returns the parts of a circle in a box, as angles from the x axis towards the y axis, 0 … 2π. */
function arcsInside(cx: number, cy: number, r: number, box: Box): [number, number][] {
  const full = 2 * Math.PI;
  const cuts = [0, full];
  for (const cos of [(box.left - cx) / r, (box.right - cx) / r])
    if (Math.abs(cos) < 1) cuts.push(Math.acos(cos), full - Math.acos(cos));
  for (const sin of [(box.top - cy) / r, (box.bottom - cy) / r])
    if (Math.abs(sin) < 1) cuts.push((Math.asin(sin) + full) % full, Math.PI - Math.asin(sin));
  cuts.sort((a, b) => a - b);
  return cuts.slice(1).flatMap((to, i): [number, number][] => {
    const from = cuts[i]!;
    const middle = (from + to) / 2;
    return inside(cx + r * Math.cos(middle), cy + r * Math.sin(middle), box) ? [[from, to]] : [];
  });
}

const periods = new Map<string, number>();
/** Returns the length of a dash pattern with its gaps, px, or 0 if the line is solid. */
function periodOf(style: string, shown: Element): number | undefined {
  if (!periods.has(style)) {
    const circle = [...shown.querySelectorAll("circle.thin")].find((one) => one.getAttribute("class") === style);
    if (!circle) return undefined;
    const dashes = getComputedStyle(circle).strokeDasharray.split(/[ ,]+/).map(parseFloat).filter(Number.isFinite);
    periods.set(style, dashes.reduce((sum, one) => sum + one, 0));
  }
  return periods.get(style);
}

/** Replaces a circle by its visible arcs. The browser computes the dashes of a line once for each tile of the
 *  screen that its bounding box touches. An arc begins with a dash, where the circle has one. */
function keepArcs(circle: Element, shown: Element, box: Box, scale: number): void {
  const style = circle.getAttribute("class")!;
  const period = periodOf(style, shown);
  if (period === undefined) return;
  const [cx, cy, r] = ["cx", "cy", "r"].map((name) => Number(circle.getAttribute(name))) as [number, number, number];
  const at = (angle: number) => `${(cx + r * Math.cos(angle)).toFixed(3)} ${(cy + r * Math.sin(angle)).toFixed(3)}`;
  const step = period / (r * scale);
  const visible = arcsInside(cx, cy, r, grown(box, kStrokes));
  if (visible.length === 1 && visible[0]![1] - visible[0]![0] === 2 * Math.PI) return; // an arc cannot be a whole circle
  const arcs = visible.map(([from, to]) => {
    const begin = step ? Math.floor(from / step) * step : from;
    return `M${at(begin)}A${r} ${r} 0 ${to - begin > Math.PI ? 1 : 0} 1 ${at(to)}`;
  });
  circle.replaceWith(svg("path", { class: style, "data-center": `${cx} ${cy}`, d: arcs.join("") }));
}

/** Returns the centre of a circle, or of the circle whose arcs are shown, px. */
export function centerOf(circle: Element): [number, number] {
  const center = circle.getAttribute("data-center")?.split(" ") ?? ["cx", "cy"].map((name) => circle.getAttribute(name));
  return center.map(Number) as [number, number];
}
