// One verdict for the spec on screen from all results of the engine: the mounted pair, its contact,
// its load, its rating. The worst level counts, and every finding is listed once. Parts that are
// still being computed, or that the engine rejected, are named.

import type { Verdict } from "./engine_worker";
import { at, bench } from "./workbench";

export const kParts = ["contact", "rating", "load"] as const;
export type Part = (typeof kParts)[number];
/** What an answer has of it, or why there is none. */
type Judged = { verdict?: Verdict; error?: { message: string } };
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
  private readonly answers = new Map<Part, Judged & { text: string }>();
  private readonly listeners = new Set<() => void>();

  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** What the engine came to for a part of a spec. */
  take(part: Part, text: string, { verdict, error }: Judged): void {
    this.answers.set(part, { verdict, error, text });
    for (const listener of this.listeners) listener();
  }
  /** The same for the spec on screen. */
  private of(part: Part): Judged | null {
    const last = this.answers.get(part);
    return last?.text === bench.text ? last : null;
  }

  /** What the spec lets the engine judge beside the pair itself. */
  private get wanted(): Part[] {
    const { solved } = bench;
    const verdict = solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!bench.settled || !solved?.hasPair || solved.fault || !verdict) return [];
    const wanted = (part: Part) =>
      verdict.not_judged?.includes(part) ??
      (part === "contact" || at(solved.spec, part === "load" ? "load.torque_Nm" : part) !== undefined);
    return kParts.filter(wanted);
  }

  /** What is still to be computed. */
  get pending(): Part[] {
    return this.wanted.filter((part) => !this.of(part));
  }
  /** What the engine refused to judge, and why. */
  get refused(): [Part, string][] {
    return this.wanted.flatMap((part) => {
      const error = this.of(part)?.error;
      return error ? [[part, error.message]] : [];
    });
  }
  /** The verdict of all that was judged; null where there is no pair. */
  get verdict(): Verdict | null {
    const pair = bench.solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!pair) return null;
    return worstOf([pair, ...kParts.flatMap((part) => this.of(part)?.verdict ?? [])]);
  }
}
export const judgement = new Judgement();
