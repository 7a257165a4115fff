// Reads a binary STL file as vertices and triangles. Corners with the same twelve bytes are one vertex.
import {readFileSync} from 'node:fs';

export function readStl(file) {
  const bytes = readFileSync(file);
  const count = bytes.readUInt32LE(80);
  if (bytes.length !== 84 + 50 * count) throw new Error(`${file}: ${bytes.length} bytes for ${count} triangles`);
  const index = new Map(), vertices = [], triangles = [];
  for (let t = 0; t < count; ++t) {
    for (let c = 0; c < 3; ++c) {
      const start = 84 + 50 * t + 12 + 12 * c;
      const key = bytes.toString('latin1', start, start + 12);
      if (!index.has(key)) {
        index.set(key, vertices.length / 3);
        for (let i = 0; i < 3; ++i) vertices.push(bytes.readFloatLE(start + 4 * i));
      }
      triangles.push(index.get(key));
    }
  }
  return {vertices, triangles};
}
