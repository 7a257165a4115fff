// What a reader sees: words instead of keys, fields that show their whole value, circles with their
// names.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, examples, idle, it, open, put, touching, withPage } from "./stage.mjs";

let page, browser, address;
withPage((stage) => ({ page, browser, address } = stage));

/** Fields of the visible part whose value is wider than they are. */
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
    it(`no field is clipped and no label is a raw key at ${width} px`, async () => {
      const page = await open(browser, address, { viewport: { width, height: 900 } });
      const raw = /_|\b(sigma|youngs|poisson|min|max|\d+C|Hlim|Flim)\b|(^| )center\b/;
      for (const { name, text } of examples) {
        for (const tab of ["load", "rating"]) {
          await put(page, text, tab);
          if (width < 900) await page.click('.parts [data-part="spec"]');
          await page.evaluate(openAll);
          const labels = await page.locator(".row .label > span:first-child").allTextContents();
          assert.deepEqual(labels.filter((label) => raw.test(label)), [], name);
          const heads = await page.locator(".section-title").allTextContents();
          assert.deepEqual(heads.filter((head) => !/^\p{Lu}/u.test(head) || /_/.test(head)), [], name);
          assert.deepEqual(await page.evaluate(clipped), [], `${name}, form`);
          if (width < 900) await page.click('.parts [data-part="view"]');
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
  it("circles of the mesh have their symbols", async () => {
    await page.evaluate(() => {
      const write = CanvasRenderingContext2D.prototype.fillText;
      window.written = [];
      CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
        window.written.push(text);
        return write.call(this, text, ...rest);
      };
    });
    await put(page, example("helical_pair"), "mesh");
    await idle(page);
    await page.click('[data-frame="whole"]');
    await page.waitForTimeout(200);
    const written = await page.evaluate(() => window.written.splice(0));
    for (const index of ["a", "b", "f", "w"]) assert.ok(written.includes(index), `d_${index}`);
    await page.uncheck("text=circles");
    await page.evaluate(() => (window.written.length = 0));
    await page.click('[data-frame="mesh"]');
    await page.waitForTimeout(200);
    assert.ok(!(await page.evaluate(() => window.written)).includes("b"));
    await page.check("text=circles");
  });

  it("both points of the shift chart have their words; the axis' title touches no tick", async () => {
    await put(page, example("helical_pair"), "shifts");
    await page.waitForSelector(".shift-chart .design");
    assert.deepEqual(await page.locator(".shift-chart .point-name").allTextContents(), [
      "the design",
      "what a search would take",
    ]);
    assert.equal(await touching(page, ".shift-chart .g2", ".shift-chart .e:not(.point-name)"), false);
    assert.equal(await touching(page, ".shift-chart .point-name", ".shift-chart .chosen"), false);
  });
});
