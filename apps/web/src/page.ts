// The page: a bar with title and verdict, the spec on the left, the picture on the right, the
// numbers below it. On a narrow screen one of the three is seen at a time.

import { button, download, fill, h } from "./elements";
import { Form } from "./form/form";
import { linkOf } from "./link";
import { QuantityPane } from "./quantities";
import { Starts, startButton } from "./starts";
import { Tabs, type Tab } from "./tabs";
import { fileName, TakeHome } from "./take_home";
import { TextPane } from "./text/text_pane";
import { VerdictLine } from "./verdict";
import { bench, kMostCharacters } from "./workbench";

type Part = "spec" | "view" | "numbers";
/** The numbers show their head alone. */
const kFolded = 0.05;

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
    title: "copies the address that holds this design",
  });
  private readonly picker = h("input", {
    type: "file",
    accept: ".toml,.json,text/plain",
    hidden: true,
    "aria-label": "open a spec",
    change: () => void this.pick(),
  });
  private readonly said = h("div", { class: "said", role: "status" });
  private readonly main: HTMLElement;
  private readonly verdict = new VerdictLine();
  private readonly numbers = new QuantityPane();
  /** Share of the height that the numbers have, per tab: a report or a list needs more than a picture. */
  private readonly shares: Record<string, number> = {
    contact: 0.2,
    load: kFolded,
    rating: kFolded,
    search: 0.2,
    sheet: kFolded,
  };
  private part: Part = "view";

  constructor(tabs: Tab[]) {
    this.tabs = new Tabs(tabs);
    this.starts = new Starts((text, tab) => this.begin(text, tab));
    const form = new Form();
    const text = new TextPane();
    const sides = [form.element, text.element];
    const side = (words: string, index: number) =>
      button(
        words,
        () => {
          sides.forEach((one, i) => (one.hidden = i !== index));
          for (const [i, one] of [...choice.children].entries())
            one.setAttribute("aria-pressed", String(i === index));
        },
        { "aria-pressed": String(index === 0) },
      );
    const choice = h(
      "div",
      { class: "choice", role: "group", "aria-label": "the spec as" },
      side("form", 0),
      side("text", 1),
    );
    text.element.hidden = true;
    this.main = h(
      "main",
      { class: "bench", "data-part": this.part },
      h(
        "section",
        { class: "spec", "aria-label": "spec" },
        h("div", { class: "spec-head" }, choice, form.units),
        ...sides,
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
          startButton(() => this.showStarts()),
          button("Open", () => this.picker.click(), {
            title: "a spec: TOML or JSON; files may also be dropped",
          }),
          button("Save", () => this.save(), { title: "the spec as a TOML file, Ctrl+S" }),
          this.link,
          new TakeHome(() => this.save()).element,
        ),
        this.picker,
      ),
      this.main,
      this.starts.element,
      this.parts(),
      this.said,
    );
    bench.on("solved", () => {
      this.name();
      this.main.classList.toggle("asking", bench.asks); // there are no numbers yet
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
  /** The line between picture and numbers, to be dragged or moved with the arrow keys. */
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
      "aria-label": "height of the numbers",
      "aria-orientation": "horizontal",
      "aria-valuemin": 5,
      "aria-valuemax": 85,
      "aria-valuenow": 34,
      pointerdown: (event: PointerEvent) => line.setPointerCapture(event.pointerId),
      pointermove: (event: PointerEvent) => {
        const box = this.main.getBoundingClientRect();
        if (event.buttons) set((box.bottom - event.clientY) / box.height);
      },
      keydown: (event: KeyboardEvent) => {
        if (event.key === "ArrowUp") set(now() + 0.05);
        else if (event.key === "ArrowDown") set(now() - 0.05);
        else return;
        event.preventDefault();
      },
    });
    return line;
  }

  /** The three parts of a narrow screen. */
  private parts(): HTMLElement {
    const one = (part: Part, words: string) =>
      button(
        words,
        () => {
          this.part = part;
          this.main.dataset["part"] = part;
          for (const other of nav.querySelectorAll("button"))
            other.setAttribute("aria-pressed", String(other.dataset["part"] === part));
          void this.tabs.refresh();
        },
        { "data-part": part, "aria-pressed": String(part === this.part) },
      );
    const nav: HTMLElement = h(
      "nav",
      { class: "parts", "aria-label": "parts of the page" },
      one("spec", "Spec"),
      one("view", "Pictures"),
      one("numbers", "Numbers"),
    );
    return nav;
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
    this.showBench();
    bench.setText(text, "opened");
    this.tabs.open(tab);
    scrollTo(0, 0);
  }

  private name(): void {
    if (document.body.dataset["at"] !== "bench") return;
    const title = bench.solved?.spec?.["title"];
    const words = typeof title === "string" && title ? title : "untitled";
    this.title.textContent = words;
    document.title = words + " – Gearwright";
  }

  private timer = 0;
  private address(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(async () => {
      if (bench.text.length > kMostCharacters) return;
      const hash = await linkOf(bench.text);
      if (hash !== location.hash) history.replaceState(null, "", hash);
    }, 250);
  }

  private async copyLink(): Promise<void> {
    const hash = await linkOf(bench.text);
    history.replaceState(null, "", hash);
    try {
      await navigator.clipboard.writeText(location.href);
      this.say("The address is copied. It holds the whole design.");
    } catch {
      this.say("The address of this page holds the whole design: copy it from the address line.");
    }
  }

  private fading = 0;
  say(sentence: string, forMs = 4000): void {
    this.said.textContent = sentence;
    this.said.classList.add("shown");
    clearTimeout(this.fading);
    this.fading = window.setTimeout(() => this.said.classList.remove("shown"), forMs);
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
      return this.say(`${file.name} has ${(file.size / 1e6).toFixed(1)} MB; a spec has at most 1 MB.`);
    const text = await file.text();
    if (!text.trimStart().startsWith("{")) return this.begin(text);
    try {
      this.begin(await bench.front.ask("tomlOf", { json: text }));
    } catch (reason) {
      this.say(`${file.name}: ${reason instanceof Error ? reason.message : String(reason)}`);
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
