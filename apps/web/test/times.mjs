// Measures the speed of the page: from opening to the first result, from a keystroke to the picture, the
// contact curve, and frames while the gears turn or a value changes. The other files contain the tests.
//
//   node apps/web/test/times.mjs

import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { example, kPatience, launch, open, openTab, put, settled, web } from "./stage.mjs";

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const browser = await launch();
const starts = [];
for (let i = 0; i < 5; ++i) {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(pathToFileURL(join(web, "gearwright.html")).href);
  await page.waitForSelector("html[data-ready]", { timeout: kPatience });
  starts.push(await page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
  await context.close();
}
console.log(`opening to the first result of the engine   ${median(starts).toFixed(0)} ms`);

const page = await open(browser, pathToFileURL(join(web, "gearwright.html")).href);
for (const name of ["spur_pair", "helical_pair", "planetary_ring", "crossed_pair", "misaligned_pair"]) {
  await put(page, example(name));
  const times = await page.evaluate(async () => {
    const all = [];
    const field = document.querySelector('[data-key="gear1.face_width_mm"]');
    for (let i = 0; i < 25; ++i) {
      const before = window.gearwright.text();
      field.value = String(20.06 + i / 8);
      field.dispatchEvent(new Event("input"));
      while (window.gearwright.text() === before) await new Promise((go) => setTimeout(go));
      all.push([window.gearwright.lastMs(), window.gearwright.engineMs()]);
      await new Promise((go) => setTimeout(go, 60)); // until the last picture is painted
    }
    return all;
  });
  const [there, engine] = [0, 1].map((k) => median(times.map((one) => one[k])).toFixed(1));
  console.log(`${name.padEnd(18)} change of a key: result after ${there} ms, of which the engine takes ${engine} ms`);
}
await put(page, example("misaligned_pair"), "contact");
await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
console.log("contact            " + (await page.textContent(".time")));
await put(page, example("helical_pair"), "mesh");
await settled(page);
for (const tab of ["mesh", "solid"]) {
  await openTab(page, tab);
  await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
  await page.click(`#room-${tab} .controls button`);
  const frames = await page.evaluate(
    () =>
      new Promise((done) => {
        let n = 0;
        const begin = performance.now();
        const count = () =>
          performance.now() - begin < 2000 ? (++n, requestAnimationFrame(count)) : done(n / 2);
        requestAnimationFrame(count);
      }),
  );
  console.log(
    `${tab.padEnd(18)} frames per second while turning, without a graphics card: ${frames.toFixed(0)}`,
  );
  await page.click(`#room-${tab} .controls button`);
}
// Frames while a slider moves in each frame: the engine computes, and the pictures follow.
for (const [tab, name, key, from] of [
  ["mesh", "helical_pair", "gear1.profile_shift", 0.3],
  ["contact", "misaligned_pair", "errors.crossing_deg", 0.03],
]) {
  await put(page, example(name), tab);
  await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
  const [frames, results] = await page.evaluate(
    ({ key, from }) =>
      new Promise((done) => {
        const field = document.querySelector(`[data-key="${key}"]`);
        let n = 0, results = 0, last = window.gearwright.text();
        const begin = performance.now();
        const move = () => {
          const text = window.gearwright.text();
          if (text !== last) ++results;
          last = text;
          if (performance.now() - begin > 3000) return done([n / 3, results / 3]);
          field.value = (from + 0.0001 * ++n).toFixed(4);
          field.dispatchEvent(new Event("input"));
          requestAnimationFrame(move);
        };
        requestAnimationFrame(move);
      }),
    { key, from },
  );
  console.log(
    `${tab.padEnd(18)} frames per second while ${key} changes: ${frames.toFixed(0)}, ` +
      `results per second: ${results.toFixed(0)}`,
  );
}
await browser.close();
