// SPDX-License-Identifier: Apache-2.0
import type { Cell, CellKind, CellsData } from "../cells/data";
import type { SphereGeometry } from "./sphere_data";

type Vec3 = readonly [number, number, number];

const pointReach = 9; // pixels
const edgeReach = 6;

/** What lies in a direction: points before edges before faces, as far as they are shown. */
export class SpherePicker {
  readonly isShown: Record<CellKind, boolean> = { face: true, edge: true, point: true };

  constructor(
    private readonly data: CellsData,
    private readonly geometry: SphereGeometry,
  ) {}

  /** `pixel` is the angle that one pixel shows. */
  cellAt(d: Vec3, pixel: number): Cell | undefined {
    const { cells } = this.data;
    const point = this.isShown.point ? this.nearestPoint(d, pointReach * pixel) : undefined;
    if (point !== undefined) return cells.point[point];
    const edge = this.isShown.edge ? this.nearestEdge(d, edgeReach * pixel) : undefined;
    if (edge !== undefined) return cells.edge[edge];
    const face = this.geometry.map.faceAt(...d);
    return face === undefined ? undefined : cells.face[face];
  }

  private nearestPoint(d: Vec3, reach: number): number | undefined {
    const { points } = this.geometry;
    let best: number | undefined;
    let least = reach * reach;
    for (let i = 0; 3 * i < points.length; ++i) {
      const square = (points[3 * i] - d[0]) ** 2 + (points[3 * i + 1] - d[1]) ** 2 + (points[3 * i + 2] - d[2]) ** 2;
      if (square < least) [best, least] = [i, square];
    }
    return best;
  }

  private nearestEdge(d: Vec3, reach: number): number | undefined {
    let best: number | undefined;
    let least = reach * reach;
    this.geometry.paths.forEach((path, edge) => {
      for (let i = 3; i < path.length; i += 3) {
        const square = squareToChord(d, path, i - 3);
        if (square < least) [best, least] = [edge, square];
      }
    });
    return best;
  }
}

function squareToChord(d: Vec3, path: Float32Array, i: number): number {
  const [ax, ay, az] = [path[i], path[i + 1], path[i + 2]];
  const [ux, uy, uz] = [path[i + 3] - ax, path[i + 4] - ay, path[i + 5] - az];
  const [px, py, pz] = [d[0] - ax, d[1] - ay, d[2] - az];
  const length = ux * ux + uy * uy + uz * uz;
  const t = length > 0 ? Math.min(1, Math.max(0, (px * ux + py * uy + pz * uz) / length)) : 0;
  return (px - t * ux) ** 2 + (py - t * uy) ** 2 + (pz - t * uz) ** 2;
}

/** For each face a direction inside it, as far from edges as one of a few thousand is; none for tiny faces. */
export function faceMiddles(geometry: SphereGeometry, faceCount: number): (Vec3 | undefined)[] {
  const samples = edgeSamples(geometry);
  const tries = Math.round(Math.min(4000, 2e7 / Math.max(1, samples.length / 3)));
  const best: (Vec3 | undefined)[] = new Array(faceCount).fill(undefined);
  const room = new Float64Array(faceCount);
  for (let n = 0; n < tries; ++n) {
    const z = 1 - (2 * n + 1) / tries;
    const angle = n * Math.PI * (3 - Math.sqrt(5));
    const r = Math.sqrt(1 - z * z);
    const d: Vec3 = [r * Math.cos(angle), r * Math.sin(angle), z];
    const face = geometry.map.faceAt(...d);
    if (face === undefined) continue;
    let square = 4;
    for (let i = 0; i < samples.length && square > room[face]; i += 3) {
      square = Math.min(square, (samples[i] - d[0]) ** 2 + (samples[i + 1] - d[1]) ** 2 + (samples[i + 2] - d[2]) ** 2);
    }
    if (square > room[face]) [room[face], best[face]] = [square, d];
  }
  return best;
}

function edgeSamples({ paths, points }: SphereGeometry): Float32Array {
  const samples: number[] = [...points];
  for (const path of paths) {
    for (let i = 0; i < path.length; i += 6) samples.push(path[i], path[i + 1], path[i + 2]);
  }
  return new Float32Array(samples);
}
