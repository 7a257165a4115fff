// Tests the tab "scatter" in a browser: numbers compared with the native program, the sliders of tolerances,
// and the offer for a spec without tolerances.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, it, kPatience, native, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

describe("scatter", () => {
  const text = example("scattered_pair").replace(/^(indices|worst_case) = true$/gm, "");
  const state = (pattern) =>
    page.waitForFunction(
      (pattern) => new RegExp(pattern).test(document.querySelector("#room-scatter .scatter-state").textContent),
      pattern,
      { timeout: kPatience },
    );
  const highest = async () =>
    Number(/at most ([\d.]+)″/.exec(await page.textContent("#room-scatter .view-sentence"))[1]);
  const move = (place, value, events) =>
    page.evaluate(
      ([place, value, events]) => {
        const input = document.querySelector(`[data-slide="${place}"]`);
        input.value = String(value);
        for (const name of events) input.dispatchEvent(new Event(name, { bubbles: true }));
      },
      [place, value, events],
    );
  /** Returns the highest percentile that the program computes for the number of pairs on the page, in 8
   *  replicates. */
  const percentile = async (text) => {
    const pairs = Number.parseInt(await page.textContent("#room-scatter .scatter-state"));
    const same = text.replace("samples = 256", `samples = ${pairs / 8}`);
    return native("scatter", same).scatter.peak_to_peak_arcsec.percentiles[2];
  };

  it("complete contact analyses give the numbers of the program", async () => {
    await put(page, text, "scatter");
    await state("^\\d+ pairs");
    assert.equal(await highest(), Number((await percentile(text)).toFixed(2)));
    assert.equal(await page.locator("#room-scatter .sliders input").count(), 8);
    for (const id of ["scatter-te", "scatter-play", "scatter-pattern1", "scatter-pattern2"]) await page.waitForSelector(`#room-scatter [id^="${id}"]`);
    assert.equal(await page.locator("#room-scatter .scatter-events li").count(), 3);
  });

  it("an estimate follows the slider, and releasing the slider starts the contact analyses", async () => {
    const place = "scatter.gear1.modifications.profile_slope_um";
    await move(place, 9, ["input"]);
    await page.waitForFunction(() => /profile_slope_um = \[ *-9/.test(window.gearwright.text()));
    await settled(page);
    await state("^First-order estimate");
    const estimate = await highest();
    await move(place, 9, ["change"]);
    await state("^\\d+ pairs");
    const exact = await percentile(await page.evaluate(() => window.gearwright.text()));
    assert.equal(await highest(), Number(exact.toFixed(2)));
    assert.ok(Math.abs(estimate - exact) < 0.1 * exact, `${estimate} is not near ${exact}`);
    assert.deepEqual(page.complaints, []);
  });

  it("the slider of a range changes its ends and keeps its distribution", async () => {
    await move("scatter.errors.crossing_deg.range", 0.03, ["input", "change"]);
    await page.waitForFunction(() => /range = \[ *-0\.03, *0\.03 *\]/.test(window.gearwright.text()));
    assert.match(await page.evaluate(() => window.gearwright.text()), /distribution = "normal"/);
  });

  it("the grade of the teeth has a slider", async () => {
    await put(page, example("helical_pair") + "\n[scatter]\nquality = 7\n", "scatter");
    await state("^\\d+ pairs");
    const rough = await highest();
    await move("scatter.quality", 5, ["input"]);
    await page.waitForFunction(() => /^quality = 5$/m.test(window.gearwright.text()));
    await settled(page);
    await state("^First-order estimate");
    await move("scatter.quality", 5, ["change"]);
    await state("^\\d+ pairs");
    assert.ok((await highest()) < rough);
  });

  it("a spec without tolerances causes an offer of tolerances of the housing", async () => {
    await put(page, example("helical_pair"), "scatter");
    assert.match(await page.textContent("#room-scatter .view-sentence"), /no tolerances/);
    await page.click("#room-scatter button.main");
    await page.waitForFunction(() => /crossing_deg/.test(window.gearwright.text()));
    await state("^\\d+ pairs");
    assert.equal(await page.locator("#room-scatter .sliders input").count(), 3);
    assert.deepEqual(page.complaints, []);
  });
});
