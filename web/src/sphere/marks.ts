// SPDX-License-Identifier: Apache-2.0
// Lines and points on the ball, of constant width on the screen.
import * as THREE from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

const lift = 1.0015; // above the ball, and above the chords of its triangles

/** Ends of the chords of paths, lifted off the ball. */
export function chords(paths: Float32Array[], height = lift): Float32Array {
  const count = paths.reduce((sum, path) => sum + Math.max(0, path.length / 3 - 1), 0);
  const ends = new Float32Array(6 * count);
  let at = 0;
  for (const path of paths) {
    for (let i = 3; i < path.length; i += 3) {
      for (let k = -3; k < 3; ++k) ends[at++] = height * path[i + k];
    }
  }
  return ends;
}

export class Lines {
  readonly mesh: LineSegments2;

  constructor(width: number, paths: Float32Array[], height = lift) {
    const material = new LineMaterial({ linewidth: width, worldUnits: false });
    this.mesh = new LineSegments2(new LineSegmentsGeometry(), material);
    this.mesh.frustumCulled = false;
    this.setPaths(paths, height);
  }

  setPaths(paths: Float32Array[], height = lift): void {
    const ends = chords(paths, height);
    this.mesh.visible = ends.length > 0;
    if (ends.length === 0) return;
    this.mesh.geometry.dispose();
    this.mesh.geometry = new LineSegmentsGeometry();
    this.mesh.geometry.setPositions(ends);
  }

  /** One colour for all, or one for each path in order. */
  setColors(paths: Float32Array[], colors: THREE.Color[]): void {
    const material = this.mesh.material;
    material.vertexColors = true;
    const all: number[] = [];
    paths.forEach((path, i) => {
      const { r, g, b } = colors[i];
      for (let k = 3; k < path.length; k += 3) all.push(r, g, b, r, g, b);
    });
    if (all.length > 0) this.mesh.geometry.setColors(all);
    material.needsUpdate = true;
  }

  setColor(color: THREE.Color): void {
    this.mesh.material.color.copy(color);
  }
}

const dotVertex = /* glsl */ `
attribute vec3 dotColor;
uniform float size;
varying vec3 seen;
void main() {
  seen = dotColor;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = size;
}`;
const dotFragment = /* glsl */ `
uniform vec3 halo;
uniform float size;
varying vec3 seen;
void main() {
  float r = length(gl_PointCoord - 0.5) * size;
  float outer = size / 2.0 - 0.5;
  if (r > outer + 0.5) discard;
  gl_FragColor = vec4(mix(seen, halo, smoothstep(outer - 2.2, outer - 1.2, r)), clamp(outer + 0.5 - r, 0.0, 1.0));
}`;

/** Round dots with a rim. */
export class Dots {
  readonly mesh: THREE.Points;
  private readonly material: THREE.ShaderMaterial;

  constructor(
    positions: Float32Array,
    private readonly size: number,
  ) {
    this.material = new THREE.ShaderMaterial({
      vertexShader: dotVertex,
      fragmentShader: dotFragment,
      uniforms: { size: { value: size }, halo: { value: new THREE.Color() } },
      transparent: true,
      depthWrite: false,
    });
    this.mesh = new THREE.Points(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.setPositions(positions);
  }

  setPositions(positions: Float32Array): void {
    const lifted = positions.map((x) => 1.004 * x);
    this.mesh.geometry.setAttribute("position", new THREE.BufferAttribute(lifted, 3));
    this.mesh.visible = positions.length > 0;
  }

  setColors(colors: THREE.Color[], halo: THREE.Color): void {
    const all = new Float32Array(colors.flatMap(({ r, g, b }) => [r, g, b]));
    this.mesh.geometry.setAttribute("dotColor", new THREE.BufferAttribute(all, 3));
    this.material.uniforms.halo.value.copy(halo);
  }

  setPixelRatio(ratio: number): void {
    this.material.uniforms.size.value = this.size * ratio;
  }
}
