// Parts of a hosted page. The engine is in separate files next to the page.
import address from "gearwright-engine/gearwright.wasm?url";

/** Loads the code of the scene, which is needed when the user first opens the tab "solid". */
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
