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
declare module "*/zoom_script.js";
/** Of unpack.js, in the one file: a part of it. */
declare function unpacked(id: string): Response;
/** Of zoom_script.js. */
declare function figureZoom(
  holder: Element,
  on: { always?: boolean; touch?: boolean; home?: () => void; settled?: () => void },
): void;
