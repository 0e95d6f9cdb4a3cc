// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { lineFragment, lineVertex } from "./shaders";

/** Segments in relative coordinates, each with the piece that it moves with. */
export interface Segments {
  starts: Float32Array;
  ends: Float32Array;
  pieces: Float32Array;
  opacities: Float32Array;
}

export function emptySegments(count: number): Segments {
  return {
    starts: new Float32Array(3 * count),
    ends: new Float32Array(3 * count),
    pieces: new Float32Array(count),
    opacities: new Float32Array(count),
  };
}

export interface LineOptions {
  fade: number; ///< 0: no, up to 1: segments that are short on the screen become transparent
  fadeStart: number; ///< the same for the beginning of each segment
  isCut: boolean; ///< ends at the cut, as everything does but the cut's own outline
  order: number;
}

/** Segments drawn at constant width on the screen. */
export class LineSet {
  readonly mesh: THREE.Mesh;
  readonly color = new THREE.Vector4(0, 0, 0, 1);

  constructor(segments: Segments, uniforms: Record<string, THREE.IUniform>, options: LineOptions) {
    const material = new THREE.ShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: lineVertex,
      fragmentShader: lineFragment,
      uniforms: { ...uniforms, lineColor: { value: this.color }, fade: { value: options.fade }, fadeStart: { value: options.fadeStart }, isCut: { value: options.isCut ? 1 : 0 } },
      side: THREE.DoubleSide,
      transparent: true,
      premultipliedAlpha: true,
      depthWrite: false,
    });
    this.mesh = new THREE.Mesh(geometryOf(segments), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = options.order;
  }
  /** Draws others instead. */
  replace(segments: Segments): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometryOf(segments);
  }
}

function geometryOf(segments: Segments): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  const corners = new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]);
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.setAttribute("start", new THREE.InstancedBufferAttribute(segments.starts, 3));
  geometry.setAttribute("end", new THREE.InstancedBufferAttribute(segments.ends, 3));
  geometry.setAttribute("piece", new THREE.InstancedBufferAttribute(segments.pieces, 1));
  geometry.setAttribute("opacity", new THREE.InstancedBufferAttribute(segments.opacities, 1));
  geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(), 2);
  geometry.instanceCount = segments.pieces.length;
  return geometry;
}
