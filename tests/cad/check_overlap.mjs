// Computes the volume in which two mounted gears overlap, with manifold-3d.
//
//   node check_overlap.mjs GEAR1.stl GEAR2.stl Z1 Z2 PHASES A [A …]     [--shaft DEG] [--enough MM3]
//                                                                       [--modules FOLDER]
//
// Each file contains a gear in its own frame. Gear 2 is placed at the centre distance A, with its space 0 at
// the mesh and its axis along (0, sin Σ, cos Σ). Both gears are turned through one pitch in PHASES steps. An
// internal gear (Z2 < 0) turns in the same direction as its pinion. Its mesh is at −x, so tooth 0 of the
// pinion points to −x.
//
// The script prints a JSON list with {"overlap_mm3": greatest volume} for every A. As soon as a volume
// exceeds MM3, the computation for this A ends. For external gears, only the teeth near the mesh are
// intersected. Exit status 77: manifold-3d is not installed.
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
const enough = Number(option('--enough', 'Infinity'));
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
  let radius = 0;
  for (let i = 0; i < vertices.length; i += 3) radius = Math.max(radius, Math.hypot(vertices[i], vertices[i + 1]));
  return {radius, solid: new manifold.Manifold(new manifold.Mesh({
    numProp: 3, vertProperties: Float32Array.from(vertices), triVerts: Uint32Array.from(triangles)}))};
}

const one = body(args[0]), two = body(args[1]);
const [z1, z2, phases] = args.slice(2, 5).map(Number);
const distances = args.slice(5).map(Number);
const turned1 = (turn) => (z2 < 0 ? 180 : 0) - turn;
const turned2 = (turn) => 180 - 180 / Math.abs(z2) + turn * z1 / z2;

// Returns the part of a gear that reaches x > least in the housing frame at some phase. `turned` gives the
// rotation of the gear at a phase, and `sense` is −1 for gear 2, which faces the other way.
function near({solid, radius}, least, teeth, turned, sense) {
  if (z2 < 0) return solid;
  const half = Math.PI / teeth, middle = turned(180 / z1);
  const height = Math.sqrt(Math.max(0, radius ** 2 - least ** 2));
  const plane = least * Math.cos(half) - height * Math.sin(half);
  return solid.rotate([0, 0, middle]).trimByPlane([sense, 0, 0], plane).rotate([0, 0, -middle]);
}

const closest = Math.min(...distances);
const gear1 = near(one, closest - two.radius, z1, turned1, 1);
const gear2 = near(two, closest - one.radius, z2, turned2, -1);
const results = distances.map((distance) => {
  let greatest = 0;
  for (let i = 0; i < phases && greatest <= enough; ++i) {
    const turn = 360 / z1 * i / phases;
    const mounted1 = gear1.rotate([0, 0, turned1(turn)]);
    const mounted2 = gear2.rotate([0, 0, turned2(turn)]).rotate([-shaft, 0, 0]).translate([distance, 0, 0]);
    greatest = Math.max(greatest, mounted1.intersect(mounted2).volume());
  }
  return {overlap_mm3: greatest};
});
console.log(JSON.stringify(results));
