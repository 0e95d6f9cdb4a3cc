// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import type { FaceMap } from "./sphere_data";
import { globeFragment, globeVertex } from "./globe_shaders";

const tableWidth = 1024;

/** The coloured ball: every pixel of it asks the map which face it shows. */
export class Globe {
  readonly front: THREE.Mesh;
  /** The far side, seen through the near one. */
  readonly back: THREE.Mesh;
  private readonly colors: THREE.DataTexture;
  private readonly uniforms;

  constructor(map: FaceMap, faceCount: number) {
    const ids = new THREE.DataTexture(
      map.faces.length > 0 ? map.faces : new Uint32Array([0xffffffff]),
      Math.max(1, map.width),
      Math.max(1, map.height),
      THREE.RedIntegerFormat,
      THREE.UnsignedIntType,
    );
    ids.internalFormat = "R32UI";
    ids.needsUpdate = true;
    const rows = Math.max(1, Math.ceil((faceCount + 1) / tableWidth));
    this.colors = new THREE.DataTexture(new Uint8Array(4 * tableWidth * rows), tableWidth, rows);
    this.uniforms = {
      ids: { value: ids },
      colors: { value: this.colors },
      faceCount: { value: faceCount },
      hovered: { value: -1 },
      picked: { value: -1 },
      accent: { value: new THREE.Color() },
      rim: { value: new THREE.Color() },
      opacity: { value: 1 },
      areFacesShown: { value: 1 },
    };
    const geometry = new THREE.SphereGeometry(1, 192, 96);
    const material = (side: THREE.Side) =>
      new THREE.ShaderMaterial({
        glslVersion: THREE.GLSL3,
        vertexShader: globeVertex,
        fragmentShader: globeFragment,
        uniforms: this.uniforms,
        side,
      });
    this.front = new THREE.Mesh(geometry, material(THREE.FrontSide));
    this.back = new THREE.Mesh(geometry, material(THREE.BackSide));
    this.back.visible = false;
  }

  /** Colours of the faces, and last that of places without a face; 0 to 255 each. */
  setColors(colors: THREE.Color[]): void {
    const bytes = this.colors.image.data as Uint8Array;
    colors.forEach((color, i) => bytes.set([255 * color.r, 255 * color.g, 255 * color.b, 255].map(Math.round), 4 * i));
    this.colors.needsUpdate = true;
  }

  setTheme(accent: THREE.Color, rim: THREE.Color): void {
    this.uniforms.accent.value.copy(accent);
    this.uniforms.rim.value.copy(rim);
  }

  light(hovered: number, picked: number): void {
    this.uniforms.hovered.value = hovered;
    this.uniforms.picked.value = picked;
  }

  showFaces(areShown: boolean): void {
    this.uniforms.areFacesShown.value = areShown ? 1 : 0;
  }

  setGlass(isOn: boolean): void {
    const material = this.front.material as THREE.ShaderMaterial;
    this.back.visible = isOn;
    this.uniforms.opacity.value = isOn ? 0.45 : 1;
    for (const m of [material, this.back.material as THREE.ShaderMaterial]) {
      m.transparent = isOn;
      m.depthWrite = !isOn;
      m.needsUpdate = true;
    }
    this.back.renderOrder = 0;
    this.front.renderOrder = isOn ? 2 : 0;
  }
}
