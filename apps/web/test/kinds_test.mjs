// Tests a rack and its pinion, and a double-helical pair, in every tab for which the engine has a result. Numbers are
// compared with the native program.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, idle, it, kPatience, native, openTab, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

const figures = (room) =>
  page.evaluate((room) => [...document.querySelectorAll(`#room-${room} .figure-slot:not([hidden]) svg[id]`)].map((one) => one.id), room);
const sentence = (room) => page.textContent(`#room-${room} .view-sentence`);
/** Returns the greatest and the least value of the first curve of a figure of the tab contact. */
const span = (id) =>
  page.evaluate((id) => /peak to peak ([\d.]+)/.exec(document.querySelector(`#room-contact #${id}`).textContent)?.[1], id);

describe("a rack and its pinion", () => {
  const errors = "\n[errors]\ncrossing_deg = 0.02\n";

  it("contact has the transmission error in µm and the pattern on the pinion", async () => {
    const text = example("steering_rack") + errors;
    await put(page, text, "contact");
    await idle(page);
    const { contact } = native("contact", text + "\n[contact]\npositions = 64\n");
    assert.deepEqual((await figures("contact")).sort(), ["bearing1", "spectrum", "te"]);
    assert.match(await page.textContent("#room-contact #te"), /µm/);
    const shown = await span("te");
    const te = contact.positions.map((one) => one.transmission_error_um);
    assert.equal(shown, (Math.max(...te) - Math.min(...te)).toFixed(shown.split(".")[1].length));
    assert.equal(await page.locator("#room-contact .error-map").isHidden(), true);
    assert.equal(await page.locator('#room-contact [data-slide^="gear2"]').first().isHidden(), true);
    assert.equal(await page.locator('#room-contact [data-slide="errors.crossing_deg"]').isVisible(), true);
    assert.deepEqual(page.complaints, []);
  });

  it("the rack moves by a pitch while the pinion turns by a pitch", async () => {
    await put(page, example("steering_rack"), "mesh");
    await idle(page);
    const place = async (t) => {
      await page.fill('#room-mesh input[aria-label="rotation of gear 1"]', String(t));
      await page.waitForTimeout(100); // the next frame
      return page.evaluate(() => {
        const use = document.querySelector('#room-mesh use[data-gear="1"]');
        const [lo, hi, from, to] = use.closest("g.plot").dataset.y.split(" ").map(Number);
        const px = Number(/translate\(\S+ (\S+)\)/.exec(use.getAttribute("transform"))[1]);
        return lo + ((px - from) / (to - from)) * (hi - lo);
      });
    };
    const moved = (await place(0.5)) - (await place(-0.5));
    const { gears } = native("pair", example("steering_rack"));
    assert.ok(Math.abs(moved + gears[1].transverse_pitch_mm) < 0.01, `${moved}`);
  });

  it("numbers, files and fields are those of a rack", async () => {
    const { pair, gears } = native("pair", example("steering_rack"));
    const cell = (id, column = 0) => page.textContent(`.numbers [data-quantity="${id}"][data-column="${column}"]`);
    assert.equal(Number(await cell("pair.mounting_distance_mm")).toFixed(4), pair.mounting_distance_mm.toFixed(4));
    assert.equal(Number(await cell("gears.length_mm", 1)).toFixed(4), gears[1].length_mm.toFixed(4));
    assert.equal(await page.locator('[data-key="gear2.height_mm"]').count(), 1);
    assert.equal(await page.locator('[data-key="gear2.profile_shift"]').count(), 0);
    await page.click("text=Download");
    const wait = page.waitForEvent("download");
    await page.click('button[aria-label="STEP, pair"]');
    assert.match((await wait).suggestedFilename(), /_pair\.step$/);
    const drawing = page.waitForEvent("download");
    await page.click('button[aria-label="Drawing, rack"]');
    assert.match((await drawing).suggestedFilename(), /_gear2\.pdf$/);
    await page.keyboard.press("Escape");
    for (const room of ["load", "rating", "scatter"]) {
      await openTab(page, room);
      await page.waitForFunction((room) => /gear 2 is a rack/.test(document.querySelector(`#room-${room} .view-sentence`).textContent), room);
    }
    assert.deepEqual(page.complaints, []);
  });
});

describe("a double-helical pair", () => {
  const staggered = example("herringbone_pair")
    .replace(/^\[gear1.double_helical\]$/m, "[gear1.double_helical]\ngap_mm = 4\nstagger_pitches = 0.5")
    .concat("\n[errors]\ncrossing_deg = 0.02\n");

  it("contact has the whole gears and the flanks of the halves that differ", async () => {
    await put(page, example("herringbone_pair"), "contact");
    await idle(page);
    assert.deepEqual((await figures("contact")).filter((id) => /bearing/.test(id)), ["bearing1", "bearing2"]);
    await put(page, staggered, "contact");
    await idle(page);
    assert.deepEqual((await figures("contact")).filter((id) => /bearing/.test(id)).sort(), ["bearing1", "bearing1-2", "bearing2", "bearing2-2"]);
    const { contact } = native("contact", staggered + "\n[contact]\npositions = 64\n");
    const te = contact.positions.map((one) => one.transmission_error_arcsec);
    const shown = await span("te");
    assert.equal(shown, (Math.max(...te) - Math.min(...te)).toFixed(shown.split(".")[1].length));
    assert.deepEqual(page.complaints, []);
  });

  it("load has the numbers of the program, and figures of a half", async () => {
    const text = example("herringbone_pair") + '\n[load]\ntorque_Nm = 20\naccuracy = "draft"\npositions = 8\nslices = 8\n';
    await put(page, text, "load");
    await page.waitForSelector('#room-load [data-quantity="load.peak_to_peak_arcsec"]', { timeout: kPatience });
    await idle(page);
    const [record] = native("load", text).load.torques;
    const shown = await page.textContent('#room-load [data-quantity="load.max_pressure_MPa"]');
    assert.equal(shown, record.max_pressure_MPa.toFixed((shown.split(".")[1] ?? "").length));
    const ids = await figures("load");
    for (const id of ["loaded-te", "load-pairs", "load-share", "pressure1", "root-stress-turn"]) assert.ok(ids.includes(id), id);
    assert.ok(!ids.includes("pressure1-2"));
    assert.deepEqual(page.complaints, []);
  });

  it("a slider of an error changes the contact", async () => {
    await put(page, staggered, "contact");
    await idle(page);
    const before = await sentence("contact");
    await page.evaluate(() => {
      const input = document.querySelector('[data-slide="errors.crossing_deg"]');
      input.value = "0.05";
      input.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await page.waitForFunction(() => /crossing_deg = 0.05/.test(window.gearwright.text()));
    await settled(page);
    await idle(page);
    assert.notEqual(await sentence("contact"), before);
  });
});
