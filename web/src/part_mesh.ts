// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { LineSet, type LineOptions, type Segments } from "./lines";
import { originColor, type Rgb } from "./palette";
import type { Part, Vec3 } from "./scene_data";
import { edgeLines, faceNormalLines } from "./part_lines";
import { sectionOutline } from "./section_outline";
import * as shaders from "./shaders";
import { floatTable, faceTable, unsignedTable } from "./tables";

/** What all parts share: the cut, the explosion, what is lit up. Values are changed in place. */
export interface SharedUniforms {
  [name: string]: THREE.IUniform;
  cut: THREE.IUniform<THREE.Vector4>;
  explode: THREE.IUniform<number>;
  highlightOrigin: THREE.IUniform<number>;
  showTriangles: THREE.IUniform<number>;
  accent: THREE.IUniform<THREE.Color>;
  isPerspective: THREE.IUniform<number>;
  near: THREE.IUniform<number>;
  viewport: THREE.IUniform<THREE.Vector2>;
  width: THREE.IUniform<number>;
}

/** A part on the GPU: its surface, edges, cap of the cut, and the twin that is drawn for picking. */
export class PartMesh {
  readonly group = new THREE.Group();
  readonly pickMesh: THREE.Mesh;
  readonly cap: THREE.Mesh;
  private edges: LineSet | undefined;
  readonly pieces: Piece[];
  readonly capColor: Rgb;
  private normals: LineSet | undefined;
  private outline: LineSet | undefined;
  private readonly surface: THREE.Mesh;
  private readonly stencils: THREE.Mesh[];
  private readonly uniforms: Record<string, THREE.IUniform>;
  private readonly offsets: THREE.DataTexture;

  constructor(
    readonly part: Part,
    readonly index: number,
    readonly firstTriangle: number,
    private readonly shared: SharedUniforms,
  ) {
    const relative = part.relativeVertices();
    this.pieces = piecesOf(part, relative);
    this.offsets = floatTable(part.pieceCount);
    const colors = faceColors(part);
    this.capColor = commonColor(part, colors);
    this.uniforms = {
      ...shared,
      triangleFaces: { value: unsignedTable(part.triangleFaces, part.triangleCount) },
      faceTable: { value: faceTable(part, colors) },
      pieceOffsets: { value: this.offsets },
      highlightFace: { value: -1 },
      hoverFace: { value: -1 },
      firstTriangle: { value: firstTriangle },
    };

    const geometry = surfaceGeometry(part, relative);
    this.surface = this.mesh(geometry, this.surfaceMaterial(0), 0);
    this.surface.visible = part.triangleCount > 0;
    this.group.add(this.surface);
    if (colors.some((packed) => packed >>> 24 !== 255)) {
      this.group.add(this.mesh(geometry, this.surfaceMaterial(1), 1e6 + index));
    }

    // Counted along a line of sight, back sides less front sides left of the cut say whether it meets the solid.
    const order = 10 + 4 * index;
    this.stencils = [
      this.mesh(geometry, this.stencilMaterial(THREE.BackSide, THREE.IncrementWrapStencilOp), order),
      this.mesh(geometry, this.stencilMaterial(THREE.FrontSide, THREE.DecrementWrapStencilOp), order + 1),
    ];
    this.cap = this.mesh(new THREE.PlaneGeometry(8, 8), this.capMaterial(), order + 2);
    this.group.add(...this.stencils, this.cap);

    this.pickMesh = this.mesh(geometry, this.pickMaterial(), 0);
    this.showCut(false);
  }

  get isShown(): boolean {
    return this.group.visible;
  }

  show(isShown: boolean): void {
    this.group.visible = isShown;
    this.pickMesh.visible = isShown;
  }

  showCut(isShown: boolean): void {
    for (const mesh of [...this.stencils, this.cap]) mesh.visible = isShown && this.part.triangleCount > 0;
  }

  /** Lines are made when they are first asked for. */
  showEdges(isShown: boolean): void {
    if (isShown && !this.edges) this.edges = this.lines(edgeLines(this.part), { fade: 0.7, fadeStart: 0, isCut: true });
    if (this.edges) this.edges.mesh.visible = isShown;
  }

  showNormals(isShown: boolean): void {
    if (isShown && !this.normals) this.normals = this.lines(faceNormalLines(this.part), { fade: 0, fadeStart: 0.75, isCut: true });
    if (this.normals) this.normals.mesh.visible = isShown;
  }

  /** Where the cut meets the boundary; nothing hides the outline. */
  showOutline(normal: Vec3 | undefined, distance: number): void {
    if (this.outline) this.outline.mesh.visible = normal !== undefined;
    if (!normal) return;
    const segments = sectionOutline(this.part, this.part.relativeVertices(), (i) => this.offset(i), normal, distance);
    if (this.outline) this.outline.replace(segments);
    else this.outline = this.lines(segments, { fade: 0, fadeStart: 0, isCut: false });
  }

  setLineColors(edges: THREE.Vector4, normals: THREE.Vector4): void {
    this.edges?.color.copy(edges);
    this.outline?.color.copy(edges);
    this.normals?.color.copy(normals);
  }

  highlight(face: number): void {
    this.uniforms.highlightFace.value = face;
  }

  hover(face: number): void {
    this.uniforms.hoverFace.value = face;
  }

