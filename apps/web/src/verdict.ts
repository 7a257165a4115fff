// The verdict at the top of the page shows the level, the worst finding in one sentence, and
// the parts that are still pending. If the user unfolds the verdict, every finding is listed
// with its remedy. The engine provides the sentences.

import { fill, foldOut, h } from "./elements";
import type { Finding, Notice } from "./engine_worker";
import { judgement } from "./judgement";
import { bench } from "./workbench";

/** The headline for a spec with unknown values, by the verb that computes them. */
const kFinders = {
  search: "This spec describes a search. Open the tab “search” to run it.",
  fit: "Some values of this spec are unknown. The tab “search” computes them.",
  identify: "This spec contains measurements of an unknown gear. The tab “search” lists the gears that fit them.",
};
const kBadges: Record<string, string> = { green: "Runs", amber: "Check", red: "Does not run" };

export class VerdictLine {
  private readonly level = h("b", { class: "level" }, "…");
  private readonly headline = h("span", { class: "headline" });
  private readonly scope = h("span", { class: "scope" });
  private readonly list = h("ul", { class: "findings", id: "findings" });
  private readonly opener = h(
    "button",
    { type: "button", class: "verdict", "aria-controls": "findings" },
    this.level,
    this.scope,
    this.headline,
  );
  readonly element = foldOut("verdict-box", this.opener, this.list);

  constructor() {
    this.element.setAttribute("aria-live", "polite");
    bench.on("read", () => this.update());
    bench.on("searched", () => this.update());
    bench.on("opened", () => this.wait());
    judgement.onChange(() => this.update());
  }

  private head(level: string, word: string, headline: string): void {
    this.opener.dataset["level"] = level;
    this.level.textContent = word;
    this.headline.textContent = headline;
    this.opener.title = headline;
  }

  /** Clears the verdict when another design is opened. */
  private wait(): void {
    this.head("none", "…", "");
    fill(this.scope);
    fill(this.list);
  }

  private update(): void {
    const solved = bench.solved;
    if (!solved) return;
    const verdict = judgement.verdict;
    let findings: Finding[] = verdict?.findings ?? [];
    if (solved.fault) {
      findings = [];
      const { searched } = bench;
      if (bench.finder === "search" && searched.text === solved.text) this.head("none", "search", searched.words);
      else if (bench.finder) this.head("none", bench.finder, kFinders[bench.finder]);
      else this.head("fault", "incomplete", solved.fault.message);
    } else if (verdict) this.head(verdict.level, kBadges[verdict.level] ?? verdict.level, verdict.headline);
    else {
      const warnings = (solved.result?.["warnings"] ?? []) as unknown as Notice[];
      findings = warnings.map((one) => ({ ...one, level: "amber", remedy: null }));
      const [first] = findings;
      this.head(first?.level ?? "none", "gear", first?.message ?? "This is a single gear. A pair needs a second gear.");
    }
    const { pending, refused } = judgement;
    const open = [
      pending.length ? `${pending.join(", ")} pending` : "",
      refused.length ? `${refused.map(([part]) => part).join(", ")} not judged` : "",
    ];
    fill(this.scope, open.filter(Boolean).join("; "));
    const whole = h("li", { class: "whole" }, this.headline.textContent);
    fill(
      this.list,
      whole,
      ...findings.map(findingItem),
      !findings.length && h("li", {}, "No further findings."),
      pending.length > 0 && h("li", { class: "soft" }, `Parts still to be judged: ${pending.join(", ")}.`),
      ...refused.map(([part, reason]) => h("li", { class: "soft" }, `Not judged: ${part}. ${reason}`)),
    );
  }
}

function findingItem(one: Finding): HTMLElement {
  return h(
    "li",
    { "data-level": one.level },
    one.gear ? h("span", { class: "where g" + one.gear }, `gear ${one.gear}`) : null,
    h("span", {}, one.message),
    one.remedy ? h("span", { class: "remedy" }, " " + one.remedy) : null,
  );
}

/** Returns the messages of a result. They are its findings that are not green, and the warnings that
 *  are not among them. */
export function noticesOf(warnings: Notice[], findings: Finding[] = []): HTMLElement[] {
  const grave = findings.filter((one) => one.level !== "green");
  const found = new Set(grave.map((one) => one.message));
  const more = warnings
    .filter((one) => !found.has(one.message))
    .map((one) => ({ ...one, level: "note", remedy: null }));
  return [...grave, ...more].map(findingItem);
}
