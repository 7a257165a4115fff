// The parts of the self-contained page, which is one file. unpack.js unpacks the engine from this file.
import EngineWorker from "./engine_worker.ts?worker&inline";
import * as scene from "./solid/scene";

export const loadScene = () => Promise.resolve(scene);
export const makeWorker = () => new EngineWorker();
let bytes: Promise<ArrayBuffer> | null = null;
export function wasmBytes(): Promise<ArrayBuffer> {
  bytes ??= unpacked("engine-wasm").arrayBuffer();
  return bytes;
}