  /** Where piece i goes when the explosion is 1. */
  setOffsets(offsets: Vec3[]): void {
    const data = this.offsets.image.data as Float32Array;
    offsets.forEach((offset, i) => data.set(offset, 4 * i));
    this.offsets.needsUpdate = true;
  }

  offset(piece: number): Vec3 {
    const data = this.offsets.image.data as Float32Array;
    const k = this.shared.explode.value;
    return [k * data[4 * piece], k * data[4 * piece + 1], k * data[4 * piece + 2]];
  }

  private lines(segments: Segments, options: Omit<LineOptions, "order">): LineSet {
    const lines = new LineSet(segments, this.uniforms, { ...options, order: 5e5 + this.index });
    this.group.add(lines.mesh);
    return lines;
  }

  private mesh(geometry: THREE.BufferGeometry, material: THREE.Material, order: number): THREE.Mesh {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
    return mesh;
  }

  private material(fragmentShader: string, options: THREE.ShaderMaterialParameters): THREE.ShaderMaterial {
    return new THREE.ShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: shaders.surfaceVertex,
      fragmentShader,
      uniforms: this.uniforms,
      side: THREE.DoubleSide,
      ...options,
    });
  }

  private surfaceMaterial(pass: number): THREE.ShaderMaterial {
    return this.material(shaders.surfaceFragment, {
      uniforms: { ...this.uniforms, pass: { value: pass } },
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 1,
      transparent: pass > 0,
      premultipliedAlpha: true,
      depthWrite: pass === 0,
    });
  }

  private pickMaterial(): THREE.ShaderMaterial {
    return this.material(shaders.pickFragment, { blending: THREE.NoBlending });
  }

  private stencilMaterial(side: THREE.Side, operation: THREE.StencilOp): THREE.ShaderMaterial {
    return this.material(shaders.stencilFragment, {
      side,
      colorWrite: false,
      depthWrite: false,
      depthTest: false,
      stencilWrite: true,
      stencilFunc: THREE.AlwaysStencilFunc,
      stencilFail: operation,
      stencilZFail: operation,
      stencilZPass: operation,
    });
  }

  /** Draws where the count is not zero and sets it back to zero for the next part. */
  private capMaterial(): THREE.ShaderMaterial {
    const color = new THREE.Vector3(...this.capColor).divideScalar(255).lerp(new THREE.Vector3(1, 1, 1), 0.25);
    return this.material(shaders.capFragment, {
      vertexShader: shaders.capVertex,
      uniforms: { capColor: { value: color }, hatch: { value: 11 }, slant: { value: this.index % 2 ? -1 : 1 } },
      stencilWrite: true,
      stencilRef: 0,
      stencilFunc: THREE.NotEqualStencilFunc,
      stencilFail: THREE.ZeroStencilOp,
      stencilZFail: THREE.ZeroStencilOp,
      stencilZPass: THREE.ZeroStencilOp,
    });
  }
}

/** Centre and box of the triangles of a piece, relative. */
export interface Piece {
  low: Vec3;
  high: Vec3;
}

function piecesOf(part: Part, relative: Float32Array): Piece[] {
  const pieces = Array.from({ length: part.pieceCount }, (): Piece => {
    return { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  });
  for (let i = 0; i < part.triangles.length; ++i) {
    const { low, high } = pieces[part.piece(part.triangleFaces[Math.floor(i / 3)])];
    const at = 3 * part.triangles[i];
    for (let axis = 0; axis < 3; ++axis) {
      const x = relative[at + axis];
      if (x < low[axis]) low[axis] = x;
      if (x > high[axis]) high[axis] = x;
    }
  }
  return pieces;
}

function surfaceGeometry(part: Part, relative: Float32Array): THREE.BufferGeometry {
  const { triangles } = part;
  const positions = new Float32Array(3 * triangles.length);
  for (let i = 0, to = 0; i < triangles.length; ++i, to += 3) {
    const from = 3 * triangles[i];
    positions[to] = relative[from];
    positions[to + 1] = relative[from + 1];
    positions[to + 2] = relative[from + 2];
  }
  const geometry = new THREE.BufferGeometry();
  const attribute = new THREE.BufferAttribute(positions, 3);
  attribute.onUpload(function (this: THREE.BufferAttribute) {
    (this as { array: THREE.TypedArray | null }).array = null;
  });
  geometry.setAttribute("position", attribute);
  geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(), 2);
  return geometry;
}

/** Packed, opacity in the highest byte. */
function faceColors(part: Part): Uint32Array {
  const colors = new Uint32Array(part.faceCount);
  for (let face = 0; face < part.faceCount; ++face) {
    const [r, g, b, a] = part.color(face) ?? [...originColor(part.origin(face)), 255];
    colors[face] = (r | (g << 8) | (b << 16) | (a << 24)) >>> 0;
  }
  return colors;
}

/** The colour of most triangles. */
function commonColor(part: Part, colors: Uint32Array): Rgb {
  const counts = new Map<number, number>();
  for (const face of part.triangleFaces) counts.set(colors[face], (counts.get(colors[face]) ?? 0) + 1);
  let best = 0xff808080;
  let most = 0;
  for (const [color, count] of counts) if (count > most) [best, most] = [color, count];
  return [best & 255, (best >> 8) & 255, (best >> 16) & 255];
}
