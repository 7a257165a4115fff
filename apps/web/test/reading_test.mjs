// Tests the texts on the page: labels are words instead of keys, fields show their whole value, and circles
// have names.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, examples, idle, it, open, put, touching, withPage } from "./stage.mjs";

let page, browser, address;
withPage((stage) => ({ page, browser, address } = stage));

/** Fields of the visible part whose value is wider than the field. */
const clipped = () => {
  const pen = document.createElement("canvas").getContext("2d");
  return [...document.querySelectorAll("input[type=text], select")].flatMap((one) => {
    if (!one.offsetParent || !one.clientWidth) return [];
    const style = getComputedStyle(one);
    const select = one instanceof HTMLSelectElement;
    const text = select ? (one.selectedOptions[0]?.text ?? "") : one.value || one.placeholder;
    pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const room = one.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - (select ? 20 : 0);
    return pen.measureText(text).width > room + 1 ? [`${one.dataset.key ?? one.className}: ${text}`] : [];
  });
};
/** Opens every section of the form, with every key. */
const openAll = () => {
  const next = () => [...document.querySelectorAll(".form button.more")].find((one) => /^\d/.test(one.textContent));
  for (let button; (button = next()); ) button.click();
  for (const one of document.querySelectorAll(".form details")) one.open = true;
};
describe("fields and labels", () => {
  for (const width of [1400, 420])
    it(`no field cuts off its value and no label is a key at ${width} px`, async () => {
      const page = await open(browser, address, { viewport: { width, height: 900 } });
      const raw = /_|\b(sigma|youngs|poisson|min|max|\d+C|Hlim|Flim)\b|(^| )center\b/;
      for (const { name, text } of examples) {
        for (const tab of ["load", "rating"]) {
          await put(page, text, tab);
          if (width < 900) await page.click('.parts [data-choice="spec"]');
          await page.evaluate(openAll);
          const labels = await page.locator(".row .label > span:first-child").allTextContents();
          assert.deepEqual(labels.filter((label) => raw.test(label)), [], name);
          const heads = await page.locator(".section-title").allTextContents();
          assert.deepEqual(heads.filter((head) => !/^\p{Lu}/u.test(head) || /_/.test(head)), [], name);
          assert.deepEqual(await page.evaluate(clipped), [], `${name}, form`);
          if (width < 900) await page.click('.parts [data-choice="view"]');
          assert.deepEqual(await page.evaluate(clipped), [], `${name}, ${tab}`);
        }
      }
      await page.context().close();
    });

  it("words of a list are read and written without underscores", async () => {
    await put(page, example("gearbox_search"), "search");
    assert.equal(await page.inputValue('[data-key="search.objective"]'), "contact ratio, sliding");
    await page.fill('[data-key="search.objective"]', "sliding, contact ratio");
    await page.waitForFunction(() => /objective = \["sliding", "contact_ratio"\]/.test(window.gearwright.text()));
  });
});

