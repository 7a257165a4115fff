// The tabs "load" and "rating" in a browser: numbers against the native program, fields that ask for
// what is missing, colours of the verdict.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, it, kPatience, native, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

describe("load", () => {
  /** The full answer stands there, under this torque: a former answer would do for one who came too early. */
  const finished = (torque) =>
    page.waitForFunction(
      (torque) => {
        const cell = document.querySelector('#room-load [data-quantity="load.torque_Nm"]');
        const state = document.querySelector("#room-load .load-head .soft");
        return parseFloat(cell?.textContent) === torque && /^\d+ positions/.test(state.textContent);
      },
      torque,
      { timeout: kPatience },
    );
  /** The text is the number, to the digits that it has. */
  const shows = (text, value) => assert.equal(text, value.toFixed((text.split(".")[1] ?? "").length));
  const cell = (id, column = 0) =>
    page.textContent(`#room-load [data-quantity="load.${id}"][data-column="${column}"]`);

  it("a draft comes first, then the program's own numbers", async () => {
    await put(page, example("loaded_pair"), "load");
    await finished(80);
    const expected = native("load", example("loaded_pair"));
    for (const [torque, record] of expected.load.torques.entries()) {
      await page.click(`#room-load .load-head button >> nth=${torque}`);
      shows(await cell("peak_to_peak_arcsec"), record.peak_to_peak_arcsec);
      shows(await cell("face_load_factor"), record.face_load_factor);
      shows(await cell("mesh_stiffness_N_per_mm_um.mean"), record.mesh_stiffness_N_per_mm_um.mean);
      for (const gear of [0, 1])
        shows(await cell("max_root_stress_MPa", gear), record.max_root_stress_MPa[gear]);
    }
    const findings = expected.verdict.findings.filter((one) => one.level !== "green");
    assert.ok((await page.locator("#room-load .notices li").count()) >= findings.length);
    assert.equal(await page.locator("#room-load .uplot").count(), 4);
  });

  it("the slider shows where teeth bear, and the torque is a field", async () => {
    const ink = () => page.evaluate(() => document.querySelector("#room-load canvas[role=img]").toDataURL());
    const before = await ink();
    await page.fill('#room-load input[aria-label="position over the pitch"]', "3");
    assert.notEqual(await ink(), before);
    await page.fill('#room-load [data-key="load.torque_Nm"]', "100");
    await page.waitForFunction(() => /torque_Nm = 100\b/.test(window.gearwright.text()));
    await settled(page);
    await finished(100);
    const text = await page.evaluate(() => window.gearwright.text());
    const [record] = native("load", text).load.torques;
    shows(await cell("max_pressure_MPa"), record.max_pressure_MPa);
    assert.deepEqual(page.complaints, []);
  });

  it("what is missing stands at its field, in the engine's words", async () => {
    await put(page, example("helical_pair"), "load");
    await page.waitForSelector('#room-load [data-key="load.torque_Nm"][aria-invalid=true]');
    const { message } = native("load", example("helical_pair")).error;
    assert.equal(await page.textContent("#room-load .note .fault:not(:empty)"), message);
  });
});

describe("rating", () => {
  it("shows the program's safeties and every factor with its clause and branch", async () => {
    await put(page, example("rated_pair"), "rating");
    await page.waitForSelector("#room-rating [data-safety]");
    const { rating } = native("rate", example("rated_pair"));
    for (const key of ["S_F", "S_H"])
      for (const gear of [1, 2])
        assert.equal(
          await page.textContent(`[data-safety="${key}.${gear}"] .level`),
          rating[key][gear - 1].toFixed(3),
        );
    for (const [key, { formula, branch }] of Object.entries(rating.formulas)) {
      if (rating[key] === null) continue;
      const row = await page.textContent(`#room-rating tr:has([data-quantity="rating.${key}"]) .place`);
      for (const words of [formula, branch].flat()) assert.ok(row.includes(words), `${key}: ${row}`);
    }
  });

  it("a safety that falls short has the verdict's colour; a steel is chosen by name", async () => {
    await page.fill('#room-rating [data-key="rating.power_kW"]', "200");
    await page.waitForSelector('#room-rating .safety[data-level="red"]');
    await page.selectOption('#room-rating [data-key="gear1.material.name"]', "34CrNiMo6");
    await page.waitForFunction(() => /name = "34CrNiMo6"/.test(window.gearwright.text()));
    await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
    const text = await page.evaluate(() => window.gearwright.text());
    const { rating, verdict } = native("rate", text);
    assert.equal(await page.textContent('[data-safety="S_F.1"] .level'), rating.S_F[0].toFixed(3));
    const found = verdict.findings.find((one) => one.code === "root_safety" && one.gear === 1);
    assert.equal(await page.getAttribute('[data-safety="S_F.1"]', "data-level"), found?.level ?? "green");
  });

  it("what is missing stands at its field, in the engine's words", async () => {
    const text = example("rated_pair").replace(/\[gear2.material\]\nname = .*\n/, "");
    await put(page, text, "rating");
    await page.waitForSelector('#room-rating [data-key="gear2.material.name"][aria-invalid=true]');
    const { message } = native("rate", text).error;
    assert.equal(await page.textContent("#room-rating .note .fault:not(:empty)"), message);
    await put(page, example("helical_pair"), "rating");
    await page.waitForSelector('#room-rating [data-key="rating.power_kW"][aria-invalid=true]');
    assert.deepEqual(page.complaints, []);
  });
});
