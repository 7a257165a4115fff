// Each picture stores the revision of the spec that it shows. If this revision differs from the revision of
// the spec on screen, the picture is dimmed. A spinner is shown while the next picture is being made.

/** Returns a hash of the text (32-bit FNV-1a) in hexadecimal digits, or "" if there is no text. */
export function revisionOf(text: string): string {
  if (!text) return "";
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

/** Stores in a picture the revision of the text `made`, from which the picture was made. `wanted`
 *  is the text on screen. If the texts differ, the picture is marked "working" while the next
 *  picture is being made, otherwise "kept". */
export function markRevision(picture: HTMLElement, made: string, wanted: string, working = true): void {
  const stale = made !== "" && made !== wanted;
  picture.dataset["revision"] = revisionOf(made);
  if (stale) picture.dataset["stale"] = working ? "working" : "kept";
  else delete picture.dataset["stale"];
}
