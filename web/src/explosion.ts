// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import type { PartMesh, Piece } from "./part_mesh";
import type { Vec3 } from "./scene_data";
import type { Stage } from "./stage";

/** Moves pieces away from the middle of all, and knows the boxes of what is shown. */
export class Explosion {
  readonly pieceCount: number;

  constructor(
    private readonly stage: Stage,
    private readonly meshes: PartMesh[],
  ) {
    this.pieceCount = meshes.reduce((sum, mesh) => sum + mesh.pieces.filter(isInhabited).length, 0);
    const all = new THREE.Box3().setFromPoints(this.corners());
    const middle = all.getCenter(new THREE.Vector3());
    let concentric = 0;
    for (const mesh of meshes) {
      mesh.setOffsets(
        mesh.pieces.map((piece): Vec3 => {
          if (!isInhabited(piece)) return [0, 0, 0];
          const away = boxOf(piece).getCenter(new THREE.Vector3()).sub(middle);
          // One piece inside another has nowhere to go outward: such ones part upwards, each further than the last.
          if (away.length() < 0.02) return [0, 0, 1.1 * concentric++];
          return away.multiplyScalar(1.25).toArray() as Vec3;
        }),
      );
    }
    this.measure();
  }

  get amount(): number {
    return this.stage.shared.explode.value;
  }

  /** 0: as it is, 1: far apart. */
  set amount(amount: number) {
    this.stage.shared.explode.value = amount;
    this.measure();
    this.stage.invalidate();
  }

  /** Corners of the boxes of all pieces shown, as drawn. */
  corners(): THREE.Vector3[] {
    const result: THREE.Vector3[] = [];
    for (const mesh of this.meshes) {
      if (!mesh.isShown) continue;
      mesh.pieces.forEach((piece, i) => {
        if (!isInhabited(piece)) return;
        const offset = mesh.offset(i);
        for (let corner = 0; corner < 8; ++corner) {
          const at = [0, 1, 2].map((k) => ((corner >> k) & 1 ? piece.high[k] : piece.low[k]) + offset[k]);
          result.push(new THREE.Vector3(...at));
        }
      });
    }
    return result;
  }

  /** Tells the stage what is shown. */
  measure(): void {
    const corners = this.corners();
    const { ball } = this.stage;
    this.stage.corners = corners;
    if (corners.length === 0) ball.set(new THREE.Vector3(), 1);
    else new THREE.Box3().setFromPoints(corners).getBoundingSphere(ball);
  }
}

function isInhabited(piece: Piece): boolean {
  return piece.low[0] <= piece.high[0];
}

function boxOf(piece: Piece): THREE.Box3 {
  return new THREE.Box3(new THREE.Vector3(...piece.low), new THREE.Vector3(...piece.high));
}
