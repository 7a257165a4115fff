// Modules that vite.config.ts makes.
declare module "gearwright:parts" {
  export function makeWorker(): Worker;
  export function loadScene(): Promise<typeof import("./solid/scene")>;
  export function wasmBytes(): Promise<ArrayBuffer>;
}
declare module "*.css?inline" {
  const text: string;
  export default text;
}
declare module "*/figure_script.js";
