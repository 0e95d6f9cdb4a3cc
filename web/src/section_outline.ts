// SPDX-License-Identifier: Apache-2.0
import { emptySegments, type Segments } from "./lines";
import type { Part, Vec3 } from "./scene_data";

/** Where the triangles of a part, moved by the explosion, meet the plane normal . p = distance. O(triangles). */
export function sectionOutline(
  part: Part,
  relative: Float32Array,
  offset: (piece: number) => Vec3,
  normal: Vec3,
  distance: number,
): Segments {
  const heights = new Float32Array(part.vertexCount);
  for (let v = 0; v < heights.length; ++v) {
    heights[v] = normal[0] * relative[3 * v] + normal[1] * relative[3 * v + 1] + normal[2] * relative[3 * v + 2];
  }
  const levels = Array.from({ length: part.pieceCount }, (_, piece) => {
    const o = offset(piece);
    return distance - (normal[0] * o[0] + normal[1] * o[1] + normal[2] * o[2]);
  });
  const ends: number[] = [];
  const pieces: number[] = [];
  const cross = (a: number, b: number, level: number) => {
    const t = (level - heights[a]) / (heights[b] - heights[a]);
    for (let k = 0; k < 3; ++k) ends.push(relative[3 * a + k] + t * (relative[3 * b + k] - relative[3 * a + k]));
  };
  for (let t = 0, at = 0; t < part.triangleCount; ++t, at += 3) {
    const piece = part.piece(part.triangleFaces[t]);
    const level = levels[piece];
    const [a, b, c] = [part.triangles[at], part.triangles[at + 1], part.triangles[at + 2]];
    const isHigh = [heights[a] > level, heights[b] > level, heights[c] > level];
    if (isHigh[0] === isHigh[1] && isHigh[1] === isHigh[2]) continue;
    if (isHigh[0] !== isHigh[1]) cross(a, b, level);
    if (isHigh[1] !== isHigh[2]) cross(b, c, level);
    if (isHigh[2] !== isHigh[0]) cross(c, a, level);
    pieces.push(piece);
  }
  const result = emptySegments(pieces.length);
  for (let i = 0; i < pieces.length; ++i) {
    result.starts.set(ends.slice(6 * i, 6 * i + 3), 3 * i);
    result.ends.set(ends.slice(6 * i + 3, 6 * i + 6), 3 * i);
    result.pieces[i] = pieces[i];
    result.opacities[i] = 1;
  }
  return result;
}
