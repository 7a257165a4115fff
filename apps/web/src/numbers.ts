// Formats numbers for users with the digits and units of the catalogue, in mm or in inches.

import type { Quantity } from "../engine/engine";
import { inchUnit } from "./catalogue";
import type { Json } from "./engine_worker";

/** A unit, or a key or a quantity with its unit. Modules are in mm in both systems. */
type Dimension = string | { unit: string; key: string };
const kModules = /(^|_)modules?_mm$/;
let inches = localStorage.getItem("gearwright.unit") === "in";
const listeners = new Set<() => void>();

/** Sets whether lengths are shown in "mm" or "in". */
export function showLengthsIn(unit: string): void {
  inches = unit === "in";
  localStorage.setItem("gearwright.unit", unit);
  for (const listener of listeners) listener();
}
export function lengthUnit(): "mm" | "in" {
  return inches ? "in" : "mm";
}
export function onUnitChange(listener: () => void): void {
  listeners.add(listener);
}

const unitOf = (of: Dimension) => (typeof of === "string" ? of : of.unit);
const inInch = (of: Dimension) =>
  inches && (typeof of === "string" || !kModules.test(of.key)) ? inchUnit(unitOf(of)) : undefined;

/** Returns the unit shown with a value. */
export function shownUnit(of: Dimension): string {
  return inInch(of)?.[0] ?? unitOf(of);
}
/** Converts a value to the shown unit. fromShown() is its inverse. */
export function toShown(value: number, of: Dimension): number {
  return value / (inInch(of)?.[1] ?? 1);
}
export function fromShown(value: number, of: Dimension): number {
  const size = inInch(of)?.[1];
  return size === undefined ? value : clean(value * size);
}
/** Returns a value without its unit. `digits` is the number of decimals in the unit of the catalogue. */
export function shownText(value: number, of: Dimension, digits: number): string {
  return fixed(toShown(value, of), Math.max(0, digits + (inInch(of)?.[2] ?? 0)));
}
/** Returns a value with its unit and a true minus sign. */
export function amount(value: number, of: Dimension, digits: number): string {
  const unit = shownUnit(of);
  return shownText(value, of, digits).replace("-", "−") + (unit === "°" ? "" : " ") + unit;
}
/** Removes rounding errors in the last bits. For example, 0.1 in becomes exactly 2.54 mm. */
function clean(value: number): number {
  return Number(value.toPrecision(14));
}

/** Returns the number with a fixed number of decimals. If it is rounded to zero, it has no sign. */
export function fixed(value: number, digits: number): string {
  if (!Number.isFinite(value)) return "–";
  if (Math.abs(value) >= 1e15) return value.toExponential(6);
  const text = value.toFixed(digits);
  return /^-[0.]+$/.test(text) ? text.slice(1) : text;
}

/** Returns a length that is not in the catalogue, such as a coordinate in the housing frame, with its unit. */
export function length(mm: number, digits = 3): string {
  return amount(mm, "mm", digits);
}

/** Returns a number in a field, as the shortest text from which the same number is read. */
export function short(value: number): string {
  return String(clean(value));
}

/** Returns a value of a result as text for users, without its unit. */
export function textOf(quantity: Quantity, value: Json | undefined): string {
  if (value === null || value === undefined) return quantity.nothing || "–";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value.replaceAll("_", " ");
  if (Array.isArray(value))
    return value.length
      ? (quantity.two === "fraction" && value[1] === 1 ? value.slice(0, 1) : value)
          .map((one) => textOf(quantity, one))
          .join({ values: ", ", gears: ", ", ends: " … ", fraction: "/" }[quantity.two] ?? ", ")
      : "none";
  if (typeof value === "object") return "";
  if (quantity.type === "whole" || quantity.type === "index") return String(value);
  if (quantity.percent) return fixed(100 * value, quantity.digits);
  // A small number without a unit, such as a damage, is not printed as zero.
  const size = Math.abs(value);
  if (!quantity.unit && size > 1e-9 && size < 0.5 * 10 ** -quantity.digits) return value.toExponential(1);
  return shownText(value, quantity, quantity.digits);
}

/** Returns a step of 1, 2 or 5 times a power of ten, near `size`/`parts`. */
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
