// Compares two JSON texts: equal bits, or equal except for the last digits of numbers.
//
//   error   |a − b| / max(|a|, |b|, scale). The scale is the size of the terms from which the number is
//           computed, in the unit at the end of its key. The transmission error of a conjugate pair is the
//           difference of two angles of about 1 rad, and a gap is the difference of two radii. Both are 0
//           except for the rounding errors of these terms.

/** For contact: 45 units in the last place of numbers of 1. Sums of products in another order differ by a few. */
export const kNear = 1e-14;
/** For results of a solved system: the stiffness of a section. */
export const kSolved = 1e-10;

const kLengths = 100; // mm: a large length of the examples
// N/mm²: a root stress is a difference of terms E u/h. With u = 17 µm and elements of h < 1 mm, they exceed 3000.
const kStresses = 1000;
// N/mm²: the nominal root stress of ISO 6336-3, by which a root stress is divided, is less than this in the examples.
const kNominalStress = 200;
const units = [
  [/root_stress_MPa$/, kStresses],
  [/root_stress_over_nominal$/, kStresses / kNominalStress],
  [/_arcsec$/, (180 * 3600) / Math.PI],
  [/_deg$/, 180 / Math.PI],
  [/_mm$/, kLengths],
  [/_um$/, 1000 * kLengths],
];

/** The scale of a key, "contact.positions[3].point_mm[1]". */
export function scaleOf(path) {
  const key = path.slice(path.lastIndexOf(".") + 1).replace(/\[\d+\]/g, "");
  const unit = /_per_/.test(key) ? undefined : units.find(([ending]) => ending.test(key));
  return unit ? unit[1] : 1;
}

/** Compares two trees. */
export function compare(a, b, path = "", found = { numbers: 0, bits: 0, differing: [], faults: [] }) {
  const into = (x, y, step) => compare(x, y, path + step, found);
  if (typeof a === "number" && typeof b === "number") {
    found.numbers += 1;
    if (Object.is(a, b)) {
      found.bits += 1;
    } else {
      const size = Math.max(Math.abs(a), Math.abs(b));
      const error = Math.abs(a - b) / Math.max(size, scaleOf(path));
      found.differing.push({ path, a, b, error, relative: Math.abs(a - b) / size });
    }
  } else if (Array.isArray(a) && Array.isArray(b)) {
    if (a.length !== b.length) found.faults.push(`${path}: ${a.length} and ${b.length} elements`);
    a.slice(0, b.length).forEach((x, i) => into(x, b[i], `[${i}]`));
  } else if (a && b && typeof a === "object" && typeof b === "object") {
    for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
      if (!(key in a) || !(key in b)) found.faults.push(`${path}.${key} is only on one side`);
      else into(a[key], b[key], `.${key}`);
    }
  } else if (a !== b) {
    found.faults.push(`${path}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`);
  }
  return found;
}
