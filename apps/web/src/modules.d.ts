// Modules that vite.config.ts makes.
declare module "gearwright:parts" {
  export function makeWorker(): Worker;
  export function loadScene(): Promise<typeof import("./solid/scene")>;
  export function wasmBytes(): Promise<ArrayBuffer>;
}
declare module "gearwright:palette.css";
