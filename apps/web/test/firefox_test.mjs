// Tests the page in Firefox. Every example works in every tab without errors. The engine returns the same
// bytes as in Chromium, which page_test.mjs compares with the program.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { kFirefox, launchFirefox } from "./firefox.mjs";
import { example, examples, kPatience, kTabs, launch, open, serve, web } from "./stage.mjs";

const skip = existsSync(kFirefox) ? false : `${kFirefox} is not installed (Debian: firefox-esr)`;

describe("in Firefox", { skip }, () => {
  let server, page, address;
  before(async () => {
    server = await serve();
    address = `http://127.0.0.1:${server.address().port}/`;
    page = await launchFirefox();
    await page.open(address);
    await page.until(() => document.documentElement.dataset.ready === "true", kPatience);
  });
  after(async () => {
    await page?.close();
    server?.close();
  });
  const it = (name, body) => test(name, { timeout: 8 * kPatience }, body);
  const put = async (text, tab) => {
    await page.evaluate((text, tab) => window.gearwright.open(text, tab), text, tab);
    await page.until(() => window.gearwright.idle(), kPatience);
  };

  it("every example has a picture or a result in every tab", async () => {
    // Without a screen, Firefox of Debian has no WebGL. Solids are therefore tested only in Chromium.
    const solids = await page.evaluate(() => document.createElement("canvas").getContext("webgl2") !== null);
    const tabs = kTabs.filter((tab) => solids || tab !== "solid");
    for (const one of examples) for (const tab of tabs) await put(one.text, tab);
    assert.deepEqual(page.complaints, []);
  });

  it("quick changes of tab and design cause no errors", async () => {
    for (let i = 0; i < 40; ++i) {
      const [text, tab] = [examples[(7 * i) % examples.length].text, kTabs[(3 * i) % kTabs.length]];
      if (tab !== "solid") await page.evaluate((text, tab) => window.gearwright.open(text, tab), text, tab);
    }
    await page.until(() => window.gearwright.idle(), kPatience);
    assert.deepEqual(page.complaints, []);
  });

  it("a damaged link causes a message of the page", async () => {
    for (const hash of ["#1.not-a-design", "#1.q1ZK!LS7", "#1.A"]) {
      await page.open(`${address}?${hash.length}${hash}`);
      await page.until(() => document.documentElement.dataset.ready === "true", kPatience);
      const said = await page.evaluate(() => document.querySelector(".said").textContent);
      assert.match(said, /^This link is damaged, .*Copy it again, from its first to its last character\.$/, hash);
    }
    assert.deepEqual(page.complaints, []);
    await page.open(address);
    await page.until(() => document.documentElement.dataset.ready === "true", kPatience);
  });

  it("the engine returns the same bytes as in Chromium", async () => {
    const browser = await launch();
    const other = await open(browser, address);
    for (const [verb, name] of [
      ["pair", "helical_pair"],
      ["contact", "misaligned_pair"],
      ["rate", "rated_pair"],
      ["load", "loaded_pair"],
    ]) {
      const text = example(name);
      const theirs = await other.evaluate(([verb, text]) => window.gearwright.run(verb, text), [verb, text]);
      assert.equal(await page.evaluate((verb, text) => window.gearwright.run(verb, text), verb, text), theirs);
    }
    await browser.close();
  });

  it("the self-contained file opens from disk", async () => {
    await page.open(pathToFileURL(join(web, "gearwright.html")).href);
    await page.until(() => document.documentElement.dataset.ready === "true", kPatience);
    await put(example("helical_pair"), "mesh");
    assert.match(await page.evaluate(() => document.querySelector(".headline").textContent), /The pair runs/);
    assert.deepEqual(page.complaints, []);
  });
});
