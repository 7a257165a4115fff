// Defines two builds of the page: `vite build` makes static files for any host, and `vite build --mode
// single` makes one self-contained gearwright.html.

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { defineConfig, type Plugin } from "vite";

const here = import.meta.dirname;
const root = resolve(here, "../..");
/** The folder of the compiled engine: engine.js, gearwright.mjs, gearwright.wasm. */
const engine = resolve(process.env["GEARWRIGHT_ENGINE"] ?? resolve(root, "build/wasm/engine"));

/** Replaces import.meta.url in the module from emscripten. The module needs it only to find its file, and
 *  a worker in a single file does not have it. The page provides the bytes of the module instead. */
function engineModule(): Plugin {
  return {
    name: "gearwright-engine",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith("gearwright.mjs")) return null;
      return code
        .replaceAll("import.meta.url", "self.location.href")
        .replace(/require\(['"](fs|path)['"]\)/g, "null"); // removes the modules of node
    },
  };
}

/** Returns the file compressed by the program zstd. The zlib of node supports zstd only from version 22.15 on. */
const zstd = (file: string) => execFileSync("zstd", ["--ultra", "-22", "-qc", file], { maxBuffer: 1e8 });
/** Returns the text compressed by the program gzip, whose result is half a per cent smaller than that of node. */
const gzip = (text: string) => execFileSync("gzip", ["-9nc"], { input: text, maxBuffer: 1e8 });

/** Returns the bytes as text in base 85, which src/unpack.js reads. */
function base85(bytes: Buffer): string {
  let text = "";
  for (let i = 0; i < bytes.length; i += 4) {
    const part = bytes.subarray(i, i + 4);
    let group = Buffer.concat([part, Buffer.alloc(4 - part.length)]).readUInt32BE();
    let five = "";
    for (let j = 0; j < 5; ++j, group = Math.floor(group / 85)) {
      const digit = group % 85;
      five = String.fromCharCode(digit === 20 ? 126 : 40 + digit) + five;
    }
    text += five.slice(0, part.length + 1);
  }
  return text;
}

const kLicences =
  "<!-- Contains three.js, © 2010-2026 three.js authors, and fzstd, © 2020 Arjun Barrett, both under the MIT licence. -->";

/** Puts everything into one HTML file. The style is included as it is. The script and the engine are
 *  compressed and in base 85, and src/unpack.js unpacks them. Three quarters of the script are three.js,
 *  which most visits do not need. */
function single(): Plugin {
  return {
    name: "gearwright-single",
    enforce: "post",
    generateBundle(_, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("no index.html");
      let html = String(page.source).replace("<html", `${kLicences}\n<html`);
      const place = (id: string, bytes: Buffer) =>
        `<script id="${id}" type="text/plain">${base85(bytes)}</script>\n`;
      for (const [name, part] of Object.entries(bundle)) {
        if (part.type === "chunk" && part.isEntry) {
          const parts =
            place("page-script", gzip(part.code)) +
            place("engine-wasm", zstd(resolve(engine, "gearwright.wasm"))) +
            `<script type="module">${readFileSync(resolve(here, "src/unpack.js"))}</script>\n`;
          html = html.replace(/<script[^>]*src="[^"]*"[^>]*><\/script>/, "");
          html = html.replace("</body>", () => `${parts}</body>`);
        } else if (name.endsWith(".css") && part.type === "asset") {
          html = html.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${String(part.source)}</style>`);
        }
        if (name !== "index.html") delete bundle[name];
      }
      page.fileName = "gearwright.html";
      page.source = html;
    },
  };
}

export default defineConfig(({ mode }) => ({
  root: here,
  base: "./",
  resolve: {
    alias: {
      "gearwright-engine": engine,
      "gearwright:parts": resolve(here, mode === "single" ? "src/parts_single.ts" : "src/parts_static.ts"),
    },
  },
  plugins: [engineModule(), ...(mode === "single" ? [single()] : [])],
  // A page opened from disk cannot start a worker that is an ES module.
  worker: { format: mode === "single" ? "iife" : "es", plugins: () => [engineModule()] },
  server: { fs: { allow: [root, engine] } },
  build: {
    outDir: process.env["GEARWRIGHT_WEB_OUT"] ?? resolve(root, "build/web"),
    emptyOutDir: false,
    target: "es2022",
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
    ...(mode === "single" ? { rolldownOptions: { output: { codeSplitting: false } } } : {}),
  },
}));
