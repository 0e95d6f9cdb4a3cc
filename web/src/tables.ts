// SPDX-License-Identifier: Apache-2.0
// Textures that hold one entry per triangle, face or piece, in rows of `tableWidth`.
import * as THREE from "three";
import type { Part } from "./scene_data";
import { tableWidth } from "./shaders";

function table(
  data: Uint32Array | Float32Array,
  count: number,
  format: THREE.PixelFormat,
  type: THREE.TextureDataType,
  internalFormat: THREE.PixelFormatGPU,
): THREE.DataTexture {
  const texture = new THREE.DataTexture(data as THREE.TypedArray, tableWidth, rows(count), format, type);
  texture.internalFormat = internalFormat;
  texture.needsUpdate = true;
  return texture;
}

function rows(count: number): number {
  return Math.max(1, Math.ceil(count / tableWidth));
}

export function unsignedTable(values: ArrayLike<number>, count: number): THREE.DataTexture {
  const data = new Uint32Array(rows(count) * tableWidth);
  data.set(values);
  return table(data, count, THREE.RedIntegerFormat, THREE.UnsignedIntType, "R32UI");
}

/** Per face: packed colour, origin, piece. */
export function faceTable(part: Part, colors: Uint32Array): THREE.DataTexture {
  const data = new Uint32Array(4 * rows(part.faceCount) * tableWidth);
  for (let face = 0; face < part.faceCount; ++face) {
    data[4 * face] = colors[face];
    data[4 * face + 1] = part.origin(face);
    data[4 * face + 2] = part.piece(face);
  }
  return table(data, part.faceCount, THREE.RGBAIntegerFormat, THREE.UnsignedIntType, "RGBA32UI");
}

/** Four numbers per entry, zero. */
export function floatTable(count: number): THREE.DataTexture {
  const data = new Float32Array(4 * rows(count) * tableWidth);
  return table(data, count, THREE.RGBAFormat, THREE.FloatType, "RGBA32F");
}
