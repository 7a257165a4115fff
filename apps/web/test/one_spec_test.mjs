// Tests that everything on the page belongs to the spec on screen: pictures, numbers, form, and the verdict.
// The verdict is the worst of the verdicts of the native program.

import assert from "node:assert/strict";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe } from "node:test";
import { deflateRawSync } from "node:zlib";
import { example, examples, idle, it, judged, kPatience, kTabs, native, open, put, settled, withPage } from "./stage.mjs";

let page, browser, address;
withPage((stage) => ({ page, browser, address } = stage));

/** Visible parts that belong to another spec than the one on screen, but are not marked as stale. */
const strangers = () => {
  const now = window.gearwright.revision();
  return [...document.querySelectorAll("[data-revision]")]
    .filter((one) => one.dataset.revision && one.offsetParent && !one.closest("[data-stale]"))
    .filter((one) => one.dataset.revision !== now)
    .map((one) => one.className);
};
/** Replaces text in the editor. Returns the state of the page before anything is computed again. */
const typed = (page, from, to) =>
  page.evaluate(
    ([from, to]) => {
      const area = document.querySelector("textarea");
      area.value = area.value.replace(from, to);
      area.dispatchEvent(new Event("input"));
      return {
        stale: document.querySelector('[role="tabpanel"]:not([hidden]) [data-stale]')?.dataset.stale,
        spinner: !document.querySelector(".spinner").hidden,
        numbers: document.querySelector(".sheet").dataset.stale,
      };
    },
    [from, to],
  );

