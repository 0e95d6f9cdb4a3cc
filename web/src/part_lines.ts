// SPDX-License-Identifier: Apache-2.0
import type { Segments } from "./lines";
import type { Part, Vec3 } from "./scene_data";
import { faceNormal } from "./part_geometry";

const severalPieces = -2;
const noPiece = -1;

/** The edges of a part; one that faces of several pieces share is drawn with each of them. */
export function edgesByPiece(part: Part, relative: Float32Array): Segments {
  const pairs: [number, number, number][] = [];
  const count = part.edges.length / 2;
  const shared = new Map<string, number>();
  const pieceOf = part.pieceCount > 1 ? vertexPieces(part) : undefined;
  const pieces: number[] = [];
  for (let e = 0; e < count; ++e) {
    const a = part.edges[2 * e];
    const b = part.edges[2 * e + 1];
    const piece = pieceOf ? edgePiece(pieceOf[a], pieceOf[b]) : 0;
    if (piece === severalPieces) shared.set(edgeKey(a, b), e);
    pieces.push(Math.max(0, piece));
  }
  if (shared.size > 0) pairs.push(...copiesOfSharedEdges(part, shared, pieces));
  const total = count + pairs.length;
  const result: Segments = {
    starts: new Float32Array(3 * total),
    ends: new Float32Array(3 * total),
    pieces: new Float32Array(total),
  };
  const put = (at: number, a: number, b: number, piece: number) => {
    result.starts.set(relative.subarray(3 * a, 3 * a + 3), 3 * at);
    result.ends.set(relative.subarray(3 * b, 3 * b + 3), 3 * at);
    result.pieces[at] = piece;
  };
  for (let e = 0; e < count; ++e) put(e, part.edges[2 * e], part.edges[2 * e + 1], pieces[e]);
  pairs.forEach(([a, b, piece], i) => put(count + i, a, b, piece));
  return result;
}

function vertexPieces(part: Part): Int32Array {
  const pieces = new Int32Array(part.vertexCount).fill(noPiece);
  for (let i = 0; i < part.triangles.length; ++i) {
    const piece = part.piece(part.triangleFaces[Math.floor(i / 3)]);
    const v = part.triangles[i];
    if (pieces[v] === noPiece) pieces[v] = piece;
    else if (pieces[v] !== piece) pieces[v] = severalPieces;
  }
  return pieces;
}

function edgePiece(a: number, b: number): number {
  return a === severalPieces ? b : a;
}

function edgeKey(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** Sets the piece of each shared edge to the first one found and returns the edge again for every further one. */
function copiesOfSharedEdges(
  part: Part,
  shared: Map<string, number>,
  pieces: number[],
): [number, number, number][] {
  const found = new Map<number, Set<number>>();
  for (let t = 0; t < part.triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const edge = shared.get(edgeKey(part.triangles[t + k], part.triangles[t + ((k + 1) % 3)]));
      if (edge === undefined) continue;
      if (!found.has(edge)) found.set(edge, new Set());
      found.get(edge)?.add(part.piece(part.triangleFaces[t / 3]));
    }
  }
  const copies: [number, number, number][] = [];
  for (const [edge, among] of found) {
    const [first, ...further] = among;
    pieces[edge] = first;
    for (const piece of further) copies.push([part.edges[2 * edge], part.edges[2 * edge + 1], piece]);
  }
  return copies;
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
  const result: Segments = {
    starts: new Float32Array(3 * faces.length),
    ends: new Float32Array(3 * faces.length),
    pieces: new Float32Array(faces.length),
  };
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
