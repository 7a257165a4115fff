// Checks mesh files with independent software and prints the errors that it finds.
//
//   node check_meshes.mjs FILE.glb FILE.stl FILE.3mf …     [--modules FOLDER]
//
// .glb        The Khronos validator reports no error and no warning.
// .stl, .3mf  For manifold-3d, every body (3MF object, STL part) is an oriented manifold of positive volume.
//
// Exit status 0: no errors; 1: errors; 77: the npm packages are not installed (npm ci here).
import {existsSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {inflateRawSync} from 'node:zlib';

import {readStl} from './read_stl.mjs';

const args = process.argv.slice(2);
const at = args.indexOf('--modules');
const folder = at >= 0 ? resolve(args.splice(at, 2)[1]) : dirname(fileURLToPath(import.meta.url));
const require = createRequire(join(folder, 'package.json'));
const manifoldFile = join(folder, 'node_modules', 'manifold-3d', 'manifold.js');
const validatorFolder = join(folder, 'node_modules', 'gltf-validator');
for (const path of [manifoldFile, validatorFolder]) {
  if (existsSync(path)) continue;
  console.error(`not installed: ${path}`);
  process.exit(77);
}
const validator = require(validatorFolder);
const manifold = await (await import(pathToFileURL(manifoldFile).href)).default();
manifold.setup();

let failed = 0;
function expect(condition, file, message) {
  if (condition) return;
  console.error(`${file}: ${message}`);
  failed = 1;
}

async function checkGlb(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  const {numErrors, numWarnings, messages} = report.issues;
  expect(numErrors === 0 && numWarnings === 0, file, JSON.stringify(messages, null, 1));
  const {drawCallCount, totalTriangleCount} = report.info ?? {};
  expect(drawCallCount > 0 && totalTriangleCount > 0, file, 'draws nothing');
  console.log(`${basename(file)}: ${numErrors} errors, ${numWarnings} warnings, ` +
              `${drawCallCount} parts, ${totalTriangleCount} triangles`);
}

function checkBody(file, name, vertices, triangles) {
  let body;
  try {
    body = new manifold.Manifold(new manifold.Mesh({
      numProp: 3, vertProperties: Float32Array.from(vertices), triVerts: Uint32Array.from(triangles)}));
  } catch (error) {
    expect(false, file, `${name}: ${error.message ?? error}`);
    return;
  }
  const status = body.status();
  const volume = body.volume();
  expect(status === 'NoError', file, `${name}: ${status}`);
  expect(volume > 0, file, `${name}: volume ${volume}`);
  console.log(`${basename(file)}: ${name} ${status}, genus ${body.genus()}, ` +
              `${body.decompose().length} parts, ${volume.toFixed(3)} mm3`);
}

function checkStl(file) {
  try {
    const {vertices, triangles} = readStl(file);
    checkBody(file, 'all', vertices, triangles);
  } catch (error) {
    expect(false, file, error.message);
  }
}

function unzip(file) {
  const bytes = readFileSync(file);
  const end = bytes.length - 22;
  const files = {};
  for (let i = 0, p = bytes.readUInt32LE(end + 16); i < bytes.readUInt16LE(end + 10); ++i) {
    const packed = bytes.readUInt32LE(p + 20), nameSize = bytes.readUInt16LE(p + 28);
    const local = bytes.readUInt32LE(p + 42);
    const name = bytes.toString('utf8', p + 46, p + 46 + nameSize);
    const start = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    files[name] = inflateRawSync(bytes.subarray(start, start + packed)).toString('utf8');
    p += 46 + nameSize;
  }
  return files;
}

function check3mf(file) {
  const model = unzip(file)['3D/3dmodel.model'] ?? '';
  const objects = [...model.matchAll(/<object [^>]*name="([^"]*)"[^>]*>(.*?)<\/object>/gs)];
  expect(objects.length > 0, file, 'no object');
  const items = [...model.matchAll(/<item /g)].length;
  expect(items === objects.length, file, `${items} items for ${objects.length} objects`);
  for (const [, name, mesh] of objects) {
    const vertices = [], triangles = [];
    for (const [, x, y, z] of mesh.matchAll(/<vertex x="([^"]+)" y="([^"]+)" z="([^"]+)"\/>/g)) {
      vertices.push(Number(x), Number(y), Number(z));
    }
    for (const [, a, b, c] of mesh.matchAll(/<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"\/>/g)) {
      triangles.push(Number(a), Number(b), Number(c));
    }
    checkBody(file, name, vertices, triangles);
  }
}

expect(args.length > 0, 'check_meshes.mjs', 'no file given');
for (const file of args) {
  if (file.endsWith('.glb')) await checkGlb(file);
  else if (file.endsWith('.stl')) checkStl(file);
  else if (file.endsWith('.3mf')) check3mf(file);
  else expect(false, file, 'not a .glb, .stl or .3mf file');
}
process.exit(failed);
