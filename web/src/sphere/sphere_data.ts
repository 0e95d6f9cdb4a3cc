// SPDX-License-Identifier: Apache-2.0
// What quoin/view/sphere_page.cc wrote into this page beside the cells.
import type { CellsHeader } from "../cells/data";
import { decodeBase64 } from "../scene_data";

export interface SphereHeader extends CellsHeader {
  map: [width: number, height: number];
  lengths: number[]; ///< directions of each edge
  styles: number[]; ///< of each edge: plain, strong, faint, dashed
}

export const noFace = 0xffffffff;

/** Which face is where, by longitude and latitude; see quoin/view/sphere_picture.h. */
export class FaceMap {
  constructor(
    readonly width: number,
    readonly height: number,
    readonly faces: Uint32Array,
  ) {}

  /** In the direction of a unit vector; undefined where there is none. */
  faceAt(x: number, y: number, z: number): number | undefined {
    if (this.faces.length === 0) return undefined;
    const column = Math.floor(((Math.atan2(y, x) / Math.PI + 1) / 2) * this.width);
    const row = Math.floor((0.5 - Math.asin(Math.min(1, Math.max(-1, z))) / Math.PI) * this.height);
    const face = this.faces[Math.min(row, this.height - 1) * this.width + (column % this.width)];
    return face === noFace ? undefined : face;
  }
}

export interface SphereGeometry {
  points: Float32Array; ///< 3 for each
  /** Directions along each edge, 3 for each, close enough for chords. */
  paths: Float32Array[];
  map: FaceMap;
}

const incomplete = () => new Error("The picture in this page is incomplete; the file may have been cut short.");
const longestChord = 0.02; // radians

function block(id: string): ArrayBuffer {
  const element = document.getElementById(id);
  if (!element) throw incomplete();
  const bytes = decodeBase64(element.textContent ?? "");
  element.remove();
  return bytes.buffer as ArrayBuffer;
}

export function readGeometry(header: SphereHeader): SphereGeometry {
  const read = (id: string, length: number) => {
    const bytes = block(id);
    if (bytes.byteLength !== 12 * length) throw incomplete();
    return new Float32Array(bytes);
  };
  const points = read("quoin-points", header.points.length);
  const all = read("quoin-paths", header.lengths.reduce((sum, n) => sum + n, 0));
  let at = 0;
  const paths = header.lengths.map((length) => refined(all.subarray(3 * at, 3 * (at += length))));
  return { points, paths, map: readMap(header) };
}

function readMap(header: SphereHeader): FaceMap {
  const [width, height] = header.map;
  const bytes = block("quoin-map");
  if (bytes.byteLength % 8 !== 0) throw incomplete();
  const runs = new Uint32Array(bytes);
  const faces = new Uint32Array(width * height);
  let at = 0;
  for (let i = 0; i < runs.length; i += 2) faces.fill(runs[i], at, (at += runs[i + 1]));
  if (at !== faces.length) throw incomplete();
  return new FaceMap(width, height, faces);
}

/** With further directions on the great arcs between those given. */
function refined(path: Float32Array): Float32Array {
  const out: number[] = [...path.subarray(0, 3)];
  for (let i = 3; i < path.length; i += 3) {
    const [ax, ay, az, bx, by, bz] = path.subarray(i - 3, i + 3);
    const chord = Math.hypot(bx - ax, by - ay, bz - az);
    const angle = 2 * Math.asin(Math.min(1, chord / 2));
    const count = Math.max(1, Math.ceil(angle / longestChord));
    for (let k = 1; k < count; ++k) {
      const s = Math.sin(angle) || 1;
      const [u, v] = [Math.sin((angle * (count - k)) / count) / s, Math.sin((angle * k) / count) / s];
      out.push(u * ax + v * bx, u * ay + v * by, u * az + v * bz);
    }
    out.push(bx, by, bz);
  }
  return new Float32Array(out);
}
