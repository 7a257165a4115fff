// Identifies the spec of each picture by a revision. A picture of another spec than the one on
// screen is dimmed, and a spinner turns while its successor is being made.

/** A hash of the text, FNV-1a of 32 bits in hexadecimal digits; "" if there is no text. */
export function revisionOf(text: string): string {
  if (!text) return "";
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

/** Marks a picture with the text for which it was `made`. `wanted` is the text on screen. A stale
 *  picture is "working" while the next one is being made, or "kept" until the spec can be solved again. */
export function markRevision(picture: HTMLElement, made: string, wanted: string, working = true): void {
  const stale = made !== "" && made !== wanted;
  picture.dataset["revision"] = revisionOf(made);
  if (stale) picture.dataset["stale"] = working ? "working" : "kept";
  else delete picture.dataset["stale"];
}
