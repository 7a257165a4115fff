// Tests the table of designs that a search has found. The table has enough room and describes the kind of
// point in words. The scatter plot below it uses quantities in which the designs differ.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, idle, it, open, put, touching, withPage } from "./stage.mjs";

let page, browser, address;
withPage((stage) => ({ page, browser, address } = stage));

describe("the table of designs", () => {
  it("fits into 1400 px, above its scatter plot, with words instead of keys", async () => {
    const page = await open(browser, address, { viewport: { width: 1400, height: 900 } });
    await put(page, example("gearbox_search"), "search");
    await idle(page);
    const room = await page.evaluate(() => {
      const table = document.querySelector(".designs-scroll");
      const scatter = document.querySelector(".pareto").getBoundingClientRect();
      const view = document.querySelector("#room-search").getBoundingClientRect();
      return {
        hidden: table.scrollWidth - table.clientWidth,
        over: scatter.top - table.getBoundingClientRect().bottom,
        empty: view.bottom - scatter.bottom,
        tall: scatter.height,
      };
    });
    assert.equal(room.hidden, 0);
    assert.ok(room.over >= 0 && room.tall > 150 && room.empty < 30, JSON.stringify(room));
    assert.equal(await touching(page, ".pareto text.panel", ".pareto text.e"), false);
    await page.context().close();
  });

  it("describes the shifts in words and uses another axis if the centre distance is fixed", async () => {
    await page.evaluate(() => window.gearwright.start());
    await page.click('form.have:has-text("Two tooth numbers and a centre distance") button');
    await page.waitForSelector(".designs tbody tr");
    await idle(page);
    assert.doesNotMatch(await page.textContent("#room-search"), /eq11|lo[ _]hi/);
    assert.match(await page.textContent(".common"), /centre distance 90\.0000 mm/);
    const across = "select[aria-label='horizontal axis of the Pareto chart']";
    assert.doesNotMatch(await page.inputValue(across), /center_distance/);
    const options = await page.locator(`${across} option`).allTextContents();
    assert.ok(!options.includes("centre distance") && options.length > 4, options.join());
    const places = await page.locator(".pareto circle").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().left));
    assert.ok(new Set(places).size > 1);
    assert.deepEqual(page.complaints, []);
  });

  it("names the least and the greatest backlash", async () => {
    await put(page, example("gearbox_search").replace("[search]", '[search]\nthickness_series = "cd25"'), "search");
    await idle(page);
    const heads = await page.locator(".designs thead button").evaluateAll((all) => all.map((one) => one.title));
    const backlash = heads.filter((one) => /^backlash/.test(one));
    assert.deepEqual(backlash.map((one) => one.replace(/^.*, /, "")), ["least", "greatest"], heads.join());
  });

  it("scrolls in its own area on a narrow screen", async () => {
    const page = await open(browser, address, { viewport: { width: 420, height: 860 } });
    await put(page, example("gearbox_search"), "search");
    await idle(page);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 420);
    assert.ok((await page.locator(".designs-scroll").boundingBox()).height > 120);
    assert.ok((await page.locator(".pareto").boundingBox()).height > 150);
    const tab = await page.locator("#tab-search").boundingBox();
    assert.ok(tab.x >= 0 && tab.x + tab.width <= 420, "the tab extends beyond the screen");
    await page.context().close();
  });
});
