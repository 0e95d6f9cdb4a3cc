// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import { Stage, isometric } from "../stage";
import { el } from "../ui/dom";
import { DrawnLayer, placesTexture, type CloudUniforms } from "./drawn_layer";
import type { LayeredData } from "./layered_data";
import { Owners } from "./owners";

const reach = 9; // pixels
const slowFrame = 80; // milliseconds; beyond it fewer elements are drawn while the picture moves
const mostWhileMoving = { points: 60_000, segments: 30_000, triangles: 150_000 };
const mostForSmoothEdges = 300_000; // elements

export interface PickedPoint {
  layer: number;
  element: number;
  point: number;
}

/** The layers at a value. Draws only when something changed. */
export class CloudView {
  readonly element = el("div", { class: "view" });
  readonly stage: Stage;
  readonly layers: DrawnLayer[];
  readonly isFlat: boolean;
  private readonly rings: HTMLElement[] = [];
  private readonly shared: CloudUniforms;
  private value = 0;
  private marked: number[] = [];
  private owners: Owners | undefined;
  private isSelected = false;
  private isHeld = false;
  private isThin = false;
  private lastFrame = 0;
  private followers: (() => void)[] = [];

  constructor(
    private readonly data: LayeredData,
    host: HTMLElement,
  ) {
    host.append(this.element);
    const elements = data.layers.reduce((sum, layer) => sum + layer.count, 0);
    this.stage = new Stage(this.element, elements <= mostForSmoothEdges);
    this.shared = {
      places: { value: placesTexture(data.relative) },
      viewport: this.stage.shared.viewport as { value: THREE.Vector2 },
      ratio: { value: this.stage.renderer.getPixelRatio() },
    };
    this.layers = data.layers.map((layer) => new DrawnLayer(layer, this.shared, data.values.length, usualSize(layer.kind, layer.count)));
    for (const layer of this.layers) this.stage.scene.add(layer.object);
    const box = boxOf(data.relative.subarray(0, 3 * data.givenCount));
    const size = box.getSize(new THREE.Vector3());
    this.isFlat = size.z === 0 && data.givenCount > 0;
    this.stage.ball.set(box.getCenter(new THREE.Vector3()), Math.max(1e-3, size.length() / 2));
    this.stage.corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
      (i) => new THREE.Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z),
    );
    this.stage.setOrthographic(this.isFlat);
    this.stage.onFrame = () => this.afterFrame();
    this.stage.controls.addEventListener("start", () => (this.isHeld = true));
    this.stage.controls.addEventListener("end", () => this.rest());
  }

  /** Called after each frame. */
  follow(run: () => void): void {
    this.followers.push(run);
  }

  home(animated: boolean): void {
    this.stage.lookFrom(this.isFlat ? new THREE.Vector3(0, -1e-4, 1) : isometric, animated);
  }

  show(value: number): void {
    this.value = value;
    for (const layer of this.layers) layer.show(value);
    this.thin();
    this.stage.invalidate();
  }

  showLayer(layer: DrawnLayer, isShown: boolean): void {
    layer.isShown = isShown;
    this.show(this.value);
  }

  /** Marks points of the data. */
  mark(points: number[]): void {
    this.marked = points;
    while (this.rings.length < points.length) {
      this.rings.push(el("div", { class: "ring", hidden: true }));
      this.element.append(this.rings[this.rings.length - 1]);
    }
    this.stage.invalidate();
  }

  /** Whether only what a picked point owns is seen. */
  get isAlone(): boolean {
    return this.isSelected;
  }

  /** What is seen of layers that have owners is what an owner has; undefined: all. */
  select(owner: number | undefined): void {
    if (owner === undefined && !this.isSelected) return;
    this.owners ??= new Owners(this.data);
    const seen = owner === undefined ? undefined : this.owners.seenWith(owner);
    this.isSelected = seen !== undefined;
    for (const layer of this.layers) layer.select(seen);
    this.show(this.value);
  }

  /** The foremost point within a few pixels of one of the window. */
  pointAt(x: number, y: number): PickedPoint | undefined {
    const { left, top, width, height } = this.element.getBoundingClientRect();
    this.stage.updateCameras();
    const { camera } = this.stage;
    const m = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    const p = this.data.relative;
    let best: PickedPoint | undefined;
    let nearest = Infinity;
    this.layers.forEach((drawn, layer) => {
      if (drawn.layer.kind !== "points" || !drawn.isSeen) return;
      const { vertices } = drawn.layer;
      const begun = drawn.begunAt(this.value);
      const within = Math.max(reach, drawn.layer.size / 2);
      for (let element = 0; element < begun; ++element) {
        const i = 3 * vertices[element];
        const w = m[3] * p[i] + m[7] * p[i + 1] + m[11] * p[i + 2] + m[15];
        const px = left + ((m[0] * p[i] + m[4] * p[i + 1] + m[8] * p[i + 2] + m[12]) / w + 1) * (width / 2);
        if (Math.abs(px - x) > within || w <= 0) continue;
        const py = top + (1 - (m[1] * p[i] + m[5] * p[i + 1] + m[9] * p[i + 2] + m[13]) / w) * (height / 2);
        if ((px - x) ** 2 + (py - y) ** 2 > within * within) continue;
        const depth = (m[2] * p[i] + m[6] * p[i + 1] + m[10] * p[i + 2] + m[14]) / w;
        // Of points as near, the one closer to the pointer.
        const far = depth + 1e-4 * Math.hypot(px - x, py - y);
        if (far >= nearest || !drawn.isThere(element, this.value)) continue;
        nearest = far;
        best = { layer, element, point: vertices[element] };
      }
    });
    return best;
  }

  /** Milliseconds per frame, each waited for. */
  frameTime(frames: number): number {
    const gl = this.stage.renderer.getContext();
    const start = performance.now();
    for (let i = 0; i < frames; ++i) {
      this.stage.draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }
    return (performance.now() - start) / frames;
  }

  /** The same of frames as they are while the picture moves, where it is slow. */
  movingFrameTime(frames: number): number {
    this.isThin = true;
    this.thin();
    const time = this.frameTime(frames);
    this.rest();
    return time;
  }

  private afterFrame(): void {
    const ratio = this.stage.renderer.getPixelRatio();
    if (this.shared && ratio !== this.shared.ratio.value) {
      this.shared.ratio.value = ratio;
      this.stage.invalidate();
    }
    const now = performance.now();
    const took = now - this.lastFrame;
    this.lastFrame = now;
    if (this.isHeld && !this.isThin && took > slowFrame && took < 3000) {
      this.isThin = true;
      this.thin();
    }
    this.placeRings();
    for (const run of this.followers) run();
  }

  private rest(): void {
    this.isHeld = false;
    this.isThin = false;
    this.thin();
    this.stage.invalidate();
  }

  /** While it moves slowly: a sample of the points, and what stands on them only if it is not much; then all points. */
  private thin(): void {
    let isAnyDropped = false;
    for (const drawn of this.layers) {
      const { kind } = drawn.layer;
      const most = mostWhileMoving[kind];
      const isDropped = this.isThin && kind !== "points" && drawn.isSeen && drawn.drawnCount > most;
      isAnyDropped ||= isDropped;
      drawn.limit(!this.isThin ? Infinity : isDropped ? 0 : kind === "points" ? most : Infinity);
    }
    const points = this.layers.find((drawn) => drawn.layer.kind === "points");
    if (isAnyDropped && points) points.limit(mostWhileMoving.points, true);
  }

  private placeRings(): void {
    const p = this.data.relative;
    this.rings.forEach((ring, k) => {
      const i = k < this.marked.length ? 3 * this.marked[k] : -1;
      const at = i < 0 ? undefined : this.stage.project(new THREE.Vector3(p[i], p[i + 1], p[i + 2]));
      ring.hidden = !at;
      if (at) ring.style.cssText = `left:${at.x}px;top:${at.y}px`;
    });
  }
}

function usualSize(kind: "points" | "segments" | "triangles", count: number): number {
  if (kind === "points") return count < 3000 ? 7 : count < 60_000 ? 4 : count < 300_000 ? 2.5 : 1.5;
  return count < 3000 ? 1.8 : count < 100_000 ? 1.2 : 1;
}

function boxOf(relative: Float32Array): THREE.Box3 {
  const box = new THREE.Box3();
  const at = new THREE.Vector3();
  for (let i = 0; i < relative.length; i += 3) box.expandByPoint(at.set(relative[i], relative[i + 1], relative[i + 2]));
  return box.isEmpty() ? box.set(new THREE.Vector3(), new THREE.Vector3()) : box;
}
