// SPDX-License-Identifier: Apache-2.0
// The scene that quoin/view/page.cc wrote into this page; the format is described in quoin/view/page_format.h.

export type Vec3 = [number, number, number];
export type Fact = [string, string];
export type Unsigned = Uint8Array | Uint16Array | Uint32Array;

export interface ArrayHeader {
  type: "u8" | "u16" | "u32" | "f32" | "f64";
  length: number;
  block: number;
}

interface PartHeader {
  name: string;
  facts: Fact[];
  faceCount: number;
  arrays: Record<string, ArrayHeader | undefined>;
}

interface SceneHeader {
  format: string;
  version: number;
  title: string;
  unit: string;
  facts: Fact[];
  center: Vec3;
  scale: number;
  origins: string[];
  parts: PartHeader[];
}

export interface FaceOrigin {
  origin: number;
  face: number;
}

/** One object of the scene. "Relative" coordinates are (x - center) / scale: the whole scene lies within [-1, 1]. */
export class Part {
  readonly name: string;
  readonly facts: Fact[];
  readonly triangles: Unsigned;
  readonly triangleFaces: Unsigned;
  readonly edges: Unsigned;
  readonly planes: Float32Array | Float64Array;
  readonly faceCount: number;
  readonly pieceCount: number;
  private readonly vertices: Float32Array | Float64Array;
  private readonly faceOrigins: Unsigned | undefined;
  private readonly faceOriginFaces: Unsigned | undefined;
  private readonly facePieces: Unsigned | undefined;
  private readonly colors: Unsigned | undefined;
  private readonly colored: Unsigned | undefined;
  private readonly moreOrigins: Unsigned;
  private readonly faceSpans: Unsigned | undefined;
  private readonly planePoints: Float32Array | Float64Array;
  private readonly planeTexts: Uint8Array | undefined;
  private readonly planeTextEnds: Unsigned | undefined;

  constructor(
    header: PartHeader,
    private readonly center: Vec3,
    private readonly scale: number,
  ) {
    const unsigned = (key: string) => readArray(header.arrays[key]) as Unsigned | undefined;
    const real = (key: string) =>
      (readArray(header.arrays[key]) as Float32Array | Float64Array | undefined) ?? new Float32Array(0);
    this.name = header.name;
    this.facts = header.facts;
    this.vertices = real("vertices");
    this.triangles = unsigned("triangles") ?? new Uint8Array(0);
    this.triangleFaces = unsigned("triangleFaces") ?? new Uint8Array(0);
    this.edges = unsigned("edges") ?? new Uint8Array(0);
    this.planes = real("planes");
    this.faceCount = header.faceCount;
    this.faceSpans = unsigned("faceSpans");
    this.planePoints = real("planePoints");
    this.faceOrigins = unsigned("faceOrigins");
    this.faceOriginFaces = unsigned("faceOriginFaces");
    this.facePieces = unsigned("facePieces");
    this.colors = unsigned("colors");
    this.colored = unsigned("colored");
    this.moreOrigins = unsigned("moreOrigins") ?? new Uint8Array(0);
    this.planeTexts = unsigned("planeTexts") as Uint8Array | undefined;
    this.planeTextEnds = unsigned("planeTextEnds");
    let last = 0;
    for (const piece of this.facePieces ?? []) last = Math.max(last, piece);
    this.pieceCount = last + 1;
  }

  get triangleCount(): number {
    return this.triangles.length / 3;
  }

  get vertexCount(): number {
    return this.vertices.length / 3;
  }

  /** The coordinates as they were given, each the same double. */
  vertex(index: number): Vec3 {
    const v = this.vertices;
    const i = 3 * index;
    if (v instanceof Float64Array) return [v[i], v[i + 1], v[i + 2]];
    const { center: c, scale: s } = this;
    return [c[0] + s * v[i], c[1] + s * v[i + 1], c[2] + s * v[i + 2]];
  }

  /** Relative coordinates of all vertices, in single precision. */
  relativeVertices(): Float32Array {
    if (this.vertices instanceof Float32Array) return this.vertices;
    const result = new Float32Array(this.vertices.length);
    for (let i = 0; i < result.length; ++i) result[i] = (this.vertices[i] - this.center[i % 3]) / this.scale;
    return result;
  }

  piece(face: number): number {
    return this.facePieces ? this.facePieces[face] : 0;
  }

