// SPDX-License-Identifier: Apache-2.0
// What quoin/view/layered_page.cc wrote into this page.
import { readArray, type ArrayHeader, type Fact, type Unsigned, type Vec3 } from "../scene_data";

export type LayerKind = "points" | "segments" | "triangles";
/** The death of a class that stays for ever. */
export const never = 0xffffffff;

export interface Layer {
  name: string;
  kind: LayerKind;
  color: [number, number, number, number];
  size: number; ///< pixels, or 0
  isShown: boolean;
  count: number;
  vertices: Unsigned; ///< indices into points: 1, 2 or 3 for each
  shown: Unsigned | undefined; ///< how many have begun, by value
  ends: Unsigned | undefined; ///< of those for ever the number of values
  colors: Uint8Array | undefined; ///< 4 for each
}

export interface CountRow {
  name: string;
  at: Unsigned; ///< by value
}

/** Classes of homology, by degree, with the values of their births and deaths. */
export interface Pairs {
  count: number;
  degree: Uint32Array;
  birth: Uint32Array;
  death: Uint32Array;
}

export interface LayeredData {
  title: string;
  facts: Fact[];
  center: Vec3;
  scale: number;
  valueName: string;
  rootName: string;
  value: number | undefined;
  values: Float64Array;
  pointNumbers: Unsigned;
  layers: Layer[];
  counts: { name: string; rows: CountRow[] }[];
  pairs: Pairs;
  pairsLeftOut: number;
  pointCount: number;
  /** The coordinates as they were given, each the same double. */
  point(index: number): Vec3;
  /** (x - center) / scale of all points, in single precision. */
  relative: Float32Array;
}

interface LayerHeader extends Omit<Layer, "vertices" | "shown" | "ends" | "colors" | "count"> {
  vertices: ArrayHeader;
  shown?: ArrayHeader;
  ends?: ArrayHeader;
  colors?: ArrayHeader;
}

interface Header {
  format: string;
  version: number;
  title: string;
  facts: Fact[];
  center: Vec3;
  scale: number;
  valueName: string;
  rootName: string;
  value?: number;
  pairsLeftOut: number;
  points: ArrayHeader;
  pointNumbers: ArrayHeader;
  values: ArrayHeader;
  pairs: ArrayHeader;
  counts: { name: string; rows: { name: string; at: ArrayHeader }[] }[];
  layers: LayerHeader[];
}

const arity: Record<LayerKind, number> = { points: 1, segments: 2, triangles: 3 };

export function verticesOf(kind: LayerKind): number {
  return arity[kind];
}

function readHeader(): Header {
  const element = document.getElementById("quoin-layers");
  if (!element) throw new Error("This page holds no points: it is the empty template of the view.");
  let header: Header;
  try {
    header = JSON.parse(element.textContent ?? "") as Header;
  } catch {
    throw new Error("The scene in this page is incomplete; the file may have been cut short.");
  }
  if (header.format !== "quoin-layers" || header.version !== 1) {
    throw new Error("This page holds points in a format that it does not know.");
  }
  element.remove();
  return header;
}

/** The scene, which leaves the document. Throws an Error that says what is wrong. */
export function readLayers(): LayeredData {
  const header = readHeader();
  const unsigned = (array: ArrayHeader | undefined) => readArray(array) as Unsigned | undefined;
  const raw = readArray(header.points) as Float32Array | Float64Array;
  const { center, scale } = header;
  const pointNumbers = unsigned(header.pointNumbers) as Unsigned;
  const values = readArray(header.values) as Float64Array;
  const pairs = pairsOf(unsigned(header.pairs) as Uint32Array);
  const counts = header.counts.map(({ name, rows }) => ({
    name,
    rows: rows.map((row) => ({ name: row.name, at: unsigned(row.at) as Unsigned })),
  }));
  const layers = header.layers.map((layer) => ({
    ...layer,
    count: layer.vertices.length / arity[layer.kind],
    vertices: unsigned(layer.vertices) as Unsigned,
    shown: unsigned(layer.shown),
    ends: unsigned(layer.ends),
    colors: readArray(layer.colors) as Uint8Array | undefined,
  }));
  return {
    ...header,
    value: header.value,
    pointNumbers,
    values,
    pairs,
    counts,
    layers,
    pointCount: raw.length / 3,
    point: (i) => {
      const p: Vec3 = [raw[3 * i], raw[3 * i + 1], raw[3 * i + 2]];
      return raw instanceof Float64Array ? p : (p.map((x, k) => center[k] + scale * x) as Vec3);
    },
    relative: raw instanceof Float32Array ? raw : Float32Array.from(raw, (x, i) => (x - center[i % 3]) / scale),
  };
}

function pairsOf(triples: Uint32Array): Pairs {
  const count = triples.length / 3;
  const column = (k: number) => Uint32Array.from({ length: count }, (_, i) => triples[3 * i + k]);
  return { count, degree: column(0), birth: column(1), death: column(2) };
}
