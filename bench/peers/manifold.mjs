// SPDX-License-Identifier: Apache-2.0
//
// The peer: Manifold (WebAssembly, one thread), from meshes in memory to a mesh in memory.
//
//   node manifold.mjs union|difference REPEATS FILE...
import fs from 'node:fs';
import { pathToFileURL } from 'node:url';

const { default: Module } = await import(pathToFileURL(process.cwd() + '/node_modules/manifold-3d/manifold.js'));
const wasm = await Module();
wasm.setup();

function readOff(path) {
  const lines = fs.readFileSync(path, 'utf8').split('\n');
  const [vertexCount, faceCount] = lines[1].split(' ').map(Number);
  const vertProperties = new Float32Array(3 * vertexCount);
  const triVerts = [];
  for (let v = 0; v < vertexCount; ++v) vertProperties.set(lines[2 + v].split(' ').map(Number), 3 * v);
  for (let f = 0; f < faceCount; ++f) {
    const corners = lines[2 + vertexCount + f].split(' ').slice(1).map(Number);
    for (let i = 2; i < corners.length; ++i) triVerts.push(corners[0], corners[i - 1], corners[i]);
  }
  return new wasm.Mesh({ numProp: 3, vertProperties, triVerts: Uint32Array.from(triVerts) });
}

const [operation, repeats, ...files] = process.argv.slice(2);
const meshes = files.map(readOff);
const seconds = [];
let volume = 0;
let triangles = 0;
for (let repeat = 0; repeat < Number(repeats); ++repeat) {
  const start = performance.now();
  const solids = meshes.map((mesh) => new wasm.Manifold(mesh));
  const result = operation === 'union' ? wasm.Manifold.union(solids) : wasm.Manifold.difference(solids);
  triangles = result.getMesh().triVerts.length / 3;
  seconds.push((performance.now() - start) / 1000);
  volume = result.volume();
  for (const solid of [...solids, result]) solid.delete();
}
seconds.sort((a, b) => a - b);
const peak_kb = Number(/VmHWM:\s*(\d+)/.exec(fs.readFileSync('/proc/self/status', 'utf8'))[1]);
console.log(JSON.stringify({ seconds: seconds[Math.floor(seconds.length / 2)], volume, triangles, peak_kb }));
