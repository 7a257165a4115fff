// One verdict of the spec on screen, out of all answers that the engine has given about it: the pair
// as it is mounted, its contact, its load, its rating. The worst level wins, and every finding is
// listed once. What is still to be computed is named, and so is what the engine refused.

import type { Fault, Verdict } from "./engine_worker";
import { at, bench } from "./workbench";

export const kParts = ["contact", "rating", "load"] as const;
export type Part = (typeof kParts)[number];
type Judged = { verdict: Verdict } | { refused: string };
const kLevels = ["green", "amber", "red"];

/** The worst of several verdicts: its headline, and the findings of all, worst first. */
export function worstOf(verdicts: Verdict[]): Verdict {
  const rank = (level: string) => kLevels.indexOf(level);
  const worst = verdicts.reduce((a, b) => (rank(b.level) > rank(a.level) ? b : a));
  const once = new Map(
    verdicts
      .flatMap((one) => one.findings)
      .map((one) => [JSON.stringify([one.code, one.gear, one.message]), one]),
  );
  const findings = [...once.values()].sort((a, b) => rank(b.level) - rank(a.level));
  return { level: worst.level, headline: worst.headline, findings };
}

class Judgement {
  private text = "";
  private readonly answers = new Map<Part, Judged>();
  private readonly listeners = new Set<() => void>();

  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** What the engine came to for a part of a spec; of another spec than the one on screen it is
   *  let go. */
  take(part: Part, text: string, answer: { verdict?: Verdict; error?: Fault }): void {
    if (text !== bench.text) return;
    this.follow();
    if (answer.error) this.answers.set(part, { refused: answer.error.message });
    else if (answer.verdict) this.answers.set(part, { verdict: answer.verdict });
    for (const listener of this.listeners) listener();
  }

  private follow(): void {
    if (this.text === bench.text) return;
    this.text = bench.text;
    this.answers.clear();
  }

  /** What the spec lets the engine judge beside the pair itself. */
  private get wanted(): Part[] {
    const { solved } = bench;
    const verdict = solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!bench.settled || !solved?.hasPair || solved.fault || !verdict) return [];
    const asks = (part: Part) =>
      verdict.not_judged?.includes(part) ??
      (part === "contact" || at(solved.spec, part === "load" ? "load.torque_Nm" : part) !== undefined);
    return kParts.filter(asks);
  }

  /** What is still to be computed. */
  get pending(): Part[] {
    this.follow();
    return this.wanted.filter((part) => !this.answers.has(part));
  }
  /** What the engine refused to judge, and why. */
  get refused(): [Part, string][] {
    this.follow();
    return this.wanted.flatMap((part) => {
      const one = this.answers.get(part);
      return one && "refused" in one ? [[part, one.refused]] : [];
    });
  }
  /** The verdict of all that was judged; null where there is no pair. */
  get verdict(): Verdict | null {
    this.follow();
    const pair = bench.solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!pair) return null;
    const judged = kParts.flatMap((part) => {
      const one = this.answers.get(part);
      return one && "verdict" in one ? [one.verdict] : [];
    });
    return worstOf([pair, ...judged]);
  }
}
export const judgement = new Judgement();
