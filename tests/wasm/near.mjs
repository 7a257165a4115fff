// Two JSON texts compared: the same bits, or the same but for the last digits of numbers.
//
//   relative error   |a − b| / max(|a|, |b|); a number that is small beside its like, an error in µm of
//                    lengths in mm, is measured against `scale`

/** What two trees have in common: {bits, worst, where, faults}. */
export function compare(a, b, path = "", found = { numbers: 0, bits: 0, worst: 0, where: "", faults: [] }) {
  if (typeof a === "number" && typeof b === "number") {
    found.numbers += 1;
    if (Object.is(a, b)) {
      found.bits += 1;
    } else {
      const error = Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b));
      if (error > found.worst) Object.assign(found, { worst: error, where: `${path} ${a} ${b}` });
      found.differing ??= [];
      found.differing.push({ path, a, b, error });
    }
  } else if (Array.isArray(a) && Array.isArray(b)) {
    if (a.length !== b.length) found.faults.push(`${path}: ${a.length} and ${b.length} elements`);
    a.slice(0, b.length).forEach((x, i) => compare(x, b[i], `${path}[${i}]`, found));
  } else if (a && b && typeof a === "object" && typeof b === "object") {
    const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
    for (const key of keys) {
      if (!(key in a) || !(key in b)) found.faults.push(`${path}.${key} is only on one side`);
      else compare(a[key], b[key], `${path}.${key}`, found);
    }
  } else if (a !== b) {
    found.faults.push(`${path}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`);
  }
  return found;
}
