// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import type { PartMesh } from "./part_mesh";
import type { Vec3 } from "./scene_data";
import type { Stage } from "./stage";

export type SectionAxis = "x" | "y" | "z" | "face";

/** The cutting plane: its normal, and where along it; keeps what lies behind it. */
export class Section {
  isOn = false;
  axis: SectionAxis = "x";
  isFlipped = false;
  /** Along the unflipped normal, 0 at one end of the solids and 1 at the other. */
  position = 0.5;
  private readonly faceNormal = new THREE.Vector3(0, 0, 1);
  private timer = 0;
  private low = -1;
  private high = 1;

  constructor(
    private readonly stage: Stage,
    private readonly meshes: PartMesh[],
    private readonly corners: () => THREE.Vector3[],
    private readonly outlined: () => void,
  ) {}

  get normal(): THREE.Vector3 {
    if (this.axis === "face") return this.faceNormal.clone();
    return new THREE.Vector3(+(this.axis === "x"), +(this.axis === "y"), +(this.axis === "z"));
  }

  /** Distance of the plane from the scene's centre along the unflipped normal, relative. */
  get offset(): number {
    return this.low + this.position * (this.high - this.low);
  }

  set offset(offset: number) {
    const range = this.high - this.low;
    this.position = range > 0 ? Math.min(1, Math.max(0, (offset - this.low) / range)) : 0.5;
  }

  alongFace(normal: THREE.Vector3, throughOffset: number): void {
    this.axis = "face";
    this.faceNormal.copy(normal);
    this.measureRange();
    this.offset = throughOffset - 0.25 * (this.high - this.low);
  }

  /** Takes away the side nearer to the viewer, so that the cut is seen. */
  faceViewer(): void {
    this.isFlipped = this.normal.dot(this.stage.gaze) < 0;
  }

  /** Point on the plane nearest to the middle of everything shown. */
  get anchor(): THREE.Vector3 {
    const normal = this.normal;
    const center = this.stage.ball.center;
    return center.clone().addScaledVector(normal, this.offset - normal.dot(center));
  }

  apply(): void {
    this.measureRange();
    const sign = this.isFlipped ? -1 : 1;
    const n = this.normal.multiplyScalar(sign);
    const cut = this.stage.shared.cut.value;
    if (this.isOn) cut.set(n.x, n.y, n.z, sign * this.offset);
    else cut.set(0, 0, 0, 1);
    const facing = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), n);
    for (const mesh of this.meshes) {
      mesh.showCut(this.isOn);
      mesh.cap.position.copy(this.anchor);
      mesh.cap.quaternion.copy(facing);
      mesh.cap.scale.setScalar(Math.max(1, this.stage.ball.radius));
    }
    this.drawOutlines();
    this.stage.invalidate();
  }

  /** At once where that is quick, else when the plane rests. */
  private drawOutlines(): void {
    clearTimeout(this.timer);
    const triangles = this.meshes.reduce((sum, mesh) => sum + mesh.part.triangleCount, 0);
    const draw = () => {
      const normal = this.isOn ? (this.normal.toArray() as Vec3) : undefined;
      for (const mesh of this.meshes) mesh.showOutline(normal, this.offset);
      this.outlined();
    };
    if (!this.isOn || triangles < 100_000) return draw();
    for (const mesh of this.meshes) mesh.showOutline(undefined, 0);
    this.timer = window.setTimeout(draw, 160);
  }

  private measureRange(): void {
    const normal = this.normal;
    let [low, high] = [Infinity, -Infinity];
    for (const corner of this.corners()) {
      const along = corner.dot(normal);
      low = Math.min(low, along);
      high = Math.max(high, along);
    }
    if (low <= high) [this.low, this.high] = [low, high];
  }
}
