// Tests the page in a browser: every example and every tab, numbers compared with the native program, links,
// errors at their fields, and the single file without a server or a network.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, statSync, writeFileSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe } from "node:test";
import { pathToFileURL } from "node:url";
import { compare, kNear, kSolved } from "../../../tests/wasm/near.mjs";
import {
  example,
  examples,
  idle,
  it,
  kPatience,
  kTabs,
  native,
  open,
  openTab,
  program,
  put,
  root,
  settled,
  web,
  withPage,
} from "./stage.mjs";

let browser, page, address;
withPage((stage) => ({ browser, page, address } = stage));

describe("every example", () => {
  it("has a card, opens, and shows the verdict of the program", async () => {
    for (const one of examples) {
      await page.evaluate(() => window.gearwright.start());
      await page.click(`[data-example=${one.name}]`);
      await settled(page);
      // The headline is read before contact and load are judged.
      const headline = await page.textContent(".headline");
      const expected = native("pair", one.text);
      if (expected.verdict) assert.equal(headline, expected.verdict.headline, one.name);
      else assert.ok(headline.length > 10, one.name);
    }
    assert.deepEqual(page.complaints, []);
  });

  it("has a picture or a result in every tab", async () => {
    for (const one of examples) {
      for (const tab of kTabs) {
        await put(page, one.text, tab);
        await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
      }
    }
    assert.deepEqual(page.complaints, []);
  });
});

describe("numbers", () => {
  it("are those of the native program except for the last bits of sums", async () => {
    for (const one of examples)
      for (const verb of ["gear", "pair", "contact", "load", "rate"]) {
        const run = ([verb, text]) => window.gearwright.run(verb, text);
        const mine = JSON.parse(await page.evaluate(run, [verb, one.text]));
        const theirs = native(verb, one.text);
        for (const side of [mine, theirs]) delete side.error?.file;
        const { faults, differing } = compare(mine, theirs);
        assert.deepEqual(faults, [], `${verb} ${one.name}`);
        const tolerance = verb === "load" ? kSolved : kNear;
        const far = differing.filter((number) => number.error > tolerance);
        assert.deepEqual(far, [], `${verb} ${one.name}`);
      }
  });

  /** Returns the rows of a table, and of a listing of the program, as words without blanks and without marks of
   *  indices. */
  const plain = (text) => text.replace(/[\s_]/g, "").replaceAll("–", "-");
  const listed = (verb, name) =>
    execFileSync(program, [verb, join(root, "examples", `${name}.toml`)], { encoding: "utf8" })
      .split("\n")
      .filter((line) => /^ {2}\S.* {2}/.test(line)) // sentences have no columns
      .map(plain);
  const shown = async (room) =>
    (
      await page.$$eval(`${room} table.quantities tbody tr:not(.group)`, (all) =>
        all.map((row) => {
          const [words, symbol, unit, ...cells] = [...row.children].map((one) => one.textContent);
          const note = row.querySelector(".place") ? cells.pop() : "";
          return [words, symbol, ...cells, unit, note].join("");
        }),
      )
    ).map(plain);

  it("in the table are the rows of the listing of the program", async () => {
    for (const name of ["helical_pair", "crossed_pair", "circular_arc_drive", "herringbone_pair", "ring_pair"]) {
      await put(page, example(name));
      const rows = new Set(await shown(".numbers"));
      const lines = listed("pair", name);
      assert.ok(lines.length > 20);
      assert.deepEqual(lines.filter((line) => !rows.has(line)), [], name);
    }
    await put(page, example("rated_pair"), "rating");
    await page.waitForSelector("#room-rating [data-safety]");
    const rows = new Set(await shown("#room-rating"));
    assert.deepEqual(listed("rate", "rated_pair").filter((line) => !rows.has(line)), []);
  });

  it("in the table are those of the JSON", async () => {
    await put(page, example("helical_pair"));
    const result = native("pair", example("helical_pair"));
    const cell = (id, column = 0) => page.textContent(`[data-quantity="${id}"][data-column="${column}"]`);
    assert.equal(await cell("pair.contact_ratio"), result.pair.contact_ratio.toFixed(5));
    assert.equal(await cell("pair.center_distance_mm"), result.pair.center_distance_mm.toFixed(4));
    for (const gear of [0, 1])
      assert.equal(await cell("gears.tip_diameter_mm", gear), result.gears[gear].tip_diameter_mm.toFixed(4));
    await page.click('[data-choice="in"]');
    await idle(page);
    assert.equal(await cell("pair.center_distance_mm"), (result.pair.center_distance_mm / 25.4).toFixed(5));
    await page.click('[data-choice="mm"]');
  });
});

