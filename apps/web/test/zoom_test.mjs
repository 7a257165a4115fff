// Tests zooming and moving a picture with the script that page and report share. The engine is not needed.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe } from "node:test";
import { it, launch, root } from "./stage.mjs";

const script = readFileSync(join(root, "gearwright/figure/zoom_script.js"), "utf8");
const home = [0, 0, 400, 300];
let browser, page;
before(async () => {
  browser = await launch();
  page = await browser.newPage({ viewport: { width: 800, height: 600 } });
  await page.setContent(`<body style="margin:0"><div id="holder" style="width:400px;height:300px;touch-action:none">
    <svg tabindex="0" viewBox="0 0 400 300" width="400" height="300">
    <g class="lb" transform="translate(100 100)"><circle r="5"/></g></svg></div><script>${script}</script>`);
  await page.evaluate(() => {
    window.settled = 0;
    figureZoom(document.getElementById("holder"), { always: true, touch: true, settled: () => ++window.settled });
  });
});
after(() => browser.close());

const box = () =>
  page.evaluate(() => document.querySelector("svg").getAttribute("viewBox").split(" ").map(Number));
const near = (a, b) => a.forEach((one, i) => assert.ok(Math.abs(one - b[i]) < 1e-3, `${a} is not ${b}`));

describe("zoom", () => {
  it("the wheel zooms about the pointer, and labels keep their size", async () => {
    await page.mouse.move(100, 150);
    await page.mouse.wheel(0, -200);
    await page.waitForFunction(() => window.settled > 0);
    const [x, y, width, height] = await box();
    const factor = Math.exp(-200 * 0.0018);
    near([x, y, width, height], [100 - 100 * factor, 150 - 150 * factor, 400 * factor, 300 * factor]);
    const label = await page.getAttribute(".lb", "transform");
    assert.ok(Math.abs(Number(/scale\(([^)]*)\)/.exec(label)[1]) - factor) < 1e-6, label);
  });

  it("dragging moves the view, and a double click restores it", async () => {
    const [x, , width] = await box();
    await page.mouse.down();
    await page.mouse.move(140, 150);
    await page.mouse.up();
    assert.ok(Math.abs(((x - (await box())[0]) / width) * 400 - 40) < 1e-3);
    await page.mouse.dblclick(200, 200);
    near(await box(), home);
    assert.equal(await page.getAttribute(".lb", "transform"), "translate(100 100)");
  });

  it("the keyboard zooms, moves and restores the view", async () => {
    await page.focus("svg");
    await page.keyboard.press("+");
    near(await box(), [40, 30, 320, 240]);
    await page.keyboard.press("ArrowRight");
    near(await box(), [40 + 320 / 12, 30, 320, 240]);
    await page.keyboard.press("0");
    near(await box(), home);
  });

  it("two fingers zoom about the point between them", async () => {
    const client = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    await touch("touchStart", [150, 150], [250, 150]);
    await touch("touchMove", [125, 150], [275, 150]);
    await touch("touchMove", [100, 150], [300, 150]);
    await touch("touchEnd");
    near(await box(), [100, 75, 200, 150]);
  });
});
