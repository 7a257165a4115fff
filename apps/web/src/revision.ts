// Each picture stores the revision of the spec that it shows. If this revision differs from the revision of
// the spec on screen, the picture is stale. A stale picture that is not renewed for a moment is dimmed, and a
// spinner is shown while the next picture is being made.

/** Time after which a stale picture is dimmed, so that it does not flicker if the next picture comes quickly, ms. */
const kDimMs = 200;

/** Returns a hash of the text (32-bit FNV-1a) in hexadecimal digits, or "" if there is no text. */
export function revisionOf(text: string): string {
  if (!text) return "";
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

const waiting = new WeakMap<HTMLElement, number>();
const shown = new WeakMap<HTMLElement, string>(); // the text that each picture shows

/** Sets the class "late" of an element if it stays late for a moment. A script waits instead of the style sheet,
 *  because a browser makes a layer for an animation that has not begun, and draws it in every frame. */
export function markLate(element: HTMLElement, late: boolean): void {
  if (late) {
    if (!waiting.has(element))
      waiting.set(element, window.setTimeout(() => element.classList.add("late"), kDimMs));
    return;
  }
  clearTimeout(waiting.get(element));
  waiting.delete(element);
  element.classList.remove("late");
}

/** Marks a part of a picture as renewed. The picture is then not dimmed for another moment. */
export function markRenewed(picture: HTMLElement): void {
  if (!waiting.has(picture)) return;
  markLate(picture, false);
  markLate(picture, true);
}

/** Stores in a picture the revision of the text `made`, from which the picture was made. `wanted`
 *  is the text on screen. If the texts differ, the picture is marked "working" while the next
 *  picture is being made, otherwise "kept". */
export function markRevision(picture: HTMLElement, made: string, wanted: string, working = true): void {
  const stale = made !== "" && made !== wanted;
  if (shown.get(picture) !== made) {
    shown.set(picture, made);
    picture.dataset["revision"] = revisionOf(made);
    // While a value changes, the picture lags behind the spec, but it is renewed in every frame and not dimmed.
    markRenewed(picture);
  }
  markLate(picture, stale);
  if (stale) picture.dataset["stale"] = working ? "working" : "kept";
  else delete picture.dataset["stale"];
}
