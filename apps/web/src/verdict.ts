// The verdict, always in sight: its level, the worst thing in one sentence, what is still to be judged,
// and on request every finding with what would help. The words are the engine's, the same as on the
// report.

import { fill, h } from "./elements";
import type { Finding, Json, Notice } from "./engine_worker";
import { judgement } from "./judgement";
import { bench } from "./workbench";

export class VerdictLine {
  private readonly level = h("b", { class: "level" }, "…");
  private readonly headline = h("span", { class: "headline" });
  private readonly scope = h("span", { class: "scope" });
  private readonly list = h("ul", { class: "findings", id: "findings" });
  private readonly opener = h(
    "button",
    {
      type: "button",
      class: "verdict",
      "aria-expanded": "false",
      "aria-controls": "findings",
      click: () => this.toggle(),
    },
    this.level,
    this.scope,
    this.headline,
  );
  readonly element = h("div", { class: "verdict-box", "aria-live": "polite" }, this.opener, this.list);

  constructor() {
    this.list.hidden = true;
    bench.on("solved", () => this.update());
    bench.on("opened", () => this.wait());
    judgement.onChange(() => this.update());
    document.addEventListener("pointerdown", (event) => {
      if (!this.list.hidden && !this.element.contains(event.target as Node)) this.toggle();
    });
    this.element.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !this.list.hidden) {
        this.toggle();
        this.opener.focus();
      }
    });
  }

  private toggle(): void {
    this.list.hidden = !this.list.hidden;
    this.opener.setAttribute("aria-expanded", String(!this.list.hidden));
  }

  private say(level: string, word: string, headline: string): void {
    this.opener.dataset["level"] = level;
    this.level.textContent = word;
    this.headline.textContent = headline;
    this.opener.title = headline;
  }

  /** Another design was opened: the verdict on the last one goes. */
  private wait(): void {
    this.say("none", "…", "");
    fill(this.scope);
    fill(this.list);
  }

  private update(): void {
    const solved = bench.solved;
    if (!solved) return;
    const verdict = judgement.verdict;
    const warnings = (solved.result?.["warnings"] ?? []) as unknown as {
      message: string;
      gear: number | null;
    }[];
    let findings: Finding[] = verdict?.findings ?? [];
    if (solved.fault) {
      if (bench.asks && solved.spec?.["search"] !== undefined)
        this.say("none", "search", "This spec asks for gears: the search finds them.");
      else if (bench.asks)
        this.say(
          "none",
          /identify finds/.test(solved.fault.message) ? "identify" : "fit",
          /identify finds/.test(solved.fault.message)
            ? "This spec has the readings of an unknown gear: the search says which gears have them."
            : "This spec leaves numbers to be found: the fit finds them.",
        );
      else {
        this.say("fault", "not yet", solved.fault.message);
        findings = [];
      }
    } else if (verdict) this.say(verdict.level, verdict.level, verdict.headline);
    else {
      findings = warnings.map((one) => ({
        code: "",
        level: "amber",
        gear: one.gear,
        message: one.message,
        remedy: null,
      }));
      const count = findings.length;
      this.say(
        count ? "amber" : "none",
        "gear",
        count ? findings[0]!.message : "One gear; a second one makes a pair.",
      );
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
      pending.length > 0 && h("li", { class: "soft" }, `Still being judged: ${pending.join(", ")}.`),
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

/** What an answer has to be read with: findings, and the warnings that are none of them. */
export function noticesOf(warnings: Notice[], findings: Finding[] = []): HTMLElement[] {
  const grave = findings.filter((one) => one.level !== "green");
  const told = new Set(grave.map((one) => one.message));
  const more = warnings
    .filter((one) => !told.has(one.message))
    .map((one) => ({ ...one, level: "note", remedy: null }));
  return [...grave, ...more].map(findingItem);
}

/** Whether the engine has an answer that is a pair of gears. */
export function pairOf(result: { [key: string]: Json } | null): { [key: string]: Json } | null {
  const pair = result?.["pair"];
  return pair && typeof pair === "object" && !Array.isArray(pair) ? pair : null;
}
