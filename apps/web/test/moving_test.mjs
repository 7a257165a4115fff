// Tests what the page requests from the engine and renews while a value changes continuously, and that everything
// is complete when the value rests.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, idle, it, put, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

const kSlow = 10;
/** Sets a key to each value as soon as the result for the previous one has come, and waits for the end of all work.
 *  Meanwhile the clock of the page is slower by the factor kSlow, so that results follow each other quickly on a
 *  loaded machine, too. Returns the requests to the engine, how often the table of numbers was renewed, the greatest
 *  number of arcs that replaced circles of the mesh, and the time in s of the slow clock. */
const drag = (key, values) =>
  page.evaluate(
    async ([key, values, kSlow]) => {
      const real = { now: performance.now.bind(performance), setTimeout, postMessage: Worker.prototype.postMessage };
      const pause = (ms) => new Promise((go) => real.setTimeout.call(window, go, ms));
      const begin = real.now();
      performance.now = () => begin + (real.now() - begin) / kSlow;
      window.setTimeout = (then, ms = 0, ...rest) => real.setTimeout.call(window, then, kSlow * ms, ...rest);
      const requests = [];
      Worker.prototype.postMessage = function (message, ...rest) {
        if (message.name) requests.push(message);
        return real.postMessage.call(this, message, ...rest);
      };
      let [renewals, arcs] = [0, 0];
      const table = new MutationObserver(() => ++renewals);
      table.observe(document.querySelector(".numbers table"), { characterData: true, childList: true, subtree: true });
      const field = document.querySelector(`[data-key="${key}"]`);
      for (const value of values) {
        const before = window.gearwright.text();
        field.value = value;
        field.dispatchEvent(new Event("input"));
        while (window.gearwright.text() === before) await pause(0);
        arcs = Math.max(arcs, document.querySelectorAll("#room-mesh path[data-center]").length);
      }
      const seconds = (performance.now() - begin) / 1000;
      while (!window.gearwright.idle()) await pause(10);
      table.disconnect();
      Worker.prototype.postMessage = real.postMessage;
      window.setTimeout = real.setTimeout;
      performance.now = real.now;
      return { requests, renewals, arcs, seconds };
    },
    [key, values, kSlow],
  );
const named = (requests, name) => requests.filter((one) => one.name === name);
const steps = (from, step, count) => Array.from({ length: count }, (_, i) => (from + step * (i + 1)).toFixed(4));

describe("while a value changes", () => {
  it("numbers are renewed at most ten times per second", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const { renewals, seconds } = await drag("gear1.profile_shift", steps(0.3, 0.001, 40));
    assert.ok(renewals >= 2 && renewals <= 10 * seconds + 2, `${renewals} renewals in ${seconds} s`);
    const shown = await page.textContent('.numbers [data-quantity="gears.profile_shift"][data-column="0"]');
    assert.equal(Number(shown), 0.34);
    assert.equal(await page.locator(".numbers [data-stale]").count(), 0);
  });

  it("the figure of the mesh and the motion of its gears need one request", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const { requests, arcs } = await drag("gear1.profile_shift", steps(0.3, 0.001, 12));
    assert.equal(named(requests, "edit").length, 12);
    const figures = named(requests, "mesh");
    assert.ok(figures.length > 0 && figures.length <= 12, `${figures.length} figures`);
    assert.ok(figures.every((one) => one.question.positions > 0));
    const others = requests.filter(({ name }) => !["edit", "mesh", "rows", "answer"].includes(name));
    assert.deepEqual(others, []);
    // Meanwhile the circles are shown as their visible arcs.
    assert.ok(arcs > 10, `${arcs} arcs`);
    await page.waitForFunction(() => !document.querySelector("#room-mesh [data-center]"));
  });

  it("the circles of the whole pair stay visible", async () => {
    // Regression: an arc that begins and ends at the same point is not drawn.
    await put(page, example("helical_pair"), "mesh");
    await page.click('[data-choice="whole"]');
    await idle(page);
    const drawn = page.evaluate(async () => {
      let least = Infinity;
      for (let i = 0; i < 100; ++i) {
        const lines = [...document.querySelectorAll("#room-mesh .thin")].filter((one) => one.getTotalLength() > 100);
        least = Math.min(least, lines.length);
        await new Promise(requestAnimationFrame);
      }
      return least;
    });
    const before = await page.locator("#room-mesh .thin").count();
    await drag("gear1.profile_shift", steps(0.3, 0.001, 12));
    const least = await drawn;
    assert.ok(least > 0.8 * before, `${least} of ${before} circles`);
    await page.click('[data-choice="mesh"]');
  });

  it("the contact pattern is computed only when the value rests", async () => {
    await put(page, example("misaligned_pair"), "contact");
    await idle(page);
    const { requests } = await drag("errors.crossing_deg", steps(0.03, 0.0001, 30));
    const patterns = named(requests, "pattern");
    // The first change does not follow another one, and the last one is followed by no other.
    assert.ok(patterns.length >= 1 && patterns.length <= 2, `${patterns.length} patterns`);
    assert.match(patterns.at(-1).question.text, /crossing_deg = 0\.033/);
    assert.equal(await page.locator("#room-contact [data-stale]").count(), 0);
    assert.ok((await page.locator("#room-contact #bearing2 .marked").count()) > 0);
  });

  it("the solids are coarser", async () => {
    await put(page, example("helical_pair"), "solid");
    await idle(page);
    const triangles = () => page.textContent("#room-solid .readout");
    const before = await triangles();
    const { requests } = await drag("gear1.profile_shift", steps(0.3, 0.0001, 6));
    const tolerances = named(requests, "meshes").map((one) => one.question.tolerance);
    assert.ok(Math.max(...tolerances) > 4 * tolerances.at(-1), `${tolerances}`);
    const patterns = named(requests, "pattern");
    assert.match(patterns.at(-1).question.text, /profile_shift = 0\.3006/);
    assert.equal(await triangles(), before);
    assert.deepEqual(page.complaints, []);
  });
});