describe("tolerances", () => {
  it("a value that they affect has its values at both ends below it", async () => {
    const text = example("spur_pair").replace("[gear2]", "thickness_allowance_mm = [-0.12, -0.06]\n\n[gear2]");
    await put(page, text);
    const { gears, pair } = native("pair", text);
    const ends = (id, column = 0) =>
      page.textContent(`[data-quantity="${id}"][data-column="${column}"] .ends`);
    const shown = (both, digits) =>
      [...both].sort((a, b) => a - b).map((one) => one.toFixed(digits)).join(" … ");
    const { normal_mm, circumferential_mm } = pair.interval.backlash;
    assert.equal(await ends("gears.root_diameter_mm"), shown(gears[0].interval.root_diameter_mm, 4));
    assert.equal(await ends("pair.backlash.normal_mm"), shown(normal_mm, 4));
    assert.equal(await ends("pair.backlash.circumferential_mm", 1), shown(circumferential_mm[1], 4));
    assert.equal(await page.locator('[data-quantity="gears.base_diameter_mm"] .ends').count(), 0);
  });

  it("a series shows its limits of the thickness allowance in the form", async () => {
    await put(page, example("spur_pair").replace("[gear2]", '[gear1.tolerance]\nthickness_series = "cd25"\n\n[gear2]'));
    const field = '[data-key="gear1.thickness_allowance_mm"]';
    assert.match(await page.getAttribute(field, "placeholder"), /^-0\.\d+ … -0\.\d+$/);
    assert.equal(await page.inputValue(field), "");
  });

  it("quantities of a point or of a part have its name", async () => {
    await put(page, example("helical_pair"));
    const heads = await page.locator('.sheet tbody th[scope="row"]').allTextContents();
    for (const point of "ABCDE") assert.ok(heads.includes(`distance from A, point ${point}`), heads.join());
    assert.ok(heads.includes("specific sliding, gear 1"), heads.join());
    assert.deepEqual(heads.filter((one) => one.includes("_") || /^(total|gear [12])$/.test(one)), []);
  });
});

