// SPDX-License-Identifier: Apache-2.0
import { exactPlane, exactPlaneText, type ExactPlane } from "./exact_plane";
import { givenPlane, faceNormal } from "./part_geometry";
import type { Part, Vec3 } from "./scene_data";

const minus = (text: string) => text.replace("-", "−");

/** The double itself: the shortest digits that read back as it. */
export function exactNumber(x: number): string {
  return minus(String(x === 0 ? 0 : x)).replace("e−", "e-").replace("e-", "e−");
}

/** Rounded for reading. */
export function number(x: number, digits = 10): string {
  return exactNumber(Number(x.toPrecision(digits)));
}

export function count(n: number, one: string, many = `${one}s`): string {
  return `${n.toLocaleString("en").replaceAll(",", " ")} ${n === 1 ? one : many}`;
}

export function point(p: Vec3, isExact: boolean): string {
  return `${isExact ? "" : "≈ "}(${p.map((x) => (isExact ? exactNumber(x) : number(x, 7))).join(", ")})`;
}

/** a x + b y + c z = d, without terms that are zero and factors that are one. */
export function planeEquation(plane: [number, number, number, number]): string {
  let text = "";
  ["x", "y", "z"].forEach((name, axis) => {
    const factor = plane[axis];
    if (factor === 0) return;
    const size = Math.abs(factor) === 1 ? name : `${exactNumber(Math.abs(factor))} ${name}`;
    if (text === "") text = factor < 0 ? `−${size}` : size;
    else text += `${factor < 0 ? " − " : " + "}${size}`;
  });
  return `${text} = ${exactNumber(plane[3])}`;
}

/** The plane of a face: `text` is exact unless it begins with ≈, and then `exact` has the equation in full, if known. */
export interface FacePlane {
  text: string;
  exact?: ExactPlane;
}

const longEquation = 60;
const longNumber = 14;

/** As it was given, else from the points that span it, else that of the triangle. One across an axis is read off a corner. */
export function facePlane(part: Part, face: number, triangle: number): FacePlane {
  const text = part.planeText(face);
  if (text) return { text };
  const given = givenPlane(part, face);
  const span = part.span(face);
  const exact = !given && span ? exactPlane(...span) : undefined;
  const normal = given ?? exact?.normal;
  const axes = [0, 1, 2].filter((axis) => normal && Number(normal[axis]) !== 0);
  const corner = exact && span ? span[0] : part.vertex(part.triangles[3 * triangle]);
  if (normal && axes.length === 1) return { text: `${"xyz"[axes[0]]} = ${exactNumber(corner[axes[0]])}` };
  if (given) return { text: planeEquation(given) };
  const whole = exact && exactPlaneText(exact);
  if (whole && whole.length <= longEquation) return { text: whole };
  const n = faceNormal(part, face, triangle);
  const offset = n[0] * corner[0] + n[1] * corner[1] + n[2] * corner[2];
  const rounded = [...n, offset].map((x) => Number(x.toPrecision(7)));
  return { text: `≈ ${planeEquation(rounded as [number, number, number, number])}`, exact };
}

/** An exact equation in a line or two: of long numbers the first and the last digits, and how many there are. */
export function shortened(plane: ExactPlane): string {
  return exactPlaneText(plane, (digits) => {
    if (digits.length <= longNumber) return digits;
    return `${digits.slice(0, 5)}…${digits.slice(-4)}`;
  });
}
