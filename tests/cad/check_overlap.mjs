// How much of two mounted gears is in the same place, by manifold-3d.
//
//   node check_overlap.mjs GEAR1.stl GEAR2.stl Z1 Z2 PHASES A [A …]     [--shaft DEG] [--modules FOLDER]
//
// Each gear in its own frame; gear 2 is put at the distance A with space 0 to the mesh, its axis along
// (0, sin Σ, cos Σ), and both are turned through one pitch in PHASES steps. A ring (Z2 < 0) turns as its
// pinion does, and its mesh lies at −x, to where tooth 0 of the pinion is turned. Prints {"overlap_mm3": greatest volume} for every A, as one JSON list.
// Exit status 77: manifold-3d is not installed.
import {existsSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

import {readStl} from './read_stl.mjs';

const args = process.argv.slice(2);
const option = (name, absent) => {
  const at = args.indexOf(name);
  return at >= 0 ? args.splice(at, 2)[1] : absent;
};
const shaft = Number(option('--shaft', '0'));
const modules = option('--modules', '');
const folder = modules ? resolve(modules) : dirname(fileURLToPath(import.meta.url));
const file = join(folder, 'node_modules', 'manifold-3d', 'manifold.js');
if (!existsSync(file)) {
  console.error(`not installed: ${file}`);
  process.exit(77);
}
const manifold = await (await import(pathToFileURL(file).href)).default();
manifold.setup();

function body(path) {
  const {vertices, triangles} = readStl(path);
  return new manifold.Manifold(new manifold.Mesh({
    numProp: 3, vertProperties: Float32Array.from(vertices), triVerts: Uint32Array.from(triangles)}));
}

const gear1 = body(args[0]), gear2 = body(args[1]);
const [z1, z2, phases] = args.slice(2, 5).map(Number);
const results = args.slice(5).map((text) => {
  let greatest = 0;
  for (let i = 0; i < phases; ++i) {
    const turn = 360 / z1 * i / phases;
    const mounted1 = gear1.rotate([0, 0, (z2 < 0 ? 180 : 0) - turn]);
    const mounted2 = gear2.rotate([0, 0, 180 - 180 / Math.abs(z2) + turn * z1 / z2])
                         .rotate([-shaft, 0, 0]).translate([Number(text), 0, 0]);
    greatest = Math.max(greatest, mounted1.intersect(mounted2).volume());
  }
  return {overlap_mm3: greatest};
});
console.log(JSON.stringify(results));
