// SPDX-License-Identifier: Apache-2.0
import type { Part, Vec3 } from "./scene_data";

export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Scaled by its largest component first, so that nothing overflows; zero stays zero. */
export function unit(v: Vec3): Vec3 {
  const largest = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  if (!(largest > 0)) return [0, 0, 0];
  const w: Vec3 = [v[0] / largest, v[1] / largest, v[2] / largest];
  const length = Math.hypot(...w);
  return [w[0] / length, w[1] / length, w[2] / length];
}

export function triangleCorners(part: Part, triangle: number): [Vec3, Vec3, Vec3] {
  const at = 3 * triangle;
  return [part.vertex(part.triangles[at]), part.vertex(part.triangles[at + 1]), part.vertex(part.triangles[at + 2])];
}

/** (a, b, c, d) of a x + b y + c z = d as it was given, or nothing. */
export function givenPlane(part: Part, face: number): [number, number, number, number] | undefined {
  if (part.planes.length === 0) return undefined;
  const p = part.planes.subarray(4 * face, 4 * face + 4);
  return p[0] === 0 && p[1] === 0 && p[2] === 0 ? undefined : [p[0], p[1], p[2], p[3]];
}

/** Unit outward normal, of the given plane, of the points that span it, or else of the triangle. */
export function faceNormal(part: Part, face: number, triangle: number): Vec3 {
  const plane = givenPlane(part, face);
  if (plane) return unit([plane[0], plane[1], plane[2]]);
  const [a, b, c] = part.span(face) ?? triangleCorners(part, triangle);
  return unit(cross(unit(sub(b, a)), unit(sub(c, a))));
}