describe("form and text", () => {
  it("stay in agreement: each follows the other, comments are kept, undo and redo work", async () => {
    await put(page, example("helical_pair"));
    await page.fill('[data-key="gear1.profile_shift"]', "0.41");
    await page.waitForFunction(() => window.gearwright.text().includes("profile_shift = 0.41"));
    await settled(page);
    assert.match(await page.evaluate(() => window.gearwright.text()), /# right hand/);
    await page.click("button[aria-label=undo]");
    await page.waitForFunction(() => window.gearwright.text().includes("profile_shift = 0.3"));
    await page.click("button[aria-label=redo]");
    await page.waitForFunction(() => window.gearwright.text().includes("profile_shift = 0.41"));
    await page.click("text=text >> nth=0");
    const area = page.locator("textarea");
    await area.fill((await area.inputValue()).replace("teeth = 43", "teeth = 44"));
    await settled(page);
    await page.click(".spec-head >> text=form");
    assert.equal(await page.inputValue('[data-key="gear2.teeth"]'), "44");
  });

  it("arrow keys and the slider change a number", async () => {
    await put(page, example("helical_pair"));
    await page.focus('[data-key="gear1.teeth"]');
    await page.keyboard.press("ArrowUp");
    await page.waitForFunction(() => window.gearwright.text().includes("teeth = 18"));
    await page.waitForSelector(
      'input[aria-label^="number of teeth, gear 1"][type=range]',
    );
  });

  it("an error is shown at its field with the engine's message, and the page continues to work", async () => {
    await put(page, example("helical_pair"));
    await page.fill('[data-key="gear1.normal_module_mm"]', "1e300");
    await page.waitForSelector('[data-key="gear1.normal_module_mm"][aria-invalid=true]');
    assert.match(await page.textContent(".note .fault:not(:empty)"), /must lie between/);
    await page.fill('[data-key="gear1.normal_module_mm"]', "2.5");
    await page.waitForSelector('[data-key="gear1.normal_module_mm"][aria-invalid=false]');
    for (const [text, words] of [
      ["[gear1]\nteeth = = 3\n", /line 2/i],
      ["[gear1]\nteth = 17\n", /did you mean teeth/],
      ["\u0000\u0001[[[[", /./],
      ["[gear1]\nteeth = 99999999999999999999\nnormal_module_mm = 1\n", /./],
      ["x".repeat(10_000_000), /10\.0 million characters/],
    ]) {
      await put(page, text);
      assert.match(await page.textContent(".headline"), words);
    }
    await put(page, example("spur_pair"));
    assert.equal(await page.getAttribute(".verdict", "data-level"), native("pair", example("spur_pair")).verdict.level);
    assert.deepEqual(page.complaints, []);
  });

  it("a title is shown as text everywhere", async () => {
    const evil = '</script><img src=x onerror="window.stolen=1"><b>';
    const text = example("helical_pair").replace('title = "helical pair"', `title = ${JSON.stringify(evil)}`);
    for (const tab of kTabs) {
      await put(page, text, tab);
      await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
    }
    assert.equal(await page.textContent("h1"), evil);
    assert.equal(await page.evaluate(() => window.stolen), undefined);
    for (const frame of page.frames()) assert.equal(await frame.evaluate(() => window.stolen), undefined);
    assert.equal(await page.locator("img").count(), 0);
  });
});

describe("pictures", () => {
  const inked = (selector) =>
    page.evaluate((selector) => {
      const canvas = document.querySelector(selector);
      const copy = document.createElement("canvas");
      copy.width = 160;
      copy.height = 100;
      const c = copy.getContext("2d");
      c.drawImage(canvas, 0, 0, 160, 100);
      return Array.from(c.getImageData(0, 0, 160, 100).data);
    }, selector);
  const changed = (a, b) => a.filter((one, i) => Math.abs(one - b[i]) > 24).length;

  for (const [tab, name] of [
    ["solid", "helical_pair"],
    ["solid", "crossed_pair"],
    ["solid", "planetary_ring"],
  ])
    it(`${tab} of ${name} is not blank and changes when turned`, async () => {
      await put(page, example(name), tab);
      await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
      const canvas = `#room-${tab} canvas`;
      const turn = (t) => page.fill(`#room-${tab} input[aria-label="rotation of gear 1"]`, t);
      await turn("-0.1");
      await page.waitForTimeout(1500);
      const still = await inked(canvas);
      assert.ok(
        still.some((one, i) => i % 4 === 3 && one > 200),
        "blank",
      );
      await turn("0.15");
      for (let tries = 0; tries < 100 && changed(still, await inked(canvas)) <= 50; ++tries)
        await page.waitForTimeout(200);
      assert.ok(changed(still, await inked(canvas)) > 50, "the picture is the same after a turn");
    });

  it("the slider turns the gears of the mesh in opposite directions", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const angles = () =>
      page.locator("#room-mesh use.body").evaluateAll((all) =>
        Object.fromEntries(
          all.map((one) => [one.dataset.gear, Number(/rotate\(([^)]*)/.exec(one.getAttribute("transform"))[1])]),
        ),
      );
    const turn = async (t) => {
      await page.fill('#room-mesh input[aria-label="rotation of gear 1"]', t);
      await page.waitForTimeout(200);
      return angles();
    };
    const [a, b] = [await turn("-0.1"), await turn("0.15")];
    const pitch = 360 / 17;
    assert.ok(Math.abs(b[0] - a[0] - 0.25 * pitch) < 1e-6, `gear 1: ${b[0] - a[0]}°`);
    assert.ok(Math.abs((b[1] - a[1]) / (b[0] - a[0]) + 17 / 43) < 1e-3, `gear 2: ${b[1] - a[1]}°`);
    assert.equal(await page.locator("#room-mesh .touches").getAttribute("visibility"), "visible");
  });

  it("a search lists the designs of the program, and a click on a row opens one", async () => {
    await put(page, example("gearbox_search"), "search");
    await page.waitForSelector(".designs tbody tr");
    await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
    const expected = native("search", example("gearbox_search")).search;
    assert.match(await page.textContent(".search-said"), new RegExp(`^${expected.feasible_count} of`));
    assert.match(await page.textContent(".headline"), new RegExp(`^${expected.feasible_count} of .* every limit`));
    await page.click(".designs tbody tr:nth-child(2)");
    await page.waitForFunction(() => /teeth = /.test(window.gearwright.text()));
    await settled(page);
    assert.equal(await page.inputValue('[data-key="gear1.teeth"]'), String(expected.designs[1].teeth[0]));
  });

  it("a fit shows all branches", async () => {
    await put(page, example("crossed_fit"), "search");
    await page.waitForSelector(".branch");
    assert.equal(
      await page.locator(".branch").count(),
      native("fit", example("crossed_fit")).fit.branches.length,
    );
    const facts = await page.locator(".branch dd").allTextContents();
    assert.ok(facts.every((fact) => /\d/.test(fact)), "a row without a value");
    await page.click(".branch button");
    await page.waitForFunction(() => document.querySelector(".level").textContent !== "fit");
    await settled(page);
    assert.match(await page.textContent(".level"), /Runs|Check|Does not run/);
  });
});

