// SPDX-License-Identifier: Apache-2.0
import { emptySegments, type Segments } from "./lines";
import { dot, faceNormal } from "./part_geometry";
import type { Part, Vec3 } from "./scene_data";

/** Edges found by their two vertices: open addressing, two slots or more per edge. */
class EdgeTable {
  private readonly slots: Int32Array;
  private readonly mask: number;

  constructor(private readonly edges: ArrayLike<number>) {
    const count = edges.length / 2;
    this.mask = 2 ** Math.ceil(Math.log2(2 * count + 2)) - 1;
    this.slots = new Int32Array(this.mask + 1).fill(-1);
    for (let e = 0; e < count; ++e) {
      const slot = this.slot(edges[2 * e], edges[2 * e + 1]);
      if (this.slots[slot] < 0) this.slots[slot] = e;
    }
  }

  /** Its index, or -1. */
  find(a: number, b: number): number {
    return this.slots[this.slot(a, b)];
  }

  private slot(a: number, b: number): number {
    const [low, high] = a < b ? [a, b] : [b, a];
    let at = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
    for (at = (at ^ (at >>> 15)) & this.mask; ; at = (at + 1) & this.mask) {
      const e = this.slots[at];
      if (e < 0) return at;
      const [c, d] = [this.edges[2 * e], this.edges[2 * e + 1]];
      if ((c === low && d === high) || (c === high && d === low)) return at;
    }
  }
}

/** What lies along an edge. */
interface Sides {
  pieces: Float32Array; ///< by edge
  sharpness: Float32Array; ///< by edge: 0 where two faces meet almost flat, 1 from 40 degrees on and where not two meet
  copies: [edge: number, piece: number][]; ///< of edges that several pieces share
}

function sidesOfEdges(part: Part): Sides {
  const count = part.edges.length / 2;
  const table = new EdgeTable(part.edges);
  const found = new Uint8Array(count);
  const firstTriangle = new Int32Array(count);
  const result: Sides = { pieces: new Float32Array(count), sharpness: new Float32Array(count).fill(1), copies: [] };
  const copied = new Set<string>();
  for (let t = 0; t < part.triangleCount; ++t) {
    const face = part.triangleFaces[t];
    const piece = part.piece(face);
    for (let k = 0; k < 3; ++k) {
      const e = table.find(part.triangles[3 * t + k], part.triangles[3 * t + ((k + 1) % 3)]);
      if (e < 0) continue;
      if (found[e] === 0) {
        firstTriangle[e] = t;
        result.pieces[e] = piece;
      } else {
        const first = firstTriangle[e];
        result.sharpness[e] = found[e] === 1 ? sharpness(part, first, t) : 1;
        if (piece !== result.pieces[e] && !copied.has(`${e} ${piece}`)) {
          copied.add(`${e} ${piece}`);
          result.copies.push([e, piece]);
        }
      }
      if (found[e] < 255) ++found[e];
    }
  }
  return result;
}

function sharpness(part: Part, t: number, s: number): number {
  const [f, g] = [part.triangleFaces[t], part.triangleFaces[s]];
  const cosine = dot(faceNormal(part, f, t), faceNormal(part, g, s));
  const angle = (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI;
  return Math.min(1, Math.max(0, (angle - 4) / 36));
}

/** The edges of a part; one that faces of several pieces share is drawn with each of them. */
export function edgeLines(part: Part): Segments {
  const relative = part.relativeVertices();
  const { pieces, sharpness: sharp, copies } = sidesOfEdges(part);
  const result = emptySegments(pieces.length + copies.length);
  const put = (at: number, edge: number, piece: number) => {
    for (let axis = 0; axis < 3; ++axis) {
      result.starts[3 * at + axis] = relative[3 * part.edges[2 * edge] + axis];
      result.ends[3 * at + axis] = relative[3 * part.edges[2 * edge + 1] + axis];
    }
    result.pieces[at] = piece;
    result.opacities[at] = 0.24 + 0.76 * sharp[edge];
  };
  for (let e = 0; e < pieces.length; ++e) put(e, e, pieces[e]);
  copies.forEach(([edge, piece], i) => put(pieces.length + i, edge, piece));
  return result;
}

/** A short line from the middle of the largest triangle of every face along its normal. */
export function faceNormalLines(part: Part): Segments {
  const relative = part.relativeVertices();
  const largest = new Int32Array(part.faceCount).fill(-1);
  const areas = new Float32Array(part.faceCount);
  for (let t = 0; t < part.triangleCount; ++t) {
    const face = part.triangleFaces[t];
    const area = doubledArea(corner(part, relative, t, 0), corner(part, relative, t, 1), corner(part, relative, t, 2));
    if (largest[face] < 0 || area > areas[face]) [largest[face], areas[face]] = [t, area];
  }
  const faces = [...largest.keys()].filter((face) => largest[face] >= 0);
  const result = emptySegments(faces.length);
  faces.forEach((face, i) => {
    const triangle = largest[face];
    const normal = faceNormal(part, face, triangle);
    const size = Math.min(0.14, Math.max(0.02, 0.5 * Math.sqrt(areas[face])));
    for (let axis = 0; axis < 3; ++axis) {
      let middle = 0;
      for (let k = 0; k < 3; ++k) middle += corner(part, relative, triangle, k)[axis] / 3;
      result.starts[3 * i + axis] = middle;
      result.ends[3 * i + axis] = middle + size * normal[axis];
    }
    result.pieces[i] = part.piece(face);
    result.opacities[i] = 1;
  });
  return result;
}

function corner(part: Part, relative: Float32Array, triangle: number, k: number): Vec3 {
  const at = 3 * part.triangles[3 * triangle + k];
  return [relative[at], relative[at + 1], relative[at + 2]];
}

function doubledArea(a: Vec3, b: Vec3, c: Vec3): number {
  const u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}
