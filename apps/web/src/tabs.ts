// The room on the right: one view at a time, each asked to look anew only while it is seen.

import { h } from "./elements";
import { bench } from "./workbench";

export interface Tab {
  readonly id: string;
  readonly words: string;
  readonly element: HTMLElement;
  /** Shows the design of now; called when it has changed or the tab is opened. */
  refresh(): Promise<void> | void;
  /** The tab is left. */
  leave?(): void;
}

export class Tabs {
  readonly list = h("div", {
    class: "tab-list",
    role: "tablist",
    "aria-label": "views",
    keydown: (event: KeyboardEvent) => this.key(event),
  });
  readonly room = h("div", { class: "tab-room" });
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly fault = h("p", { class: "view-fault", role: "status" });
  current: Tab;
  /** Called with the tab that is opened. */
  opened: (id: string) => void = () => undefined;
  private asking = 0;

  constructor(readonly tabs: Tab[]) {
    this.current = tabs[0]!;
    for (const tab of tabs) {
      const one = h(
        "button",
        {
          type: "button",
          role: "tab",
          id: "tab-" + tab.id,
          "aria-controls": "room-" + tab.id,
          click: () => this.open(tab.id),
        },
        tab.words,
      );
      this.buttons.set(tab.id, one);
      this.list.append(one);
      tab.element.id = "room-" + tab.id;
      tab.element.setAttribute("role", "tabpanel");
      tab.element.setAttribute("aria-labelledby", "tab-" + tab.id);
      this.room.append(tab.element);
    }
    this.room.append(this.fault);
    bench.on("solved", () => void this.refresh());
    this.mark();
  }

  open(id: string): void {
    const tab = this.tabs.find((one) => one.id === id);
    if (!tab) return;
    if (tab !== this.current) this.current.leave?.();
    this.current = tab;
    this.mark();
    this.opened(id);
    void this.refresh();
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
    ++this.asking;
    try {
      await tab.refresh();
      if (tab === this.current) this.fault.textContent = "";
    } catch (reason) {
      if (tab === this.current)
        this.fault.textContent = reason instanceof Error ? reason.message : String(reason);
    } finally {
      --this.asking;
    }
  }
  get busy(): boolean {
    return this.asking > 0;
  }

  private key(event: KeyboardEvent): void {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!step) return;
    const index = (this.tabs.indexOf(this.current) + step + this.tabs.length) % this.tabs.length;
    this.open(this.tabs[index]!.id);
    this.buttons.get(this.current.id)!.focus();
  }
}