describe("unknown values of a spec", () => {
  it("a broken gear is identified, and the result is opened as a gear", async () => {
    await put(page, example("broken_gear"), "search");
    await page.waitForSelector(".branch");
    const expected = native("identify", example("broken_gear")).identify.candidates;
    assert.equal(await page.locator(".branch").count(), expected.length);
    await page.click(".branch button");
    await page.waitForFunction(() => document.querySelector(".level").textContent !== "identify");
    await settled(page);
    for (const key of ["normal_module_mm", "profile_shift", "thickness_allowance_mm"]) {
      const shown = await page.inputValue(`[data-key="gear1.${key}"]`);
      assert.equal(Number(shown), expected[0].spec.gear1[key], key);
    }
  });

  it("every form under “Start from” leads to a result", async () => {
    const count = await page.locator("form.have").count();
    assert.equal(count, 8);
    for (let i = 0; i < count; ++i) {
      await page.evaluate(() => window.gearwright.start());
      await page.click(`form.have >> nth=${i} >> button`);
      await settled(page);
      await page.waitForFunction(() => document.querySelector(".designs tbody tr, .branch") ||
        /Runs|Check/.test(document.querySelector(".level").textContent));
    }
    assert.deepEqual(page.complaints, []);
  });
});

describe("links and files", () => {
  it("a link contains the design", async () => {
    await put(page, example("ring_pair"));
    await page.waitForFunction(() => location.hash.startsWith("#1."));
    await page.waitForTimeout(600);
    const other = await open(browser, page.url());
    await settled(other);
    assert.equal(await other.evaluate(() => window.gearwright.text()), example("ring_pair"));
    await other.context().close();
    const broken = await open(browser, address + "#1.not-a-design");
    assert.match(await broken.textContent(".said"), /damaged/);
    await broken.context().close();
  });

  it("every kind of file can be downloaded and is not empty", async () => {
    await put(page, example("spur_pair"));
    const folder = mkdtempSync(join(tmpdir(), "gearwright_web_"));
    await page.click("text=Download");
    for (const [label, first] of [
      ["Report, save", /^<!DOCTYPE html|^<!doctype html/],
      ["JSON, save", /^\{/],
      ["STL, gear 1", /./s],
      ["3MF, gear 1", /^PK/],
      ["GLB, pair", /^glTF/],
      ["Drawing, pair", /^%PDF/],
      ["STEP, pair", /^ISO-10303-21;/],
      ["DXF, gear 1", /./s],
      ["SVG, gear 1", /<svg/],
    ]) {
      const [file] = await Promise.all([
        page.waitForEvent("download"),
        page.click(`button[aria-label="${label}"]`),
      ]);
      const path = join(folder, file.suggestedFilename());
      await file.saveAs(path);
      assert.ok(statSync(path).size > 300, label);
      assert.match(readFileSync(path, "latin1"), first, label);
    }
    await page.keyboard.press("Escape");
  });

  it("a dropped file is opened", async () => {
    const folder = mkdtempSync(join(tmpdir(), "gearwright_web_"));
    writeFileSync(
      join(folder, "one.json"),
      JSON.stringify({ title: "from JSON", gear1: { teeth: 19, normal_module_mm: 2 } }),
    );
    await page.setInputFiles("input[type=file]", join(folder, "one.json"));
    await page.waitForFunction(() => window.gearwright.text().includes("from JSON"));
    await settled(page);
    assert.equal(await page.textContent("h1"), "from JSON");
  });

  it("the self-contained file opens from disk, offline, and has less than 2.99 MB", async () => {
    const path = join(web, "gearwright.html");
    assert.ok(statSync(path).size < 2.99e6);
    const context = await browser.newContext({ offline: true });
    const alone = await context.newPage();
    const asked = [];
    alone.on("request", (request) => !/^(file|blob|data):/.test(request.url()) && asked.push(request.url()));
    await alone.goto(pathToFileURL(path).href);
    await alone.waitForSelector("html[data-ready]", { timeout: kPatience });
    await put(alone, example("helical_pair"));
    assert.equal(
      await alone.textContent(".headline"),
      native("pair", example("helical_pair")).verdict.headline,
    );
    assert.deepEqual(asked, []);
    await context.close();
  });
});

describe("for everybody", () => {
  const axe = readFileSync(join(root, "apps/web/node_modules/axe-core/axe.min.js"), "utf8");
  const findings = async (page) => {
    await page.evaluate(axe);
    const result = await page.evaluate(() => window.axe.run(document, { iframes: false }));
    return result.violations
      .filter((one) => one.impact === "serious" || one.impact === "critical")
      .map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`);
  };
  for (const [name, width, scheme] of [
    ["wide and light", 1280, "light"],
    ["wide and dark", 1280, "dark"],
    ["narrow", 400, "light"],
  ])
    it(`axe finds no serious problem: ${name}`, async () => {
      const one = await open(browser, address, { viewport: { width, height: 800 }, colorScheme: scheme });
      const first = await one.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(first <= width, `the first page is ${first} px wide`);
      assert.deepEqual(await findings(one), []);
      const shown = { search: "gearbox_search", load: "loaded_pair", rating: "rated_pair" };
      for (const tab of ["mesh", "contact", "load", "rating", "shifts", "search"]) {
        await put(one, example(shown[tab] ?? "misaligned_pair"), tab);
        await one.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
        assert.deepEqual(await findings(one), [], tab);
      }
      const wide = await one.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `the page is ${wide} px wide`);
      await one.context().close();
    });
});
