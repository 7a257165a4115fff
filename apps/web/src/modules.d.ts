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
declare module "*/turn_script.js";
declare module "*/zoom_script.js";
/** Defined by unpack.js in the self-contained file. It returns the compressed bytes of a part. */
declare function packedPart(id: string): Uint8Array;
/** Defined by zoom_script.js. */
declare function figureZoom(
  holder: Element,
  on: { always?: boolean; touch?: boolean; home?: () => void; moved?: () => void; settled?: () => void },
): void;
/** Defined by turn_script.js. */
declare function figureTurn(scope: Element): (t: number, moved: boolean) => void;
declare function figureDrive(
  button: HTMLButtonElement,
  slider: HTMLInputElement,
  seconds: number,
  changed: (t: number, whole: number) => void,
): { stop: () => void };
