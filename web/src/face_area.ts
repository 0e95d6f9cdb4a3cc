// SPDX-License-Identifier: Apache-2.0
import { cross, sub, triangleCorners } from "./part_geometry";
import type { Part } from "./scene_data";

/** Sum over the face's triangles, rounded. */
export function faceArea(part: Part, face: number): number {
  let area = 0;
  for (let t = 0; t < part.triangleCount; ++t) {
    if (part.triangleFaces[t] !== face) continue;
    const [a, b, c] = triangleCorners(part, t);
    area += Math.hypot(...cross(sub(b, a), sub(c, a))) / 2;
  }
  return area;
}
