// Combines the verdicts of the engine on the mounted pair, its contact, its load and its rating into one
// verdict on the spec on screen. The level is the worst of their levels, and every finding is listed once.
// The verdict also names the parts that are pending and the parts that the engine cannot judge.

import type { Verdict } from "./engine_worker";
import { at, bench } from "./workbench";

export const kParts = ["contact", "rating", "load"] as const;
export type Part = (typeof kParts)[number];
/** The verdict on one part, or the reason why there is none. */
type Judged = { verdict?: Verdict; error?: { message: string } };
const kLevels = ["green", "amber", "red"];

/** Combines verdicts. The headline belongs to the worst verdict. All findings are listed, worst first. */
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

  /** Stores the verdict on one part of the spec with this text. */
  take(part: Part, text: string, { verdict, error }: Judged): void {
    this.answers.set(part, { verdict, error, text });
    for (const listener of this.listeners) listener();
  }
  /** Returns the verdict on a part, if it belongs to the spec on screen, otherwise null. */
  private of(part: Part): Judged | null {
    const last = this.answers.get(part);
    return last?.text === bench.text ? last : null;
  }

  /** The parts that the engine can judge for the spec, in addition to the pair itself. */
  private get wanted(): Part[] {
    const { solved } = bench;
    const verdict = solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!bench.settled || !solved?.hasPair || solved.fault || !verdict) return [];
    const wanted = (part: Part) =>
      verdict.not_judged?.includes(part) ??
      (part === "contact" || at(solved.spec, part === "load" ? "load.torque_Nm" : part) !== undefined);
    return kParts.filter(wanted);
  }

  get pending(): Part[] {
    return this.wanted.filter((part) => !this.of(part));
  }
  /** The parts that the engine could not judge, with the reasons. */
  get refused(): [Part, string][] {
    return this.wanted.flatMap((part) => {
      const error = this.of(part)?.error;
      return error ? [[part, error.message]] : [];
    });
  }
  /** The verdict on all parts that have been judged, or null if the spec has no result. */
  get verdict(): Verdict | null {
    const pair = bench.solved?.result?.["verdict"] as unknown as Verdict | undefined;
    if (!pair) return null;
    return worstOf([pair, ...kParts.flatMap((part) => this.of(part)?.verdict ?? [])]);
  }
}
export const judgement = new Judgement();
