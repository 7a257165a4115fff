// Tests lengths in inch: a spec in inch becomes the same spec in mm, and figures, sliders, tables, report and
// drawing show inch.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, idle, it, native, openTab, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

const kSpec = `units = "inch"
[gear1]
teeth = 17
normal_diametral_pitch_per_in = 10
helix_angle_deg = 15
face_width_in = 1
[gear1.modifications]
tip_relief_uin = 400
tip_relief_start_in = 1.8
[gear2]
teeth = 43
[pair]
backlash_in = 0.004
[errors]
center_distance_in = 0.002
[load]
torque_Nm = 100
accuracy = "draft"
`;
/** Returns the words of both axes of each figure in a tab. */
const axesOf = (tab) =>
  page.$$eval(`#room-${tab} svg.zoom`, (all) =>
    all.map((one) => [...one.querySelectorAll("text.panel, text.tick.m")].map((text) => text.textContent).join(" | ")),
  );
const switchTo = (unit) => page.click(`[data-choice="${unit}"]`);

describe("inch", () => {
  it("a spec in inch becomes the same spec in mm, and the page shows inch", async () => {
    await page.evaluate((text) => window.gearwright.open(text, "contact"), kSpec);
    await page.waitForFunction(() => /face_width_mm = 25\.4\b/.test(window.gearwright.text()));
    await settled(page);
    await idle(page);
    const text = await page.evaluate(() => window.gearwright.text());
    assert.match(text, /tip_relief_um = 10\.16\b/);
    assert.doesNotMatch(text, /units|(?<!_per)_in\b|_uin\b/);
    const [mm, inch] = [native("pair", text), native("pair", kSpec)];
    assert.ok(Math.abs(mm.pair.center_distance_mm / 25.4 - inch.pair.center_distance_in) < 1e-9);
    assert.equal(await page.getAttribute('[data-choice="in"]', "aria-pressed"), "true");
    const units = await page.$$eval(".numbers td.unit", (all) => all.map((one) => one.textContent));
    assert.ok(units.includes("in"));
    assert.deepEqual([...new Set(units)].filter((unit) => /mm|µm/.test(unit) && !/N/.test(unit)), ["mm"]);
    const modules = await page.$$eval(".numbers tr", (all) =>
      all.filter((row) => row.querySelector(".unit")?.textContent === "mm").map((row) => row.querySelector("th").textContent),
    );
    for (const words of modules) assert.match(words, /module/);
  });

  it("the key units in another table is an error of the spec", async () => {
    const text = "[gear1]\nteeth = 17\nnormal_module_mm = 2\nunits = \"inch\"\n";
    await page.evaluate((text) => window.gearwright.open(text, "contact"), text);
    await page.waitForFunction((text) => window.gearwright.text() === text, text);
    await page.evaluate((text) => window.gearwright.open(text, "contact"), kSpec);
    await page.waitForFunction(() => /face_width_mm = 25\.4\b/.test(window.gearwright.text()));
    await settled(page);
  });

  it("figures and sliders of contact are in inch, and in mm after the switch", async () => {
    await page.waitForSelector("#room-contact #bearing1");
    await idle(page);
    const inInch = (await axesOf("contact")).join("\n");
    assert.match(inInch, /diameter, in/);
    assert.match(inInch, /along the face from its middle, in/);
    assert.doesNotMatch(inInch, /, mm|, µm/);
    const slider = page.locator('#room-contact [data-slide="errors.center_distance_mm"]');
    assert.match(await slider.evaluate((one) => one.closest("label").textContent), /0\.0020 in/);
    await switchTo("mm");
    await page.waitForFunction(() => /diameter, mm/.test(document.querySelector("#room-contact #bearing1").textContent));
    assert.match(await slider.evaluate((one) => one.closest("label").textContent), /0\.051 mm/);
    await switchTo("in");
  });

  it("figures under load are in inch, and stresses in N/mm²", async () => {
    await openTab(page, "load");
    await page.waitForSelector("#room-load #pressure1");
    await idle(page);
    const axes = (await axesOf("load")).join("\n");
    assert.match(axes, /along the face from its middle, in/);
    assert.match(axes, /N\/mm²/);
    assert.doesNotMatch(axes, /, mm/);
  });

  it("report and drawing are those of the spec in inch", async () => {
    await openTab(page, "sheet");
    await idle(page);
    const report = await page.$eval("iframe.report", (frame) => frame.srcdoc);
    assert.match(report, /Lengths are in inch/);
    assert.match(report, /face_width_in = 1\.0/);
  });

  it("a click on a map of errors sets the values in mm", async () => {
    await put(page, example("misaligned_pair"), "contact");
    await page.waitForSelector("#room-contact #te path.curve");
    await page.selectOption(".error-map select >> nth=0", "center_distance_mm");
    await page.click(".error-map .map-head button");
    await page.waitForSelector(".error-map g.plot");
    await idle(page);
    assert.match(await page.textContent(".error-map"), /centre distance, in/);
    const svg = page.locator(".error-map svg");
    await svg.scrollIntoViewIfNeeded();
    const box = await page.locator(".error-map g.plot").boundingBox();
    await page.mouse.click(box.x + 0.97 * box.width, box.y + 0.5 * box.height);
    await page.waitForFunction(() => /center_distance_mm = 0\.(08|09|1)/.test(window.gearwright.text()));
    await switchTo("mm");
  });
});
