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
  owners: Unsigned | undefined; ///< what each belongs to
  elementName: string; ///< of a point that is picked
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
  points: Uint32Array | undefined; ///< of each pair those at which it is born and dies, or `never`
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
  hasAllValues: boolean; ///< else what begins at a value may have one after the value before
  pointNumbers: Unsigned;
  layers: Layer[];
  links: Uint32Array; ///< from owner to owner, two for each
  counts: { name: string; rows: CountRow[] }[];
  pairs: Pairs;
  pairsLeftOut: number;
  givenCount: number; ///< points; more of them are known in single precision
  /** The coordinates as they were given, each the same double; of others about. */
  point(index: number): Vec3;
  /** (x - center) / scale of all points, in single precision. */
  relative: Float32Array;
}

interface LayerHeader extends Omit<Layer, "vertices" | "shown" | "ends" | "colors" | "owners" | "count"> {
  vertices: ArrayHeader;
  shown?: ArrayHeader;
  ends?: ArrayHeader;
  colors?: ArrayHeader;
  owners?: ArrayHeader;
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
  hasAllValues: boolean;
  points: ArrayHeader;
  nearPoints?: ArrayHeader;
  pairPoints?: ArrayHeader;
  links?: ArrayHeader;
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
  const near = readArray(header.nearPoints) as Float32Array | undefined;
  const pairs = pairsOf(unsigned(header.pairs) as Uint32Array, unsigned(header.pairPoints));
  const links = (unsigned(header.links) ?? new Uint32Array()) as Uint32Array;
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
    owners: unsigned(layer.owners),
  }));
  return {
    ...header,
    value: header.value,
    pointNumbers,
    values,
    pairs,
    counts,
    layers,
    links,
    givenCount: raw.length / 3,
    point: (i) => {
      const isGiven = 3 * i < raw.length;
      const [from, at] = isGiven || !near ? [raw, 3 * i] : [near, 3 * i - raw.length];
      const p: Vec3 = [from[at], from[at + 1], from[at + 2]];
      return from instanceof Float64Array ? p : (p.map((x, k) => center[k] + scale * x) as Vec3);
    },
    relative: relativeOf(raw, near, header),
  };
}

function relativeOf(raw: Float32Array | Float64Array, near: Float32Array | undefined, { center, scale }: Header): Float32Array {
  if (raw instanceof Float32Array && !near) return raw;
  const relative = new Float32Array(raw.length + (near?.length ?? 0));
  if (raw instanceof Float32Array) relative.set(raw);
  else for (let i = 0; i < raw.length; ++i) relative[i] = (raw[i] - center[i % 3]) / scale;
  if (near) relative.set(near, raw.length);
  return relative;
}

function pairsOf(triples: Uint32Array, points: Unsigned | undefined): Pairs {
  const count = triples.length / 3;
  const column = (k: number) => Uint32Array.from({ length: count }, (_, i) => triples[3 * i + k]);
  return { count, degree: column(0), birth: column(1), death: column(2), points: points && Uint32Array.from(points) };
}