describe("a picture of another spec", () => {
  const shown = { contact: "misaligned_pair", load: "loaded_pair", rating: "rated_pair", scatter: "scattered_pair" };
  for (const tab of kTabs.filter((one) => one !== "search"))
    it(`is dimmed, with a spinner, until the new one is drawn: ${tab}`, async () => {
      await put(page, example(shown[tab] ?? "helical_pair"), tab);
      await idle(page);
      assert.deepEqual(await page.evaluate(strangers), []);
      const before = await page.evaluate(() => window.gearwright.revision());
      const seen = await typed(page, "face_width_mm = ", "face_width_mm = 1");
      assert.deepEqual(seen, { stale: "working", spinner: true, numbers: "working" });
      await settled(page);
      await idle(page);
      assert.notEqual(await page.evaluate(() => window.gearwright.revision()), before);
      const panel = '[role="tabpanel"]:not([hidden])';
      assert.equal(await page.locator(`${panel} [data-stale]`).count(), 0);
      const now = await page.evaluate(() => window.gearwright.revision());
      assert.ok((await page.locator(`${panel} [data-revision="${now}"]`).count()) > 0, "no picture of the new spec");
      assert.deepEqual(page.complaints, []);
    });

  it("stays dimmed, without a spinner, while the spec has an error", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    await typed(page, "teeth = 17", "teeth = 17.5");
    await settled(page);
    await idle(page);
    assert.equal(await page.getAttribute("#room-mesh .canvas-room", "data-stale"), "kept");
    assert.match(await page.textContent(".kept:not([hidden])"), /last valid spec/);
    assert.equal(await page.locator(".spinner").isVisible(), false);
    await typed(page, "teeth = 17.5", "teeth = 17");
    await settled(page);
    await idle(page);
    assert.equal(await page.locator("[data-stale]:visible").count(), 0);
  });

  it("numbers of the previous design disappear if the new spec cannot be read", async () => {
    await put(page, example("helical_pair"), "mesh");
    await put(page, "[gear1]\nteeth = = 3\n", "mesh");
    assert.equal(await page.locator(".numbers [data-quantity]").count(), 0);
    assert.equal(await page.locator(".form [data-key]").count(), 0);
  });

  it("a pinion with three teeth does not show the designs of the previous search", async () => {
    await put(page, example("gearbox_search"), "search");
    await idle(page);
    assert.ok((await page.locator(".pareto circle").count()) > 10);
    await page.evaluate(() => window.gearwright.start());
    await page.click('form.have:has-text("A pinion with three teeth") button');
    await page.waitForSelector(".branch");
    await idle(page);
    assert.equal(await page.locator(".pareto circle").count(), 0);
    assert.equal(await page.locator(".designs tbody tr").count(), 0);
    assert.equal(await page.locator(".pareto, .pareto-axes").filter({ visible: true }).count(), 0);
  });

  it("two objectives border a staircase, and one objective has its own name", async () => {
    const axes = page.locator(".pareto-axes select");
    await put(page, example("gearbox_search"), "search");
    await idle(page);
    await axes.nth(0).selectOption("objective.contact_ratio");
    await axes.nth(1).selectOption("objective.sliding");
    await page.waitForSelector(".pareto .staircase", { state: "attached" });
    assert.equal(await page.locator(".pareto .staircase").count(), 1);
    const words = await page.textContent(".pareto svg");
    assert.match(words, /greatest specific sliding.*, smaller values are better/);
    assert.match(words, /contact ratio.*, greater values are better/);
    await put(page, example("gearbox_search").replace(/^objective = .*$/m, 'objective = "mass"'), "search");
    await idle(page);
    await axes.nth(0).selectOption("objective.-1");
    await page.waitForFunction(() => /mass.*kg, smaller values are better/.test(document.querySelector(".pareto svg")?.textContent));
    assert.equal(await axes.nth(0).locator("option:checked").textContent(), "mass");
    assert.equal(await page.locator(".pareto .staircase").count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  it("the picture of the previous design disappears even if the new design has none", async () => {
    await put(page, example("printed_drive"), "mesh");
    await idle(page);
    const inked = (expected) =>
      page.waitForFunction(
        (expected) => (document.querySelector("#room-mesh .plot:not(.unplaced) use") !== null) === expected,
        expected,
      );
    await inked(true);
    // With this bore the gear has no body, so the engine cannot draw its section.
    await put(page, example("printed_drive").replace(/^diameter_mm = .*$/m, "diameter_mm = 80"), "mesh");
    await idle(page);
    assert.match(await page.textContent(".view-fault"), /bore/);
    await inked(false);
    assert.equal(await page.locator("[data-stale]:visible").count(), 0);
  });

  it("a list of designs is dimmed if the spec is neither the search nor one of its designs", async () => {
    await put(page, example("gearbox_search"), "search");
    await idle(page);
    await page.click(".designs tbody tr:nth-child(2)");
    await page.waitForFunction(() => !window.gearwright.text().includes("[search]"));
    await settled(page);
    await idle(page);
    assert.equal(await page.getAttribute(".found", "data-stale"), null);
    await page.fill('[data-key="gear1.profile_shift"]', "0.111");
    await page.waitForSelector('.found[data-stale="kept"]');
    await page.click("text=Back to the search");
    await page.waitForSelector(".found:not([data-stale])");
    assert.ok((await page.locator(".designs tbody tr").count()) > 10);
  });

  it("quick changes of tab and design never mix designs and cause no errors", async () => {
    await page.evaluate((strangers) => {
      const check = new Function(`return (${strangers})()`);
      window.mixed = [];
      window.watching = true;
      const look = () => {
        const found = check();
        if (found.length) window.mixed.push(found.join());
        if (window.watching) requestAnimationFrame(look);
      };
      look();
    }, String(strangers));
    // A fixed pseudo-random sequence of designs and tabs.
    let seed = 12345;
    const random = (n) => (seed = (seed * 1103515245 + 12345) % 2147483648) % n;
    for (let i = 0; i < 120; ++i) {
      const text = examples[random(examples.length)].text;
      const tab = kTabs[random(kTabs.length)];
      if (random(3) > 0) await page.evaluate(([text, tab]) => window.gearwright.open(text, tab), [text, tab]);
      else await page.evaluate((tab) => document.querySelector(`#tab-${tab}`).click(), tab);
      await page.waitForTimeout(random(4) * 60);
    }
    await settled(page);
    await idle(page);
    const mixed = await page.evaluate(() => ((window.watching = false), window.mixed));
    assert.deepEqual([...new Set(mixed)], []);
    assert.deepEqual(page.complaints, []);
  });
});

describe("form and link", () => {
  const json = JSON.stringify({ title: "from JSON", gear1: { teeth: 19, normal_module_mm: 2 }, gear2: { teeth: 37 } });
  const shows = async () => {
    await settled(page);
    assert.equal(await page.inputValue('.form [data-key="gear1.teeth"]'), "19");
    assert.equal(await page.inputValue(".form .title"), "from JSON");
  };

  it("JSON after TOML, as a file", async () => {
    await put(page, example("helical_pair"));
    const path = join(mkdtempSync(join(tmpdir(), "gearwright_web_")), "one.json");
    writeFileSync(path, json);
    await page.setInputFiles("input[type=file]", path);
    await page.waitForFunction(() => window.gearwright.text().includes("from JSON"));
    await shows();
  });

  it("JSON after TOML, as a text; the first change of a field makes it TOML", async () => {
    await put(page, example("helical_pair"));
    await put(page, json);
    await shows();
    await page.fill('.form [data-key="gear1.teeth"]', "20");
    await page.waitForFunction(() => /^teeth = 20$/m.test(window.gearwright.text()));
    await settled(page);
    assert.equal(await page.inputValue('.form [data-key="gear2.teeth"]'), "37");
  });

  it("a damaged link causes a message of the page", async () => {
    const link = "#1." + deflateRawSync(example("helical_pair")).toString("base64url");
    for (const hash of ["#1.not-a-design", "#1.q1ZK!LS7JzEtXslLKSM1", link.slice(0, -40), link.slice(0, 60) + "AAAA" + link.slice(64), "#1.A"]) {
      const other = await open(browser, address + hash);
      const said = await other.textContent(".said");
      assert.match(said, /^This link is damaged, .*Copy it again, from its first to its last character\.$/, hash);
      assert.doesNotMatch(said, /atob|decod|compress|Failed|Error/i);
      assert.deepEqual(other.complaints, []);
      await other.context().close();
    }
  });
});

describe("the verdict", () => {
  const levels = ["green", "amber", "red"];
  /** Returns the worst of the verdicts that the program computes for the parts of the spec. */
  const expected = (text) => {
    const pair = native("pair", text);
    const asks = (part) =>
      pair.verdict.not_judged?.includes(part) ??
      (part === "contact" || pair.pair === undefined || new RegExp(part === "load" ? "^torque_Nm" : "^\\[rating", "m").test(text));
    const verbs = { contact: "contact", rating: "rate", load: "load" };
    const judged = Object.keys(verbs)
      .filter(asks)
      .map((part) => native(verbs[part], text).verdict)
      .filter((verdict) => verdict);
    return [pair.verdict, ...judged].reduce((a, b) => (levels.indexOf(b.level) > levels.indexOf(a.level) ? b : a));
  };

  it("on every example is the worst of the program's verdicts", async () => {
    for (const { name, text } of examples) {
      const pair = native("pair", text);
      if (!pair.verdict || !pair.pair) continue;
      await put(page, text);
      await judged(page);
      const worst = expected(text);
      assert.equal(await page.getAttribute(".verdict", "data-level"), worst.level, name);
      assert.equal(await page.textContent(".headline"), worst.headline, name);
      assert.equal(await page.textContent(".scope"), "", name);
    }
  });

  // The shafts of this pair without backlash are crossed by an error, so it jams. Only the contact analysis
  // detects this.
  const jams = `[gear1]
teeth = 25
normal_module_mm = 3
face_width_mm = 30
[gear2]
teeth = 43
[errors]
crossing_deg = 0.01
[load]
torque_Nm = 250
positions = 16
slices = 12
accuracy = "draft"
`;
  it("names what is pending, then covers contact and load", async () => {
    await put(page, jams); // the parts are judged after a pause without changes
    const parts = native("pair", jams).verdict.not_judged ?? ["contact", "load"];
    assert.equal(await page.textContent(".scope"), `${parts.join(", ")} pending`);
    await judged(page);
    assert.equal(await page.textContent(".scope"), "");
    assert.equal(await page.getAttribute(".verdict", "data-level"), expected(jams).level);
    const messages = [];
    for (const verb of ["pair", "contact", "load"])
      for (const one of native(verb, jams).verdict.findings) messages.push(JSON.stringify([one.code, one.gear, one.message]));
    await page.click("button.verdict");
    assert.equal(await page.locator(".findings li[data-level]").count(), new Set(messages).size);
    await page.click("button.verdict");
    assert.deepEqual(page.complaints, []);
  });

  it("names the parts that the program cannot judge, with the reasons", async () => {
    const text = example("rated_pair").replace(/^quality.*\n/m, "");
    const { error } = native("rate", text);
    await put(page, text);
    await judged(page);
    assert.equal(await page.textContent(".scope"), "rating not judged");
    await page.click("button.verdict");
    assert.ok((await page.textContent(".findings")).includes(error.message));
    await page.click("button.verdict");
  });

  it("is the same in the tabs load and rating as in the bar", async () => {
    for (const [name, tab] of [["loaded_pair", "load"], ["rated_pair", "rating"]]) {
      await put(page, example(name), tab);
      await judged(page);
      await page.waitForFunction(
        (tab) => document.querySelector(`#room-${tab} .view-sentence`).textContent === document.querySelector(".headline").textContent,
        tab,
        { timeout: kPatience },
      );
    }
  });
});
