// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { SharedUniforms } from "./part_mesh";

const fieldOfView = 32;
const slowFrame = 60; // milliseconds; beyond it the picture is coarser while it moves

/** Canvas, camera and controls. Draws only when something changed. */
export class Stage {
  readonly scene = new THREE.Scene();
  readonly renderer: THREE.WebGLRenderer;
  readonly controls: OrbitControls;
  readonly shared: SharedUniforms;
  /** Ball that holds everything shown. */
  readonly ball = new THREE.Sphere(new THREE.Vector3(), 1);
  /** Of the boxes of everything shown. */
  corners: THREE.Vector3[] = [];
  /** Called after each frame: what lies over the canvas follows the camera. */
  onFrame: () => void = () => {};
  private readonly perspective = new THREE.PerspectiveCamera(fieldOfView, 1, 0.01, 10);
  private readonly orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 10);
  private flight: { from: Pose; to: Pose; start: number } | undefined;
  private insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  private keptFreeBelow = 0;
  private isScheduled = false;
  private isHeld = false;
  private isCoarse = false;
  private lastFrame = 0;

  constructor(
    readonly host: HTMLElement,
    antialias: boolean,
  ) {
    this.renderer = new THREE.WebGLRenderer({ antialias, alpha: true, stencil: true });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // the shaders write what the screen shows
    this.renderer.sortObjects = true;
    host.append(this.renderer.domElement);
    this.shared = {
      cut: { value: new THREE.Vector4(0, 0, 0, 1) },
      explode: { value: 0 },
      highlightOrigin: { value: -1 },
      showTriangles: { value: 0 },
      accent: { value: new THREE.Color() },
      isPerspective: { value: 1 },
      near: { value: 0.01 },
      viewport: { value: new THREE.Vector2(1, 1) },
      width: { value: 1.5 },
    };
    this.perspective.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.perspective, this.renderer.domElement);
    this.controls.enableDamping = !prefersStillness();
    this.controls.dampingFactor = 0.18;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 1e-3;
    this.controls.maxDistance = 60;
    this.controls.addEventListener("change", () => this.invalidate());
    this.controls.addEventListener("start", () => this.hold());
    this.controls.addEventListener("end", () => this.refine());
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
    this.lookFrom(isometric, false);
  }

  get camera(): THREE.PerspectiveCamera | THREE.OrthographicCamera {
    return this.isOrthographic ? this.orthographic : this.perspective;
  }

  get isOrthographic(): boolean {
    return this.shared.isPerspective.value === 0;
  }

  setOrthographic(on: boolean): void {
    this.shared.isPerspective.value = on ? 0 : 1;
    this.invalidate();
  }

  /** Direction from the target to the camera. */
  get gaze(): THREE.Vector3 {
    return this.perspective.position.clone().sub(this.controls.target).normalize();
  }

  /** Margins in pixels that are covered; the middle of the picture is that of the rest. `keptFreeBelow` matters only to fitting. */
  setInsets(insets: Insets, keptFreeBelow = 0): void {
    this.insets = insets;
    this.keptFreeBelow = keptFreeBelow;
    this.invalidate();
  }

  /** Turns to look at everything shown from a direction. */
  lookFrom(direction: THREE.Vector3, animated = true): void {
    const toward = direction.clone().normalize();
    const to = { target: this.ball.center.clone(), direction: toward, distance: this.fittingDistance(toward) };
    if (!animated || prefersStillness()) return this.setPose(to);
    this.flight = { from: this.pose(), to, start: performance.now() };
    this.invalidate();
  }

  fit(animated = true): void {
    this.lookFrom(this.gaze, animated);
  }

  invalidate(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => this.frame());
  }

  /** Draws at once. */
  draw(): void {
    this.updateCameras();
    this.renderer.render(this.scene, this.camera);
    this.onFrame();
  }

  /** Where a point appears, in pixels of the host; undefined behind the camera. */
  project(point: THREE.Vector3): { x: number; y: number } | undefined {
    const p = point.clone().applyMatrix4(this.camera.matrixWorldInverse);
    if (!this.isOrthographic && p.z > -this.perspective.near) return undefined;
    p.applyMatrix4(this.camera.projectionMatrix);
    return { x: ((p.x + 1) / 2) * this.host.clientWidth, y: ((1 - p.y) / 2) * this.host.clientHeight };
  }

  /** Line of sight through a pixel of the host. */
  ray(x: number, y: number): THREE.Ray {
    this.updateCameras();
    const caster = new THREE.Raycaster();
    const at = new THREE.Vector2((x / this.host.clientWidth) * 2 - 1, 1 - (y / this.host.clientHeight) * 2);
    caster.setFromCamera(at, this.camera);
    return caster.ray;
  }

  /** Makes the cameras ready to draw, to project and to look along rays; a part of the picture only, if given. */
  updateCameras(part?: { left: number; top: number; size: number }): void {
    const { perspective, orthographic, controls } = this;
    const width = this.host.clientWidth;
    const height = this.host.clientHeight;
    const shiftX = (this.insets.right - this.insets.left) / 2;
    const shiftY = (this.insets.bottom - this.insets.top) / 2;
    const { left, top } = part ?? { left: 0, top: 0 };
    for (const camera of [perspective, orthographic]) {
      camera.setViewOffset(width, height, left + shiftX, top + shiftY, part?.size ?? width, part?.size ?? height);
    }
    const toCenter = perspective.position.distanceTo(this.ball.center);
    const reach = this.ball.radius * 1.05 + 1e-3;
    perspective.far = toCenter + reach;
    perspective.near = Math.max(toCenter - reach, 5e-4 * perspective.far, 1e-5);
    perspective.updateProjectionMatrix();
    perspective.updateMatrixWorld();
    const halfHeight =
      perspective.position.distanceTo(controls.target) * Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2));
    orthographic.position.copy(perspective.position);
    orthographic.quaternion.copy(perspective.quaternion);
    orthographic.top = halfHeight;
    orthographic.bottom = -halfHeight;
    orthographic.right = halfHeight * perspective.aspect;
    orthographic.left = -orthographic.right;
    orthographic.near = toCenter - reach;
    orthographic.far = toCenter + reach;
    orthographic.updateProjectionMatrix();
    orthographic.updateMatrixWorld();
    this.shared.near.value = perspective.near * 1.0001;
  }

  /** From where, on the line of sight through the middle, all corners are seen in the free part of the picture. */
  private fittingDistance(direction: THREE.Vector3): number {
    const right = new THREE.Vector3().crossVectors(this.perspective.up, direction).normalize();
    const up = new THREE.Vector3().crossVectors(direction, right);
    const { insets, host } = this;
    const perPixel = Math.tan(THREE.MathUtils.degToRad(fieldOfView / 2)) / (host.clientHeight / 2);
    const halfWidth = (Math.max(120, host.clientWidth - insets.left - insets.right) / 2) * 0.88;
    const halfHeight = Math.max(60, (host.clientHeight - insets.top - insets.bottom) / 2 - this.keptFreeBelow) * 0.92;
    let distance = this.corners.length > 0 ? 0 : 4;
    for (const corner of this.corners) {
      const p = corner.clone().sub(this.ball.center);
      const across = Math.max(Math.abs(p.dot(right)) / halfWidth, Math.abs(p.dot(up)) / halfHeight) / perPixel;
      distance = Math.max(distance, p.dot(direction) + across);
    }
    return Math.max(distance, 0.01);
  }

  private frame(): void {
    this.isScheduled = false;
    const now = performance.now();
    const isMoving = this.fly(now);
    const isDrifting = this.controls.update();
    this.draw();
    this.adapt(performance.now());
    if (isMoving || isDrifting) this.invalidate();
  }

  private fly(now: number): boolean {
    if (!this.flight) return false;
    const { from, to, start } = this.flight;
    const t = Math.min(1, (now - start) / 280);
    const eased = t * t * (3 - 2 * t);
    const turn = new THREE.Quaternion().setFromUnitVectors(from.direction, to.direction);
    this.setPose({
      target: from.target.clone().lerp(to.target, eased),
      direction: from.direction.clone().applyQuaternion(new THREE.Quaternion().slerp(turn, eased)),
      distance: from.distance * Math.pow(to.distance / from.distance, eased),
    });
    if (t >= 1) this.flight = undefined;
    return t < 1;
  }

  private pose(): Pose {
    const offset = this.perspective.position.clone().sub(this.controls.target);
    return { target: this.controls.target.clone(), distance: offset.length(), direction: offset.normalize() };
  }

  private setPose(pose: Pose): void {
    this.controls.target.copy(pose.target);
    this.perspective.position.copy(pose.target).addScaledVector(pose.direction, pose.distance);
    this.controls.update();
    this.invalidate();
  }

  private adapt(now: number): void {
    const took = now - this.lastFrame;
    this.lastFrame = now;
    if (this.isCoarse || !this.isHeld || took < slowFrame || took > 1000) return;
    this.isCoarse = true;
    this.resize();
  }

  /** While the camera is dragged, slow frames make the picture coarser. */
  private hold(): void {
    this.flight = undefined;
    this.isHeld = true;
  }

  private refine(): void {
    this.isHeld = false;
    if (!this.isCoarse) return;
    this.isCoarse = false;
    this.resize();
  }

  private resize(): void {
    const width = Math.max(1, this.host.clientWidth);
    const height = Math.max(1, this.host.clientHeight);
    const ratio = this.isCoarse ? Math.min(1, window.devicePixelRatio) * 0.75 : Math.min(2.5, window.devicePixelRatio);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height);
    this.perspective.aspect = width / height;
    this.shared.viewport.value.set(width * ratio, height * ratio);
    this.shared.width.value = 1.4 * ratio;
    this.draw();
  }
}

export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

interface Pose {
  target: THREE.Vector3;
  direction: THREE.Vector3;
  distance: number;
}

export const isometric = new THREE.Vector3(0.62, -1, 0.72);

function prefersStillness(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}
