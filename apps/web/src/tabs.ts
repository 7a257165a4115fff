// The area on the right, which shows one tab at a time. A tab is refreshed only while it is visible.

import { h, onKeys, sentenceOf } from "./elements";
import { judgement, kParts, type Part } from "./judgement";
import { onUnitChange } from "./numbers";
import { Pause } from "./pauses";
import { markLate, markRevision } from "./revision";
import { bench, isDrive } from "./workbench";

/** After this pause in the changes, contact, load and rating are judged even if their tabs are hidden. */
const kPauseMs = 700;

export interface Tab {
  readonly id: string; // the identifier, which is also the name
  readonly element: HTMLElement;
  /** The element that is dimmed while it does not show the spec on screen. */
  readonly picture: HTMLElement;
  /** The text of the spec that the picture shows, or "" if there is no picture. */
  shown: string;
  /** The part of the verdict to which this tab contributes, and the function that computes it while the
   *  tab is hidden. */
  readonly part?: Part;
  judge?(): Promise<void>;
  /** True if the tab also shows drives, "only" if it shows nothing else. */
  readonly ofDrives?: boolean | "only";
  /** Shows the current design. It is called when the design has changed and when the tab is opened. */
  refresh(): Promise<void> | void;
  /** It is called when the unit of lengths has changed, before the next refresh(). By default, the picture is
   *  made again. */
  inUnits?(): void;
  leave?(): void;
}

export class Tabs {
  readonly list = h("div", { class: "tab-list", role: "tablist", "aria-label": "views" });
  readonly room = h("div", { class: "tab-room" });
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly fault = h("p", { class: "view-fault", role: "status" });
  private readonly spinner = h(
    "div",
    { class: "spinner", role: "status" },
    h("span", { class: "unseen" }, "The picture is being made."),
  );
  private readonly kept = h("p", { class: "kept", role: "status" });
  current: Tab;
  /** This function is called with the id of each tab that is opened. */
  opened: (id: string) => void = () => undefined;
  private readonly refreshing = new Map<Tab, number>();
  private turn = 0;
  private readonly pause = new Pause(kPauseMs);
  private ofDrive = false;

  constructor(readonly tabs: Tab[]) {
    this.current = tabs[0]!;
    onKeys(this.list, { ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1) });
    for (const tab of tabs) {
      const one = h(
        "button",
        {
          type: "button",
          role: "tab",
          id: "tab-" + tab.id,
          hidden: tab.ofDrives === "only",
          "aria-controls": "room-" + tab.id,
          click: () => this.open(tab.id),
        },
        tab.id,
      );
      this.buttons.set(tab.id, one);
      this.list.append(one);
      tab.element.id = "room-" + tab.id;
      tab.element.setAttribute("role", "tabpanel");
      tab.element.setAttribute("aria-labelledby", "tab-" + tab.id);
      this.room.append(tab.element);
    }
    this.room.prepend(this.fault);
    this.room.append(this.spinner, this.kept);
    bench.on("text", () => this.age());
    bench.on("opened", () => {
      this.ofDrive = false;
      // Every tab, visible or not, removes the results of the previous design.
      for (const tab of this.tabs) void tab.refresh();
    });
    bench.on("solved", () => {
      // If the spec on screen becomes a drive, a tab for drives is opened.
      // If it becomes a pair, the tab that shows only drives is closed.
      const moves = isDrive() ? !this.ofDrive && !this.current.ofDrives : this.current.ofDrives === "only";
      this.ofDrive = isDrive();
      for (const tab of this.tabs) this.buttons.get(tab.id)!.hidden = tab.ofDrives === "only" && !this.ofDrive;
      if (moves && !this.ofDrive) this.open(this.tabs[0]!.id);
      else if (moves) this.open(this.tabs.find((tab) => tab.ofDrives)!.id);
      else void this.refresh();
      this.pause.run(() => void this.judge());
    });
    onUnitChange(() => {
      for (const tab of this.tabs) {
        if (tab.inUnits) tab.inUnits();
        else tab.shown = "";
      }
      if (bench.settled) void this.refresh();
    });
    this.mark();
    this.age();
  }

  /** Computes the missing parts of the verdict one after the other. If the spec changes, this loop ends,
   *  and a new one starts for the new spec. */
  private async judge(): Promise<void> {
    const { text } = bench;
    for (const part of kParts) {
      if (bench.text !== text || !judgement.pending.includes(part)) continue;
      await this.tabs.find((tab) => tab.part === part)?.judge?.().catch(() => undefined);
    }
  }

  /** Dims the picture if it does not show the spec on screen. */
  private age(): void {
    const { picture, shown } = this.current;
    const working = !bench.settled || (this.refreshing.get(this.current) ?? 0) > 0;
    markRevision(picture, shown, bench.text, working);
    const stale = picture.dataset["stale"];
    this.spinner.hidden = !working || (shown !== "" && !stale);
    markLate(this.spinner, !this.spinner.hidden);
    this.kept.hidden = stale !== "kept";
    this.kept.textContent = bench.fault
      ? "The view shows the last valid spec."
      : "The view shows an earlier spec.";
  }

  open(id: string): void {
    const tab = this.tabs.find((one) => one.id === id);
    if (!tab) return;
    if (tab !== this.current) this.current.leave?.();
    this.current = tab;
    this.mark();
    this.opened(id);
    if (bench.settled) void this.refresh();
    else this.age(); // otherwise, the pending result will update the picture
  }

  private mark(): void {
    for (const tab of this.tabs) {
      const here = tab === this.current;
      tab.element.hidden = !here;
      const one = this.buttons.get(tab.id)!;
      one.setAttribute("aria-selected", String(here));
      one.tabIndex = here ? 0 : -1;
      if (here && one.offsetParent) {
        const before = one.offsetLeft - this.list.offsetLeft;
        const after = before + one.offsetWidth + 8 - this.list.clientWidth;
        this.list.scrollLeft = Math.max(after, Math.min(before, this.list.scrollLeft));
      }
    }
  }

  async refresh(): Promise<void> {
    const tab = this.current;
    const turn = ++this.turn;
    const count = (more: number) => this.refreshing.set(tab, (this.refreshing.get(tab) ?? 0) + more);
    count(1);
    this.age();
    let fault = "";
    try {
      if (isDrive() && !tab.ofDrives) fault = "This spec describes a drive. The tabs “drive”, “solid” and “sheet” show it.";
      else await tab.refresh();
    } catch (reason) {
      fault = sentenceOf(reason);
    }
    // If a newer request has replaced this one, the newer request shows its own error.
    if (turn === this.turn) this.fault.textContent = fault;
    count(-1);
    this.age();
  }
  get busy(): boolean {
    return [...this.refreshing.values()].some((count) => count > 0);
  }

  private step(step: number): void {
    const seen = this.tabs.filter((tab) => !this.buttons.get(tab.id)!.hidden);
    const index = (seen.indexOf(this.current) + step + seen.length) % seen.length;
    this.open(seen[index]!.id);
    this.buttons.get(this.current.id)!.focus();
  }
}
