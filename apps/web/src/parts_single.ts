// The engine inside the single file, as gzip in base64 in an element of the page.
import EngineWorker from "./engine_worker.ts?worker&inline";
import * as scene from "./solid/scene";

export const loadScene = () => Promise.resolve(scene);
export const makeWorker = () => new EngineWorker();
let bytes: Promise<ArrayBuffer> | null = null;
export function wasmBytes(): Promise<ArrayBuffer> {
  bytes ??= unpack(document.getElementById("engine-wasm")!.textContent!);
  return bytes;
}
async function unpack(base64: string): Promise<ArrayBuffer> {
  const letters = atob(base64.trim());
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
