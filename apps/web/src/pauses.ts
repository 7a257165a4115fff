// Pauses between changes. While a value changes continuously, the page does only what is quick. The rest follows in a
// pause.

/** A value rests if it has not changed for this time, ms. */
const kRestMs = 200;

/** Runs an action after a time. A later action replaces the action that is still waiting. */
export class Pause {
  private timer = 0;
  constructor(private readonly ms: number) {}
  run(action: () => void, ms = this.ms): void {
    this.cancel();
    this.timer = window.setTimeout(action, ms);
  }
  cancel(): void {
    clearTimeout(this.timer);
  }
}

/** The changes of a value, which show whether it changes continuously. */
export class Changes {
  private last = 0; // ms, the time of the last change
  private quick = false; // true if the last change followed another one within kRestMs, or a change followed it
  private readonly pause = new Pause(kRestMs);

  /** Records a change. `more` is true if the next change has come in the meantime. */
  add(more = false): void {
    const now = performance.now();
    this.quick = more || now - this.last < kRestMs;
    this.last = now;
  }
  get moving(): boolean {
    return this.quick && performance.now() - this.last < kRestMs;
  }
  /** If the value is moving, waits for the time of a rest. */
  async rest(): Promise<void> {
    if (this.moving) await new Promise<void>((go) => setTimeout(go, kRestMs));
  }
  /** If the value is moving, runs the action when it rests. */
  atRest(action: () => void): void {
    if (this.moving) this.pause.run(action);
    else this.pause.cancel();
  }
}
