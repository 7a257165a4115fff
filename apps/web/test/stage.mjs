// The environment that the tests share: a server of static files, a browser without a screen, and the native
// program.

import { execFileSync } from "node:child_process";
import { createReadStream, existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { basename, extname, join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";

export const root = resolve(import.meta.dirname, "../../..");
export const web = resolve(process.env.GEARWRIGHT_WEB_OUT ?? join(root, "build/web"));
export const program = resolve(process.env.GEARWRIGHT ?? join(root, "build/release/gearwright"));
/** A generous time limit, for two loaded cores and a browser without a graphics card. These tests do not
 *  measure time. */
export const kPatience = 120_000;
export const kTabs = ["mesh", "solid", "contact", "load", "rating", "scatter", "shifts", "search", "sheet"];

const kTypes = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

/** Serves build/web on a port of this machine. */
export function serve() {
  const server = createServer((request, response) => {
    const name = basename(new URL(request.url, "http://x").pathname) || "index.html";
    const path = [join(web, name), join(web, "assets", name)].find(
      (one) => existsSync(one) && statSync(one).isFile(),
    );
    if (!path) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": kTypes[extname(path)] ?? "application/octet-stream" });
    createReadStream(path).pipe(response);
  });
  return new Promise((ready) => server.listen(0, "127.0.0.1", () => ready(server)));
}

export function launch() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    // Without a graphics card, pages are painted 25 times faster if the GPU compositor is disabled. WebGL
    // still works.
    args: [
      "--disable-gpu",
      "--no-sandbox",
      "--disable-background-networking",
      "--no-first-run",
      "--enable-unsafe-swiftshader",
    ],
  });
}

/** Opens one page that all tests of a file share. `take` receives it before the first test. */
export function withPage(take) {
  let server, browser;
  before(
    async () => {
      server = await serve();
      const address = `http://127.0.0.1:${server.address().port}/`;
      browser = await launch();
      take({ browser, address, page: await open(browser, address) });
    },
    { timeout: kPatience },
  );
  after(async () => {
    await browser?.close();
    server?.close();
  });
}
export const it = (name, body) => test(name, { timeout: 4 * kPatience }, body);

/** Opens an address and waits for the engine. Errors that the page reports are collected in `page.complaints`. */
export async function open(browser, address, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    ...options,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on(
    "console",
    (message) =>
      message.type() === "error" &&
      !/favicon/.test(message.text() + message.location().url) &&
      page.complaints.push(message.text()),
  );
  await page.goto(address);
  await page.waitForSelector("html[data-ready]", { timeout: kPatience });
  return page;
}

/** Opens a text on the page and waits for its result. */
export async function put(page, text, tab = "mesh") {
  await page.evaluate(([text, tab]) => window.gearwright.open(text, tab), [text, tab]);
  await settled(page);
}
/** Waits until the result on screen belongs to the text on screen. */
export async function settled(page) {
  await page.waitForFunction(() => window.gearwright.settled(), undefined, { timeout: kPatience });
}
export async function openTab(page, id) {
  await page.click(`#tab-${id}`);
  await page.waitForSelector(`#room-${id}:not([hidden])`);
}

export const examples = readdirSync(join(root, "examples"))
  .filter((name) => name.endsWith(".toml"))
  .map((name) => ({
    name: name.replace(".toml", ""),
    path: join(root, "examples", name),
    text: readFileSync(join(root, "examples", name), "utf8"),
  }));
export function example(name) {
  return examples.find((one) => one.name === name).text;
}

/** Returns the output of the native program with --json, which may be an error. */
export function native(verb, text) {
  try {
    return JSON.parse(
      execFileSync(program, [verb, "-", "--json"], {
        input: text,
        encoding: "utf8",
        stdio: ["pipe", "pipe", "ignore"],
        maxBuffer: 1 << 28,
      }),
    );
  } catch (failure) {
    if (failure.stdout) return JSON.parse(failure.stdout);
    throw failure;
  }
}

/** Waits until no part of the verdict on screen is pending. */
export async function judged(page) {
  await page.waitForFunction(() => window.gearwright.judged(), undefined, { timeout: kPatience });
}
/** Waits until the engine has no pending work. */
export async function idle(page) {
  await page.waitForFunction(() => window.gearwright.idle(), undefined, { timeout: kPatience });
}
/** True if the boxes of two elements, given by selectors, overlap. */
export const touching = (page, first, second) =>
  page.evaluate(
    ([first, second]) => {
      const boxes = (selector) => [...document.querySelectorAll(selector)].map((one) => one.getBoundingClientRect());
      return boxes(first).some((a) =>
        boxes(second).some((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom),
      );
    },
    [first, second],
  );
