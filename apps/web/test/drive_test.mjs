// Tests the tabs "drive" and "solid" of drives: scheme, power flow, the colours and the rotation of all
// bodies, and the choice of the held, driving and driven bodies. Numbers are compared with the native
// program.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe } from "node:test";
import { example, idle, it, native, put, root, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

const drive = (name) => readFileSync(join(root, "examples/drives", `${name}.toml`), "utf8");
const room = "#room-solid";
const legend = () => page.locator(`${room} .legend li`).allTextContents();
const menu = (name) => page.locator(`${room} [data-menu="${name}"] select`);
const shown = async () => {
  await settled(page);
  await idle(page);
};
/** Pixels of the canvas, reduced in size. */
const pixels = () =>
  page.evaluate((selector) => {
    const copy = document.createElement("canvas");
    copy.width = 160;
    copy.height = 100;
    const context = copy.getContext("2d");
    context.drawImage(document.querySelector(selector), 0, 0, 160, 100);
    return Array.from(context.getImageData(0, 0, 160, 100).data);
  }, `${room} canvas`);

describe("the figures of a drive", () => {
  const ids = () => page.$$eval("#room-drive .figure-slot:not([hidden]) svg[id]", (all) => all.map((one) => one.id));

  it("the tab drive has the scheme, the power flow and the curves under load, and saves them", async () => {
    await put(page, drive("planetary_set"), "drive");
    await shown();
    assert.deepEqual(await ids(), ["scheme", "power"]);
    for (const name of Object.keys(native("drive", drive("planetary_set")).drive.bodies))
      assert.match(await page.textContent("#room-drive #scheme"), new RegExp(name));
    const [saved] = await Promise.all([
      page.waitForEvent("download"),
      page.click('#room-drive .figure-slot:has(#power) .figure-save button:has-text("SVG")'),
    ]);
    assert.equal(saved.suggestedFilename(), "power.svg");
    await put(page, drive("loaded_planets"), "drive");
    await page.waitForSelector('#room-drive .figure-slot:not([hidden]) svg[id^="planet-share"]', { timeout: 90000 });
    await shown();
    assert.deepEqual((await ids()).slice(0, 2), ["scheme", "power"]);
    assert.deepEqual(page.complaints, []);
  });

  it("a pair has no tab drive", async () => {
    await put(page, example("spur_pair"), "drive");
    await shown();
    assert.equal(await page.locator("#tab-drive").isHidden(), true);
    assert.equal(await page.locator("#room-mesh").isVisible(), true);
  });
});

describe("the solids of a drive", () => {
  it("a planetary set has all its bodies and turns by the rotation of the chosen body", async () => {
    await put(page, drive("planetary_set"), "solid");
    await shown();
    assert.deepEqual(await legend(), ["sun", "ring", "planet"]);
    assert.deepEqual(await menu("slider turns").locator("option").allTextContents(), ["sun", "carrier", "planet"]);
    await page.waitForTimeout(1500);
    const still = await pixels();
    assert.ok(still.some((one, i) => i % 4 === 3 && one > 200), "blank");
    await menu("slider turns").selectOption("carrier");
    await page.fill(`${room} input[aria-label="rotation of carrier"]`, "0.1");
    assert.equal(await page.textContent(`${room} .angle`), "36.00°");
    let changed = 0;
    for (let tries = 0; tries < 100 && changed <= 50; ++tries) {
      await page.waitForTimeout(200);
      const now = await pixels();
      changed = still.filter((one, i) => Math.abs(one - now[i]) > 24).length;
    }
    assert.ok(changed > 50, "the picture is the same after a turn");
    assert.deepEqual(page.complaints, []);
  });

  it("the choice of the held body exchanges two bodies in the spec in one step, and the answer follows", async () => {
    await put(page, drive("planetary_set"), "solid");
    await shown();
    const before = await page.evaluate(() => window.gearwright.text());
    await menu("held").selectOption("sun");
    await page.waitForFunction(() => /fixed = "sun"/.test(window.gearwright.text()));
    await shown();
    const text = await page.evaluate(() => window.gearwright.text());
    for (const line of [/^fixed = "sun"$/m, /^input = "ring"$/m, /^output = "carrier"$/m]) assert.match(text, line);
    const { drive: answer } = native("drive", text);
    const ratio = await page.textContent('.numbers [data-quantity="drive.ratio"]');
    assert.equal(ratio, answer.ratio.toFixed((ratio.split(".")[1] ?? "").length));
    assert.deepEqual(await menu("slider turns").locator("option").allTextContents(), ["ring", "carrier", "planet"]);
    await page.keyboard.press("Control+z");
    await settled(page);
    assert.equal(await page.evaluate(() => window.gearwright.text()), before);
    assert.deepEqual(page.complaints, []);
  });

  it("a train has no choice of roles, and a pair has no controls of drives", async () => {
    await put(page, drive("two_stage_gearbox"), "solid");
    await shown();
    assert.equal((await legend()).length, 3);
    assert.equal(await menu("held").count(), 0);
    await put(page, readFileSync(join(root, "examples/spur_pair.toml"), "utf8"), "solid");
    await shown();
    assert.equal(await page.locator(`${room} .drive-controls`).isHidden(), true);
    assert.equal(await page.locator(`${room} input[aria-label="rotation of gear 1"]`).count(), 1);
    assert.deepEqual(page.complaints, []);
  });
});
