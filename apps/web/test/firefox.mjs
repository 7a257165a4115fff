// Controls an unmodified Firefox with WebDriver BiDi: one page, its scripts and its pictures. For
// Chromium, playwright-core does this. For Firefox, playwright-core needs commands that the
// released browser does not have.
//
// Requires the WebSocket of node: `node --experimental-websocket` before node 22.

import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const kFirefox = process.env.FIREFOX ?? "/usr/bin/firefox-esr";

/** Starts the browser. Resolves to the address on which the browser listens. */
function start() {
  const profile = mkdtempSync(join(tmpdir(), "gearwright_firefox_"));
  const process = spawn(kFirefox, ["--headless", "--no-remote", "--remote-debugging-port=0", "--profile", profile]);
  return new Promise((ready, fail) => {
    let said = "";
    process.stderr.on("data", (bytes) => {
      said += bytes;
      const found = /WebDriver BiDi listening on (ws:\/\/\S+)/.exec(said);
      if (found) ready({ process, address: found[1] });
    });
    process.on("error", fail);
    process.on("exit", () => fail(new Error(`Firefox has exited: ${said.slice(-500)}`)));
  });
}

/** Opens a browser with one page of this size. */
export async function launchFirefox(width = 1280, height = 800) {
  const { process, address } = await start();
  const socket = new WebSocket(address + "/session");
  await new Promise((open, fail) => {
    socket.onopen = open;
    socket.onerror = () => fail(new Error(`no answer at ${address}`));
  });
  const waiting = new Map();
  const complaints = [];
  let next = 1;
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data);
    if (message.method === "log.entryAdded" && message.params.level === "error") complaints.push(message.params.text);
    const one = waiting.get(message.id);
    if (!one) return;
    waiting.delete(message.id);
    if (message.type === "error") one.fail(new Error(`${message.error}: ${message.message}`));
    else one.done(message.result);
  };
  const ask = (method, params = {}) =>
    new Promise((done, fail) => {
      waiting.set(next, { done, fail });
      socket.send(JSON.stringify({ id: next++, method, params }));
    });
  await ask("session.new", { capabilities: {} });
  const { context } = await ask("browsingContext.create", { type: "tab" });
  await ask("session.subscribe", { events: ["log.entryAdded"] });
  await ask("browsingContext.setViewport", { context, viewport: { width, height } });

  const page = {
    complaints,
    open: (url) => ask("browsingContext.navigate", { context, url, wait: "complete" }),
    /** Evaluates a function in the page and returns its result, transferred as JSON. */
    async evaluate(f, ...args) {
      const expression = `Promise.resolve((${f})(...${JSON.stringify(args)})).then((x) => JSON.stringify(x ?? null))`;
      const { result, exceptionDetails } = await ask("script.evaluate", {
        expression,
        target: { context },
        awaitPromise: true,
      });
      if (exceptionDetails) throw new Error(exceptionDetails.text);
      return JSON.parse(result.value);
    },
    async until(f, patience, ...args) {
      for (const end = Date.now() + patience; !(await page.evaluate(f, ...args)); ) {
        if (Date.now() > end) throw new Error(`the condition never became true: ${f}`);
        await new Promise((go) => setTimeout(go, 50));
      }
    },
    async screenshot() {
      return Buffer.from((await ask("browsingContext.captureScreenshot", { context })).data, "base64");
    },
    async close() {
      await ask("browser.close").catch(() => undefined);
      process.kill();
    },
  };
  return page;
}
