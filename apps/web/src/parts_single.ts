// Parts of the self-contained page, which is a single file. It contains the engine compressed by zstd, which
// saves 0.8 MB compared with gzip.
import { decompress } from "fzstd";
import EngineWorker from "./engine_worker.ts?worker&inline";
import * as scene from "./solid/scene";

export const loadScene = () => Promise.resolve(scene);
export const makeWorker = () => new EngineWorker();
let bytes: Promise<ArrayBuffer> | null = null;
export function wasmBytes(): Promise<ArrayBuffer> {
  bytes ??= Promise.resolve(decompress(packedPart("engine-wasm")).slice().buffer as ArrayBuffer);
  return bytes;
}
