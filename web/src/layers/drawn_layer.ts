// SPDX-License-Identifier: Apache-2.0
// One layer on the graphics device: one draw call. What it holds is in textures, which are written once: the number of
// a vertex names its element. Drawn are the first elements, which have begun; of layers whose elements end, those that
// have not, by an index that is written when the value changes. Selected elements have an index of their own.
import * as THREE from "three";
import type { Unsigned } from "../scene_data";
import type { Layer } from "./layered_data";
import type { SeenOwners } from "./owners";
import { layerFragment, layerVertex } from "./layer_shaders";

const width = 4096;
const cornersDrawn = { points: 1, segments: 6, triangles: 3 };

/** What all layers share. */
export interface CloudUniforms {
  places: { value: THREE.DataTexture };
  viewport: { value: THREE.Vector2 };
  ratio: { value: number };
}

export function placesTexture(relative: Float32Array): THREE.DataTexture {
  const count = relative.length / 3;
  const rows = Math.max(1, Math.ceil(count / width));
  const data = new Float32Array(4 * width * rows);
  for (let i = 0; i < count; ++i) data.set(relative.subarray(3 * i, 3 * i + 3), 4 * i);
  return texture(data, rows, THREE.RGBAFormat, THREE.FloatType, "RGBA32F");
}

function texture(
  data: Float32Array | Uint32Array | Uint8Array,
  rows: number,
  format: THREE.PixelFormat,
  type: THREE.TextureDataType,
  internal: THREE.PixelFormatGPU,
): THREE.DataTexture {
  const made = new THREE.DataTexture(data, width, rows, format, type);
  made.internalFormat = internal;
  made.needsUpdate = true;
  made.onUpdate = () => {
    made.source.data = { data: null, width, height: rows }; // it is on the device now
  };
  return made;
}

function numbers(values: Unsigned): THREE.DataTexture {
  const rows = Math.max(1, Math.ceil(values.length / width));
  const data = new Uint32Array(width * rows);
  data.set(values);
  return texture(data, rows, THREE.RedIntegerFormat, THREE.UnsignedIntType, "R32UI");
}

export class DrawnLayer {
  readonly object: THREE.Object3D;
  isShown: boolean;
  private readonly geometry = new THREE.BufferGeometry();
  private readonly material: THREE.RawShaderMaterial;
  /** How many have ended, by value. */
  private readonly ended: Uint32Array | undefined;
  private readonly index: THREE.BufferAttribute | undefined;
  private drawn = 0;
  private seenOwners: SeenOwners | undefined;
  private selected: number[] = [];
  private selection = new THREE.BufferAttribute(new Uint32Array(1), 1);