describe("pictures", () => {
  it("circles of the mesh have symbols", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    // A symbol ends in a space of zero width. If there is no free position for a name, the name is
    // omitted. Here, d_w1 is omitted.
    const names = async () =>
      (await page.locator("#room-mesh .circle-name").filter({ visible: true }).allTextContents()).map((name) => name.replaceAll("\u200b", ""));
    await page.click('[data-choice="whole"]');
    await page.waitForSelector("#room-mesh .circle-name");
    await idle(page);
    const shown = await names();
    for (const name of ["da1", "db1", "df1", "da2"]) assert.ok(shown.includes(name), `${name} of ${shown}`);
    await page.uncheck('label:has-text("circles")');
    assert.deepEqual(await names(), []);
    await page.check('label:has-text("circles")');
    await page.click('[data-choice="mesh"]');
  });

  it("after zooming, the mesh is still sharp and its circles have names", async () => {
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const window = () =>
      page.evaluate(() => {
        const [lo, hi] = document.querySelector("#room-mesh g.plot").getAttribute("data-x").split(" ").map(Number);
        return hi - lo;
      });
    const before = await window();
    await page.focus("#room-mesh svg");
    for (let i = 0; i < 4; ++i) await page.keyboard.press("+");
    await page.waitForFunction(
      (before) => {
        const plot = document.querySelector("#room-mesh g.plot");
        const [lo, hi] = plot.getAttribute("data-x").split(" ").map(Number);
        return Math.abs((hi - lo) * 1.25 ** 4 - before) < 1e-6 * before && plot.closest("svg").viewBox.baseVal.x === 0;
      },
      before,
    );
    assert.ok((await page.locator("#room-mesh .circle-name").count()) > 2);
    await page.dblclick("#room-mesh svg");
    await page.waitForFunction((before) => {
      const [lo, hi] = document.querySelector("#room-mesh g.plot").getAttribute("data-x").split(" ").map(Number);
      return Math.abs(hi - lo - before) < 1e-6 * before;
    }, before);
  });

  it("a view that is zoomed right after two figures in a row is kept", async () => {
    // Regression: 200 ms after the second figure, the whole figure replaced the zoomed view, and the new window
    // was lost.
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    const [before, after] = await page.evaluate(async () => {
      const pause = (ms) => new Promise((done) => setTimeout(done, ms));
      const ends = () => document.querySelector("#room-mesh g.plot").getAttribute("data-x");
      const width = () => ends().split(" ").slice(0, 2).map(Number).reduce((lo, hi) => hi - lo);
      const choose = async (name) => {
        const old = ends();
        document.querySelector(`[data-choice="${name}"]`).click();
        while (ends() === old) await pause(1);
      };
      await choose("whole");
      await choose("mesh");
      const before = width();
      await pause(100);
      document.querySelector("#room-mesh svg").dispatchEvent(new KeyboardEvent("keydown", { key: "+", bubbles: true }));
      for (let i = 0; i < 600 && width() === before; ++i) await pause(50);
      return [before, width()];
    });
    assert.ok(Math.abs(after * 1.25 - before) < 1e-6 * before, `${before} ${after}`);
    await page.dblclick("#room-mesh svg");
  });

  it("the stated distance to the nearest border of the shift chart agrees with the figure", async () => {
    // Regression: with a tip clearance of 0.25 modules, the page stated "0.230 modules from the nearest
    // border" for every design.
    for (const name of ["helical_pair", "rated_pair", "spur_pair"]) {
      await put(page, example(name), "shifts");
      await idle(page);
      const drawn = await page.evaluate(() => {
        const plot = document.querySelector("#room-shifts g.plot");
        const perUnit = (axis) => {
          const [lo, hi, from, to] = plot.getAttribute(`data-${axis}`).split(" ").map(Number);
          return Math.abs((to - from) / (hi - lo));
        };
        const [across, up] = [perUnit("x"), perUnit("y")];
        const design = plot.querySelector(".design");
        const p = [design.getAttribute("cx") / across, design.getAttribute("cy") / up];
        let least = Infinity;
        for (const border of plot.querySelectorAll("path.region-edge")) {
          const points = border.getAttribute("d").slice(1).split("L").map((one) => one.split(" ").map(Number));
          for (let i = 1; i < points.length; ++i) {
            const [a, b] = [points[i - 1], points[i]].map(([x, y]) => [x / across, y / up]);
            const d = [b[0] - a[0], b[1] - a[1]];
            const t = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2 || 1);
            const s = Math.min(1, Math.max(0, t));
            least = Math.min(least, Math.hypot(p[0] - a[0] - s * d[0], p[1] - a[1] - s * d[1]));
          }
        }
        return least;
      });
      const said = Number(/([\d.]+) modules/.exec(await page.textContent(".shift-sentence"))[1]);
      assert.ok(Math.abs(said - drawn) < 0.01, `${name}: ${said} in the text, ${drawn} in the figure`);
    }
  });

  it("both points and all borders of the shift chart have names", async () => {
    await put(page, example("helical_pair"), "shifts");
    await page.waitForSelector("#room-shifts .design");
    const words = await page.locator("#room-shifts g.plot text").allTextContents();
    for (const name of ["the design", "choice of a search", "contact ratio"])
      assert.ok(words.includes(name), `${name} of ${words}`);
    assert.ok((await page.locator(".shift-key .key").count()) > 2);
  });
});
