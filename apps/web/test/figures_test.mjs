// Tests the interactions with figures of the page: dragging a point, circles that follow an error, clicking a
// map, sliders, the values at the pointer, and saving files.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";
import { example, idle, it, kPatience, native, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

describe("figures", () => {
  it("dragging the point of the shift chart changes the design", async () => {
    await put(page, example("helical_pair"), "shifts");
    await page.waitForSelector("#room-shifts .design");
    await page.focus(".shift-room");
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => /profile_shift = 0\.31\b/.test(window.gearwright.text()));
  });

  it("the shift chart shows the limits and the design if no shifts are feasible", async () => {
    // Two gears with seven teeth have a contact ratio below the limit of 1.2.
    await put(page, "[gear1]\nteeth = 7\nnormal_module_mm = 2\n[gear2]\nteeth = 7\n", "shifts");
    await page.waitForSelector("#room-shifts .design.outside");
    assert.match(await page.textContent(".shift-sentence"), /No shifts satisfy the limits/);
    assert.equal(await page.locator("#room-shifts .limits-box").count(), 1);
  });

  it("the circles of a gear move with an error of the centre distance", async () => {
    await put(page, example("helical_pair") + "\n[errors]\ncenter_distance_mm = 1\n", "mesh");
    await settled(page);
    // The body and the outline of both gears are at their circles as soon as the new figure is drawn.
    await page.waitForFunction(() => {
      const plot = document.querySelector("#room-mesh g.plot");
      const on_screen = (element, x, y) => new DOMPoint(x, y).matrixTransform(element.getScreenCTM());
      const centers = [...plot.querySelectorAll("circle.thin")].map((c) =>
        on_screen(c, c.cx.baseVal.value, c.cy.baseVal.value),
      );
      const uses = [...plot.querySelectorAll("use[data-turn]")];
      const near = uses.filter((use) => {
        const axis = on_screen(use, 0, 0);
        return Math.min(...centers.map((one) => Math.hypot(one.x - axis.x, one.y - axis.y))) < 0.2; // px
      });
      return uses.length === 4 && near.length === 4;
    });
  });

  for (const [tab, name, key, from] of [
    ["mesh", "helical_pair", "gear1.profile_shift", 0.3],
    ["contact", "misaligned_pair", "errors.crossing_deg", 0.03],
  ])
    it(`keeps the nodes of the figures while a value changes: ${tab}`, async () => {
      await put(page, example(name), tab);
      await idle(page);
      const [added, nodes] = await page.evaluate(
        async ({ tab, key, from }) => {
          const room = document.querySelector(`#room-${tab}`);
          const field = document.querySelector(`[data-key="${key}"]`);
          let added = 0;
          const size = (node) => 1 + (node.querySelectorAll?.("*").length ?? 0);
          const count = (changes) =>
            changes.forEach((one) => one.addedNodes.forEach((node) => (added += size(node))));
          const slots = [...room.querySelectorAll(".figure-slot:not([hidden])")];
          const observers = slots.map((slot) => {
            const observer = new MutationObserver(count);
            observer.observe(slot, { childList: true, subtree: true });
            return observer;
          });
          const kChanges = 5;
          for (let i = 1; i <= kChanges; ++i) {
            field.value = (from + 0.0001 * i).toFixed(4);
            field.dispatchEvent(new Event("input"));
            do await new Promise((go) => setTimeout(go, 10));
            while (!window.gearwright.idle());
          }
          for (const observer of observers) count(observer.takeRecords());
          const nodes = slots.reduce((sum, slot) => sum + slot.querySelectorAll("*").length, 0);
          return [added / kChanges, nodes];
        },
        { tab, key, from },
      );
      // A figure that is replaced as a whole adds all its nodes. Labels that find no place come and go.
      assert.ok(added < 0.2 * nodes, `${added} of ${nodes} nodes are new after a change`);
    });

  it("a figure is complete again after the last change", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const field = page.locator('[data-key="gear1.profile_shift"]');
    for (const value of ["0.31", "0.32", "0.33"]) await field.fill(value);
    await page.waitForFunction(
      () =>
        window.gearwright.idle() &&
        document.querySelectorAll("#room-mesh defs use").length === 17 + 43 &&
        !document.querySelector("#room-mesh [data-center]"),
    );
  });

  it("a map of errors shows values and accepts clicks before it is complete", async () => {
    // A hollow profile has several maxima, so that the map takes long enough to be cancelled.
    const hollow = "lead_crowning_um = 6\nprofile_crowning_um = -2\n";
    await put(page, example("misaligned_pair").replace("lead_crowning_um = 6\n", hollow), "contact");
    await page.waitForSelector("#room-contact #te path.curve");
    await page.click(".error-map .map-head button");
    await page.waitForSelector(".error-map g.plot");
    await page.click(".error-map .map-head button:has-text('Cancel')");
    await page.locator(".error-map svg").scrollIntoViewIfNeeded();
    const box = await page.locator(".error-map g.plot").boundingBox();
    const before = await page.evaluate(() => window.gearwright.text());
    await page.mouse.click(box.x + 0.75 * box.width, box.y + 0.5 * box.height, { button: "right" });
    assert.equal(await page.evaluate(() => window.gearwright.text()), before);
    await page.mouse.click(box.x + 0.75 * box.width, box.y + 0.5 * box.height);
    await page.waitForFunction((before) => window.gearwright.text() !== before, before);
  });

  it("an error slider changes the transmission error and the text", async () => {
    await put(page, example("misaligned_pair"), "contact");
    await page.waitForSelector("#room-contact #te path.curve");
    const before = await page.textContent("#room-contact .view-sentence");
    await page.fill('[data-slide="errors.crossing_deg"]', "0.06");
    await page.waitForFunction(
      (before) => document.querySelector("#room-contact .view-sentence").textContent !== before,
      before,
    );
    assert.match(await page.evaluate(() => window.gearwright.text()), /crossing_deg = 0\.06/);
    // This error changes no number in the table. Even so, the table must show the next change.
    const width = '.numbers [data-quantity="gears.face_width_mm"][data-column="0"]';
    for (const value of ["41", "40"]) {
      await page.fill('[data-key="gear1.face_width_mm"]', value);
      await page.waitForFunction(([of, value]) => Number(document.querySelector(of).textContent) === Number(value), [width, value]);
      await page.fill('[data-slide="errors.crossing_deg"]', "0.02");
    }
  });

  it("corrections are listed, and a click takes them", async () => {
    const spec = example("misaligned_pair");
    const expected = native("compensate", spec).compensate;
    await put(page, spec, "contact");
    await page.waitForSelector("#room-contact #te path.curve");
    await page.click("#room-contact .corrections button");
    await page.waitForSelector("#room-contact [data-correction]", { timeout: kPatience });
    const keys = await page
      .locator("#room-contact [data-correction]")
      .evaluateAll((rows) => rows.map((row) => row.dataset.correction));
    assert.deepEqual(keys, expected.corrections.map((one) => one.key));
    const words = await page.locator("#room-contact [data-correction] th").allTextContents();
    assert.deepEqual(words, expected.corrections.map((one) => one.words));
    const first = await page.locator("#room-contact [data-correction] td").first().textContent();
    assert.match(first, / µm$/);
    await page.click('#room-contact button[aria-label="take the corrections"]');
    const { right_lead_slope_um } = expected.spec.gear1.modifications;
    assert.ok(Number.isFinite(right_lead_slope_um));
    await page.waitForFunction(
      (amount) => window.gearwright.text().includes(`right_lead_slope_um = ${amount}`),
      right_lead_slope_um,
    );
    await settled(page);
    assert.equal(await page.locator("#room-contact [data-correction]").count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  it("the pointer shows values, a press chooses a position, and values can be saved", async () => {
    await put(page, example("misaligned_pair"), "contact");
    await page.waitForSelector("#room-contact #te path.curve");
    await page.waitForSelector("#room-contact #bearing2 .marked");
    const plot = await page.locator("#te path.measured, #te rect.measured").boundingBox();
    const slider = '#room-contact input[aria-label="position within the pitch"]';
    await page.mouse.click(plot.x + plot.width * 0.25, plot.y + plot.height / 2);
    assert.ok(Math.abs(Number(await page.inputValue(slider)) - 16) <= 1, await page.inputValue(slider));
    assert.ok((await page.locator("#te .cursor").count()) >= 1);
    for (let y = 0.05; y < 1 && !(await page.locator(".readout").count()); y += 0.1)
      await page.mouse.move(plot.x + plot.width * 0.3, plot.y + plot.height * y);
    assert.match(await page.textContent(".readout text"), /^tooth pair .*: −?[\d.]+ at −?[\d.]+$/);
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      page.locator(".figure-slot", { has: page.locator("#te") }).getByText("CSV").click(),
    ]);
    const [picture] = await Promise.all([
      page.waitForEvent("download"),
      page.locator(".figure-slot", { has: page.locator("#te") }).getByText("PDF").click(),
    ]);
    assert.match(readFileSync(await picture.path(), "latin1"), /^%PDF-1\.4[^]*Tj[^]*%%EOF\n$/);
    const rows = readFileSync(await file.path(), "utf8").trim().split("\n");
    const values = rows.slice(1).map((row) => Number(row.split(",").at(-1)));
    const expected = native("contact", example("misaligned_pair")).contact.peak_to_peak_arcsec;
    assert.ok(Math.abs(Math.max(...values) - Math.min(...values) - expected) < 0.02 * expected);
  });
});
