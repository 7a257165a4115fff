// The page has a bar with title and verdict, the spec on the left, the picture on the right, and the numbers
// below the picture. A narrow screen shows only one of these three parts at a time.

import { button, Choice, download, fill, h, onKeys, sentenceOf } from "./elements";
import { Form } from "./form/form";
import { linkOf } from "./link";
import { showLengthsIn } from "./numbers";
import { Pause } from "./pauses";
import { QuantityPane } from "./quantities";
import { Starts } from "./starts";
import { Tabs, type Tab } from "./tabs";
import { fileName, TakeHome } from "./take_home";
import { TextPane } from "./text/text_pane";
import { VerdictLine } from "./verdict";
import { bench, kMostCharacters } from "./workbench";

/** The part that a narrow screen shows first. */
const kFirstPart = "view";
/** If the table of numbers has at most this fraction of the height, only its heading is visible. */
const kFolded = 0.05;
/** A spec with units = "inch", in TOML or JSON. */
const kInInch = /^[{\s]*"?units"?\s*[=:]\s*["']inch["']/m;

export class Page {
  readonly tabs: Tabs;
  readonly starts: Starts;
  private readonly title = h("h1", {}, "Gearwright");
  private readonly undo = button("↶", () => bench.undo(), {
    "aria-label": "undo",
    title: "undo, Ctrl+Z",
    disabled: true,
  });
  private readonly redo = button("↷", () => bench.redo(), {
    "aria-label": "redo",
    title: "redo, Ctrl+Shift+Z",
    disabled: true,
  });
  private readonly link = button("Link", () => void this.copyLink(), {
    title: "copy the address, which contains this design",
  });
  private readonly picker = h("input", {
    type: "file",
    accept: ".toml,.json,text/plain",
    hidden: true,
    "aria-label": "open a spec",
    change: () => void this.pick(),
  });
  private readonly toast = h("div", { class: "said", role: "status" });
  private readonly main: HTMLElement;
  private readonly verdict = new VerdictLine();
  private readonly numbers = new QuantityPane();
  /** Fraction of the height for the table of numbers, for each tab. A report or a list needs more height
   *  than a picture. */
  private readonly shares: Record<string, number> = {
    contact: 0.2,
    load: kFolded,
    rating: kFolded,
    scatter: kFolded,
    search: 0.2,
    sheet: kFolded,
  };

  constructor(tabs: Tab[]) {
    this.tabs = new Tabs(tabs);
    this.starts = new Starts((text, tab) => this.begin(text, tab));
    const form = new Form();
    const text = new TextPane();
    const choice = new Choice("form of the spec", { form: "form", text: "text" }, "form", (side) => {
      form.element.hidden = side !== "form";
      text.show(side === "text");
    });
    text.show(false);
    this.main = h(
      "main",
      { class: "bench", "data-part": kFirstPart },
      h(
        "section",
        { class: "spec", "aria-label": "spec" },
        h("div", { class: "spec-head" }, choice.element, form.units.element),
        form.element,
        text.element,
      ),
      h("section", { class: "view", "aria-label": "pictures" }, this.tabs.list, this.tabs.room),
      this.numbers.element,
    );
    this.numbers.element.prepend(this.divider());
    this.tabs.opened = (id) => this.share(id);
    this.share(this.tabs.current.id);
    fill(
      document.body,
      h(
        "header",
        { class: "bar" },
        this.title,
        this.verdict.element,
        h(
          "div",
          { class: "actions" },
          this.undo,
          this.redo,
          button("New", () => this.showStarts(), { title: "examples and other ways to start" }),
          button("Open", () => this.picker.click(), {
            title: "open a spec in TOML or JSON; a file can also be dropped on the page",
          }),
          button("Save", () => this.save(), { title: "save the spec as a TOML file, Ctrl+S" }),
          this.link,
          new TakeHome(() => this.save()).element,
        ),
        this.picker,
      ),
      this.main,
      this.starts.element,
      this.parts(),
      this.toast,
    );
    bench.on("read", () => {
      this.name();
      this.main.classList.toggle("unsolved", bench.finder !== undefined); // true while there are no numbers
    });
    bench.on("text", () => void this.address());
    bench.on("history", () => {
      this.undo.disabled = !bench.canUndo;
      this.redo.disabled = !bench.canRedo;
    });
    this.keys();
    this.drops();
  }

  private share(tab: string, set?: number): void {
    if (set !== undefined) this.shares[tab] = Math.min(0.85, Math.max(kFolded, set));
    const share = this.shares[tab] ?? 0.34;
    this.main.style.setProperty("--numbers", share > kFolded ? `${(100 * share).toFixed(1)}%` : "43px");
  }
  /** Returns the divider between picture and numbers. The user drags it or moves it with the arrow keys. */
  private divider(): HTMLElement {
    const now = () => this.shares[this.tabs.current.id] ?? 0.34;
    const set = (share: number) => {
      this.share(this.tabs.current.id, share);
      line.setAttribute("aria-valuenow", String(Math.round(100 * now())));
    };
    const line: HTMLElement = h("div", {
      class: "divider",
      role: "separator",
      tabindex: "0",
      "aria-label": "height of the table of numbers",
      "aria-orientation": "horizontal",
      "aria-valuemin": 5,
      "aria-valuemax": 85,
      "aria-valuenow": 34,
      pointerdown: (event: PointerEvent) => line.setPointerCapture(event.pointerId),
      pointermove: (event: PointerEvent) => {
        const box = this.main.getBoundingClientRect();
        if (event.buttons) set((box.bottom - event.clientY) / box.height);
      },
    });
    onKeys(line, { ArrowUp: () => set(now() + 0.05), ArrowDown: () => set(now() - 0.05) });
    return line;
  }

  /** Returns the buttons that choose one of the three parts on a narrow screen. */
  private parts(): HTMLElement {
    const parts = { spec: "Spec", view: "Pictures", numbers: "Numbers" };
    const show = (part: string) => {
      this.main.dataset["part"] = part;
      void this.tabs.refresh();
    };
    return new Choice("parts of the page", parts, kFirstPart, show, { class: "parts", role: "navigation" }).element;
  }

  showStarts(): void {
    document.body.dataset["at"] = "starts";
    this.starts.element.hidden = false;
    this.main.hidden = true;
    this.title.textContent = "Gearwright";
    void this.starts.paint();
  }
  showBench(): void {
    document.body.dataset["at"] = "bench";
    this.starts.element.hidden = true;
    this.main.hidden = false;
    this.name();
  }

  begin(text: string, tab = "mesh"): void {
    if (kInInch.test(text)) void this.beginInInch(text, tab);
    else this.showSpec(text, tab);
  }
  private showSpec(text: string, tab: string): void {
    this.showBench();
    bench.setText(text, "opened");
    this.tabs.open(tab);
    scrollTo(0, 0);
  }

  /** Shows a spec in inch as the same spec in mm, with all lengths in inch. */
  private async beginInInch(text: string, tab: string): Promise<void> {
    try {
      const metric = await bench.front.call("metric", { text });
      this.showSpec(metric, tab);
      if (metric === text) return; // the key is in another table, where the engine rejects it
      showLengthsIn("in");
      this.notify("The text of the spec is now in mm. The page, the report and drawings show lengths in inch.", 8000);
    } catch (reason) {
      this.notify(sentenceOf(reason), 8000);
    }
  }

  private name(): void {
    if (document.body.dataset["at"] !== "bench") return;
    const title = bench.solved?.spec?.["title"];
    const words = typeof title === "string" && title ? title : "untitled";
    this.title.textContent = words;
    document.title = words + " – Gearwright";
  }

  private readonly typing = new Pause(250);
  private address(): void {
    this.typing.run(async () => {
      if (bench.text.length > kMostCharacters) return;
      const hash = await linkOf(bench.text);
      if (hash !== location.hash) history.replaceState(null, "", hash);
    });
  }

  private async copyLink(): Promise<void> {
    const hash = await linkOf(bench.text);
    history.replaceState(null, "", hash);
    try {
      await navigator.clipboard.writeText(location.href);
      this.notify("The address is copied. It contains the whole design.");
    } catch {
      this.notify("The address of this page contains the whole design. Copy the address from the address bar.");
    }
  }

  private readonly fading = new Pause(4000);
  notify(sentence: string, forMs?: number): void {
    this.toast.textContent = sentence;
    this.toast.classList.add("shown");
    this.fading.run(() => this.toast.classList.remove("shown"), forMs);
  }

  private save(): void {
    download(fileName() + ".toml", bench.text, "application/toml");
  }
  private async pick(): Promise<void> {
    const file = this.picker.files?.[0];
    this.picker.value = "";
    if (file) await this.open(file);
  }
  async open(file: File): Promise<void> {
    if (file.size > kMostCharacters)
      return this.notify(`${file.name} has ${(file.size / 1e6).toFixed(1)} MB; a spec has at most 1 MB.`);
    const text = await file.text();
    if (!text.trimStart().startsWith("{")) return this.begin(text);
    try {
      this.begin(await bench.front.call("tomlOf", { json: text }));
    } catch (reason) {
      this.notify(`${file.name}: ${sentenceOf(reason)}`);
    }
  }

  private keys(): void {
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey)) return;
      const key = event.key.toLowerCase();
      if (key === "z" || key === "y") {
        event.preventDefault();
        if (key === "y" || event.shiftKey) bench.redo();
        else bench.undo();
      } else if (key === "s") {
        event.preventDefault();
        this.save();
      }
    });
  }

  private drops(): void {
    document.addEventListener("dragover", (event) => {
      event.preventDefault();
      document.body.classList.add("dropping");
    });
    document.addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) document.body.classList.remove("dropping");
    });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      document.body.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (file) void this.open(file);
    });
  }
}
