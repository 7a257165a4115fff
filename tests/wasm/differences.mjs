// Compares two JSON texts and lists the numbers with other bits, so that a failure shows their size.

/** Compares two trees. */
export function compare(a, b, path = "", found = { numbers: 0, differing: [], faults: [] }) {
  const into = (x, y, step) => compare(x, y, path + step, found);
  if (typeof a === "number" && typeof b === "number") {
    found.numbers += 1;
    if (!Object.is(a, b)) found.differing.push({ path, a, b, relative: Math.abs(a - b) / Math.max(Math.abs(a), Math.abs(b)) });
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
