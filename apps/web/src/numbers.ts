// Formats numbers for users with the digits and units of the catalogue, in mm or in inches.

import type { Quantity } from "../engine/engine";
import type { Json } from "./engine_worker";

const kMmPerInch = 25.4;
let inches = localStorage.getItem("gearwright.unit") === "in";
const listeners = new Set<() => void>();

/** Sets whether lengths are shown in "mm" or "in". */
export function showLengthsIn(unit: string): void {
  inches = unit === "in";
  localStorage.setItem("gearwright.unit", unit);
  for (const listener of listeners) listener();
}
export function onUnitChange(listener: () => void): void {
  listeners.add(listener);
}

/** The unit shown with a value. */
export function shownUnit(unit: string): string {
  return unit === "mm" && inches ? "in" : unit;
}
/** Converts a value to the shown unit. fromShown() is its inverse. */
export function toShown(value: number, unit: string): number {
  return unit === "mm" && inches ? value / kMmPerInch : value;
}
export function fromShown(value: number, unit: string): number {
  return unit === "mm" && inches ? clean(value * kMmPerInch) : value;
}
/** Removes rounding errors in the last bits. For example, 0.1 in becomes exactly 2.54 mm. */
function clean(value: number): number {
  return Number(value.toPrecision(14));
}

/** The number with a fixed number of decimals. If it is rounded to zero, it has no sign. */
export function fixed(value: number, digits: number): string {
  if (!Number.isFinite(value)) return "–";
  if (Math.abs(value) >= 1e15) return value.toExponential(6);
  const text = value.toFixed(digits);
  return /^-[0.]+$/.test(text) ? text.slice(1) : text;
}

/** A length that is not in the catalogue, such as a coordinate in the housing frame, with its unit. */
export function length(mm: number, digits = 3): string {
  return fixed(toShown(mm, "mm"), inches ? digits + 1 : digits) + " " + shownUnit("mm");
}

/** A number in a field, as the shortest text from which the same number is read. */
export function short(value: number): string {
  return String(clean(value));
}

/** A value of a result as text for users, without its unit. */
export function textOf(quantity: Quantity, value: Json | undefined): string {
  if (value === null || value === undefined) return quantity.nothing || "–";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value.replaceAll("_", " ");
  if (Array.isArray(value))
    return value.length
      ? value.map((one) => textOf(quantity, one)).join(quantity.two === "ends" ? " … " : ", ")
      : "none";
  if (typeof value === "object") return "";
  if (quantity.type === "whole" || quantity.type === "index") return String(value);
  if (quantity.percent) return fixed(100 * value, quantity.digits);
  return fixed(toShown(value, quantity.unit), quantity.digits + (quantity.unit === "mm" && inches ? 1 : 0));
}

/** A step of 1, 2 or 5 times a power of ten, near `size`/`parts`. */
export function niceStep(size: number, parts = 100): number {
  const raw = Math.abs(size) / parts || 0.01;
  const ten = 10 ** Math.floor(Math.log10(raw));
  const lead = raw / ten;
  return ten * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}
/** Rounds to a multiple of the step and removes rounding errors. */
export function onStep(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toPrecision(12));
}
