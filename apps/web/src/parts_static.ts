// The engine of a hosted page, as files next to it.
import address from "gearwright-engine/gearwright.wasm?url";

/** Loaded when the user first opens a solid. */
export const loadScene = () => import("./solid/scene");
export const makeWorker = () =>
  new Worker(new URL("./engine_worker.ts", import.meta.url), { type: "module" });
let bytes: Promise<ArrayBuffer> | null = null;
export function wasmBytes(): Promise<ArrayBuffer> {
  bytes ??= fetch(address).then((answer) => {
    if (!answer.ok) throw new Error(`gearwright.wasm: ${answer.status} ${answer.statusText}`);
    return answer.arrayBuffer();
  });
  return bytes;
}
