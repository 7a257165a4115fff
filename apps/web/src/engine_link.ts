// The engine runs in workers, so no computation blocks the page.
//
//   front   solves the design on screen in milliseconds; it does nothing that takes longer
//   back    runs long computations: solids, patterns, maps, reports, files
//   press   computes teeth under load and keeps their compliance from one torque to the next
//   seek    runs searches and fits and keeps their results
//
// `latest` drops requests that a newer request of the same kind has made obsolete. At any time, at
// most one request of each kind is being computed, and at most one is waiting. The result of a
// dropped request is null.

import type { Questions } from "./engine_worker";
import { onUnitChange, lengthUnit } from "./numbers";

export type Name = keyof Questions;
export type Answer<N extends Name> = Awaited<ReturnType<Questions[N]>>;
export type Progress = (done: number, of: number, sofar?: unknown) => void;

/** The error that is thrown if the user ends the work. */
export class Cancelled extends Error {
  override message = "cancelled";
}

interface Pending {
  resolve(answer: unknown): void;
  reject(reason: unknown): void;
  progress?: Progress;
}
interface Reply {
  id: number;
  answer?: unknown;
  failed?: string;
  broken?: string;
  progress?: [number, number, unknown];
}
interface Waiting {
  go(): void;
  drop(): void;
}

export class EngineLink {
  private worker: Worker | null = null;
  private readonly pending = new Map<number, Pending>();
  private readonly channels = new Map<string, Waiting | null>();
  private next = 1;
  private starting = 0;

  constructor(
    private readonly make: () => Worker,
    private readonly wasm: () => Promise<ArrayBuffer>,
  ) {
    onUnitChange(() => this.worker?.postMessage({ unit: lengthUnit() }));
  }

  get idle(): boolean {
    return this.pending.size === 0 && this.starting === 0;
  }

  private async start(): Promise<Worker> {
    ++this.starting;
    const bytes = await this.wasm().finally(() => --this.starting);
    if (this.worker) return this.worker;
    const worker = this.make();
    this.worker = worker;
    worker.onmessage = (event: MessageEvent) => this.take(event.data);
    worker.onerror = (event) => this.fail(new Error(event.message || "the engine has stopped"));
    worker.postMessage({ wasm: bytes, unit: lengthUnit() });
    return worker;
  }

  private take(message: Reply): void {
    if (message.broken !== undefined) return this.fail(new Error(message.broken));
    const pending = this.pending.get(message.id);
    if (!pending) return;
    if (message.progress) return pending.progress?.(...message.progress);
    this.pending.delete(message.id);
    if (message.failed !== undefined) pending.reject(new Error(message.failed));
    else pending.resolve(message.answer);
  }

  private fail(reason: unknown): void {
    for (const pending of this.pending.values()) pending.reject(reason);
    this.pending.clear();
    this.worker?.terminate();
    this.worker = null;
  }

  async call<N extends Name>(
    name: N,
    question: Parameters<Questions[N]>[0],
    progress?: Progress,
  ): Promise<Answer<N>> {
    return (await this.send(name, question, progress)) as Answer<N>;
  }

  private async send(name: Name, question: unknown, progress?: Progress, channel?: string): Promise<unknown> {
    const worker = this.worker ?? (await this.start());
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.pending.set(id, { resolve, reject, progress });
      worker.postMessage({ id, name, question, channel });
    });
  }

  /** Sends a request. The request is dropped if a newer request on this channel arrives before it
   *  starts. */
  latest<N extends Name>(
    channel: string,
    name: N,
    question: Parameters<Questions[N]>[0],
    progress?: Progress,
  ): Promise<Answer<N> | null> {
    return new Promise((resolve, reject) => {
      const waiting: Waiting = {
        drop: () => resolve(null),
        go: () => {
          this.channels.set(channel, null);
          this.send(name, question, progress, channel)
            .then(resolve as (answer: unknown) => void, reject)
            .finally(() => {
              const after = this.channels.get(channel);
              if (after) after.go();
              else this.channels.delete(channel);
            });
        },
      };
      if (!this.channels.has(channel)) return waiting.go();
      this.channels.get(channel)?.drop();
      this.channels.set(channel, waiting);
      this.worker?.postMessage({ overtake: channel });
    });
  }

  /** Ends all running work by ending the worker. The next request starts a new worker. */
  cancel(): void {
    this.fail(new Cancelled());
    for (const waiting of this.channels.values()) waiting?.drop();
    this.channels.clear();
  }
}
