// Tests the tabs "load" and "rating" in a browser: numbers compared with the native program, fields for
// missing inputs, and colours of the verdict.

import assert from "node:assert/strict";
import { describe } from "node:test";
import { example, it, kPatience, native, put, settled, withPage } from "./stage.mjs";

let page;
withPage((stage) => ({ page } = stage));

describe("load", () => {
  /** Waits for the full result under this torque, so that no earlier result is read. */
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
  /** Checks that the text shows the number, rounded to the digits of the text. */
  const shows = (text, value) => assert.equal(text, value.toFixed((text.split(".")[1] ?? "").length));
  const cell = (id, column = 0) =>
    page.textContent(`#room-load [data-quantity="load.${id}"][data-column="${column}"]`);

  it("shows a draft first, then the numbers of the program", async () => {
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
    for (const id of ["loaded-te", "mesh-stiffness", "load-share", "root-stress-turn", "harris", "pressure1", "pressure2"])
      await page.waitForSelector(`#room-load #${id}`);
  });

  it("the slider shows the pressure at a position, and the torque has a field", async () => {
    const ink = () =>
      page.evaluate(() => document.querySelector('#pressure1 [data-frame][visibility="visible"]')?.dataset.frame);
    const before = await ink();
    await page.fill('#room-load input[aria-label="position within the pitch"]', "3");
    assert.notEqual(await ink(), before);
    // Frame 0 is the position t = 0, and the frames of one pitch repeat.
    const place = page.locator('#room-load input[aria-label="position within the pitch"]');
    const positions = Number(await place.getAttribute("max")) + 1;
    const frames = Number(await page.getAttribute("#pressure1 [data-frame]", "data-frames"));
    for (const wanted of [-0.3, 0.2]) {
      const index = Math.round((wanted + 0.5) * positions);
      await place.fill(String(index));
      const frame = Math.round((index / positions - 0.5) * frames);
      assert.equal(Number(await ink()), (frame + frames) % frames);
    }
    await page.fill('#room-load [data-key="load.torque_Nm"]', "100");
    await page.waitForFunction(() => /torque_Nm = 100\b/.test(window.gearwright.text()));
    await settled(page);
    await finished(100);
    const text = await page.evaluate(() => window.gearwright.text());
    const [record] = native("load", text).load.torques;
    shows(await cell("max_pressure_MPa"), record.max_pressure_MPa);
    assert.deepEqual(page.complaints, []);
  });

  it("a proposal is listed with its effects, and a click takes it", async () => {
    const spec = example("quiet_pair") + 'positions = 8\nslices = 8\naccuracy = "draft"\n';
    await put(page, spec, "load");
    await finished(90);
    const expected = native("propose", spec).propose;
    await page.click("#room-load .proposals button");
    await page.waitForSelector("#room-load .proposals tr[data-proposal]", { timeout: kPatience });
    assert.equal(await page.locator("#room-load .proposals tr[data-proposal]").count(), expected.proposals.length);
    for (const [i, proposal] of expected.proposals.entries()) {
      const cell = (key) => page.textContent(`#room-load tr[data-proposal="${i + 1}"] [data-score="${key}"]`);
      shows(await cell("peak_to_peak_arcsec"), proposal.worst.peak_to_peak_arcsec);
      const without = "peak_to_peak_without_load_arcsec";
      shows(await cell(without), proposal[without]);
    }
    assert.ok(expected.recommended > 1);
    await page.click(`#room-load button[aria-label="take proposal ${expected.recommended}"]`);
    const { tip_relief_um } = expected.proposals[expected.recommended - 1].spec.gear1.modifications;
    await page.waitForFunction(
      (amount) => window.gearwright.text().includes(`tip_relief_um = ${amount}`),
      tip_relief_um,
    );
    await settled(page);
    await finished(90);
    assert.equal(await page.locator("#room-load .proposals tr[data-proposal]").count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  it("a spec without a torque makes the tab offer one, with an initial value and without an error", async () => {
    await put(page, example("helical_pair") + '\n[load]\npositions = 8\nslices = 8\naccuracy = "draft"\n', "load");
    await page.waitForSelector("#room-load .offered:not([hidden])");
    assert.equal(await page.locator('#room-load [aria-invalid="true"]').count(), 0);
    assert.equal(await page.locator("#room-load [role=alert]:not(:empty)").count(), 0);
    assert.equal(await page.textContent("#room-load .view-sentence"), "");
    assert.equal(await page.inputValue('[data-offered="load.torque_Nm"]'), "20");
    await page.fill('[data-offered="load.torque_Nm"]', "much");
    await page.click("#room-load .offered button");
    assert.match(await page.textContent("#room-load .offered .fault"), /“much” is not a number/);
    await page.fill('[data-offered="load.torque_Nm"]', "30");
    await page.click("#room-load .offered button");
    await page.waitForFunction(() => /^torque_Nm = 30$/m.test(window.gearwright.text()));
    await finished(30);
    assert.equal(await page.locator("#room-load .offered").isVisible(), false);
    const [record] = native("load", await page.evaluate(() => window.gearwright.text())).load.torques;
    shows(await cell("max_pressure_MPa"), record.max_pressure_MPa);
  });

  it("any other error is shown only at its field, with the engine's message", async () => {
    const text = example("loaded_pair").replace("poisson_ratio = 0.3", "poisson_ratio = 0.495");
    await put(page, text, "load");
    await page.waitForSelector('#room-load [data-key="gear1.material.poisson_ratio"][aria-invalid=true]');
    const { message } = native("load", text).error;
    assert.equal(await page.textContent("#room-load .note .fault:not(:empty)"), message);
    assert.equal(await page.textContent("#room-load .view-sentence"), "There is no result. Correct the marked field.");
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

  it("a safety that is too low has the colour of the verdict, and a steel is chosen by name", async () => {
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

  it("a missing value is reported at its field with the engine's message", async () => {
    const text = example("rated_pair").replaceAll(/\[gear[12].material\]\nname = .*\n/g, "");
    await put(page, text, "rating");
    await page.waitForSelector("#room-rating [aria-invalid=true]");
    const { key, message } = native("rate", text).error;
    assert.ok((await page.getAttribute("#room-rating [aria-invalid=true]", "data-key")).startsWith(key));
    assert.equal(await page.textContent("#room-rating .note .fault:not(:empty)"), message);
    assert.equal(await page.textContent("#room-rating .view-sentence"), "There is no result. Correct the marked field.");
  });

  it("a spec without a load makes the tab offer one, whose initial values suffice for a rating", async () => {
    await put(page, example("helical_pair"), "rating");
    await page.waitForSelector("#room-rating .offered:not([hidden])");
    assert.equal(await page.locator('#room-rating [aria-invalid="true"]').count(), 0);
    assert.equal(await page.locator("#room-rating [role=alert]:not(:empty)").count(), 0);
    const offered = await page.locator("#room-rating .offer-row").count();
    assert.equal(offered, 5);
    await page.click("#room-rating .offered button");
    await page.waitForSelector("#room-rating [data-safety]");
    const text = await page.evaluate(() => window.gearwright.text());
    assert.match(text, /name = "16MnCr5"/);
    const { rating } = native("rate", text);
    assert.equal(await page.textContent('[data-safety="S_F.1"] .level'), rating.S_F[0].toFixed(3));
    assert.deepEqual(page.complaints, []);
  });
});
