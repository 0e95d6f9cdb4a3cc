// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { originColor } from "../palette";
import { el } from "../ui/dom";
import type { Pose } from "./film";
import type { PlanPart } from "./plan_data";

const fieldOfView = 30;

interface Drawn {
  group: THREE.Group;
  surface: THREE.MeshLambertMaterial;
  lines: THREE.LineBasicMaterial;
}

/** The parts, each where its pose says. Draws only when something changed. */
export class PartsView {
  readonly element = el("div", { class: "parts" });
  /** Size of the assembly, corner to corner. */
  readonly extent: number;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(fieldOfView, 1, 0.01, 1000);
  private readonly renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  private readonly controls: OrbitControls;
  private readonly drawn: Drawn[];
  private readonly scale: number;
  private lit = new Set<number>();
  private isScheduled = false;

  constructor(parts: PlanPart[]) {
    const box = boxOf(parts);
    const center = box.getCenter(new THREE.Vector3());
    this.extent = box.isEmpty() ? 1 : box.getSize(new THREE.Vector3()).length();
    this.scale = 2 / this.extent;
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.domElement.setAttribute("aria-label", "Parts");
    this.element.append(this.renderer.domElement);
    this.drawn = parts.map((part, i) => this.draw(part, i, center));
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x9aa3b0, 2.1));
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 4);
    this.scene.add(sun);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(3.4, -5.1, 3.3);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  pose(poses: Pose[]): void {
    poses.forEach(({ offset, presence, isMoving }, i) => {
      const { group, surface, lines } = this.drawn[i];
      group.position.set(offset[0], offset[1], offset[2]).multiplyScalar(this.scale);
      const isFaint = presence < 1;
      surface.transparent = isFaint;
      surface.opacity = presence;
      surface.depthWrite = presence > 0.5;
      lines.transparent = isFaint;
      lines.opacity = presence;
      surface.emissive.setHex(isMoving || this.lit.has(i) ? 0x5a3108 : 0x000000);
    });
    this.invalidate();
  }

  /** Marks parts, as those that a set names. */
  light(parts: number[]): void {
    this.lit = new Set(parts);
  }

  invalidate(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      this.controls.update();
      this.renderer.render(this.scene, this.camera);
    });
  }

  private draw(part: PlanPart, index: number, center: THREE.Vector3): Drawn {
    const [r, g, b] = originColor(index);
    const surface = new THREE.MeshLambertMaterial({
      color: new THREE.Color().setRGB(r / 255, g / 255, b / 255, THREE.SRGBColorSpace),
      flatShading: true,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    const lines = new THREE.LineBasicMaterial({ color: 0x2a323c });
    const place = (list: number[]) => {
      const at = new Float32Array(3 * list.length);
      list.forEach((v, i) => {
        at[3 * i] = (part.vertices[3 * v] - center.x) * this.scale;
        at[3 * i + 1] = (part.vertices[3 * v + 1] - center.y) * this.scale;
        at[3 * i + 2] = (part.vertices[3 * v + 2] - center.z) * this.scale;
      });
      return new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(at, 3));
    };
    const mesh = new THREE.Mesh(place(part.triangles), surface);
    mesh.geometry.computeVertexNormals();
    const group = new THREE.Group();
    group.add(mesh, new THREE.LineSegments(place(part.edges), lines));
    this.scene.add(group);
    return { group, surface, lines };
  }

  private resize(): void {
    const width = Math.max(1, this.element.clientWidth);
    const height = Math.max(1, this.element.clientHeight);
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }
}

function boxOf(parts: PlanPart[]): THREE.Box3 {
  const box = new THREE.Box3();
  const at = new THREE.Vector3();
  for (const { vertices } of parts) {
    for (let i = 0; i < vertices.length; i += 3) box.expandByPoint(at.set(vertices[i], vertices[i + 1], vertices[i + 2]));
  }
  return box;
}
