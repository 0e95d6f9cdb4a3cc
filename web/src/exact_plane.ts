// SPDX-License-Identifier: Apache-2.0
// Exact equations of planes through three points of doubles, in whole numbers of any length.
import type { Vec3 } from "./scene_data";

/** a x + b y + c z = numerator / denominator: a, b, c without common divisor, the denominator positive, both reduced. */
export interface ExactPlane {
  normal: [bigint, bigint, bigint];
  numerator: bigint;
  denominator: bigint;
}

/** Of the plane that has a, b, c counterclockwise on its positive side; undefined where they lie on a line. */
export function exactPlane(a: Vec3, b: Vec3, c: Vec3): ExactPlane | undefined {
  const parts = [...a, ...b, ...c].map(splitDouble);
  const least = Math.min(...parts.map((part) => (part.digits === 0n ? Infinity : part.exponent)));
  const shift = Number.isFinite(least) ? least : 0;
  const whole = parts.map(({ digits, exponent }) => (digits === 0n ? 0n : digits << BigInt(exponent - shift)));
  const along = (from: number) => [0, 1, 2].map((k) => whole[from + k] - whole[k]);
  const [u, v] = [along(3), along(6)];
  let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const common = gcd(gcd(n[0], n[1]), n[2]);
  if (common === 0n) return undefined;
  n = n.map((x) => x / common);
  let numerator = n[0] * whole[0] + n[1] * whole[1] + n[2] * whole[2];
  let denominator = 1n;
  if (shift >= 0) numerator <<= BigInt(shift);
  else denominator <<= BigInt(-shift);
  const divisor = gcd(numerator, denominator);
  return { normal: n as ExactPlane["normal"], numerator: numerator / divisor, denominator: denominator / divisor };
}

/** As text; `show` writes each positive whole number. */
export function exactPlaneText(plane: ExactPlane, show: (digits: string) => string = (digits) => digits): string {
  const size = (x: bigint) => show((x < 0n ? -x : x).toString());
  let text = "";
  ["x", "y", "z"].forEach((name, axis) => {
    const factor = plane.normal[axis];
    if (factor === 0n) return;
    const term = factor === 1n || factor === -1n ? name : `${size(factor)} ${name}`;
    if (text === "") text = factor < 0n ? `−${term}` : term;
    else text += ` ${factor < 0n ? "−" : "+"} ${term}`;
  });
  const over = plane.denominator === 1n ? "" : `/${show(plane.denominator.toString())}`;
  return `${text} = ${plane.numerator < 0n ? "−" : ""}${size(plane.numerator)}${over}`;
}

/** x = digits * 2^exponent, the digits odd or zero. */
function splitDouble(x: number): { digits: bigint; exponent: number } {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const biased = Number((bits >> 52n) & 0x7ffn);
  let digits = bits & 0xfffffffffffffn;
  if (biased > 0) digits |= 1n << 52n;
  if (digits === 0n) return { digits, exponent: 0 };
  let exponent = Math.max(biased, 1) - 1075;
  while ((digits & 1n) === 0n) {
    digits >>= 1n;
    ++exponent;
  }
  return { digits: bits >> 63n ? -digits : digits, exponent };
}

function gcd(a: bigint, b: bigint): bigint {
  let [x, y] = [a < 0n ? -a : a, b < 0n ? -b : b];
  while (y !== 0n) [x, y] = [y, x % y];
  return x;
}