  constructor(
    readonly layer: Layer,
    shared: CloudUniforms,
    valueCount: number,
    usualSize: number,
  ) {
    const { kind, color, ends, colors } = layer;
    this.isShown = layer.isShown;
    this.ended = ends && endedByValue(ends, valueCount);
    const defines: Record<string, string> = { [`IS_${kind.toUpperCase()}`]: "" };
    const uniforms: Record<string, THREE.IUniform> = {
      ...shared,
      vertices: { value: numbers(layer.vertices) },
      color: { value: new THREE.Vector4(color[0] / 255, color[1] / 255, color[2] / 255, color[3] / 255) },
      size: { value: layer.size > 0 ? layer.size : usualSize },
    };
    if (colors) {
      defines.HAS_COLORS = "";
      const rows = Math.max(1, Math.ceil(layer.count / width));
      const data = new Uint8Array(4 * width * rows);
      data.set(colors);
      uniforms.colors = { value: texture(data, rows, THREE.RGBAFormat, THREE.UnsignedByteType, "RGBA8") };
    }
    const isSeenThrough = color[3] < 255 || (colors?.some((c, i) => i % 4 === 3 && c < 255) ?? false);
    this.material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: layerVertex,
      fragmentShader: layerFragment,
      defines,
      uniforms,
      side: THREE.DoubleSide,
      transparent: isSeenThrough,
      depthWrite: !isSeenThrough,
    });
    this.object =
      kind === "points" ? new THREE.Points(this.geometry, this.material) : new THREE.Mesh(this.geometry, this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = isSeenThrough ? 1 : 0;
    if (ends && this.ended) {
      let most = 0;
      for (let value = 0; value < valueCount; ++value) most = Math.max(most, this.countAt(value));
      this.index = new THREE.BufferAttribute(new Uint32Array(Math.max(1, cornersDrawn[kind] * most)), 1);
      this.index.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setIndex(this.index);
    }
    this.limit(Infinity);
  }

  /** How many elements are there at a value. */
  countAt(value: number): number {
    return this.begunAt(value) - (this.ended ? this.ended[value] : 0);
  }

  begunAt(value: number): number {
    return this.layer.shown ? (this.layer.shown[value] ?? 0) : this.layer.count;
  }

  /** How many elements are drawn. */
  get drawnCount(): number {
    return this.drawn;
  }

  get selectedCount(): number {
    return this.selected.length;
  }

  /** What is hidden when the page is opened is seen where it is selected. */
  get isSeen(): boolean {
    return this.isShown || (this.seenOwners !== undefined && !this.layer.isShown);
  }

  /** Only elements of these owners are seen from now on, of a layer whose elements have owners; undefined: all. */
  select(seen: SeenOwners | undefined): void {
    const { owners, count, kind } = this.layer;
    if (!owners) return;
    this.seenOwners = seen;
    this.selected = [];
    for (let i = 0; seen && i < count; ++i) if (seen[owners[i]]) this.selected.push(i);
    const room = cornersDrawn[kind] * this.selected.length;
    if (room > this.selection.array.length) this.selection = new THREE.BufferAttribute(new Uint32Array(2 * room), 1);
    this.geometry.setIndex(seen ? this.selection : (this.index ?? null));
  }

  show(value: number): void {
    if (this.seenOwners) this.drawn = this.writeSelection(value);
    else if (this.index && this.layer.ends) this.drawn = this.writeIndex(this.index, this.layer.ends, value);
    else this.drawn = this.begunAt(value);
    this.limit(Infinity);
  }

  /** At most so many elements, as while the picture moves; then perhaps of a hidden layer too. */
  limit(most: number, isForced = false): void {
    this.geometry.setDrawRange(0, cornersDrawn[this.layer.kind] * Math.min(most, this.drawn));
    this.object.visible = (this.isSeen || isForced) && this.drawn > 0 && most > 0;
  }

  isThere(element: number, value: number): boolean {
    const { ends, owners } = this.layer;
    if (this.seenOwners && owners && !this.seenOwners[owners[element]]) return false;
    return element < this.begunAt(value) && (ends ? ends[element] > value : true);
  }

  private writeSelection(value: number): number {
    const list = this.selection.array as Uint32Array;
    const corners = cornersDrawn[this.layer.kind];
    let at = 0;
    for (const i of this.selected) {
      if (!this.isThere(i, value)) continue;
      for (let k = 0; k < corners; ++k) list[at++] = corners * i + k;
    }
    this.selection.needsUpdate = true;
    return at / corners;
  }

  /** The elements that are there; returns how many they are. */
  private writeIndex(index: THREE.BufferAttribute, ends: Unsigned, value: number): number {
    if (!this.isShown) return 0;
    const list = index.array as Uint32Array;
    const corners = cornersDrawn[this.layer.kind];
    const begun = this.begunAt(value);
    let at = 0;
    for (let i = 0; i < begun; ++i) {
      if (ends[i] <= value) continue;
      for (let k = 0; k < corners; ++k) list[at++] = corners * i + k;
    }
    index.clearUpdateRanges();
    index.addUpdateRange(0, at);
    index.needsUpdate = true;
    return at / corners;
  }
}

function endedByValue(ends: Unsigned, valueCount: number): Uint32Array {
  const ended = new Uint32Array(valueCount);
  for (const end of ends) if (end < valueCount) ++ended[end];
  for (let i = 1; i < valueCount; ++i) ended[i] += ended[i - 1];
  return ended;
}
