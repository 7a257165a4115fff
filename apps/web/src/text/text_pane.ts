// Shows the spec as coloured text with numbered lines. An error is shown below its line.
//
// The user edits a transparent textarea. The coloured text is behind it. Long texts are not coloured.

import { fill, h } from "../elements";
import { bench } from "../workbench";

const kMostColoured = 60_000;
const kLine = 20; // px, height of a line, as in the style sheet

/** Divides a line of TOML into table headings, keys and comments. The rest of the line is a value. */
function coloured(line: string): Node[] {
  const comment = commentAt(line);
  const code = line.slice(0, comment);
  const tail = comment < line.length ? [h("span", { class: "t-comment" }, line.slice(comment))] : [];
  if (/^\s*\[/.test(code) && !code.includes("=")) return [h("span", { class: "t-table" }, code), ...tail];
  const equals = code.indexOf("=");
  if (equals < 0) return [document.createTextNode(code), ...tail];
  return [
    h("span", { class: "t-key" }, code.slice(0, equals)),
    document.createTextNode("="),
    h("span", { class: "t-value" }, code.slice(equals + 1)),
    ...tail,
  ];
}
/** Returns the index at which the comment of a line begins, which is the first # outside of quotes. */
function commentAt(line: string): number {
  let quote = "";
  for (let i = 0; i < line.length; ++i) {
    const letter = line[i]!;
    if (quote) {
      if (letter === "\\" && quote === '"') ++i;
      else if (letter === quote) quote = "";
    } else if (letter === '"' || letter === "'") quote = letter;
    else if (letter === "#") return i;
  }
  return line.length;
}

export class TextPane {
  private readonly area = h("textarea", {
    "aria-label": "the spec as TOML text",
    spellcheck: "false",
    autocapitalize: "off",
    autocomplete: "off",
    wrap: "off",
    input: () => {
      this.colour();
      bench.setText(this.area.value, "typing");
    },
    scroll: () => this.follow(),
    keydown: (event: KeyboardEvent) => {
      if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      this.area.blur();
    },
  });
  private readonly behind = h("pre", { class: "colours", "aria-hidden": "true" });
  private readonly gutter = h("pre", { class: "gutter", "aria-hidden": "true" });
  private readonly mark = h("div", { class: "fault-line", "aria-hidden": "true" });
  private readonly sentence = h("p", { class: "fault", role: "alert" });
  readonly element = h(
    "div",
    { class: "text-pane" },
    this.sentence,
    h(
      "div",
      { class: "editor" },
      this.gutter,
      h("div", { class: "paper" }, this.mark, this.behind, this.area),
    ),
  );

  constructor() {
    bench.on("text", () => this.take());
    bench.on("read", () => this.showFault());
    this.take();
  }

  /** Shows or hides the text. A hidden text is not coloured. */
  show(open: boolean): void {
    this.element.hidden = !open;
    if (open) this.colour();
  }

  private take(): void {
    if (this.area.value === bench.text) return;
    const { selectionStart, selectionEnd } = this.area;
    this.area.value = bench.text;
    if (document.activeElement === this.area) this.area.setSelectionRange(selectionStart, selectionEnd);
    if (!this.element.hidden) this.colour();
  }

  private colour(): void {
    const text = this.area.value;
    const plain = text.length > kMostColoured;
    this.element.classList.toggle("plain", plain);
    if (plain) {
      fill(this.behind);
      fill(this.gutter);
      return;
    }
    const lines = text.split("\n");
    fill(this.behind, ...lines.flatMap((line) => [...coloured(line), document.createTextNode("\n")]));
    fill(this.gutter, lines.map((_, i) => i + 1).join("\n"));
    this.follow();
  }

  private follow(): void {
    const { scrollLeft, scrollTop } = this.area;
    this.behind.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
    this.gutter.style.transform = `translateY(${-scrollTop}px)`;
    this.mark.style.marginTop = `${-scrollTop}px`;
  }

  private showFault(): void {
    const { fault } = bench;
    const line = fault?.line;
    // A syntax error has no key, and its message already contains the line number.
    this.sentence.textContent = fault ? (line && fault.key ? `Line ${line}: ` : "") + fault.message : "";
    this.mark.hidden = !line;
    if (line) this.mark.style.top = `${(line - 1) * kLine}px`;
    this.area.setAttribute("aria-invalid", String(fault !== null));
  }
}