  origin(face: number): number {
    return this.faceOrigins ? this.faceOrigins[face] : 0;
  }

  /** All input faces that a face lies on, the one that colours it first. */
  origins(face: number): FaceOrigin[] {
    const first = this.faceOriginFaces ? this.faceOriginFaces[face] : 0;
    const result = [{ origin: this.origin(face), face: first }];
    for (let i = 0; i < this.moreOrigins.length; i += 3) {
      if (this.moreOrigins[i] !== face) continue;
      result.push({ origin: this.moreOrigins[i + 1], face: this.moreOrigins[i + 2] });
    }
    return result;
  }

  /** Red, green, blue and opacity, 0 to 255, where the face has a colour of its own. */
  color(face: number): [number, number, number, number] | undefined {
    const c = this.colors;
    if (!this.colored || this.colored[face] === 0) return undefined;
    const i = 4 * face;
    return c ? [c[i], c[i + 1], c[i + 2], c[i + 3]] : [0, 0, 0, 0];
  }

  /** Three points that span the face's plane exactly, counterclockwise seen from outside, where the page has them. */
  span(face: number): [Vec3, Vec3, Vec3] | undefined {
    const spans = this.faceSpans;
    if (!spans) return undefined;
    return [this.planePoint(spans[3 * face]), this.planePoint(spans[3 * face + 1]), this.planePoint(spans[3 * face + 2])];
  }

  private planePoint(index: number): Vec3 {
    if (index < this.vertexCount) return this.vertex(index);
    const [p, i] = [this.planePoints, 3 * (index - this.vertexCount)];
    return [p[i], p[i + 1], p[i + 2]];
  }

  planeText(face: number): string {
    if (!this.planeTexts || !this.planeTextEnds) return "";
    const begin = face === 0 ? 0 : this.planeTextEnds[face - 1];
    return new TextDecoder().decode(this.planeTexts.subarray(begin, this.planeTextEnds[face]));
  }
}

export interface SceneData {
  title: string;
  unit: string;
  facts: Fact[];
  center: Vec3;
  scale: number;
  origins: string[];
  parts: Part[];
}

/** Decodes the scene and drops its text from the document. Throws an Error that says what is wrong. */
export function readScene(): SceneData {
  const element = document.getElementById("quoin-scene");
  if (!element) throw new Error("This page holds no scene: it is the empty template of the view.");
  const header = JSON.parse(element.textContent ?? "") as SceneHeader;
  if (header.format !== "quoin-scene" || header.version !== 1) {
    throw new Error("This page holds a scene in a format that it does not know.");
  }
  const { title, unit, facts, center, scale, origins } = header;
  const parts = header.parts.map((part) => new Part(part, center, scale));
  element.remove();
  return { title, unit, facts, center, scale, origins, parts };
}

export function originName(scene: SceneData, origin: number): string {
  return scene.origins[origin] || `Input ${origin}`;
}

export function readArray(header: ArrayHeader | undefined) {
  if (!header) return undefined;
  const element = document.getElementById(`quoin-block-${header.block}`);
  const bytes = decodeBase64(element?.textContent ?? "");
  element?.remove();
  const types = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array, f64: Float64Array };
  const type = types[header.type];
  if (bytes.length !== header.length * type.BYTES_PER_ELEMENT) {
    throw new Error("The scene in this page is incomplete; the file may have been cut short.");
  }
  return new type(bytes.buffer as ArrayBuffer);
}

/** Of padded base64 without white space. Not through atob, which would need the binary as one more string. */
export function decodeBase64(text: string): Uint8Array {
  const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const values = new Uint8Array(256);
  for (let i = 0; i < 64; ++i) values[digits.charCodeAt(i)] = i;
  const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  const bytes = new Uint8Array(Math.max(0, (text.length >> 2) * 3 - padding));
  for (let from = 0, to = 0; to < bytes.length; from += 4, to += 3) {
    const bits =
      (values[text.charCodeAt(from)] << 18) |
      (values[text.charCodeAt(from + 1)] << 12) |
      (values[text.charCodeAt(from + 2)] << 6) |
      values[text.charCodeAt(from + 3)];
    bytes[to] = bits >> 16;
    bytes[to + 1] = bits >> 8;
    bytes[to + 2] = bits;
  }
  return bytes;
}
