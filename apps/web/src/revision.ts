// Identifies the spec of each picture by a revision. If a picture does not belong to the spec on screen, it is dimmed,
// and a spinner is shown while the next picture is being made.

/** A hash of the text (32-bit FNV-1a) in hexadecimal digits, or "" if there is no text. */
export function revisionOf(text: string): string {
  if (!text) return "";
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

/** Marks a picture with the text for which it was `made`. `wanted` is the text on screen. A picture of another text
 *  is "working" while the next picture is being made, and "kept" until the spec can be solved again. */
export function markRevision(picture: HTMLElement, made: string, wanted: string, working = true): void {
  const stale = made !== "" && made !== wanted;
  picture.dataset["revision"] = revisionOf(made);
  if (stale) picture.dataset["stale"] = working ? "working" : "kept";
  else delete picture.dataset["stale"];
}
